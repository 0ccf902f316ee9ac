"""A step, reset or load is one thread's alone, and undone if a user's own code raises in it."""

import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, Rewards, Scene
from soccer_env.replay import Recorder


def in_a_thread(do: Callable[[], object]) -> list[BaseException]:
    raised: list[BaseException] = []

    def run() -> None:
        try:
            do()
        except BaseException as error:
            raised.append(error)

    thread = threading.Thread(target=run)
    thread.start()
    thread.join()
    return raised


class Asked:
    """A team that lets another thread do something while it decides."""

    name, memory_dtype = "asked", np.dtype([])

    def __init__(self) -> None:
        self.do: Callable[[], object] = lambda: None
        self.raised: list[BaseException] = []

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        self.raised += in_a_thread(self.do)
        return np.asarray(view.stand())


class Moves:
    """A team that does something with the match that asks it, in the same thread."""

    name, memory_dtype = "moves", np.dtype([])

    def __init__(self, do: Callable[[], object]) -> None:
        self.do = do

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        self.do()
        return np.asarray(view.stand())


@pytest.mark.parametrize("name", ["step", "reset", "save", "load", "rebuild"])
def test_a_second_thread_is_refused_and_the_first_goes_on(name: str) -> None:
    team = Asked()
    sides = ({"home": who, "away": "still"} for who in (team, Asked()))
    match, alone = (Match(home=1, away=1, seed=1, controllers=both) for both in sides)
    saved = match.save()
    arguments = (saved,) if name == "load" else ()
    team.do = lambda: getattr(match, name)(*arguments)
    match.step()
    (error,) = team.raised
    assert isinstance(error, RuntimeError)
    assert str(error) == f"{name}: another thread is using this Match; give each thread one of its own"
    alone.step()
    assert match.state_hash() == alone.state_hash()


@pytest.mark.parametrize("name", ["step", "reset", "load"])
def test_a_team_that_moves_the_match_that_asks_it_is_told_so_and_nothing_changes(name: str) -> None:
    sides = {"home": Moves(lambda: getattr(match, name)(*given)), "away": "chaser"}
    match = Match(home=1, away=1, seed=1, controllers=sides)
    given = (match.save(),) if name == "load" else ()
    before, seeds = match.state_hash(), match.seeds.tolist()
    with pytest.raises(RuntimeError, match="team 'moves' must not call step, reset or load of the match that asks it"):
        match.step()
    assert (match.state_hash(), match.seeds.tolist()) == (before, seeds)
    match.reset(seed=3)


def test_a_team_may_look_ahead_in_a_branch_of_the_match_that_asks_it() -> None:
    ahead = []
    sides = {"home": Moves(lambda: ahead.append(match.branch(0))), "away": "chaser"}
    match = Match(home=1, away=1, seed=1, controllers=sides)
    match.step()
    assert (ahead[0].matches["step"][0], match.matches["step"][0]) == (0, 1)


class OwnError(ArithmeticError):
    """What the code here raises when told to."""


class Own:
    """Code of a user that counts its calls, and raises in some of them."""

    name, memory_dtype, names = "own", np.dtype([("calls", "i8")]), ("nothing",)

    def __init__(self) -> None:
        self.calls, self.raises = 0, -1

    def count(self) -> None:
        self.calls += 1
        if self.calls == self.raises:
            raise OwnError

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        memory["calls"] += 1
        commands = np.asarray(view.stand())
        commands[..., 0] = rng.uniform()
        self.count()
        return commands

    def __call__(self, match: Match) -> np.ndarray:
        self.count()
        return np.zeros((*match.rewards.shape, 1))

    def pay(self, match: Match) -> np.ndarray:
        self.count()
        return np.ones(match.rewards.shape)

    def place(self, *records: Any) -> None:
        self.count()


