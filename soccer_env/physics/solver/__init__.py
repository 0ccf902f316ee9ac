"""Our part of the contact solver, which Chipmunk calls in every substep.

records.py    what it works on: one record for each match
rounds.py     the four functions that Chipmunk calls, and the ground under the robots
ball.py       what a blow does to a ball that rolls
posts.py      what the posts of robots touch: other robots and the ball
walls.py      what they touch that stands still: boards with their feet, goals
interlock.py  legs caught between the legs of another robot
impulses.py   impulses at the contacts of posts
"""
