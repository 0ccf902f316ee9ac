"""Measure the speed: `soccer bench`. Ratios of one run, never a stopwatch in a test.

settings.py    what the command line asks for
benchmark.py   the rows, interleaved, as medians with intervals, and the machine they were measured on
loads.py       what is timed: the core under two loads, the bare physics of the same play, pictures with overlays
plans.py       the middle-size planner, one pass and one plan
apis.py        PettingZoo's step, the memory of a match, how long importing and compiling take
against.py     --against: the rows of two checkouts in turn, as ratios with intervals
worker.py      the process that times the rows of one of the two
"""
