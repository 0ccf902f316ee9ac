"""Observations: as their layout says, own goal behind, the nearest first, always in [-1, 1]."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.observations import layout
from soccer_env.observations.truth import PLAYER, PLAYER_SIZE
from tests.scenes.staging import LEAGUES, place, put, scatter, stage


def entry(match: Match, r: int, name: str, m: int = 0) -> float:
    """Return one number of a robot's observation by its name."""
    return float(match.observations[m, r, match.observation_names.index(name)])


@pytest.mark.parametrize(("league", "size"), [("legged-2001", 73), ("middle-size-2006", 101)])
def test_the_layout_names_every_number_once(league: str, size: int) -> None:
    names = [item.name for item in layout(find_league(league))]
    assert len(names) == len(set(names)) == size == len(Match(league, seed=0).observation_names)
    assert len(PLAYER) == PLAYER_SIZE


@pytest.mark.parametrize(("league", "size"), [("legged-2001", 93), ("middle-size-2006", 126)])
def test_the_layout_of_beliefs_names_every_number_once(league: str, size: int) -> None:
    names = [item.name for item in layout(find_league(league), "belief")]
    assert len(names) == len(set(names)) == size
    assert ("obstacle_near" in names) is (league == "legged-2001")  # the only league with a ranger


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize(("home", "away"), [(1, 1), (3, 5), (11, 11)])
def test_the_layout_is_the_same_at_every_team_size(league: str, home: int, away: int) -> None:
    assert Match(league, home=home, away=away, seed=0).observation_names == Match(league, seed=0).observation_names


@pytest.mark.parametrize("league", LEAGUES)
def test_wild_states_stay_in_the_box(league: str) -> None:
    match = Match(league, home=3, away=3, matches=64, seed=0)
    rng = np.random.default_rng(0)
    for field in ("x", "y", "vx", "vy", "omega", "heading"):
        match.robots[field] = rng.normal(0.0, 100.0, match.robots.shape)
    for field in ("x", "y", "vx", "vy"):
        match.balls[field] = rng.normal(0.0, 100.0, 64)
    match.matches["score"] = rng.integers(0, 1000, (64, 2))
    match.batch.observe_anew(0, 64)
    assert np.abs(match.observations).max() <= 1.0


def test_entries_mean_what_the_layout_says() -> None:
    match = stage("middle-size-2006", home=2, away=1)
    put(match, 0, -5.0, 1.0)
    put(match, 1, 0.0, 0.0, np.pi / 2, forward=1.3)
    put(match, 2, 0.0, 3.0, -np.pi / 2)
    place(match, ball=(-2.0, 0.0, 0.0, 2.2))
    match.batch.observe_anew(0, 1)
    diagonal = np.hypot(12.0, 8.0)
    facts = {
        "own_x": 0.0, "own_cos": 0.0, "own_sin": 1.0, "own_forward": 0.5, "own_left": 0.0, "ball_x": 0.0,
        "ball_y": 2.0 / diagonal, "ball_cos": 0.0, "ball_sin": 1.0, "ball_vx": 2.2 / (2.2 + 1.1), "ball_vy": 0.0,
        "goal_x": 0.0, "goal_y": -6.0 / diagonal, "own_goal_y": 6.0 / diagonal, "keeper": -1.0, "active": 1.0,
        "in_play": 1.0, "score": 0.0, "teammate_0_present": 1.0, "teammate_0_x": 1.0 / diagonal,
        "teammate_0_y": 5.0 / diagonal, "teammate_1_present": 0.0, "opponent_0_x": 3.0 / diagonal,
        "opponent_0_cos": -1.0, "opponent_1_present": 0.0,
    }  # fmt: skip
    for name, value in facts.items():
        assert entry(match, 1, name) == pytest.approx(value, abs=1e-6), name
    assert entry(match, 0, "keeper") == 1.0 and entry(match, 2, "keeper") == -1.0


@pytest.mark.parametrize(("observe", "senses"), [("truth", "sensors"), ("belief", "ideal")])
def test_the_heading_of_another_player_is_seen_from_the_robots_own(observe: str, senses: str) -> None:
    match = stage("middle-size-2006", home=2, away=1, observe=observe, senses=senses)
    place(match, robots={0: (0.0, 0.0, 0.4), 1: (1.0, 1.0, 1.5), 2: (-1.0, 2.0, -2.0)})
    match.batch.observe_anew(0, 1)
    for r, name, angle in ((0, "teammate_0", 1.1), (0, "opponent_0", -2.4), (1, "teammate_0", -1.1)):
        assert entry(match, r, f"{name}_cos") == pytest.approx(np.cos(angle), abs=1e-6)
        assert entry(match, r, f"{name}_sin") == pytest.approx(np.sin(angle), abs=1e-6), "left of its own is positive"


@pytest.mark.parametrize("league", LEAGUES)
def test_slots_hold_the_nearest_first_and_drop_the_farthest(league: str) -> None:
    match = Match(league, home=11, away=11, seed=0)
    scatter(match, np.random.default_rng(4), share=0.95)
    match.rebuild()
    match.batch.observe_anew(0, 1)
    robots, slots = match.robots[0], match.league.slots
    for r in range(22):
        gaps = np.hypot(robots["x"] - robots["x"][r], robots["y"] - robots["y"][r])
        for kind, team, count in (
            ("teammate", robots["team"][r], slots.teammates),
            ("opponent", 1 - robots["team"][r], slots.opponents),
        ):
            expected = sorted(gaps[other] for other in range(22) if other != r and robots["team"][other] == team)
            seen = [
                np.hypot(entry(match, r, f"{kind}_{slot}_x"), entry(match, r, f"{kind}_{slot}_y"))
                for slot in range(count)
            ]
            diagonal = np.hypot(match.league.pitch.length, match.league.pitch.width)
            np.testing.assert_allclose(np.array(seen) * diagonal, expected[:count], rtol=1e-4)


def test_the_last_command_is_seen_clipped() -> None:
    match = Match(home=1, away=1, seed=0)
    match.step(np.array([[[3.0, -0.25, 0.5, -7.0], [0, 0, 0, 0]]]))
    names = ("last_forward", "last_left", "last_turn", "last_kick")
    assert [entry(match, 0, name) for name in names] == [1.0, -0.25, 0.5, -1.0]
