"""Ask the users' functions that play in a match for their decisions, before any robot moves.

All functions are asked before the first answer is stored: if a function raises or returns an invalid answer, nothing
has changed.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from threading import get_ident
from typing import Any

import numpy as np

from soccer_env.teams.function_teams.answers import HEAD, as_array
from soccer_env.teams.function_teams.team import FunctionTeam

Match = Any  # soccer_env.match.match.Match, which stands above this file
Squad = Any  # soccer_env.match.squads.Squad, which stands above this file
MOVES = ("step", "reset", "load")  # methods that move a match to another state


def ask_functions(match: Match) -> None:
    """Ask the functions for all decisions due in M matches and store them; ValueError for an invalid answer."""
    squads = [squad for squad in match.squads if isinstance(squad.team, FunctionTeam)]
    answers = [ask_squad(match, squad) for squad in squads]
    for squad, memory in zip(squads, answers, strict=True):
        squad.memory[...] = memory


def ask_squad(match: Match, squad: Squad) -> np.ndarray:
    """Ask the function of a squad's team; return a copy of the squad's memory (M, P) with the new decisions."""
    team: FunctionTeam = squad.team
    memory: np.ndarray = squad.memory.copy()
    plays = np.ones(match.count, bool) if squad.plays is None else squad.plays
    fresh = plays & (memory["begun"][:, 0] == 0)
    if fresh.any():  # robots stand until their first decision
        first = memory[fresh]
        first["begun"] = 1
        first["wait"] = -(0 if team.at_once else match.league.delay_steps) % team.action_repeat
        first["action"][..., HEAD] = -1.0
        memory[fresh] = first
    due = np.flatnonzero(plays & (memory["wait"][:, 0] == 0) & (match.matches["over"] == 0))
    if len(due):
        rows, kept = squad.players, memory[due]

        def who(d: int, p: int) -> str:
            return f"{match.agents[rows[p]]} in match {due[d]}"

        with forbid_changes(match, team.name):
            kept["action"] = team.decide(squad_observations(match, squad, due), kept, who)
        kept["wait"] = team.action_repeat
        memory[due] = kept
    return memory


@contextmanager
def forbid_changes(match: Match, team: str) -> Iterator[None]:
    """Forbid steps and other changes of a match while the Python code of a team runs; reading and copying work."""
    asks = get_ident()

    def raise_in_own_thread(name: str, *args: Any, **kwargs: Any) -> Any:
        if get_ident() != asks:  # another thread: the match itself refuses
            return getattr(type(match), name)(match, *args, **kwargs)
        moves = f"{', '.join(MOVES[:-1])} or {MOVES[-1]}"
        raise RuntimeError(f"team {team!r} must not call {moves} of the match that asks it; a branch of it may move")

    for name in MOVES:
        match.__dict__[name] = partial(raise_in_own_thread, name)
    try:
        yield
    finally:
        for name in MOVES:
            del match.__dict__[name]


def squad_observations(match: Match, squad: Squad, due: np.ndarray) -> np.ndarray:
    """Return the observations (D, P, n) float32 of a squad's players where a decision is due, as a new array."""
    team, seen = squad.team, squad.observations
    if isinstance(team.observe, str):
        match.batch.write_observations(seen, team.observe, squad.players, 0, match.count)
    else:
        own = as_array(team.observe(match))
        if own.dtype.kind not in "fiub" or own.shape != seen.shape or not np.isfinite(own).all():
            got = "others" if own.shape == seen.shape else f"shape {own.shape}"
            what = f"observe of team {team.name!r}"
            raise ValueError(f"{what} must return finite numbers of shape {seen.shape}, got {got}")
        seen[...] = own
    return np.asarray(seen[np.ix_(due, squad.players)])
