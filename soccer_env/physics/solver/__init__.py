"""Our part of the contact solver, which Chipmunk calls in every substep.

records.py    the records of this part of the solver, one for each match
rounds.py     the four functions that Chipmunk calls, and the ground under the robots
ball.py       blows to a rolling ball
contacts.py   contacts of posts, and the impulses at them
posts.py      contacts of posts with other robots and with the ball
walls.py      contacts of posts with boards, their ramps and goals
ramps.py      the ball on the ramps before boards
interlock.py  legs caught between the legs of another robot
"""
