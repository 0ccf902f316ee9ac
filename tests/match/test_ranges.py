"""Every field that a save holds has a range, and a number outside is refused before compiled code reads it."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.guards import ranges
from soccer_env.guards.ranges import ANY, FLAG, NUMBER, SIGN, first_out_of_range, number_places, ranged_record
from soccer_env.match import saving
from soccer_env.match.saving.saves import saved_arrays
from soccer_env.teams import registry
from soccer_env.types import COMMAND, GAZE
from tests.fuzz import targets

LEGGED = ["chaser", "learned", "random", "sacks-2001", "sacks-2001-future", "sacks-2001-tuned", "still", "walker"]
MIDDLE = ["chaser", "heinemann-2006", "learned-2006", "random", "still", "walker", "weigel-2001"]
SETTINGS: list[dict[str, Any]] = [
    *({"home": 1, "away": 1, "controllers": {"home": team, "away": "chaser"}, "senses": senses}
      for team in LEGGED for senses in (["ideal"] if team == "learned" else ["sensors"])),
    *({"league": "middle-size-2006", "home": 1, "away": 1, "controllers": {"home": team, "away": "chaser"}}
      for team in MIDDLE),
    {"home": 2, "away": 1, "observe": "percepts", "pose": "particles"},
    {"league": "middle-size-2006", "home": 1, "away": 2, "observe": "percepts", "pose": "particles"},
]  # fmt: skip
FREE = {"noise", "seed", "unused", "spare", "own"}  # fields in which all bits are allowed


@pytest.mark.parametrize("settings", SETTINGS, ids=str)
def test_every_field_that_a_save_holds_has_a_range(settings: dict[str, Any]) -> None:
    match = Match(**settings, seed=1)
    for name, array in saved_arrays(match, memory=True).items():
        assert array.dtype.names or array.dtype == bool or name == "seeds", name
        for place in number_places(array.dtype):
            assert place.range is not None, f"{place.path} of {name}"
            assert place.range != ANY or place.path.rpartition(".")[2] in FREE, f"{place.path} of {name}"
    match.load(match.save())


@pytest.mark.parametrize("name", targets.SETTINGS)
def test_no_match_leaves_its_ranges(name: str) -> None:
    """A range that is too narrow would refuse a sound save."""
    match = Match(**targets.SETTINGS[name], seed=3)
    for step in range(240):
        match.step(targets.actions_of(match, step))
        if step % 8 == 0:
            match.load(match.save())
        if match.terminated.all():
            match.reset()


def test_a_field_without_a_range_cannot_be_declared() -> None:
    with pytest.raises(TypeError, match="field 'count' of a record has no range"):
        ranged_record([("place", "f8", NUMBER), ("count", "i8")])
    with pytest.raises(TypeError, match="field 'place' of a record has no range"):
        ranged_record([("place", np.dtype([("x", "f8")]))])


def test_equal_records_have_equal_ranges_and_those_of_a_replay_have_some() -> None:
    ranged_record([("only_here", "i8", FLAG)])
    with pytest.raises(TypeError, match="another record has the same fields"):
        ranged_record([("only_here", "i8", NUMBER)])
    assert all(place.range is not None for dtype in (COMMAND, GAZE) for place in number_places(dtype))
    assert {*LEGGED, *MIDDLE} == set(registry.NAMES), "every shipped team is looked at"
    assert [first_out_of_range(np.array([0, flag], np.uint8).view(bool), 2) for flag in (1, 2)] == ["", "a flag"]


INNER = ranged_record([("sign", "i2", SIGN), ("row", "i1", ranges.ROW_OR_NONE)])
OUTER = ranged_record(
    [("flag", "i1", FLAG), ("inner", INNER, (2,)), ("speeds", "f4", NUMBER, (3,)), ("bits", "u8", ANY)]
)


@pytest.mark.parametrize(
    ("field", "at", "value"),
    [
        ("flag", (), 2), ("flag", (), -1), ("inner.sign", 1, 0), ("inner.sign", 0, 2), ("inner.row", 1, 4),
        ("inner.row", 0, -2), ("speeds", 2, np.nan), ("speeds", 0, np.inf), ("speeds", 1, -2e6),
    ],
)  # fmt: skip
def test_a_number_outside_its_range_is_named_wherever_it_stands(field: str, at: Any, value: float) -> None:
    records = np.zeros((2, 5), OUTER)
    records["inner"]["sign"], records["bits"] = -1, 2**64 - 1
    records["inner"]["row"][..., 0], records["inner"]["row"][..., 1] = -1, 3
    assert first_out_of_range(records, robots=4) == ""
    numbers = records[1, 3:4][field.partition(".")[0]]
    numbers = numbers[field.partition(".")[2]] if "." in field else numbers
    numbers[(0, at) if at != () else 0] = value
    assert first_out_of_range(records, robots=4) == field
    assert first_out_of_range(records[0], robots=4) == ""


class Odd:
    """A team that remembers what no match knows."""

    name = "odd"
    memory_dtype = np.dtype([("last", "f8")])

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        memory["last"] = np.nan
        return view.stand()  # type: ignore[no-any-return]


def test_the_memory_of_a_team_of_ones_own_may_hold_anything() -> None:
    match = Match(home=1, away=1, seed=1, controllers={"home": Odd(), "away": "still"})
    match.step()
    match.load(match.save())
    assert np.isnan(match.squads[0].memory["last"]).all()


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("caught_by", 5), ("caught_by", -1), ("caught_by", 10**6), ("caught_leg", 4), ("caught_leg", 2_000_000),
        ("caught_gap", -1), ("caught_gap", 4),
    ],
)  # fmt: skip
def test_a_leg_that_nobody_can_hold_is_refused(field: str, value: int) -> None:
    match, forged = Match(home=2, away=2, seed=1), Match(home=2, away=2, seed=1)
    forged.robots[field][0, 1] = value
    with pytest.raises(ValueError, match=f"{field} of robots is out of range"):
        match.load(saving.dump(forged))


@pytest.mark.parametrize("holder", [2, 3])
def test_a_leg_is_held_by_another_robot_that_is_on_the_pitch(holder: int) -> None:
    """Robot 1 is caught by itself, or by robot 2, which is out; a robot on wheels is caught by nobody."""
    match, forged = Match(home=2, away=2, seed=1), Match(home=2, away=2, seed=1)
    forged.robots["active"][0, 2] = 0
    forged.robots["caught_by"][0, 1] = holder
    with pytest.raises(ValueError, match="caught_by of robots names a robot that cannot hold a leg"):
        match.load(saving.dump(forged))
    forged.robots["caught_by"][0, 1] = 1
    match.load(saving.dump(forged))
    match, forged = (Match("middle-size-2006", home=1, away=1, seed=1) for _ in range(2))
    forged.robots["caught_by"][0, 0] = 2
    with pytest.raises(ValueError, match="caught_by"):
        match.load(saving.dump(forged))
