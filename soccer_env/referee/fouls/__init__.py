"""Fouls: a small module a rule, each with a switch in `leagues.rules.Rules`; a switch that is off costs nothing.

judging.py      all rules in their order, once a control step
penalties.py    the whistle; robots that are taken out, and that come back
goals.py        whether a goal counts
legged/         the rules of the legged league
middle_size/    the rules of the middle size
"""
