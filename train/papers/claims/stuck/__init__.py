"""How a robot notices that it is stuck, and how it gets free.

branches.py        The fate of robots that were held in play, with the recovery and without.
collisions.py      Collisions on the way to the ball: their frequency and duration; stealing the ball by one.
detection.py       How a robot notices that it is stuck: the ball does not come nearer.
false_alarms.py    False alarms, staged and in play: a robot that nothing stops believes that it is stuck.
recovery.py        How a stuck robot gets free: steps back, then aside or round, then to the ball again.
runs.py            Runs of a robot that goes for a ball and is stopped on the way, for the claims on collisions.
sampled.py         Moments of play in which a robot is held, or believes that it is stuck, and branches from them.
surface.py         S22 and S23 over both thresholds of the counters, which the paper does not tell.
worth.py           The worth of noticing a collision and recovering from it, task by task; turning at a wall.
"""
