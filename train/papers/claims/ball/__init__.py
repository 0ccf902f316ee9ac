"""How a legged robot finds and follows the ball.

gap.py        after a time without sight   memory.py     of an unseen ball
occlusion.py  a ball hidden in part        range.py      by size and by infrared
sight.py      steadiness, the head         velocity.py   readings and their accuracy
"""
