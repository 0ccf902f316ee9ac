"""The physics: bodies, drive and ball, and the pymunk engine behind them.

drive.py     from commands to what legs or wheels want of the ground: delay, gait or wheels; the head's joints
gait.py      where the paws of a walking robot are
paws.py      how they move in a control step
block.py     a goalkeeper's block: forelegs spread, and what of a robot they reach
parking.py   where robots stand that do not play
kicker.py    kicks, and whether the ball lies at the kicker
ball.py      the ball on the carpet: it slides, then rolls
contacts.py  who touched what
exchange.py  between the records of a match and the rows of numbers that the engine is given and gives back
solver/      our part of the contact solver: the ground, posts of robots, legs that interlock, the ball's roll
engine/      pymunk: Spaces and what is in them, and the calls and memory of Chipmunk under it
"""
