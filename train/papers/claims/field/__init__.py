"""The potential field that a dribbler follows, in a world of points and with robots.

Points have neither camera nor surface: distances between them count from the middle (MS54). Robots' count from camera
to surface, as the sensors gave them (MS42); beside it from middle to middle.

constants.py     Which constants the potential field needs, and whether those of points serve robots.
cost.py          What the field costs to compute.
forces.py        The forces of the potential field: exponents, the goal's pull, the cosine, walls.
minima.py        Local minima and what is left of indecision, in the point simulator and in the full one.
movers.py        Keeping one's side more often, when others move.
numbers.py       The numbers of the potential field: who exerts no force, where a force is 1, players and walls.
paths.py         Ways through the potential field: steadiness, retreat, indecision.
point_runs.py    What came of the runs of points: paths, changes of side, clearances, arrivals.
point_world.py   The point-mass simulator that the author tried first, with the team's own forces and steering.
points.py        Scenes of the point simulator: a dribbler on its way to the goal and others in its way.
robots.py        The scenes of the point simulator with robots, ball and sensors: the full simulator.
"""
