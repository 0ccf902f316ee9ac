"""What robots perceive: percepts computed from the truth, with the errors of real sensors.

    body.py    Sensing of a robot's own body: odometry, accelerometer, kicker, and a pose if the settings provide one.
    ideal.py   Ideal senses, senses="ideal": write the truth into beliefs and tracks, as a sensor without error would.
    legged/    What legged robots perceive: coloured blobs in the picture of the head camera, and an infrared range.
    omni/      What middle-size robots perceive: an omnidirectional camera, white lines, a light barrier.
    sensing.py The compiled loop over matches and robots that computes percepts, shared by all kinds of robots.

Each kind of robot has a folder; the modules here serve all robots.
"""
