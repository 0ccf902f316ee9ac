"""The physics: bodies, drive and ball, and the pymunk engine behind them.

drive.py     from commands to wanted velocities: delay, gait or wheels, moving paws; the head's joints
gait.py      the paws of a walking robot
block.py     a goalkeeper's block: it spreads its forelegs
faults.py    robots that fail for a while or for good
parking.py   places of inactive robots, off the field
kicker.py    kicks, and whether the ball lies at the kicker
ball.py      the ball on the carpet: it slides, then rolls
contacts.py  which robot touches the ball or another robot
exchange.py  copies numbers between the records of a match and the arrays of the engine
solver/      our part of the contact solver: the ground, posts of robots, legs that interlock, the ball's roll
engine/      pymunk: Spaces and their shapes, and the calls and memory of Chipmunk below pymunk
"""
