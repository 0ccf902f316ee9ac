"""How a robot notices that it is stuck, and how it gets free.

collisions.py    Collisions on the way to the ball: how common they are, and what noticing them is worth.
detection.py     How a robot notices that it is stuck: the ball does not come nearer.
false_alarms.py  When a robot believes that it is stuck and is not.
recovery.py      How a stuck robot gets free: steps back, then aside or round, then to the ball again.
runs.py          Runs of a robot that makes for a ball and is stopped on the way, for the claims on collisions.
stealing.py      Stealing the ball: whether running into an opponent that has it helps.
"""
