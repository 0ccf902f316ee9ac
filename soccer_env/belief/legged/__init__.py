"""Beliefs of legged robots: ball, other players, obstacle and own pose, and the control of the head's gaze.

    ball.py        The ball that a legged robot believes in.
    ball_blob.py   From orange blobs in the picture to a place of the ball.
    believe.py     The memory of a legged robot: ball, players, obstacle, own pose, gaze, and what it hears.
    grouping.py    From blobs of one jersey colour to players: which blobs belong together.
    head.py        Where the head looks by itself: at the ball while it is seen, else in search of it.
    landmarks.py   The own pose of a legged robot: particles weighed by the landmarks and goals that it sees.
    matching.py    Which player in memory is the one that is seen now.
    obstacle.py    The obstacle that a legged robot makes of a reading of its infrared ranger.
    players.py     The other players that a legged robot believes in.
    surface.py     From a player's middle to its surface, as the sensors measure it, and back.
    talk.py        Words of four bits by loudspeaker: how far the ball is, 1 to 15, or 0 "I do not see it".
    velocity.py    How fast the ball moves, from two of its places a third of a second apart.

`believe.py` calls them all, for one robot after the other.
"""
