"""How the matches of an evaluation are shared out among threads."""

import threading
import time
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from soccer_env.leagues import find_league
from soccer_env.train.evaluate import EvaluateSettings, contest, evaluate
from soccer_env.train.evaluate.settings import conditions_of


@given(pairs=st.integers(1, 600), threads=st.integers(1, 20), done=st.sets(st.integers(0, 1199)))
def test_batches_hold_every_match_that_is_left_once(pairs: int, threads: int, done: set[int]) -> None:
    found = list(contest.batches(2 * pairs, done, threads))
    assert sorted(match for batch in found for match in batch) == sorted(set(range(2 * pairs)) - done)
    assert all(1 <= len(batch) <= contest.BATCH and len({match % 2 for match in batch}) == 1 for batch in found)


class Alone:
    """A team that notices if two threads call it at once."""

    name = "alone"
    memory_dtype = np.dtype([])

    def __init__(self) -> None:
        self.inside, self.most, self.calls = 0, 0, 0

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        self.inside, self.calls = self.inside + 1, self.calls + 1
        self.most = max(self.most, self.inside)
        time.sleep(1e-4)
        self.inside -= 1
        return view.stand()


def test_a_team_in_python_is_never_called_by_two_threads_at_once() -> None:
    team = Alone()
    evaluate(EvaluateSettings(home="mine", away="still", matches=8, minutes=0.05, threads=4), teams={"mine": team})
    assert team.calls >= 48 and team.most == 1


def test_what_fails_in_one_thread_stops_the_others(monkeypatch: pytest.MonkeyPatch) -> None:
    """The second batch would go on for a minute."""

    def play(_: Any, batch: list[int], *rest: Any) -> list[Any]:
        if batch[0] == 0:
            raise RuntimeError("broken")
        stopped: threading.Event = rest[-1]
        return [None] if stopped.wait(60.0) else ["never told"]

    monkeypatch.setattr(contest, "play", play)
    started = time.monotonic()
    with pytest.raises(RuntimeError, match="broken"):
        evaluate(EvaluateSettings(home="random", away="still", matches=4, minutes=0.1, threads=2))
    assert time.monotonic() - started < 30.0


class Witness:
    """A team that stands and notes of each control step how many it is and whether it is sure of its place."""

    name = "witness"
    memory_dtype = np.dtype([])

    def __init__(self) -> None:
        self.seen: list[tuple[int, bool]] = []

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        sure = view.beliefs["own"]["confidence"] == 100.0
        self.seen.append((view.beliefs.shape[1], bool(sure.all())))
        return np.asarray(view.stand())


@pytest.mark.parametrize(("senses", "sure"), [("home=ideal,away=sensors", (1, 0)), ("home=sensors,away=ideal", (0, 1))])
def test_a_team_keeps_its_senses_and_its_size_when_it_changes_sides(senses: str, sure: tuple[int, int]) -> None:
    """Ideal senses are sure of the own place in every step, a particle filter is not for long."""
    first, second = Witness(), Witness()
    settings = EvaluateSettings(home="a", away="b", matches=2, minutes=0.05, players="1v2", senses=senses)
    there, back = evaluate(settings, teams={"a": first, "b": second}).lines
    assert (there.side, back.side) == ("home", "away")
    for team, size, ideal in zip((first, second), (1, 2), sure, strict=True):
        for seen, count in ((team.seen[: there.steps], there.steps), (team.seen[there.steps :], back.steps)):
            assert len(seen) == count and {players for players, _ in seen} == {size}
            assert all(known for _, known in seen) == bool(ideal)


def test_a_batch_that_is_stopped_ends_at_once() -> None:

    league = find_league("legged-2001")
    settings = EvaluateSettings(home="random", away="still", matches=2, minutes=100.0)
    played = contest.contest_of(conditions_of(settings, league), league, {})
    stopped = threading.Event()
    steps: list[float] = []

    def advance(amount: float) -> None:
        steps.append(amount)
        stopped.set()

    assert contest.play(played, [0], "", 1, advance, stopped) == []
    assert steps == [contest.REPORT_EVERY, 0]
