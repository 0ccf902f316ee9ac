"""Fouls of the middle size, a small module a rule: each is a free kick for the opponents.

book.py         all of them in their order, and what follows
taking.py       who takes a restart, and that it does not touch the ball again
distances.py    opponents keep off a restart
charging.py     driving into opponents and into the goalkeeper
handling.py     the ball within the hull, going back with it, dribbling
areas.py        who may not stay before the goals
free_kicks.py   where a free kick is taken
cards.py        yellow, and out

The book of 2006 is not to be had; the books of these years follow FIFA's laws, which are cited by their numbers.
"""
