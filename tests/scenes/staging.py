"""Stage matches for tests: small scenes and commands."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.match.staging import constants_of as running_constants
from soccer_env.match.staging import put, put_ball, send_off, set_phase
from soccer_env.types import Phase
from tests.scenes.leagues import (  # noqa: F401
    LEAGUES,
    LEGGED,
    MIDDLE,
    boarded,
    each_league,
    endless,
    icy,
    league_without_calls,
    steady,
)
from tests.scenes.looking import deepest_overlaps, distance, energy, outline, speed  # noqa: F401

WALK = ("forward", "left", "turn")


# Putting things somewhere


def stage(league: Any, matches: int = 1, home: int = 1, away: int = 1, *, ball: Any = None, robots: Any = None,
          **settings: Any) -> Match:  # fmt: skip
    """Return matches in play, the ball at rest on the centre spot, all robots sent off but those that `place` names."""
    match = Match(league, matches=matches, home=home, away=away, **{"seed": 1, **settings})
    set_phase(match, Phase.PLAY)
    send_off(match, range(home + away))
    if ball is not None or robots is not None:
        place(match, ball, robots)
    return match


def place(match: Match, ball: Any = None, robots: Any = None) -> None:
    """Put the ball, as for `put_ball`, and robots by their row, as for `put`, and rebuild the physics on them."""
    for r, where in (robots or {}).items():
        put(match, r, *where)
    if ball is not None:
        put_ball(match, *ball)
    match.rebuild()


def scatter(match: Match, rng: np.random.Generator, share: float = 0.8) -> None:
    """Put the ball and all robots at random, nobody in anybody's way nor on a ramp; `share` of the pitch is used."""
    league, count = match.league, match.robots.shape[1]
    half = np.array([league.pitch.length, league.pitch.width]) / 2
    room = np.minimum(share * half, half - league.foot) - league.body.reach
    apart = 2.0 * league.body.reach
    for m in range(match.count):
        places: list[np.ndarray] = []
        tries = 0
        while len(places) < count + 1:
            tries += 1
            assert tries < 100_000, "too many robots for so little room"
            place = rng.uniform(-room, room)
            if all(np.hypot(*(place - other)) > apart for other in places):
                places.append(place)
        match.balls["x"][m], match.balls["y"][m] = places[0]
        match.robots["x"][m], match.robots["y"][m] = np.transpose(places[1:])
    match.robots["heading"] = rng.uniform(-np.pi, np.pi, match.robots.shape)
    match.matches["still_x"], match.matches["still_y"] = match.balls["x"], match.balls["y"]


@contextmanager
def refused(match: Match, complaint: str, error: type[Exception] = ValueError) -> Iterator[None]:
    """Expect an error that says so, and a match that stays as it was."""
    before = match.state_hash()
    with pytest.raises(error, match=complaint):
        yield
    assert match.state_hash() == before


# Playing


def stand(match: Match) -> np.ndarray:
    """Return actions that let everybody stand."""
    return np.zeros((match.count, match.robots.shape[1], 4))


def robot_actions(
    match: Match, r: Any = 0, forward: Any = 0.0, left: Any = 0.0, turn: Any = 0.0, kick: Any = 0.0
) -> np.ndarray:
    """Return actions in which robot r (or several) asks for something and the others stand."""
    actions = stand(match)
    actions[:, r] = np.stack(np.broadcast_arrays(forward, left, turn, kick), axis=-1)
    return actions


def steps_in(match: Match, seconds: float) -> int:
    """Return the control steps in a time [s]."""
    return round(seconds * match.league.control_rate)


def play(match: Match, seconds: float = 0.0, actions: Any = None, steps: int | None = None) -> None:
    """Play for a time [s], or some control steps; everybody stands unless told otherwise."""
    for _ in range(steps_in(match, seconds) if steps is None else steps):
        match.step(stand(match) if actions is None else actions)


def record_each_step(match: Match, what: Callable[[], Any], seconds: float = 0.0, actions: Any = None,
              steps: int | None = None) -> np.ndarray:  # fmt: skip
    """Play as `play` does; return what is there to be seen after each control step (T, ...)."""
    found = []
    for _ in range(steps_in(match, seconds) if steps is None else steps):
        match.step(stand(match) if actions is None else actions)
        found.append(np.copy(what()))
    return np.array(found)


def freeze(match: Match) -> Match:
    """Let neither the ground nor a drive act on the robots of a match, so that blows alone change speeds."""
    for name in ("traction", "thrust", "turn_traction", "turn_thrust"):
        running_constants(match)[f"drive_{name}"] = 1e-12
    return match


def at_the_ball(league, matches=1, ahead=0.005, aside=0.0, row=0, **settings) -> Match:
    """Return matches in which one robot stands with the ball in its pocket, `ahead` of its front, and nobody else."""
    match = stage(league, matches, **settings)
    body, ball = match.league.body, match.league.ball
    put(match, row, -0.3 * match.league.pitch.length, 0.1, 0.0)
    place(match, ball=(match.robots["x"][:, row] + body.front + ball.radius + ahead, 0.1 + aside))
    numbers = 7 if settings.get("actions") == "full" else 4
    match.step(np.zeros((*match.robots.shape, numbers)))  # the robot learns that it has the ball
    return match
