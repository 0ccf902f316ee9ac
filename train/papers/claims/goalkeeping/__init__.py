"""The goalkeeper and the receiver, and their use of the ball's velocity.  [Heinemann et al. 2006, 1, 2, 4]"""
