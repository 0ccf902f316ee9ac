"""Fouls of the legged league, a small module for each rule: the guilty robot is taken out, and the ball stays.

book.py             all rules in their order
contact.py          find robots that walk into opponents
pushing.py          pushing of field players
keeper_pushing.py   pushing of goalkeepers in their areas
holding.py          a trapped ball
areas.py            illegal defender and attacker
leaving.py          robots that stand in a goal
falling.py          robots that are pushed over, or lie for too long
stuck.py            local and global game stuck
kick_off_shot.py    no goal straight from the kick-off

We know of no copy of the book of 2001. Its readable descendant is the first book of the standard platform league, of
2008, which keeps sentences of the legged book as comments (RoboCup-SPL/Rules, NaoRules2008.tex): this is "the book".
Its times and distances are assumed for 2001, except the 3 s of ball holding, from the diary of the champions of 2000.
"""
