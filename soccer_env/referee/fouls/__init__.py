"""Fouls: a small module a rule, each with a switch in `leagues.rules.Rules`; a switch that is off costs nothing.

judging.py      all rules in their order, once a control step
penalties.py    the whistle; robots that are taken out, and that come back
goals.py        whether a goal counts
legged/         the rules of the legged league
taking.py       who takes a restart, and that it does not touch the ball again
middle_size.py  the fouls of the middle size, each a free kick:
    distances.py    opponents keep off a restart          free_kicks.py   where it is taken
    charging.py     driving into opponents, the keeper    handling.py     the ball within the hull, dribbling
    areas.py        who may not stay before the goals     places.py       who stands there
    cards.py        yellow, and out
"""
