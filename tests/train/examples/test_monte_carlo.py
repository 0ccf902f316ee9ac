"""The search of the example gets past an opponent where `chaser` does not, and changes nothing until it acts."""

from pathlib import Path

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.train.examples import monte_carlo

SOURCE = Path(monte_carlo.__file__)


@pytest.mark.slow
def test_search_gets_past_where_chaser_does_not() -> None:
    assert [monte_carlo.play(seed) for seed in (1, 3)] == [True, True]
    assert [monte_carlo.play(seed, home="chaser") for seed in (1, 3)] == [False, False]


def test_a_search_changes_no_record_of_the_match() -> None:
    match = Match(seed=1, controllers={"away": "still"}, **monte_carlo.DRILL)
    planner, before = match.branch([0] * 8), match.state_hash()
    plan = monte_carlo.best_plan(match, planner, np.random.default_rng(1), np.zeros((monte_carlo.WALKS, 4)))
    assert match.state_hash() == before
    assert plan.shape == (monte_carlo.WALKS, 4) and np.abs(plan).max() <= 1.0


def test_the_example_is_short() -> None:
    text = SOURCE.read_text(encoding="utf-8").partition('"""\n\n')[2]
    assert len([line for line in text.splitlines() if line.strip()]) <= 40
