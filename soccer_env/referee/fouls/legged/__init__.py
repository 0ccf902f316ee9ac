"""Fouls of the legged league, a small module a rule: who is guilty is taken out, and the ball lies where it lay.

book.py             all of them in their order
contact.py          who walks into whom
pushing.py          field players
keeper_pushing.py   goalkeepers in their areas
holding.py          a trapped ball
areas.py            illegal defender and attacker
leaving.py          robots that stand in a goal
falling.py          robots that are pushed over, and that lie for too long
stuck.py            local and global game stuck
kick_off_shot.py    no goal straight from the kick-off

The book of 2001 is not stored anywhere that we know of. Its readable descendant is the first book of the standard
platform league, of 2008, with the legged book's sentences left in it as comments (RoboCup-SPL/Rules,
NaoRules2008.tex); "the book" is that one. Its times and distances are assumed for 2001, but for the 3 s of ball
holding, which the diary of the champions of 2000 has.
"""
