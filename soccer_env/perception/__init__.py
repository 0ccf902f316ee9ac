"""What robots perceive: percepts made from the truth, with the errors of real sensors.

    body.py    What a robot feels of itself: odometry, the accelerometer, its kicker, and a pose that it is given.
    ideal.py   senses="ideal": copy the truth into the fields of beliefs and tracks, as a sensor without error or ...
    legged/    What legged robots perceive: blobs in the picture of a camera on a moving head, and an infrared ranger.
    omni/      What middle-size robots perceive: an omnidirectional camera, white lines, a light barrier.
    pose.py    The pose that a robot is given from outside: a noisy one in every frame, or where it was put at a ...
    sensing.py The loop in which robots sense: what is common to all kinds of robots, round what each kind does ...

One folder a kind of robot; what lies here is every robot's.
"""
