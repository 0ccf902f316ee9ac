"""What middle-size robots perceive: an omnidirectional camera, white lines, a light barrier.

    around.py         The other robots round a robot, and what they hide from its omnidirectional camera.
    lighting.py       Changing light, and the colour table that must follow it.
    line_picture.py   White lines in the picture of the omnidirectional camera: the first one in each direction.
    lines.py          The white lines of a pitch: a robot's table of distances to the nearest line.
    sense.py          What the sensors of a middle-size robot deliver: mirror camera, wheels, light barrier.
    sightings.py      What the omnidirectional camera finds in its picture: ball, players, goals.

`sense.py` calls them all.
"""
