"""The clocks in beliefs and states run with the referee's, on their scales."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.types import Foul
from tests.scenes.staging import place, put_ball, set_phase, stand


def named(match: Match, r: int = 0) -> dict[str, float]:
    """Return what robot r of the first match observes, by name."""
    return dict(zip(match.observation_names, match.observations[0, r].tolist(), strict=True))


def state_of(match: Match) -> dict[str, float]:
    """Return the state of the first match by name."""
    return dict(zip(match.state_names, match.state()[0].tolist(), strict=True))


def test_a_ball_that_lies_for_ten_seconds_shows_half_of_the_scale() -> None:
    match = Match(home=1, away=1, seed=1, observe="belief")
    set_phase(match, 0)
    place(match, ball=(0.0, 0.0, 0.0), robots={0: (-1.0, 0.5), 1: (1.0, 0.5)})
    shown = []
    for _ in range(10 * match.league.control_rate):
        match.step(stand(match))
        shown.append(named(match)["ball_still"])
    assert shown == sorted(shown) and shown[-1] == pytest.approx(0.5) == state_of(match)["ball_still"]
    assert named(match, 1)["ball_still"] == shown[-1]
    put_ball(match, 0.8, 0.0)
    match.matches["still_x"] = 0.0
    match.rebuild()
    match.step(stand(match))
    assert named(match)["ball_still"] == 0.0, "it has moved on"


def test_a_whistle_for_pushing_starts_the_penalty_that_the_robot_is_told() -> None:
    match = Match(home=2, away=1, seed=1, observe="belief")
    set_phase(match, 0)
    place(match, ball=(1.5, -0.8, 0.0), robots={0: (-1.2, 0.0), 1: (-0.22, 0.0), 2: (0.0, 0.0, np.pi)})
    walk = stand(match)
    walk[0, 1, 0] = 1.0
    for _ in range(6 * match.league.control_rate):
        before = named(match, 1)["own_pushing"]
        match.step(walk)
        if match.robot_events["foul"][0, 1] == Foul.PUSHING:
            break
    assert before == pytest.approx(3.0 / 4.0, abs=0.02), "three seconds of contact are allowed"
    assert named(match, 1)["own_pushing"] == 0.0 and named(match, 1)["own_penalty"] == pytest.approx(0.75, abs=0.01)
