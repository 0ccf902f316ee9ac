"""Numbers of a user's own that no match could be played with: refused with what is allowed, and whose they are."""

from typing import Any

import gymnasium
import numpy as np
import pytest

from soccer_env import Match, soccer_v0
from soccer_env.scenes import Scene


def no_place(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Put the ball nowhere."""
    ball["x"] = np.nan


def no_team(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Give a robot to a team that there is not."""
    robots["team"][0] = 7


def no_number(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Give a robot another number."""
    robots["number"][1] = -3


def far(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Put the ball out of the hall."""
    ball["x"] = 99.0


def behind_the_boards(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Put a robot where the spectators stand."""
    robots["y"][1] = -1.2


def one_in_another(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Put both robots on one point."""
    for name in ("x", "y"):
        robots[name] = 0.5


def close(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Put both robots trunk at trunk, legs in each other, and the ball into a goal."""
    robots["heading"], robots["x"], robots["y"] = 0.0, 0.5, [0.0, 0.12]
    ball["x"] = 0.5 * league.pitch.length + 0.2


@pytest.mark.parametrize(
    ("place", "message"),
    [
        (far, r"scene 'mine' must put the ball at x = -1.8 to 1.8 m, got 99$"),
        (behind_the_boards, r"scene 'mine' must put away_0 at y = -1 to 1 m, got -1.2$"),
        (one_in_another, r"scene 'mine' must put away_0 at least 0.077 m from home_0, got 0$"),
        (no_place, "scene 'mine' must leave finite numbers, got x nan of the ball"),
        (no_team, "scene 'mine' must leave team of home_0 0, got 7"),
        (no_number, "scene 'mine' must leave number of away_0 0, got -3"),
    ],
)
def test_a_scene_that_leaves_nonsense_is_blamed_itself(place: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Match(home=1, away=1, scene=Scene("mine", "nonsense", place=place), seed=1)


def test_bodies_that_overlap_a_little_are_pushed_apart() -> None:
    match = Match(home=1, away=1, scene=Scene("mine", "a throng", place=close), seed=1)
    for _ in range(25):
        match.step(np.zeros((1, 2, 4)))
    x, y = (float(np.diff(match.robots[name][0])[0]) for name in ("x", "y"))
    assert np.hypot(x, y) > 0.12


def test_near_misses_of_settings_are_named_by_every_maker() -> None:
    with pytest.raises(TypeError, match="unknown setting 'opponent', did you mean 'opponents'"):
        soccer_v0.parallel_env(opponent="chaser")  # type: ignore[call-arg]
    with pytest.raises(TypeError, match="unknown setting 'autoreset', did you mean 'autoreset_mode'"):
        gymnasium.make_vec("soccer_env/Legged2001-1v1-v0", num_envs=2, autoreset="same_step")
