"""The potential field that a dribbler follows, in a world of points and with robots.

Points have neither camera nor surface: their distances count from middle to middle (MS54). Distances of robots count
from camera to surface, as the sensors gave them (MS42), and for comparison from middle to middle.

constants.py     The constants of the potential field, and the transfer of constants from points to robots.
forces.py        The forces of the potential field: exponents, the goal's pull, the cosine, walls.
minima.py        Local minima, remaining indecision, and a stronger preference for the present side.
numbers.py       The numbers of the potential field: zero forces, unit forces, players and walls; computing time.
paths.py         Paths through the potential field: steadiness, retreat, indecision.
point_world.py   The point-mass simulator that the author tried first, with the team's own forces and steering.
points.py        Scenes of the point simulator: a dribbler on its way to the goal, and players in its way.
robots.py        The scenes of the point simulator with robots, ball and sensors: the full simulator.
"""
