"""The paths of the two planners round other robots.  [Heinemann et al. 2006, 3]

runs.py       scenes; points that travel through them and replan every 20 ms, and single plans
crossings.py  slow obstacles, drives, random crossings, the crossing of the paper's figure
drives.py     drives past moving robots on real bases
plans.py      the cost of a plan, and its methods: local gradients, search, backward planning
timing.py     the time T, and the passes until it converges
"""
