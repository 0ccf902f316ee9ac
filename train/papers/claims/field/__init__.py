"""The potential field that a dribbler follows, in a world of points and with robots.

Points have neither camera nor surface: their distances count from middle to middle (MS54). Distances of robots count
from camera to surface, as the sensors gave them (MS42), and for comparison from middle to middle.

    constants.py    k2, x0, their transfer     forces.py       exponents, cosine, goal
    minima.py       minima, keeping a side     numbers.py      unit forces, walls, time
    paths.py        steadiness, indecision     point_world.py  the simulator of points
    points.py       scenes, runs of robots
"""
