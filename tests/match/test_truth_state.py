"""`Match.state()`: the truth by name, and what a half-turn of the field does to it."""

import numpy as np
import pytest

from soccer_env import Match, truth_state
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


def test_the_state_is_the_truth_by_name() -> None:
    match = in_motion("middle-size-2006")
    robot, ball, names = match.robots[0, 3], match.balls[0], match.state_names
    told = dict(zip(names, match.state()[0].tolist(), strict=True))
    assert told["ball_roll_y"] == pytest.approx(ball["roll_y"] / match.league.ball.top_speed)
    assert told["away_1_cos"] == pytest.approx(np.cos(robot["heading"]))
    assert told["away_1_sin"] == pytest.approx(np.sin(robot["heading"]))
    assert told["away_1_walk_left"] == pytest.approx(robot["walk"]["left"] / match.league.drive.forward)
    assert told["away_1_x"] == pytest.approx(robot["x"] / (6.0 + match.league.pitch.goal_depth))
    assert told["away_1_present"] == 1.0 and told["home_2_present"] == 0.0
    assert len(names) == len(set(names)) == len(truth_state.entries(3))
