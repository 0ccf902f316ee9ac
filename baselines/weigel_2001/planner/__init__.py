"""Plan paths past obstacles by a potential field on a grid.  [Heinemann 2006, 3]  MH09 to MH18, MH25

The planner of Weigel et al. as Heinemann et al. describe it, and their own, which predicts where obstacles move.
It knows neither team nor match: places [m] and velocities in a pitch's frame go in, and a plan comes out. A "way" is a
row of grid cells; the "path" is the smoothed line that a robot drives.

    from soccer_env.baselines.weigel_2001.planner import Planner

    plan = Planner().plan(robot=(4.0, 3.0), target=(4.0, -2.0), obstacles=[(2.8, 0.5, 1.0, 0.0)])
    plan.path, plan.time, plan.ended, plan.iterations, plan.clearance()

Files:

    planner.py      `Planner`, for Python           plan.py         `Plan`: the result, measured and replayed
    settings.py     every number and switch         records.py      the records of obstacles, plans, scratch arrays
    potential.py    forces and their gradient       stepping.py     from cell to cell, and how long that takes
    walking.py      one pass over the grid          searching.py    the search out of a local minimum, its queue
    planning.py     passes until the time agrees, and the path that a robot drives
    travelling.py   a point that plans anew every cycle
    measuring.py    clearance, turn, forces         drawing.py      pictures of plans and of travels

Teams call the kernel `planning.plan_way`, with a `records.SCRATCH` to work in.
"""

from soccer_env.baselines.weigel_2001.planner.plan import Plan
from soccer_env.baselines.weigel_2001.planner.planner import Planner
from soccer_env.baselines.weigel_2001.planner.settings import PlannerSettings
from soccer_env.baselines.weigel_2001.planner.travelling import Travel

__all__ = ["Plan", "Planner", "PlannerSettings", "Travel"]
