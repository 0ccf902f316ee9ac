"""A floor for every scripted team in every drill, by sensors: later versions may improve them, never weaken them.

What was measured stands in the table of baselines/README.md; a floor lies well below, as few runs can tell.
"""

import pytest

from soccer_env.scenes import SCENES
from soccer_env.train.evaluate.drills import run_drill
from soccer_env.train.pages.tables.drills import TEAMS, drills_of

RUNS = 60
FLOORS: dict[str, dict[str, float]] = {  # [1] of the runs of a drill of the legged league
    "chaser": {
        "facing-wall": 0.9, "lost-ball-behind": 0.7, "ball-at-board": 0.45, "ball-in-corner": 0.45, "empty-goal": 0.8,
        "ball-behind-robot": 0.25,
    },
    "sacks-2001": {"facing-wall": 0.85, "lost-ball-behind": 0.6, "empty-goal": 0.6, "ball-behind-robot": 0.02},
}  # fmt: skip
CASES = [(team, drill, floor) for team, floors in FLOORS.items() for drill, floor in floors.items()]


@pytest.mark.parametrize(("team", "drill", "floor"), CASES)
def test_a_team_does_not_fall_below_its_floor(team: str, drill: str, floor: float) -> None:
    assert run_drill("legged-2001", SCENES[drill], team, RUNS) >= floor * RUNS


@pytest.mark.slow
@pytest.mark.parametrize("league", TEAMS)
def test_every_team_plays_every_drill_to_its_end(league: str) -> None:
    for scene in drills_of(league):
        for team in TEAMS[league]:
            assert 0 <= run_drill(league, scene, team, 2) <= 2
