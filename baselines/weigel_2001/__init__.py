"""weigel-2001: the planner of the Freiburg team of 2001, as the paper of 2006 describes it.  [Heinemann 2006, 3]

planner/    ways round obstacles by a potential field on a grid: the planner of 2001, and that of 2006
"""
