"""How a robot notices that it is stuck, and how it gets free.

branches.py    fates of held robots         collisions.py  frequency, duration, stealing
detection.py   noticing, false alarms       recovery.py    steps back, aside or round
runs.py        a robot stopped on its way   sampled.py     moments of play, branches
surface.py     both thresholds              worth.py       task by task, at a wall
"""
