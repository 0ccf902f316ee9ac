"""weigel-2001: what the paper of 2006 tells of the team of Freiburg, 2001.  [Heinemann 2006, 3]

planner/    ways round obstacles by a potential field on a grid: its own, and the one of 2006
"""
