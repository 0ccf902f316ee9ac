"""Keeping the ball between the paws, past other players and to the goal.

dribbling.py  steps, angles, contact    past.py       past who stands or walks
or_shoot.py   against orbit and shoot
"""
