"""Learning from rewards by PPO, a rollout at a time.

rollout.py   play of all matches between two updates, and its advantages
update.py    gradient steps on a rollout
"""
