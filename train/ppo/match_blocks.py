"""Blocks of matches in a SoccerVecEnv: the division by team sizes, the start, and checks of arguments.

A block is a Match of up to `BLOCK` matches that one thread plays by itself for a whole decision.
"""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.actions import ActionKind
from soccer_env.api.opponents import LEARNER
from soccer_env.guards.checking import check_whole_number
from soccer_env.guards.interrupts import SignalsHeld
from soccer_env.match.match import BLOCK, Match
from soccer_env.match.saving import make_undo, signals_wait
from soccer_env.match.squads import playing_team_names


@dataclass(frozen=True)
class Result:
    """The result of an episode, seen from the learners' side."""

    players: tuple[int, int]  # a side
    opponent: str
    goals_for: int
    goals_against: int
    minutes: float = 0.0  # of play

    @property
    def points(self) -> float:
        """Return the learners' points: 1 for a win, 0.5 for a draw, 0 for a defeat."""
        return 0.5 + 0.5 * float(np.sign(self.goals_for - self.goals_against))


def check_request(
    players: Sequence[tuple[int, int]], both: bool, repeat: int, threads: int, settings: dict[str, Any]
) -> None:
    """Raise ValueError for settings under which a robot has no player, or a row no robot.

    both: the robots of both sides learn.
    """
    for name in ("teammates", "controllers", "autoreset"):
        if name in settings:
            raise ValueError(f"SoccerVecEnv takes no {name}: all home robots learn, and matches begin anew at once")
    if both and settings.get("max_players") is not None:
        raise ValueError("max_players must be None where both sides learn: rows without a robot would learn too")
    if not players or not all(len(sizes) == 2 for sizes in players):
        raise ValueError(f"players must be team sizes (home, away), at least one, got {players!r}")
    observe = settings.get("observe")
    if isinstance(observe, Mapping) or any(hasattr(observe, name) for name in ("space", "low", "high")):
        raise ValueError(f"SoccerVecEnv needs one vector in [-1, 1] for every robot, got observe={observe!r}")
    check_whole_number("action_repeat", repeat, 1, 1000)
    check_whole_number("threads", threads, 1, 256)


def split_matches(players: Sequence[tuple[int, int]], matches: int) -> list[tuple[tuple[int, int], int]]:
    """Divide matches among team sizes; return (sizes, matches) of each block.

    Each team size gets nearly as many home robots as any other: 2 v 2 has half the matches of 1 v 1.
    """
    blocks: list[tuple[tuple[int, int], int]] = []
    shares = np.array([1.0 / home for home, _ in players])
    ends = np.round(np.cumsum(shares) / shares.sum() * matches).astype(int).tolist()
    for sizes, start, end in zip(players, [0, *ends], ends, strict=False):
        count = end - start
        if count < 1:
            raise ValueError(f"matches must be at least one for each of {len(players)} team sizes, got {matches}")
        blocks += [(sizes, part) for part in split_evenly(count, -(-count // BLOCK))]
    return blocks


def split_evenly(whole: int, count: int) -> list[int]:
    """Split `whole` into `count` nearly equal whole numbers."""
    return [whole * (i + 1) // count - whole * i // count for i in range(count)]


def begin(match: Match, seeds: np.ndarray, first_decision: int, stagger: int) -> None:
    """Begin episodes from the seeds (M,), and let the robots stand until their first decision.

    stagger: 0, or the control steps of an action; episodes then start at clock times that differ by whole actions.
    """
    match.reset(seeds=seeds)
    if stagger:
        half = match.settings.half_length
        if np.isfinite(half):
            strides = int(half / (match.league.dt * stagger))
            # with the clock go the steps, so that a limit of steps ends these episodes one after the other too
            match.matches["step"] = np.arange(match.count) * strides // match.count * stagger
            match.matches["clock"] = match.matches["step"] * match.league.dt
    until = first_decision or stagger  # so that observations show the new clock
    still = match.settings.actions.still(match.count, len(match.agents))
    for _ in range(until):
        match.step(still)


def playing(match: Match) -> list[str]:
    """Return for each match the name of the team that now plays the last away robot, or LEARNER."""
    return [name or LEARNER for name in playing_team_names(match.squads, len(match.agents) - 1, match.count)]


def taken(actions: Any, like: np.ndarray, matches: Sequence[Match]) -> np.ndarray:
    """Check the actions of all rows and return them, numbers clipped to [-1, 1]; ValueError for a wrong action."""
    kind = matches[0].settings.actions
    if kind.parts:
        return index_rows(kind, actions, len(like))
    shape = like.shape
    numbers = np.asarray(actions)
    if numbers.dtype.kind not in "fiu" or numbers.shape != shape:
        raise ValueError(f"actions must be numbers of shape {shape}, got {numbers.dtype} of shape {numbers.shape}")
    numbers = numbers.astype(np.float64)
    wrong = np.flatnonzero(~np.isfinite(numbers).all(axis=1))
    if len(wrong):
        row = int(wrong[0])
        whose = [f"{agent} of match {m}" for block in matches for m, agent in learners_of(block)][row]
        raise ValueError(f"action of row {row}, {whose} of its block, is not finite: {numbers[row].tolist()}")
    return np.asarray(np.clip(numbers, -1.0, 1.0))


def learners_of(match: Match) -> list[tuple[int, str]]:
    """Return (match number, agent) of each learning robot of a block, in the order of rows."""
    learners = [agent for agent, learns in zip(match.agents, match.learns, strict=True) if learns]
    return [(m, agent) for m in range(match.count) for agent in learners]


@contextmanager
def undo_on_error(matches: Sequence[Match], opponents: list[list[str]], doing: str) -> Iterator[None]:
    """Hold back signals while all matches reset or step, and undo the step in all of them after an error.

    Signals still interrupt matches that call a user's code, or that may have to compile.
    """
    before: list[Any] = []
    names = list(opponents)
    if not all(signals_wait(match, doing) for match in matches):
        before = [make_undo(match, doing) for match in matches]
    with SignalsHeld():
        try:
            yield
        except BaseException:
            if before:
                for go_back in before:
                    if go_back is not None:
                        go_back()
                opponents[:] = names
            raise


def index_rows(kind: ActionKind, actions: Any, rows: int) -> np.ndarray:
    """Check indices (rows,) or (rows, 4) and return them; ValueError unless they are those of known actions."""
    numbers = np.asarray(actions)
    shape = (rows, *kind.shape)
    if numbers.dtype.kind not in "iu" or numbers.shape != shape:
        raise ValueError(
            f"actions must be whole numbers of shape {shape}, got {numbers.dtype} of shape {numbers.shape}"
        )
    wrong = (numbers.reshape(rows, -1) < 0) | (numbers.reshape(rows, -1) >= kind.parts)
    if wrong.any():
        kind.indices(numbers[row := int(np.argmax(wrong.any(axis=1)))], f"row {row}")
    return numbers
