"""The goalkeeper and the receiver, and their use of the ball's velocity.  [Heinemann et al. 2006, 1, 2, 4]

shots.py      shots at the goalkeeper, at its far and near post
places.py     the goalkeeper's place, and its ways to the ball
saves.py      saves of the passive and the active goalkeeper, and their dependence on the track of the ball
tracking.py   the believed velocities of ball and robots in play, and the challenge of 2003
passes.py     balls that roll past a player: with each base, after each kick, with each decision cycle
"""
