"""What an actor learns from a scripted teacher, before rewards and beside them.

imitation.py     a teacher that plays: its decisions, the fit to them, and the hold on them later
advice.py        a teacher that watches the actor play, knows the truth, and says what it would do
kept_rounds.py   the rounds of advice so far, so that a run that is cut goes on
lessons.py       what of both a run asks for, in all kinds of matches that it has
"""
