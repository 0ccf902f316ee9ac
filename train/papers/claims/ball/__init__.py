"""How a legged robot finds and follows the ball.

filter.py        How steady the believed ball is: averaging four estimates, and bearing against range.
gap.py           Velocities after a time without sight of the ball.
in_play.py       The ball in play: how often the head keeps it centred, and what is mistaken for it.
memory.py        The ball that is remembered while it is not seen, and the robot's own motion.
occlusion.py     A ball that other robots hide in part, and what the rules make of it.
ranger.py        A ball hidden in both dimensions, and the infrared ranger that knows better.
range.py         How far away a legged robot takes the ball to be: by size, by infrared, and what a pixel is worth.
velocity.py      The relative velocity of the ball: how often to read it, and what a reading is worth.
"""
