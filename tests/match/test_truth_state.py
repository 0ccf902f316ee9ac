"""`Match.state()`: the truth by name, and what a half-turn of the field does to it."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.match import truth_state
from tests.scenes.staging import LEAGUES


def in_motion(league: str) -> Match:
    """Return matches in which every record of ball and robots has some value."""
    match, rng = Match(league, home=2, away=3, matches=4, seed=1, minutes=2.0), np.random.default_rng(1)
    for records in (match.balls, match.robots, match.robots["walk"]):
        for name in records.dtype.names or ():
            if records[name].dtype.kind == "f":
                records[name] = rng.uniform(-0.1, 0.1, records.shape)
    match.matches["home_direction"] = [1.0, -1.0, 1.0, -1.0]
    return match


@pytest.mark.parametrize("league", LEAGUES)
def test_a_half_turn_of_the_field_turns_round_what_the_entries_say(league: str) -> None:
    match = in_motion(league)
    before = match.state()
    for records in (match.balls, match.robots):
        for name in {"x", "y", "vx", "vy", "roll_x", "roll_y"} & set(records.dtype.names or ()):
            records[name] *= -1.0
    match.robots["heading"] += np.pi
    match.matches["home_direction"] *= -1.0
    signs = np.array([entry.half_turn for entry in truth_state.entries(3)], np.float32)
    np.testing.assert_allclose(match.state(), before * signs, atol=1e-6)
    assert np.count_nonzero(signs < 0.0) == 7 + 6 * 6 and before[:, signs < 0.0].any(axis=0).sum() == 7 + 6 * 5
