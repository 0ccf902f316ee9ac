"""Beliefs of robots, computed from percepts and memory, without access to the truth.

    believing.py   The loop over matches and robots in which robots update their beliefs and talk.
    legged/        What legged robots believe: ball, other players, obstacle and own pose, and where the head looks.
    odometry.py    Where a remembered thing lies after the robot itself has moved.
    omni/          What middle-size robots believe: ball and players by filters, own pose by lines, reports by radio.
    own_pose.py    Where a robot believes itself to be: by a given pose, by particles, or by odometry.
    particles.py   Particles: many poses at which a robot may be, moved with it and kept where they fit what it sees.
    talk.py        What team-mates tell each other, by loudspeaker or by radio: messages that take time and get lost.

Each kind of robot has a folder; the modules here serve all robots. perception/ makes the percepts.
"""
