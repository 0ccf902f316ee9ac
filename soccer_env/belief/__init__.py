"""Beliefs of robots, computed from percepts and memory, without access to the truth.

    believing.py   The compiled loop over matches and robots that updates beliefs and exchanges messages.
    legged/        Beliefs of legged robots: ball, other players, obstacle, own pose; control of the head.
    odometry.py    Correction of remembered positions for the robot's own motion.
    omni/          Beliefs of middle-size robots: ball, other players, own pose, reports by radio.
    own_pose.py    The own pose in a robot's belief: from a given pose, from particles, or from odometry.
    particles.py   Particles: possible poses of a robot, moved with the robot and resampled by its measurements.
    talk.py        Messages between team-mates, by loudspeaker or by radio, which are delayed and can be lost.

Each kind of robot has a folder; the modules here serve all robots. perception/ makes the percepts.
"""
