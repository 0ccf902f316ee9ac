"""What robots perceive: percepts computed from the truth, with the errors of real sensors.

    body.py    What a robot feels of itself: odometry, accelerometer, kicker, and a pose if it is given one.
    ideal.py   senses="ideal": the truth in the fields of beliefs and tracks, as from a perfect sensor.
    legged/    What legged robots perceive: blobs in the picture of a camera on a moving head, and an infrared ranger.
    omni/      What middle-size robots perceive: an omnidirectional camera, white lines, a light barrier.
    sensing.py The loop over matches and robots in which robots sense, the same for every kind of robot.

Each kind of robot has a folder; the modules here serve all robots.
"""
