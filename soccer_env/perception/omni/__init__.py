"""What middle-size robots perceive: an omnidirectional camera, white lines, a light barrier.

    around.py         Who stands round a robot, and what they hide from a camera that looks in all directions.
    lighting.py       Changing light, and the colour table that must follow it.
    line_picture.py   White lines in the picture of the omnidirectional camera: the first one in each of many ...
    lines.py          The white lines of a pitch: what a robot knows of them beforehand, and how many there are.
    sense.py          What the sensors of a middle-size robot deliver in a frame: mirror camera, wheels, light ...
    sightings.py      What the omnidirectional camera finds in its picture: ball, players, goals.

`sense.py` calls them all.
"""
