"""Fouls: a small module for each rule, with a switch in `leagues.rules.Rules`; a switch that is off costs nothing.

judging.py      all rules in their order, once a control step
penalties.py    the whistle; taking robots out, and bringing them back
goals.py        whether a goal counts
legged/         the rules of the legged league
middle_size/    the rules of the middle size
"""
