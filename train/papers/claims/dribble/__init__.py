"""Keeping the ball between the paws, past other players and to the goal.

dribbling.py     Keeping the ball between the paws: step length, angle off straight ahead, a robot in the way.
or_shoot.py      Dribbling round blockers against what the team did before: orbit and shoot.
past.py          Dribbling past players who stand, past one who walks.
classes.py       A mover among players who stand, class by class.
replanning.py    How often a dribbler has to decide.
"""
