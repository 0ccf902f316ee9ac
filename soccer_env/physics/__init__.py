"""The physics: bodies, drive and ball, and the pymunk engine behind them.

drive.py        from commands to velocities: delay, gait or wheels, traction; the head's joints
gait.py         where the paws of a walking robot are
kicker.py       kicks, and whether the ball lies at the kicker
ball.py         the ball on the carpet: it slides, then rolls
contacts.py     who touched what
space.py        a pymunk Space for one match: boards, goals, ball, robots
surfaces.py     what meets what in it, and how much that bounces and rubs
space_batch.py  M of them, and the arrays through which kernels reach them
exchange.py     between the records of a match and the rows of those arrays
chipmunk.py     calls of Chipmunk, the C library under pymunk, from compiled loops
chipmunk_pools.py  where Chipmunk keeps shapes, pairs and contacts
prefetch.py     fetch the next match's memory into the cache while this one is played
reference.py    a bare scene for `soccer bench` to compare with
"""
