"""Saves hold what robots sense, believe and remember: a save goes on with the same senses, nonsense is refused."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.match.saving import dump
from tests.senses.staged_senses import LEAGUES, draws, sensing


@pytest.mark.parametrize("league", LEAGUES)
def test_a_save_goes_on_with_the_same_senses(league: str) -> None:
    match = sensing(league, pose="particles")
    actions = draws(match, 80)
    for step in range(40):
        match.step(actions[step])
    saved = match.save()
    futures = []
    for _ in range(2):
        for step in range(40, 80):
            match.step(actions[step])
        futures.append(match.state_hash())
        match.load(saved)
    assert futures[0] == futures[1]


def test_a_team_that_uses_its_sensors_alone_is_saved_alone() -> None:
    teams = {"home": "chaser", "away": "chaser"}
    match = Match("legged-2001", home=3, away=2, seed=1, controllers=teams, senses={"home": "ideal", "away": "sensors"})
    assert match.batch.senses is not None
    assert {array.shape[1] for array in match.batch.senses.parts.values()} == {2}
    for _ in range(20):
        match.step()
    saved = match.save()
    futures = []
    for _ in range(2):
        for _ in range(20):
            match.step()
        futures.append((match.state_hash(), match.beliefs.tobytes(), match.tracks.tobytes()))
        match.load(saved)
    assert futures[0] == futures[1]


def test_a_save_with_nonsense_in_the_memory_is_refused() -> None:
    match = sensing("legged-2001", matches=1)
    memory = match.batch.senses.memories
    for name, value in (("count", 100), ("x", np.nan)):
        kept = memory["ball"][name].copy()
        memory["ball"][name] = value
        damaged = dump(match)
        memory["ball"][name] = kept
        before = match.state_hash()
        with pytest.raises(ValueError, match="this save is damaged"):
            match.load(damaged)
        assert match.state_hash() == before
