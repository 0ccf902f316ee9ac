"""Fouls of the middle size, a small module for each rule: the opponents get a free kick.

book.py         all fouls in their order, with free kicks and cards
taking.py       the taker of a restart does not touch the ball again
distances.py    opponents keep off a restart
charging.py     driving into opponents and into the goalkeeper
handling.py     enclosing the ball, going back with it, dribbling
areas.py        robots that may not stay before the goals

The book of 2006 is not available; the books of these years follow FIFA's laws, which are cited by their numbers.
"""
