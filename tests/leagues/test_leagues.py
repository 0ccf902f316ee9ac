"""Leagues: presets as published, frozen, and every number checked with a message that names it."""

import importlib
import pkgutil
from dataclasses import FrozenInstanceError, fields, is_dataclass, replace
from math import inf, nan
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from soccer_env import leagues
from soccer_env.leagues import LEAGUES, Pair, find_league, legged_2001, middle_size_2006
from soccer_env.leagues.constants import CONSTANTS, constants_of

PARTS = ("pitch", "ball", "body", "materials", "drive", "kicker", "head", "rules", "slots", "substeps")


def numbers() -> list[tuple[str, str, str]]:
    """Return every number of every part of both leagues, as (league, part, field)."""
    found = []
    for name in ("legged-2001", "middle-size-2006"):
        for part in PARTS:
            record = getattr(LEAGUES[name], part)
            for field in fields(record):
                value = getattr(record, field.name)
                if isinstance(value, (int, float)) and not isinstance(value, bool):
                    found.append((name, part, field.name))
    return found


SIGNED = {"tip_x", "disc_x", "hind_x", "tilt_low"}  # may be negative


@pytest.mark.parametrize("part", PARTS)
def test_no_other_number_may_be_negative(part: str) -> None:
    for league, where, field in numbers():
        if where == part and field not in SIGNED:
            record = getattr(LEAGUES[league], part)
            with pytest.raises(ValueError, match=field):
                replace(record, **{field: type(getattr(record, field))(-1)})


@pytest.mark.parametrize("part", PARTS)
@pytest.mark.parametrize("bad", [nan, inf, -inf, "1", None, True, np.float32("nan"), 1j])
def test_a_number_must_be_one_and_finite(part: str, bad: object) -> None:
    """A NaN of numpy's, or a word, used to reach the physics and end the process."""
    for league, where, field in numbers():
        if where == part:
            with pytest.raises(ValueError, match=field):
                replace(getattr(LEAGUES[league], part), **{field: bad})


def test_numbers_of_numpy_become_python_numbers() -> None:
    ball = replace(legged_2001.BALL, mass=np.float32(0.5), radius=np.float64(0.04))
    assert type(ball.mass) is float and type(ball.radius) is float and ball.mass == 0.5


LEAGUE, SMOOTH = legged_2001.LEAGUE, legged_2001.SMOOTH_BODY


