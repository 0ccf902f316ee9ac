"""Our part of the contact solver, which Chipmunk calls in every substep.

records.py    what it works on: one record for each match
rounds.py     the four functions that Chipmunk calls, and the ground under the robots
ball.py       what a blow does to a ball that rolls
contacts.py   how a contact is listed, and what it is to bring about
posts.py      what the posts of robots touch: other robots and the ball
walls.py      what they touch that stands still: boards with their feet, goals
interlock.py  legs caught between the legs of another robot
impulses.py   impulses at the contacts of posts
"""
