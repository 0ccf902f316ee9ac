"""Keeping the ball between the paws, past other players and to the goal.

dribbling.py     Keeping the ball between the paws: step length, angle off straight ahead, a robot in the way.
or_shoot.py      Dribbling round blockers against the team's former play: orbit and shoot.
past.py          Dribbling past players who stand or walk, by class, and how often to decide.
"""
