"""Measure the speed of the package: `soccer bench`. Speeds are compared within one run; no test measures time.

settings.py    the command's options
benchmark.py   the rows of the report as medians of interleaved timings, and a description of the machine
loads.py       timed loads: the core in random and chaser play, the physics alone, pictures with overlays
plans.py       timed loads: one pass and one plan of the middle-size planner, and its team
apis.py        memory of a match, start-up times, and loads that take turns
profile.py     --profile: the time of each mechanism in a match step
against.py     --against: the ratio of two checkouts' times, with its interval
peers.py       --peers: the ratio to other environments, which pip installs
peer_worker.py the process that times one of them, or both leagues beside it
worker.py      PettingZoo's step and reset, a branch; the process that times one checkout for --against
"""
