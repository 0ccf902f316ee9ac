"""The paths of the two planners round other robots.  [Heinemann et al. 2006, 3]

runs.py       scenes, travels, drives    crossings.py  past moving obstacles
plans.py      cost, time T and methods
"""
