"""Settings of sensors and memories: what `soccer list sensors` says is allowed is what is accepted."""

import re
from dataclasses import dataclass, fields
from math import inf, nan, nextafter
from typing import Any

import pytest

from soccer_env.guards.checking import field_type_name
from soccer_env.leagues.legged_sensors import LeggedMemory, LeggedSensors
from soccer_env.leagues.omni_sensors import OmniMemory, OmniSensors
from soccer_env.leagues.options import GREATEST, Options, field_comments
from soccer_env.leagues.rules import Rules
from soccer_env.train.command.command_line import main

KINDS: tuple[type[Options], ...] = (LeggedSensors, LeggedMemory, OmniSensors, OmniMemory)


NUMBERS = [  # the kind and the name of every number: the id of a test names no value, so no change of one renames it
    (kind, field.name)
    for kind in KINDS
    for field in fields(kind)  # type: ignore[arg-type]
    if field_type_name(field) in ("float", "int")
]


def in_order(kind: type[Options], name: str, value: float) -> dict[str, Any]:
    """Return settings with this value, and others that go with it."""
    changes = {name: value}
    for one, _, other in kind.ORDER:
        changes |= {other: kind.bounds(other)[1]} if one == name else {}
        changes |= {one: kind.bounds(one)[0]} if other == name else {}
    return changes


@pytest.mark.parametrize(("kind", "name"), NUMBERS)
def test_the_bounds_that_are_listed_are_those_that_are_enforced(kind, name) -> None:
    (allowed,) = (row[2] for row in kind().rows() if row[0] == name)
    whole = allowed.startswith("whole, ")
    listed = re.findall(r"(-?[\d.]+) to ([\d.]+)", allowed)[0]
    assert [float(number) for number in listed] == pytest.approx(kind.bounds(name)[:2], rel=1e-5)
    low, high = map(int, listed) if whole else kind.bounds(name)[:2]
    reached = high if "less than" not in allowed else nextafter(high, -inf)
    for value in (low, reached):
        assert getattr(kind(**in_order(kind, name, value)), name) == value
    for value in (low - 1, high + 1) if whole else (nextafter(low, -inf), nextafter(high, inf), inf, -inf, nan):
        with pytest.raises(ValueError, match=rf"{kind.__name__}\.{name} must be "):
            kind(**in_order(kind, name, value))


@pytest.mark.parametrize("kind", KINDS)
def test_what_must_be_in_order_is_listed_at_both_fields_and_enforced(kind: type[Options]) -> None:
    allowed = {row[0]: row[2] for row in kind().rows()}
    for one, relation, other in kind.ORDER:
        assert f"{relation} {other}" in allowed[one]
        assert {"at most": f"at least {one}", "less than": f"more than {one}"}[relation] in allowed[other]
        equal = getattr(kind(), other)
        if relation == "at most":
            assert getattr(kind(**{one: equal}), one) == equal
        for value in [nextafter(equal, inf), *([equal] if relation == "less than" else [])]:
            with pytest.raises(ValueError, match=f"{one} must be {relation} {other} {equal}, got {value}"):
                kind(**{one: value})


def test_every_field_has_a_note_and_own_fields_come_first() -> None:
    for kind in KINDS:
        rows = list(kind().rows())
        assert all(note or isinstance(value, bool) for _, value, _, note in rows)
        assert {row[0] for row in rows} == {field.name for field in fields(kind)}  # type: ignore[arg-type]
    names = [row[0] for row in OmniMemory().rows()]
    assert names[0] == "fading" and names.index("pose_line_noise") < names.index("particles")


def test_the_list_shows_bounds(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "sensors", "--league", "legged-2001"]) == 0
    printed = " ".join(capsys.readouterr().out.split())
    assert "0 to 64, even" in printed and "whole, 1 to 6" in printed and "whole, 1 to 65536" in printed
    assert f"0 to {GREATEST:.0f}" in printed and "0 or more" not in printed


@pytest.mark.parametrize("rule", [field.name for field in fields(Rules)])
def test_every_rule_says_what_it_is(rule: str) -> None:
    assert field_comments(Rules).get(rule), "`soccer list rules` shows the comment beside the field"


@dataclass(frozen=True)
class Evaluated(Options):
    """Of a module without `from __future__ import annotations`: its fields have types, not their names."""

    near: float = 0.7
    most: int = 3
    bold: bool = True


def test_settings_of_a_module_that_evaluates_its_annotations_keep_their_kinds() -> None:
    record = Evaluated().record()
    assert [record.dtype[name].str for name in ("near", "most", "bold")] == ["<f8", "<i8", "<i8"]
    assert (record["near"][0], record["most"][0], record["bold"][0]) == (0.7, 3, 1)
    assert [allowed for _, _, allowed, _ in Evaluated().rows()] == [
        "0 to 1000000",
        "whole, 0 to 1000000",
        "True, False",
    ]