def made(own: Own, kind: str, **settings: Any) -> Match:
    """Return matches that call a user's code of a kind."""
    first = Own()  # a team before the one that raises: its memory and its random numbers move on first
    kinds: dict[str, dict[str, Any]] = {
        "team": {"controllers": {"home": first, "away": own}},
        "reward": {"rewards": Rewards(extra={"own": own.pay}), "controllers": {"home": first}},
        "observe": {"observe": own, "controllers": {"home": first}},
        "scene": {"scene": Scene("own", "where it is", own.place)},
    }
    return Match("legged-2001", home=1, away=1, matches=3, seed=1, **{**kinds[kind], **settings})


def stepped(match: Match) -> None:
    match.step(None if not match.learns.any() else np.full((3, 2, 4), 0.3))


def everything(match: Match) -> list[bytes]:
    return [match.state_hash().encode(), match.rewards.tobytes(), match.terms.tobytes(), match.observations.tobytes()]


@pytest.mark.parametrize("repeat", [1, 3])
@pytest.mark.parametrize("kind", ["team", "reward", "observe"])
def test_a_step_in_which_code_of_a_user_raises_changes_nothing(kind: str, repeat: int) -> None:
    own = Own()
    match = made(own, kind, action_repeat=repeat)
    for _ in range(5):
        stepped(match)
    before = everything(match)
    for call in range(1, repeat + 1):
        own.raises = own.calls + call
        with pytest.raises(OwnError):
            stepped(match)
        assert everything(match) == before
    assert np.allclose(match.batch.physics.bodies[:, 0, 0], match.balls["x"], atol=1e-12)
    saved = match.save()
    stepped(match)
    after = everything(match)
    match.load(saved)
    stepped(match)
    assert everything(match) == after


def test_a_team_that_raises_before_anything_moves_leaves_the_future_as_it_was() -> None:
    own, other = Own(), Own()
    match, undisturbed = made(own, "team"), made(other, "team")
    for step in range(40):
        if step % 7 == 3:
            own.raises = own.calls + 1
            with pytest.raises(OwnError):
                stepped(match)
        stepped(match)
        stepped(undisturbed)
    assert everything(match) == everything(undisturbed)


@pytest.mark.parametrize("autoreset", ["same_step", "next_step"])
@pytest.mark.parametrize("kind", ["scene", "observe"])
def test_an_error_in_a_new_episode_undoes_the_step_that_began_it(kind: str, autoreset: str) -> None:
    own = Own()
    match = made(own, kind, autoreset=autoreset, max_cycles=4, controllers={"home": "chaser"})
    for _ in range(3 if autoreset == "same_step" else 4):
        stepped(match)
    before = everything(match)
    own.raises = own.calls + 2
    with pytest.raises(OwnError):
        stepped(match)
    assert everything(match) == before
    stepped(match)
    assert (match.matches["episode"] == 1).all()


@pytest.mark.parametrize("kind", ["scene", "observe"])
def test_a_reset_or_load_in_which_code_of_a_user_raises_changes_nothing(kind: str) -> None:
    own = Own()
    match = made(own, kind)
    saved = match.save()
    stepped(match)
    before, seeds = everything(match), match.seeds.copy()
    own.raises = own.calls + 1
    with pytest.raises(OwnError):
        match.reset(seed=5)
    assert everything(match) == before and (match.seeds == seeds).all()
    if kind == "observe":
        own.raises = own.calls + 1
        with pytest.raises(OwnError):
            match.load(saved)
        assert everything(match) == before
    stepped(match)


def test_a_recording_knows_nothing_of_a_step_that_was_undone() -> None:
    """Heads that look by themselves look where they did: each step has its commands, its gaze and its hash."""
    replays = []
    for undone in ((2, 4), ()):
        own = Own()
        match = made(own, "reward", controllers={"home": "chaser", "away": "chaser"})
        recorder = Recorder(match)
        for step in range(6):
            if step in undone:
                own.raises = own.calls + 1
                with pytest.raises(OwnError):
                    stepped(match)
            stepped(match)
        replays.append(recorder.stop())
        assert replays[-1].check() == 6
    one, undisturbed = replays
    assert one.hashes == undisturbed.hashes and one.commands.tobytes() == undisturbed.commands.tobytes()
    assert one.gazes.tobytes() == undisturbed.gazes.tobytes()
    assert len(np.unique(one.gazes["pan"])) > 6, "heads turn"
