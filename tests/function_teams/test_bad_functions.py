"""Functions that return nonsense are named, with the robot and what is allowed, and the match stays as it was."""

import copy
import re
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, team_of_function
from tests.scenes.staging import refused


def nothing(observations: np.ndarray) -> np.ndarray:
    return np.zeros((*observations.shape[:-1], 4))


def returns(value: Any) -> Any:
    """Return a function of that name that returns a value, whatever it sees."""

    def mine(observations: np.ndarray) -> Any:
        return value

    return mine


def with_one(value: Any, size: int = 4) -> np.ndarray:
    """Return actions (2, 3, size) with one value in the last robot of the second match."""
    actions = np.zeros((2, 3, size))
    actions[1, 2, 1] = value
    return actions


MUST = "team 'mine' must return actions of shape (2, 3, 4) or (2, 3, 7), or discrete ones of shape (2, 3), for "
IN_MATCH = "in match 1 by team 'mine' must be"
RANGE = MUST + "away_0 in match 0 to away_2 in match 1, got "
WRONG: dict[str, tuple[Any, str]] = {
    "another number of players": (np.zeros((2, 2, 4)), RANGE + "float64 of shape (2, 2, 4)"),
    "another number of matches": (np.zeros((1, 3, 4)), RANGE + "float64 of shape (1, 3, 4)"),
    "five numbers": (np.zeros((2, 3, 5)), RANGE + "float64 of shape (2, 3, 5)"),
    "nothing": (None, RANGE + "None"),
    "words": (np.full((2, 3, 4), "a"), RANGE + "<U1 of shape (2, 3, 4)"),
    "complex": (np.zeros((2, 3, 4), complex), RANGE + "complex128 of shape (2, 3, 4)"),
    "switches": (np.zeros((2, 3), bool), RANGE + "bool of shape (2, 3)"),
    "lists of different lengths": ([[1.0], [1.0, 2.0]], RANGE + "[[1.0], [1.0, 2.0]]"),
    "fractions for discrete ones": (np.zeros((2, 3)), RANGE + "float64 of shape (2, 3)"),
    "NaN": (with_one(np.nan), f"action of away_2 {IN_MATCH} finite, got [0.0, nan, 0.0, 0.0]"),
    "infinity": (with_one(-np.inf, 7), f"action of away_2 {IN_MATCH} finite, got [0.0, -inf,"),
    "an unknown discrete action": ([[0, 1, 2], [3, 12, 4]], f"action of away_1 {IN_MATCH} 0 to 11, got 12"),
    "below all discrete actions": ([[0, 1, 2], [3, 11, -1]], f"action of away_2 {IN_MATCH} 0 to 11, got -1"),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_it_returns_wrongly_is_named_and_nothing_changes(case: str) -> None:
    value, message = WRONG[case]
    team = team_of_function(returns(value))
    match = Match(home=1, away=3, matches=2, opponents=team, teammates="chaser", seed=1)
    with refused(match, re.escape(message)):
        match.step(np.ones((2, 4, 4)))


def test_a_flat_function_is_told_of_rows_and_one_robot_alone_is_named_once() -> None:
    match = Match(home=3, away=1, matches=2, teammates=team_of_function(returns(np.zeros((3, 4))), flat=True), seed=1)
    said = "actions of shape (4, 4) or (4, 7), or discrete ones of shape (4,), for home_0 in match 0 to home_1 in match"
    with pytest.raises(ValueError, match=re.escape(f"team 'mine' must return {said} 1, got float64 of shape (3, 4)")):
        match.step(np.zeros((2, 4, 4)))
    match = Match(home=1, away=1, opponents=team_of_function(returns(np.zeros((1, 1, 5)))), seed=1)
    with pytest.raises(ValueError, match=r"of shape \(1, 1\), for away_0 in match 0, got float64"):
        match.step(np.zeros((1, 2, 4)))


def test_neither_of_two_functions_keeps_anything_when_the_second_raises() -> None:
    def remembering(observations: np.ndarray, memory: np.ndarray) -> np.ndarray:
        memory += 1.0
        return nothing(observations)

    def raising(observations: np.ndarray) -> np.ndarray:
        raise KeyError("no such layer")

    first = team_of_function(remembering, memory="f8")
    match = Match(home=1, away=1, controllers={"home": first, "away": team_of_function(raising)}, seed=1)
    with refused(match, "no such layer", KeyError):
        match.step()


@pytest.mark.parametrize("flat", [False, True])
@pytest.mark.parametrize("memory", ["f4", ("f8", (2,)), [("h", "f4", (3,)), ("n", "i8")]])
def test_memory_that_is_not_finite_is_named(memory: Any, flat: bool) -> None:
    def forget(observations: np.ndarray, memory: np.ndarray) -> np.ndarray:
        (memory["h"] if memory.dtype.names else memory)[...] = np.nan
        return nothing(observations)

    match = Match(home=1, away=2, opponents=team_of_function(forget, memory=memory, flat=flat), seed=1)
    with refused(match, "memory of away_0 in match 0 by team 'forget' must be finite"):
        match.step(np.zeros((1, 3, 4)))


def test_a_function_cannot_change_what_the_match_holds() -> None:
    def scribble(observations: np.ndarray) -> np.ndarray:
        observations[...] = np.nan
        return nothing(observations)

    match = Match(home=1, away=1, observe="belief", opponents=team_of_function(scribble), seed=1)
    match.step(np.zeros((1, 2, 4)))
    assert np.isfinite(match.observations).all()


@pytest.mark.parametrize("returned", [np.zeros((1, 2)), np.full((1, 2, 3), np.nan)])
def test_an_observation_of_ones_own_that_is_wrong_is_named(returned: np.ndarray) -> None:
    class Own:
        names = ("a", "b", "c")

        def __call__(self, match: Any) -> np.ndarray:
            return returned

    match = Match(home=1, away=1, opponents=team_of_function(nothing, observe=Own()), seed=1)
    with pytest.raises(ValueError, match=r"observe of team 'nothing' must return finite numbers of shape \(1, 2, 3\)"):
        match.step(np.zeros((1, 2, 4)))


BAD: list[tuple[dict[str, Any], str]] = [
    ({"function": 3}, "function must be a function of observations, got 3"),
    ({"observe": "beliefs"}, "observe must be one of truth, percepts, belief, got 'beliefs'"),
    ({"observe": None}, "observe must be one of truth, percepts, belief, got None"),
    ({"action_repeat": 0}, "action_repeat must be 1 to 1000, got 0"),
    ({"action_repeat": 2.5}, "action_repeat must be a whole number, 1 to 1000, got 2.5"),
    ({"memory": "nonsense"}, "memory must be a dtype of plain numbers, got 'nonsense'"),
    ({"memory": object}, "memory must be a dtype of plain numbers, got <class 'object'>"),
    ({"memory": ("f4", (0,))}, "memory must be a dtype of plain numbers"),
    ({"flat": 1}, "flat must be one of True, False, got 1"),
    ({"memory": ("f4", (1,))}, "the function must take (observations, memory), got "),
    ({"function": lambda seen, memory: seen}, "a second argument is for memory=, got (seen, memory)"),
    ({"name": ""}, "name must be a plain text, got ''"),
    ({"fingerprint": 7}, "fingerprint must be a plain text, got 7"),
]


@pytest.mark.parametrize(("given", "message"), BAD, ids=range(len(BAD)))
def test_bad_settings_are_named(given: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        team_of_function(**{"function": nothing, **given})


def test_senses_that_do_not_fit_what_it_observes_are_named() -> None:
    with pytest.raises(ValueError, match="team 'nothing' observes truth: it needs senses='ideal', got 'sensors'"):
        Match(home=1, away=1, opponents=team_of_function(nothing, observe="truth"))
    with pytest.raises(ValueError, match="team 'nothing' observes percepts: it needs senses='sensors', got 'ideal'"):
        Match(home=1, away=1, senses="ideal", opponents=team_of_function(nothing, observe="percepts"))


@pytest.mark.parametrize("move", ["step", "reset", "load"])
def test_a_function_that_moves_the_match_that_asks_it_is_told_so_and_nothing_changes(move: str) -> None:
    match = Match(home=1, away=1, seed=1, opponents=team_of_function(lambda seen: mine(seen), name="mine"))
    content = match.save()
    given = {"step": (np.zeros((1, 2, 4)),), "reset": (7,), "load": (content,)}[move]

    def mine(observations: np.ndarray) -> np.ndarray:
        getattr(match, move)(*given)
        return nothing(observations)

    seeds = match.seeds.tolist()
    with refused(match, "team 'mine' must not call step, reset or load of the match that asks", RuntimeError):
        match.step(np.zeros((1, 2, 4)))
    assert match.seeds.tolist() == seeds
    match.reset(seed=3)


def test_a_function_may_look_ahead_in_a_branch_of_the_match() -> None:
    match = Match(home=1, away=1, seed=1, opponents=team_of_function(lambda seen: mine(seen), name="mine"))

    def mine(observations: np.ndarray) -> np.ndarray:
        copy.deepcopy(match)
        ahead = match.branch(0)
        ahead.rebuild()
        return nothing(observations)

    match.step(np.zeros((1, 2, 4)))
    assert match.matches["step"].tolist() == [1]
