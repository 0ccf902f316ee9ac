"""The numbers and switches of the planner.  [Heinemann 2006, 3]

The paper gives the two equations, the speed and the threshold; numbers marked "assumed" are ours. Every idea that the
paper tests with and without is a switch.
"""

from dataclasses import dataclass
from math import floor
from typing import ClassVar

from soccer_env.baselines.weigel_2001.planner.records import GRID, MOST_CELLS, MOST_ITERATIONS
from soccer_env.guards.checking import ABOVE_ZERO, raise_not_allowed
from soccer_env.leagues.options import Options

FORMS = {"scalar": 0, "vector": 1}
REPULSIONS = {"inverse": 0, "khatib": 1}
STEPPINGS = {"carried": 0, "quantised": 1}
FALLBACKS = {"best": 0, "first": 1, "last": 2}


@dataclass(frozen=True)
class PlannerSettings(Options):
    """The settings of the planner; `Planner(time_variant=False)` changes a switch by name."""

    NAMES = {"form": FORMS, "repulsion": REPULSIONS, "stepping": STEPPINGS, "fallback": FALLBACKS}
    BOUNDS = {
        "pitch_length": (1.0, 200.0), "pitch_width": (1.0, 200.0), "margin": (0.0, 10.0), "cell": (0.01, 1.0),
        "speed": (0.01, 100.0), "robot_radius": (0.0, 5.0), "reach": (0.01, 100.0), "floor": (0.001, 1.0),
        "border_reach": (0.01, 100.0), "gain": (0.0, 100.0), "border_gain": (0.0, 100.0),
        "attraction": ABOVE_ZERO, "gained": (0.0, 100.0), "last_cells": (2, MOST_CELLS),
        "most_evaluations": (100, 1_000_000), "most_iterations": (1, MOST_ITERATIONS), "damping": (0.0, 0.95),
        "threshold": ABOVE_ZERO, "smoothing": (0, 20),
    }  # fmt: skip
    ORDER: ClassVar[tuple[tuple[str, str, str], ...]] = (
        ("floor", "less than", "reach"),
        ("floor", "less than", "border_reach"),
    )

    # what is compared, 3
    time_variant: bool = True  # obstacles move as the plan goes on; False: they stand still, Weigel  MH15, MH17
    backward: bool = True  # from the target to the robot; False: from the robot to the target  MH13
    search: bool = True  # a way out of local minima; False: the plan ends there  MH12
    literal: bool = False  # T by the paper's words alone: not damped, of the cells, the last plan, no present  MH16

    # the pitch and the robot
    pitch_length: float = 12.0  # [m] of the middle-size pitch of 2006, Tribots 2005
    pitch_width: float = 8.0  # [m] the same
    margin: float = 1.0  # [m] beyond the lines in which ways may lie: the band of the same pitch
    speed: float = 2.6  # [m/s] of the robot, Heinemann 2006, 2  MH15
    robot_radius: float = 0.25  # [m] half of the 50 cm that a robot may take, rules of 2006

    # the potential field, (1), (2)
    cell: float = 0.1  # [m] alpha, assumed  MH10
    form: str = "scalar"  # sum of the forces' sizes; vector: size of their sum, as (1) is written  MH09
    repulsion: str = "inverse"  # size of a force kr (1/d - 1/d0); khatib: over d^2, Khatib 1986  MH09
    attraction: float = 1.0  # [1/m] ka: the target's force over its distance, assumed  MH09
    gain: float = 0.15  # [m] kr, assumed: 0.1 to 0.3 were tried  MH09
    reach: float = 1.0  # [m] d0, from surface to surface, assumed  MH09
    floor: float = 0.05  # [m] gap below which it grows evenly, assumed  MH09
    borders: bool = False  # True: the pitch's lines repel as well; (1) has none
    border_gain: float = 0.05  # [m] kr of a line, assumed
    border_reach: float = 0.35  # [m] d0 of a line, assumed
    stepping: str = "carried"  # the rest of a direction goes on to the next cell; quantised: to 45 degrees  MH11

    # the local search, 3
    last_cells: int = 8  # of the way, whose lowest potential the search must get below, assumed  MH12
    gained: float = 0.1  # [1] by which the search must get below it: a cell's worth of attraction, assumed  MH12
    most_evaluations: int = 4000  # of the potential in one plan, assumed: some tenths of a millisecond  MH12

    # the time T, 3
    threshold: float = 0.1  # [s] between T before and after, "less than 100 milliseconds", Heinemann 2006, 3  MH16
    damping: float = 0.5  # [1] share of the old T in the new one, assumed: 0.3 to 0.5 keep it from swinging  MH16
    most_iterations: int = 8  # assumed  MH16
    fallback: str = "best"  # the plan that is kept if none agrees, first and last beside it, assumed  MH16
    smoothing: int = 4  # cells on each side over which the driven path is a mean, assumed  MH16

    def __post_init__(self) -> None:
        super().__post_init__()
        cells = (2 * self.half_u + 1) * (2 * self.half_v + 1)
        if cells > GRID:
            size = f"{self.pitch_length:g} x {self.pitch_width:g} m and a margin of {self.margin:g} m"
            raise_not_allowed(
                self.where("cell"), f"so large that {size} are at most {GRID} cells, not {cells}", self.cell
            )

    @property
    def half_u(self) -> int:
        """Return the number of cells from the middle of the pitch to either end."""
        return floor((0.5 * self.pitch_length + self.margin) / self.cell)

    @property
    def half_v(self) -> int:
        """Return the number of cells from the middle of the pitch to either side."""
        return floor((0.5 * self.pitch_width + self.margin) / self.cell)
