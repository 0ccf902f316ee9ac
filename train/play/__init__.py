"""Measure how a match is played: `python -m soccer_env.train.play`, the same figures whatever the engine.

settings.py     what the command line asks for
recording.py    matches as arrays of records over time, a block at once
convex.py       signed distance of convex shapes          outlines.py   bodies, boards and posts as such shapes
gaps.py         how far ball, robots and boards are apart, by geometry alone
runs.py         how long something stays so
ball.py         where the ball lies, how far it comes back          possession.py   spells, touches, kicks
stuck.py        robots that want to walk and are stopped            scrums.py       scrums, and the overlap in them
figures.py      a number of many matches, with its interval         measures.py     all measures; measuring
referee.py      what follows where the referee moves robots
report.py       the table and the JSON file                         goals/          how goals fell, and pictures of them

Every measure is defined by the first sentence of its function. Distances are judged by this package's own geometry,
not by what the physics reports, as the figures are there to judge the physics.
"""
