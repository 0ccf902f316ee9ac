"""Every entry of every observation and of `state()` is what a formula written anew says, for every robot.

The scene has both halves, unequal teams that stand askew, a robot of away sent off, a score of 3:1 and odd clocks.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.match.truth_state import SIDES, WholeTruth
from soccer_env.types import Phase
from tests.observations import formulas, formulas_believed
from tests.scenes.staging import LEAGUES, scatter

FLAGS = ("present", "seen", "teammate", "held", "keeper", "active", "upright", "placing", "touch_head")
SIZES = [(2, 4), (1, 1), (6, 5)]  # home, away: some slots stay empty, all are full


def staged(league: str, home: int = 2, away: int = 4, **settings: Any) -> Match:
    """Return matches in both halves and both directions of play, the last without an end, all their records unlike."""
    match = Match(league, home=home, away=away, matches=4, seed=1, minutes=2.0, **settings)
    rng = np.random.default_rng(4)
    scatter(match, rng)
    drive, robots, game = match.league.drive, match.robots, match.matches
    fastest = {"forward": drive.forward, "left": drive.forward, "turn": drive.turn}
    most = {"vx": drive.forward, "vy": drive.forward, "omega": drive.turn, "pan": 1.5, "tilt": 1.0}
    asked = dict.fromkeys(("forward", "left", "turn", "kick"), 1.0)
    for records, limits in ((robots, most), (robots["walk"], fastest), (robots["command"], asked)):
        for name, limit in limits.items():
            records[name] = rng.uniform(-0.9, 0.9, robots.shape) * limit
    robots["kick_clock"] = rng.choice([0.0, 0.3, -0.2], robots.shape)
    robots["gait_phase"] = rng.integers(0, max(drive.gait_steps, 1), robots.shape)
    robots["has_ball"], robots["fallen"] = rng.integers(0, 2, (2, *robots.shape))
    clocks = ("pushing", "keeper_pushing", "charging", "holding", "handling", "penalty", "area_clock", "crowd_clock")
    for name in (*clocks, "trespass"):
        robots[name] = rng.uniform(0.0, 5.0, robots.shape) * rng.integers(0, 2, robots.shape)
    robots["trespass"] -= 2.0  # below 0: it has that long to walk out
    robots["yellow"], game["taker"] = rng.integers(0, 3, robots.shape), rng.integers(-1, home + away, 4)
    game["still_clock"] = [0.0, 7.5, 12.0, 3.0]
    for name in ("vx", "vy", "roll_x", "roll_y"):
        match.balls[name] = rng.uniform(-0.7, 0.7, 4) * match.league.ball.top_speed
    game["half"], game["home_direction"], game["half_length"][3] = [0, 1, 0, 1], [1.0, -1.0, -1.0, 1.0], np.inf
    game["score"], game["clock"], game["placing"] = (3, 1), 17.3, [0, 1, 0, 1]
    game["phase"], game["restart_team"] = [Phase.PLAY, Phase.FREE_KICK, Phase.CORNER_KICK, Phase.OVER], [-1, 1, 0, -1]
    if away > 1:
        robots["active"][:, home + 1] = 0
    return match


def fill(records: np.ndarray, rng: np.random.Generator) -> None:
    """Put other numbers into each field of records."""
    for name in records.dtype.names or ():
        field = records[name]
        if field.dtype.names:
            fill(field, rng)
        elif field.dtype.kind == "f":
            field[...] = rng.uniform(-1.2, 1.2, field.shape)
        else:
            field[...] = rng.integers(0, 2 if name in FLAGS else 4, field.shape)
    for name in {"age", "distance", "confidence", "infrared", "seconds_left", "lines"} & set(records.dtype.names or ()):
        records[name] = np.abs(records[name]) * (records[name] > -1.0)  # some are exactly 0


def assert_told(names: list[str], told: np.ndarray, formula: dict[str, float], where: str) -> None:
    """Assert that every entry of an observation equals its formula, and that no entry lacks a formula."""
    assert set(names) == set(formula), "an entry without a formula, or a formula without its entry"
    wrong = {n: (t, formula[n]) for n, t in zip(names, told.tolist(), strict=True) if not abs(t - formula[n]) <= 2e-6}
    assert not wrong, f"{where}: told, expected {wrong}"


def assert_formulas(match: Match, formula: Callable[[Match, int, int], dict[str, float]]) -> None:
    """Assert that what every robot of every match observes is what a formula says."""
    if isinstance(match.settings.observe, str):
        match.observations[...] = np.nan  # every number is written
        match.batch.observe_anew(0, match.count)
    for m, r in np.ndindex(*match.robots.shape):
        where = f"{match.agents[r]} of match {m}"
        assert_told(match.observation_names, match.observations[m, r], formula(match, m, r), where)


@pytest.mark.parametrize(("home", "away"), SIZES)
@pytest.mark.parametrize("league", LEAGUES)
def test_every_entry_of_the_truth_is_its_formula(league: str, home: int, away: int) -> None:
    match = staged(league, home, away, observe="truth")
    assert_formulas(match, formulas.truth_of)


@pytest.mark.parametrize("league", LEAGUES)
def test_with_ideal_senses_a_belief_is_the_truth(league: str) -> None:
    """What is more than the truth: rates as the moving robot sees them, all of it seen just now."""
    match = staged(league, observe="belief", senses="ideal")
    match.matches["half_length"] = match.settings.half_length

    def formula(match: Match, m: int, r: int) -> dict[str, float]:
        sure = {name: 1.0 for name in match.observation_names if name.endswith("confidence")}
        rest = {name: 0.0 for name in match.observation_names if name.endswith("age") or name.startswith("obstacle")}
        clocks = formulas.clocks_of(match.robots[m, r], "own_")
        still = {"ball_still": formulas.soft(match.matches["still_clock"][m], 10.0)}
        still["own_barred"] = float(formulas.is_barred(match, m, r))
        told = formulas.truth_of(match, m, r) | formulas.rates_of(match, m, r) | sure | rest | clocks | still
        return told | {name: told[f"{name.rpartition('_')[0]}_present"] for name in sure if name[-12] in "0123456789"}

    assert_formulas(match, formula)


@pytest.mark.parametrize(
    ("observe", "formula"), [("belief", formulas_believed.belief_of), ("percepts", formulas_believed.percepts_of)]
)
@pytest.mark.parametrize("league", LEAGUES)
def test_every_entry_of_what_is_believed_and_sensed_is_its_formula(league, observe, formula) -> None:
    match, rng = staged(league, observe=observe), np.random.default_rng(5)
    for records in (match.beliefs, match.tracks, match.percepts):
        fill(records, rng)
    assert_formulas(match, formula)


@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("league", LEAGUES)
def test_every_entry_of_the_state_is_its_formula(league: str, side: str) -> None:
    match = staged(league)
    names = [entry.name for entry in match.state_entries(side)]
    for m, told in enumerate(match.state(side)):
        assert_told(names, told, formulas.state_of(match, m, side, match.settings.max_players), f"match {m}")


def renamed(key: str, names: dict[str, str]) -> str:
    """Return a name with another beginning, if it has one of some beginnings."""
    begins = next((old for old in names if key.startswith(old)), "")
    return names.get(begins, "") + key.removeprefix(begins)


@pytest.mark.parametrize("league", LEAGUES)
def test_the_whole_truth_of_a_robot_is_the_state_of_its_team_with_itself_first(league: str) -> None:
    match = staged(league, observe=WholeTruth(5))
    match.observations[...] = match.settings.observe(match)

    def formula(match: Match, m: int, r: int) -> dict[str, float]:
        home = match.settings.home
        own = r if r < home else r - home
        others = [number for number in range(5) if number != own]
        names = {f"own_{own}_": "self_"} | {f"own_{n}_": f"teammate_{i}_" for i, n in enumerate(others)}
        names |= {f"other_{n}_": f"opponent_{n}_" for n in range(5)}
        told = formulas.state_of(match, m, "home" if r < home else "away", 5)
        return {renamed(key, names): value for key, value in told.items()}

    assert_formulas(match, formula)
