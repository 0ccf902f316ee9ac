"""Learning from rewards by PPO, a rollout at a time.

distributions.py   what a policy draws its actions from
matches.py         the matches of a run, here or on a cluster
rollout.py         play of all matches between two updates, and its advantages
update.py          gradient steps on a rollout
"""
