"""How a robot notices that it is stuck, and how it gets free.

alarms_in_play.py  When a robot believes in play that it is stuck and is not.
branches.py        What becomes of robots that were held in play: with the recovery and without.
collisions.py      Collisions on the way to the ball: how common they are, and that robots stay in them.
detection.py       How a robot notices that it is stuck: the ball does not come nearer.
false_alarms.py    When a robot that nothing stops believes that it is stuck: in staged approaches.
recovery.py        How a stuck robot gets free: steps back, then aside or round, then to the ball again.
runs.py            Runs of a robot that makes for a ball and is stopped on the way, for the claims on collisions.
sampled.py         Moments of play in which a robot is held, or thinks itself stuck, and branches of matches from them.
stealing.py        Stealing the ball: whether running into an opponent that has it helps.
wall.py            A robot that faces out at the field's edge and turns to a ball aside or behind.
worth.py           What noticing a collision and recovering from it are worth, task by task.
"""
