"""`state()` from a team's side: turned at half-time, own team first; that of an end; and as an observation."""

import re
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, WholeTruth, soccer_v0
from tests.scenes.staging import LEAGUES

PLACES = ("x", "y", "vx", "vy", "roll_x", "roll_y")


def in_motion(league: str, home: int = 2, away: int = 3) -> Match:
    """Return matches in which every record of ball and robots has some value."""
    match, rng = Match(league, home=home, away=away, matches=2, seed=1, minutes=2.0), np.random.default_rng(1)
    for records in (match.balls, match.robots, match.robots["walk"]):
        for name in records.dtype.names or ():
            if records[name].dtype.kind == "f":
                records[name] = rng.uniform(-0.1, 0.1, records.shape)
    match.matches["score"] = [(3, 1), (0, 2)]
    match.matches["restart_team"] = [0, 1]
    return match


def turn_round(match: Match) -> None:
    """Turn a match by half a turn of the field, as if the teams had changed ends."""
    for records in (match.balls, match.robots):
        for name in {*PLACES} & {*(records.dtype.names or ())}:
            records[name] *= -1.0
    match.robots["heading"] += np.pi
    match.matches["home_direction"] *= -1.0


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("side", ["home", "away"])
def test_a_teams_side_shows_no_half_time(league: str, side: str) -> None:
    match = in_motion(league)
    before, field = match.state(side), match.state()
    turn_round(match)
    np.testing.assert_allclose(match.state(side), before, atol=1e-6)
    assert np.abs(match.state() - field).max() > 0.01


@pytest.mark.parametrize("league", LEAGUES)
def test_a_teams_side_names_its_own_players_first(league: str) -> None:
    match = in_motion(league)
    sides = ("field", "home", "away")
    field, home, away = (dict(zip(names(match, side), match.state(side)[0], strict=True)) for side in sides)
    assert home["own_1_x"] == field["home_1_x"] and home["other_2_cos"] == field["away_2_cos"]
    assert away["own_2_x"] == -field["away_2_x"] and away["other_1_sin"] == -field["home_1_sin"]
    assert away["own_2_walk_left"] == field["away_2_walk_left"] and away["other_2_present"] == 0.0
    assert (home["goals_own"], home["goals_other"]) == (field["goals_home"], field["goals_away"])
    assert (away["goals_own"], away["goals_other"]) == (field["goals_away"], field["goals_home"])
    assert home["restart_own"] == 1.0 == -away["restart_own"] and home["ball_vy"] == -away["ball_vy"]
    assert home["own_direction"] == away["own_direction"] == 1.0 and {*home} == {*away} and len({*home}) == len(home)
    assert all(entry.frame != "field" for entry in match.state_entries("away"))


def names(match: Match, side: str) -> list[str]:
    return [entry.name for entry in match.state_entries(side)]


def test_a_setting_says_whose_state_it_is_by_default() -> None:
    env = soccer_v0.parallel_env(home=2, away=1, opponents="chaser", state_side="away")
    env.reset(seed=1)
    env.step({agent: np.ones(4) for agent in env.agents})
    assert np.array_equal(env.state(), env.unwrapped.match.state("away")[0])
    assert env.state_names[:2] == ["clock", "half"] and "own_0_x" in env.state_names
    assert env.state_space.contains(env.state()) and not np.array_equal(env.state(), env.state("field"))


def test_the_state_of_an_end_is_the_one_before_the_new_episode() -> None:
    """Against matches that do not begin anew, of the same seed."""
    settings: Any = {"home": 2, "away": 2, "matches": 4, "seed": 3, "max_cycles": 30, "state_side": "home"}
    match, plain = Match(autoreset="same_step", **settings), Match(**settings)
    match.matches["step"][2] = plain.matches["step"][2] = 20  # one of them ends earlier
    assert "state" not in match.final
    with pytest.raises(KeyError):
        match.final["state"]
    rng = np.random.default_rng(1)
    for _ in range(10):
        actions = rng.uniform(-1.0, 1.0, (4, 4, 4))
        match.step(actions)
        plain.step(actions)
    assert match.ended.tolist() == [2] and plain.truncated.tolist() == [False, False, True, False]
    assert np.array_equal(match.final["state"], plain.state()[[2]])
    assert np.array_equal(match.final.state("away"), plain.state("away")[[2]])
    assert not np.array_equal(match.state()[2], match.final["state"][0])


def test_a_whole_truth_has_every_player_where_the_truth_has_the_nearest() -> None:
    match = Match(home=6, away=5, observe=WholeTruth(6), matches=2, seed=1)
    truth = Match(home=6, away=5, matches=2, seed=1)
    entries = match.observation_names
    assert len([name for name in truth.observation_names if re.fullmatch("opponent.*present", name)]) == 3
    assert sum(name.endswith("_present") for name in entries) == 12 and len({*entries}) == len(entries)
    row = dict(zip(entries, match.observations[1, 4], strict=True))
    state = dict(zip(names(match, "home"), match.state("home")[1], strict=True))
    assert row["self_x"] == state["own_4_x"] and row["self_keeper"] == 0.0 and row["ball_y"] == state["ball_y"]
    assert [row[f"teammate_{i}_y"] for i in range(5)] == [state[f"own_{i}_y"] for i in (0, 1, 2, 3, 5)]
    assert [row[f"opponent_{i}_x"] for i in range(6)] == [state[f"other_{i}_x"] for i in range(6)]
    away = dict(zip(entries, match.observations[0, 6], strict=True))
    told = dict(zip(names(match, "away"), match.state("away")[0], strict=True))
    assert away["self_keeper"] == 1.0 and away["teammate_4_present"] == 0.0 and away["teammate_0_x"] == told["own_1_x"]


def test_a_side_that_is_none_and_a_whole_truth_that_is_too_small_are_refused() -> None:
    for bad in ("left", None, 1):
        with pytest.raises(ValueError, match="state_side must be one of field, home, away, got"):
            Match(home=1, away=1, state_side=bad)
    for bad in ("left", 1):
        with pytest.raises(ValueError, match="side must be one of field, home, away, got"):
            Match(home=1, away=1).state(bad)
    with pytest.raises(ValueError, match="players of WholeTruth must be at least the match's 3 a side, got 2"):
        Match(home=3, away=1, observe=WholeTruth(2))
    with pytest.raises(ValueError, match="players must be 1 to 11, got 12"):
        WholeTruth(12)


@pytest.mark.parametrize(
    ("settings", "expected"),
    [
        ({"home": 2, "away": 3, "opponents": "chaser", "max_cycles": 50, "minutes": 1.0}, (2, 4, 50)),
        ({"actions": "discrete", "minutes": 1.0, "action_repeat": 8}, (6, 12, 120)),
        ({"actions": "multi", "minutes": 1.0, "action_repeat": 8}, (6, 20, 120)),
        ({"scene": "empty-goal", "episode": "drill", "home": 1, "away": 1, "actions": "full"}, (2, 7, 960)),
        ({"episode": "goal"}, (6, 4, None)),
    ],
)
def test_the_sizes_that_pymarl_asks_for(settings: dict[str, Any], expected: tuple[Any, ...]) -> None:
    env = soccer_v0.parallel_env(**settings)
    info = env.get_env_info()
    assert (info["n_agents"], info["n_actions"], info["episode_limit"]) == expected
    assert info["state_shape"] == env.state().size
    assert info["obs_shape"] == env.observation_space(env.possible_agents[0]).shape[0]
