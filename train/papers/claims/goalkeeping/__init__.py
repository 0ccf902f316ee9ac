"""The goalkeeper, the receiver and what they make of the ball's velocity.  [Heinemann et al. 2006, 1, 2, 4]

shots.py      shots at the goalkeeper, at its far post and its near one
places.py     where it stands, and how far it has to go
saves.py      what the passive goalkeeper and the active one save, and by how good a track of the ball
passes.py     balls that roll past a player: who gets them, by which base, by which kick
cycles.py     how often a player decides
"""
