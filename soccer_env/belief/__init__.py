"""What robots believe: percepts and memory in, beliefs and tracks out; the truth is out of reach here.

    believing.py   The loop in which robots bring their beliefs up to their percepts, then talk: the same for every ...
    legged/        What legged robots believe: ball, other players, obstacle and own pose, and where the head looks.
    odometry.py    Where a remembered thing lies after the robot itself has moved.
    omni/          What middle-size robots believe: ball and players by filters, own pose by lines, reports by radio.
    own_pose.py    Where a robot believes itself to be: by a pose that it is given, by particles, or by odometry.
    particles.py   Particles: many poses at which a robot may be, moved with it and kept where they fit what it sees.
    talk.py        What team-mates tell each other, by loudspeaker or by radio: messages that take time and get lost.

One folder a kind of robot; what lies here is every robot's. perception/ makes what is read here.
"""
