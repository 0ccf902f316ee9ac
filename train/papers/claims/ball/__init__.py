"""How a legged robot finds and follows the ball.

filter.py        How steady the believed ball is: averaging four estimates, and bearing against range.
gap.py           Velocities after a time without sight of the ball.
in_play.py       The ball in play: how often the head keeps it centred, and false sightings.
memory.py        The memory of an unseen ball, and the robot's own motion.
occlusion.py     A ball that other robots hide in part: its estimated range, and the correction by infrared.
range.py         The estimated range of the ball: by size, by infrared, and the worth of a pixel.
velocity.py      The relative velocity of the ball: how often to read it, and the accuracy of a reading.
"""
