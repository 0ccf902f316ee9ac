"""Lessons of the actor by a scripted teacher, before learning from rewards.

imitation.py     a teacher that plays: its decisions, and the fit to them
advice.py        a teacher that watches the actor play, knows the truth, and labels each decision
lessons.py       the lessons of a run, in all its match settings; the rounds so far on the disk, for resuming
"""
