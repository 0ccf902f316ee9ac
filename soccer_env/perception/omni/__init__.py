"""What middle-size robots perceive: an omnidirectional camera, white lines, a light barrier.

    around.py         The other robots in view of the omnidirectional camera, and the parts of things that they hide.
    lighting.py       Changing light, and the vision's colour table that must adapt to it.
    line_picture.py   White lines in the picture of the omnidirectional camera: the first line in each direction.
    sense.py          All sensors of a middle-size robot: mirror camera, wheels, light barrier.
    sightings.py      Objects that the omnidirectional camera finds in its picture: ball, players, goals.

`sense.py` calls them all.
"""
