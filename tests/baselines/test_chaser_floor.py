"""The chaser's floor at strength 1 with ideal senses: later versions may improve it, never weaken it."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league

LEAGUES = ("legged-2001", "middle-size-2006")


def finish(match: Match) -> Match:
    """Play matches to their end."""
    while not (match.terminated | match.truncated).all():
        match.step()
    match.close()
    return match


def score(
    league: str, home: str, away: str, matches: int, minutes: float, seed: int = 11, placement: str = "instant"
) -> np.ndarray:
    """Return the scores (M, 2) of 3 v 3 matches; in half of them the first team starts as away."""
    scores = []
    for swapped in (False, True):
        teams = {"home": away, "away": home} if swapped else {"home": home, "away": away}
        match = Match(
            league,
            home=3,
            away=3,
            matches=matches // 2,
            threads=2,
            seed=seed,
            minutes=minutes,
            controllers=teams,
            placement=placement,
            senses="ideal",
        )
        scores.append(finish(match).matches["score"][:, :: -1 if swapped else 1])
    return np.concatenate(scores)


def points(scores: np.ndarray) -> float:
    """Return the share of points of the first team; a draw is half."""
    ours, theirs = scores.T
    return float(((ours > theirs) + 0.5 * (ours == theirs)).mean())


def drill(league: str, scene: str, home: str, away: str, matches: int) -> float:
    """Return the share of drills that succeed."""
    match = Match(
        league, home=3, away=3, matches=matches, threads=2, seed=3, scene=scene, episode="drill",
        controllers={"home": home, "away": away}, senses="ideal",
    )  # fmt: skip
    succeeded = np.zeros(matches, bool)
    while not (match.terminated | match.truncated).all():
        match.step()
        succeeded |= match.events["drill"] == 1
    match.close()
    return float(succeeded.mean())


@pytest.mark.parametrize("league", LEAGUES)
def test_it_scores_into_an_empty_goal_close_by(league: str) -> None:
    assert drill(league, "empty-goal", "chaser", "still", 100) >= 0.95


@pytest.mark.parametrize(("league", "minutes", "rate"), [("legged-2001", 4.0, 0.5), ("middle-size-2006", 2.0, 2.0)])
def test_it_scores_against_a_team_that_stands_still(league: str, minutes: float, rate: float) -> None:
    assert score(league, "chaser", "still", 20, minutes)[:, 0].mean() / minutes >= rate


def test_its_middle_size_keeper_saves_shots() -> None:
    saved = drill("middle-size-2006", "shot-at-keeper", "still", "chaser", 300)
    hit_by_chance = drill("middle-size-2006", "shot-at-keeper", "still", "still", 300)
    assert saved >= 0.30 and saved > hit_by_chance + 0.20


@pytest.mark.parametrize(("league", "minutes"), [("legged-2001", 5.0), ("middle-size-2006", 2.0)])
def test_it_beats_random_players(league: str, minutes: float) -> None:
    assert points(score(league, "chaser", "random", 20, minutes)) >= 0.95


@pytest.mark.parametrize(("league", "minutes"), [("legged-2001", 5.0), ("middle-size-2006", 2.0)])
def test_without_strength_it_loses_to_itself(league: str, minutes: float) -> None:
    placement = find_league(league).evaluation_placement
    assert points(score(league, "chaser@0", "chaser", 20, minutes, 1, placement)) < 0.4


@pytest.mark.slow
@pytest.mark.whole
@pytest.mark.parametrize(("league", "minutes"), [("legged-2001", 10.0), ("middle-size-2006", 4.0)])
def test_every_step_of_strength_wins_points(league: str, minutes: float) -> None:
    """100 matches each against strength 1, which against itself has half of the points by symmetry.

    The table of baselines/README.md has all steps with 200 matches each;
    tests/train/pages/tables/test_tables.py asks it for a ladder.
    """
    placement = find_league(league).evaluation_placement  # as `soccer evaluate` and the table play
    ladder = [points(score(league, f"chaser@{s}", "chaser", 100, minutes, 1, placement)) for s in (0, 0.5)]
    assert all(lower < higher for lower, higher in zip(ladder, [*ladder[1:], 0.5], strict=True)), ladder
