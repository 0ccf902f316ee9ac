"""Beliefs of legged robots: ball, other players, obstacle and own pose, and the control of the head's gaze.

    ball.py        The ball in a legged robot's belief.
    ball_blob.py   From orange blobs in the picture to a position of the ball.
    believe.py     The belief of a legged robot: ball, players, obstacle, own pose, gaze, heard words.
    grouping.py    Group the blobs of one jersey colour into players.
    head.py        The default control of the head: look at the ball's blob while it is seen, else search for it.
    landmarks.py   The own pose of a legged robot, by particles weighed by landmarks and goals.
    matching.py    Match the players in view to the players in memory.
    obstacle.py    The obstacle that a legged robot infers from a reading of its infrared ranger.
    players.py     The other players in a legged robot's belief.
    surface.py     Distances to a player's middle converted to distances to its surface.
    talk.py        Messages by loudspeaker: four bits for the distance to the ball, 1 to 15, or 0 "I do not see it".
    velocity.py    The ball's velocity, from two of its positions a third of a second apart.

`believe.py` calls them all, for one robot after the other.
"""