@pytest.mark.parametrize(
    ("record", "changes", "message"),
    [
        (LEAGUE.drive, {"gait_steps": 2.5}, "gait_steps must be a whole number above 0, got 2.5"),
        (LEAGUE.substeps, {"least": 2.5}, "least must be a whole number, 1 to 1000, got 2.5"),
        (SMOOTH, {"corners": tuple(reversed(SMOOTH.corners))}, "counter-clockwise"),
        (SMOOTH, {"corners": ((0.0, 0.0), (0.1, 0.0))}, "counter-clockwise"),
        (SMOOTH, {"corners": ((-0.1, -0.1), (0.1, -0.1), (0.0, 0.0), (0.1, 0.1), (-0.1, 0.1))}, "counter-clockwise"),
        (
            SMOOTH, {"corners": ((-0.3, -0.1), (0.1, -0.1), (0.1, 0.1), (-0.3, 0.1))},
            r"Body\.reach must be at least 0\.316",
        ),
        (SMOOTH, {"disc_back": 0.1}, r"Body\.disc_back must be 0 for a hull, got 0\.1"),
        (LEAGUE.body, {"hind_y": 0.0}, "four posts, one in each quarter"),
        (LEAGUE.body, {"hind_x": 0.1}, "four posts, one in each quarter"),
        (LEAGUE.body, {"hind_x": -0.15}, r"Body\.reach must be at least 0\.181"),
        (LEAGUE.body, {"disc_radius": 0.0}, "either a disc_radius above zero or corners"),
        (LEAGUE.body, {"mass": 0.0}, r"Body\.mass must be a number above 0"),
        (Pair(0.5, 0.3), {"elasticity": 1.1}, r"Pair\.elasticity must be 0 to 1, got 1\.1"),
        (Pair(0.5, 0.3), {"friction": -0.3}, r"Pair\.friction must be a number of at least 0, got -0\.3"),
        (LEAGUE.pitch, {"goal_width": 9.0}, r"Pitch\.goal_width must be less than width 2\.0, got 9"),
        (LEAGUE.drive, {"kind": "hover"}, r"Drive\.kind must be one of gait, omnidirectional, differential"),
        (LEAGUE.drive, {"delay": 0.3}, r"Drive\.delay must be 0 to 0\.2, got 0\.3"),
        (LEAGUE.kicker, {"slowest": 3.0}, r"Kicker\.slowest must be at most fastest"),
        (LEAGUE.rules, {"half_minutes": 2e12}, r"Rules\.half_minutes must be .* at most 1e\+12, got 2"),
        (LEAGUE.slots, {"teammates": -1}, r"Slots\.teammates must be 0 to 11, got -1"),
        (LEAGUE.slots, {"teammates": 0, "opponents": 0}, "Slots must hold at least one"),
        (LEAGUE.substeps, {"least": 20}, r"Substeps\.least must be at most close 4, got 20"),
        (LEAGUE.substeps, {"iterations": 0}, r"Substeps\.iterations must be 1 to 1000, got 0"),
        (LEAGUE, {"control_rate": 0}, "control_rate must be 1 to 1000"),
        (LEAGUE, {"family": "Legged"}, "League.family must be .* got 'Legged'"),
        (LEAGUE, {"team_size": 12}, "team_size must be 1 to 11"),
        (LEAGUE, {"control_rate": 200}, r"Drive\.delay spans 20 control steps"),
        (LEAGUE, {"evaluation_placement": "walk"}, "evaluation_placement must be one of"),
    ],
)  # fmt: skip
def test_what_cannot_be_is_named(record: Any, changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        replace(record, **changes)


@pytest.mark.parametrize("name", LEAGUES)
def test_leagues_are_frozen_and_become_constants(name: str) -> None:
    league = LEAGUES[name]
    with pytest.raises(FrozenInstanceError):
        league.control_rate = 5  # type: ignore[misc]
    assert all(is_dataclass(getattr(league, part)) for part in PARTS)
    record = constants_of(league)
    assert record.dtype is CONSTANTS and record.shape == (1,)
    assert record["pitch_length"][0] == league.pitch.length and record["dt"][0] == 1 / league.control_rate
    assert record["delay_steps"][0] == {16: 2, 50: 5}[league.control_rate]


def modules_of_leagues() -> list[ModuleType]:
    names = [found.name for found in pkgutil.iter_modules(leagues.__path__)]
    found = [importlib.import_module(f"soccer_env.leagues.{name}") for name in names]
    return [module for module in found if hasattr(module, "LEAGUE")]


def test_each_league_draws_its_pitch() -> None:
    assert {legged_2001, middle_size_2006} <= set(modules_of_leagues())
    for module in modules_of_leagues():
        assert module.__doc__ is not None and "---+" in module.__doc__


def test_each_number_of_a_preset_has_its_source_beside_it() -> None:
    """A number without unit and source, or the word assumed, is a guess that nobody can find."""
    from pathlib import Path

    for module in modules_of_leagues():
        lines = Path(module.__file__ or "").read_text(encoding="utf-8").splitlines()
        for line in lines:
            code, _, comment = line.partition("#")
            value = code.strip().rstrip(",").partition("=")[2]
            if code.startswith("    ") and value and value.replace(".", "").replace("-", "").isdigit():
                assert comment or float(value) in (0.0, 1.0), f"{module.__name__}: {line.strip()}"


def test_an_unknown_league_names_those_that_exist() -> None:
    with pytest.raises(ValueError, match="unknown league 'cricket'; known: legged-2001, middle-size-2006"):
        find_league("cricket")
