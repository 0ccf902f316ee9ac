"""Ways round the others: what the two planners do.  [Heinemann et al. 2006, 3]

scenes.py     what they are asked: canonical and random crossings, slow traffic, rows and cups
runs.py       points that travel, planned anew every 20 ms, and plans that are made once
crossings.py  slow obstacles, the crossing of the paper's figure, random crossings
plans.py      what a plan costs, and how it comes about: local gradients, search, backwards
timing.py     the time T, and how many passes it takes
"""
