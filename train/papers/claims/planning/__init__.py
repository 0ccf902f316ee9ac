"""The paths of the two planners round other robots.  [Heinemann et al. 2006, 3]"""
