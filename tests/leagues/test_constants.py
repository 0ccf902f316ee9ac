"""The constants of a league: what kernels read of its parts, all of it and nothing else."""

import ast
from collections.abc import Iterator
from dataclasses import Field, fields, is_dataclass
from pathlib import Path
from typing import Any, get_type_hints

import pytest

from soccer_env.leagues import LEAGUES, League
from soccer_env.leagues.checks import PYTHON_ONLY
from soccer_env.leagues.constants import CONSTANTS, NUMBERS, constants_of
from soccer_env.leagues.robot import DRIVE_KINDS

ROOT = Path(__file__).parents[2]
PARTS = {name: kind for name, kind in get_type_hints(League).items() if is_dataclass(kind)}


def numbers() -> Iterator[tuple[str, Field[Any]]]:
    """Yield every number of every part of a league that is no whole one."""
    for part, kind in PARTS.items():
        yield from ((part, field) for field in fields(kind) if str(field.type) == "float")


def reads() -> tuple[set[str], set[str]]:
    """Return the names that product code reads as k.NAME or constants[0].NAME, and as NAME of anything else."""
    of_constants, of_others = set(), set()
    for folder in ("soccer_env", "baselines", "agents", "train"):
        for file in (ROOT / folder).rglob("*.py"):
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load):
                    record = ast.unparse(node.value).rpartition(".")[2] in ("k", "constants[0]")
                    (of_constants if record else of_others).add(node.attr)
    return of_constants, of_others


@pytest.mark.parametrize("name", LEAGUES)
def test_each_number_stands_under_the_name_of_its_part(name: str) -> None:
    league = LEAGUES[name]
    record = constants_of(league)[0]
    assert len(NUMBERS) > 60
    for part, field in numbers():
        if field.metadata != PYTHON_ONLY:
            assert record[f"{part}_{field.name}"] == getattr(getattr(league, part), field.name), (part, field.name)
    assert record["drive_kind"] == DRIVE_KINDS[league.drive.kind]
    assert record["corners"] == len(league.body.corners)
    assert [(x, y) for x, y in zip(record["corner_x"], record["corner_y"]) if x != 0.0] == [*league.body.corners]
    assert record["teammate_slots"] == league.slots.teammates and record["walled"] == league.pitch.walled
    assert not any(record[of_a_match] for of_a_match in ("placement_by_driving", "end_at_goal", "drill", "drill_time"))


def test_every_constant_is_read_and_what_no_kernel_reads_is_none() -> None:
    of_constants, of_others = reads()
    assert set(CONSTANTS.names or ()) <= of_constants, "declare it with metadata=PYTHON_ONLY"
    python_only = {(part, field.name) for part, field in numbers() if field.metadata == PYTHON_ONLY}
    assert not {f"{part}_{name}" for part, name in python_only} & set(CONSTANTS.names or ())
    assert {name for _, name in python_only} <= of_others
