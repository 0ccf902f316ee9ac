"""What a Match says of its attributes is true: they are there, in the shapes that its docstring gives."""

import re
from typing import Any

import numpy as np
import pytest

from soccer_env import Match

SHAPES = {"M": 3, "R": 4, "(M,)": (3,), "(M, R)": (3, 4), "(R,)": (4,)}


@pytest.fixture(scope="module")
def match() -> Match:
    made = Match(
        "legged-2001", home=2, away=2, matches=3, seed=1, autoreset="same_step", max_cycles=2, observe="belief"
    )
    for _ in range(2):
        made.step(np.zeros((3, 4, 4)))
    return made


def told() -> dict[str, str]:
    """Return the attributes in the table of the docstring with the shape of each."""
    rows = re.findall(r"^ *\| (`.*?`) \| (.*?) ?\| ", Match.__doc__ or "", re.MULTILINE)
    found: dict[str, str] = {}
    for names, shapes in rows:
        found |= dict(zip(re.findall(r"`(\w+)`", names), re.split(r"(?<=\)), ", shapes), strict=False))
    return found


def test_every_attribute_in_the_table_is_there_in_its_shape(match: Match) -> None:
    found: dict[str, Any] = {name: getattr(match, name) for name in told()}
    assert {"final", "ended", "learns", "statistics", "observations", "settings"} <= set(found)
    wrong = [x for x, shape in told().items() if shape in SHAPES and np.shape(found[x]) != SHAPES[shape]]
    assert wrong == []
    assert match.observations.shape == (3, 4, len(match.observation_names))
    assert match.terms.shape == (3, 4, len(match.term_names))
    assert len(match.agents) == 4 and match.settings.rewards.gamma == 0.99


def test_final_has_a_row_for_each_match_that_began_anew(match: Match) -> None:
    assert match.ended.tolist() == [0, 1, 2]
    assert match.final["observations"].shape == (3, 4, len(match.observation_names))
    assert len(match.final["state"]) == 3


def test_a_run_that_saves_is_a_run_of_its_own_and_one_that_saves_at_the_same_steps_the_same() -> None:
    def played(saves_at: tuple[int, ...]) -> str:
        match = Match(home=2, away=2, seed=4, controllers={"home": "chaser", "away": "chaser"})
        for step in range(700):
            match.step()
            if step in saves_at:
                match.save()
        return match.state_hash(0)

    once = played((300, 400, 500, 600))
    assert once == played((300, 400, 500, 600))
    assert once != played(())
