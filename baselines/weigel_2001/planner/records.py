"""The records of the planner: obstacles, a plan, and scratch arrays."""

import numpy as np

MOST_CELLS = 384  # of a way: two and a half diagonals of the pitch
MOST_OBSTACLES = 32
MOST_ITERATIONS = 16
MOST_NODES = 2560  # of one search
GRID = 32768  # cells: 18 x 12 m with a margin of 1 m, at 10 cm

# How a pass over the grid ends. All but the first leave a gap, over which the path goes straight.
ARRIVED, LOOPED, ENCLOSED, CAPPED = range(4)
ENDINGS = (
    "arrived",  # it joins robot and target
    "looped",  # it came to a cell twice, and there is no search
    "enclosed",  # the search found no way out
    "capped",  # too many cells or evaluations
)

OBSTACLE = np.dtype(
    [
        ("x", "f8"),  # [m] where it is now
        ("y", "f8"),  # [m]
        ("vx", "f8"),  # [m/s]
        ("vy", "f8"),  # [m/s]
        ("radius", "f8"),  # [m]
    ]
)

CELL = np.dtype(
    [
        ("u", "i4"),  # cells from the middle of the pitch along x
        ("v", "i4"),  # cells from the middle of the pitch along y
        ("t", "f8"),  # [s] from now: the obstacles were moved to this time
        ("slope_x", "f8"),  # [1] gradient of the potential, (2); 0 where none was needed
        ("slope_y", "f8"),  # [1]
    ]
)

POINT = np.dtype([("x", "f8"), ("y", "f8")])  # [m]

PLAN = np.dtype(
    [
        ("robot", POINT),  # as asked for, but inside the grid
        ("target", POINT),  # the same
        ("side", "i8"),  # +1 or -1: the side of y that a way takes if both are equal
        ("count", "i8"),  # cells, and points of the path
        ("cells", CELL, (MOST_CELLS,)),  # from robot to target
        ("path", POINT, (MOST_CELLS,)),  # the cells' way, smoothed: begins at the robot, ends at the target
        ("ended", "i8"),  # ENDINGS
        ("length", "f8"),  # [m] of the path
        ("time", "f8"),  # [s] for the path at full speed: T a posteriori
        ("least_time", "f8"),  # [s] for the straight line: T_min
        ("iterations", "i8"),  # passes over the grid
        ("kept", "i8"),  # the pass, from 0, that the plan is
        ("converged", "i8"),  # 1: its T a priori and T a posteriori agree
        ("guesses", "f8", (MOST_ITERATIONS,)),  # [s] T a priori of each pass
        ("times", "f8", (MOST_ITERATIONS,)),  # [s] T a posteriori of each pass
        ("evaluations", "i8"),  # of the potential, in all passes
        ("searches", "i8"),  # for ways out of local minima, in all passes
    ]
)

NODE = np.dtype(
    [
        ("u", "i2"),
        ("v", "i2"),
        ("parent", "i2"),  # node from which it was reached; -1 for the first
        ("under", "i2"),  # the grid's mark of its cell before
        ("t", "f8"),  # [s] as of a CELL
        ("far", "f8"),  # [m] from the first node
        ("gap", "f8"),  # [m] to the nearest obstacle
        ("potential", "f8"),  # the node with the least is next
    ]
)

SCRATCH = np.dtype(
    [
        ("half_u", "i8"),  # cells on each side of the middle one
        ("half_v", "i8"),
        ("end_u", "i8"),  # cell at which a pass ends
        ("end_v", "i8"),
        ("goal", POINT),  # the exact place that attracts it
        ("clock", "f8"),  # [1] -1: time runs back along the way, +1: on
        ("tight", "f8"),  # [m] cells with no larger gap to an obstacle are not searched
        ("side", "i8"),
        ("count", "i8"),  # cells of the way
        ("lowest", "f8"),  # potential that the next search must get below
        ("evaluations", "i8"),
        ("searches", "i8"),
        ("way", CELL, (MOST_CELLS,)),  # in the order of planning
        ("path", POINT, (MOST_CELLS,)),
        ("nodes", NODE, (MOST_NODES,)),
        ("heap", "i4", (MOST_NODES,)),
        ("marks", "i2", (GRID,)),  # 0; 1 + number of a cell of the way; -1 - number of a node. All 0 between passes
    ]
)
