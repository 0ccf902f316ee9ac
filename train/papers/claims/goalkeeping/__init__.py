"""The goalkeeper and the receiver, and their use of the ball's velocity.  [Heinemann et al. 2006, 1, 2, 4]

places.py    geometry of its kernels         shots.py     shots at the goalkeeper
saves.py     passive and active goalkeeper   passes.py    rolling balls and passes
tracking.py  velocities, the challenge
"""
