"""Stage and play the matches of a claim's batch.

    match = stage(batch, LEGGED, matches=128, memory={"infrared_override": False})
    put(match, 0, x=0.0, y=0.0, heading=batch.rng().uniform(-pi, pi, 128))
    put_ball(match, *ahead_of(match, 0, distance, bearing))
    begin(match)
    for _ in play(match, seconds=2.0): ...   # match.percepts, match.beliefs, match.tracks against the truth

The field is empty until `put` brings robots on; the referee calls only goals and the ball out of play (PATIENT).

    stage      scenes of our own          drill     a drill of the package as it is judged
    kick_off   whole matches, under the rules of play that the claim states

All matches of claims are made here (`make_matches`), which refuses rules that the claim does not state.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.match.staging import PATIENT, send_off, set_phase
from soccer_env.match.staging import begin_scene as begin_scene
from soccer_env.match.staging import put as put
from soccer_env.match.staging import put_ball as put_ball
from soccer_env.scenes import find_scene
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import Batch
from soccer_env.types import Phase

LEGGED, MIDDLE = "legged-2001", "middle-size-2006"
FLOOR = replace(find_league(LEGGED).pitch, length=7.0, width=6.0)  # [m]
OPEN_FLOOR = replace(find_league(LEGGED), pitch=FLOOR)  # for scenes that reach beyond the boards, whose ramps move them


def make_matches(batch: Batch, league: str | League, rules: str, *, matches: int, **settings: Any) -> Match:
    """Make matches with the batch's seeds and threads; ValueError for rules that the claim does not state."""
    if rules not in batch.rules:
        raise ValueError(f"claim {batch.claim} states the rules {batch.rules}, its matches are made with {rules!r}")
    settings = {"pose": batch.pose, **settings}
    return Match(league, matches=matches, seeds=batch.seeds(matches), threads=batch.threads, rules=rules, **settings)


def stage(
    batch: Batch, league: str | League = LEGGED, *, matches: int = 128, home: int = 1, away: int = 1,
    rules: str = PATIENT, **settings: Any,
) -> Match:  # fmt: skip
    """Return matches in play whose robots use their sensors, all parked off the field, the ball at the centre.

    `settings` of a Match: sensors={...}, memory={...}; the batch sets the pose. All variants share the batch's seeds.
    """
    settings = {"observe": "belief", "senses": "sensors", **settings}
    match = make_matches(batch, league, rules, matches=matches, home=home, away=away, **settings)
    set_phase(match, Phase.PLAY)
    send_off(match, range(home + away))
    return match


def stage_team(
    batch: Batch, team: str, settings: dict[str, Any], league: str | League = LEGGED, opponents: str | None = "still",
    **more: Any,
) -> Match:  # fmt: skip
    """Return matches of `stage` whose home is a team with `settings`; `opponents`: the other team, None: by actions."""
    sides = {"home": make_team(team, **settings)} | ({} if opponents is None else {"away": opponents})
    return stage(batch, league, controllers=sides, **more)


def stage_ball(
    batch: Batch, x: Any, y: Any, heading: Any, distance: np.ndarray, bearing: Any, *, forward: Any = 0.0,
    league: str | League = LEGGED, **settings: Any,
) -> Match:  # fmt: skip
    """Return matches with a robot at a pose [m, rad] and a still ball at a distance [m] and bearing [rad] from it.

    Nothing else is orange; the robot walks `forward` [m/s], and its head obeys actions.
    """
    settings["sensors"] = {"patches": 0.0, **settings.get("sensors", {})}
    match = stage(batch, league, matches=len(distance), actions="full", **settings)
    put(match, 0, x, y, heading, forward)
    put_ball(match, *point_ahead(match, 0, distance, bearing))
    begin_scene(match)
    return match


def kick_off(
    batch: Batch, *, matches: int = 32, team: str = "chaser", rules: str | None = None, **settings: Any
) -> Match:
    """Return legged matches of the usual team sizes from the kick-off, a team with sensors against itself.

    The matches use the batch's rules of play, unless `rules` are given.
    """
    settings = {"senses": "sensors", "controllers": {"home": team, "away": team}, **settings}
    return make_matches(batch, LEGGED, rules or batch.play_rules, matches=matches, **settings)


def stage_drill(batch: Batch, scene: str, team: Any, *, matches: int) -> Match:
    """Return matches of a legged drill, one robot of a team against one that stands, under the drill's own rules."""
    return make_matches(
        batch, LEGGED, find_scene(scene).rules, matches=matches, home=1, away=1, keeper=0, scene=scene,
        episode="drill", controllers={"home": team, "away": "still"},
    )  # fmt: skip


def play(match: Match, seconds: float, actions: np.ndarray | None = None) -> Iterator[int]:
    """Step all matches for `seconds`, and yield 0, 1, ... after each control step; robots stand without `actions`.

    Actions (M, R, 4 or 7) may be changed between steps.
    """
    numbers = still_actions(match) if actions is None and match.learns.any() else actions
    for step in range(round(seconds * match.league.control_rate)):
        match.step(numbers)
        yield step


def watch(
    match: Match, seconds: float, actions: np.ndarray | None = None, settle: float = 0.0,
    steer: Callable[[int], None] = lambda step: None,
) -> Iterator[int]:  # fmt: skip
    """Play for `settle` [s], in which heads and filters settle, and for `seconds`; yield the steps after `settle`.

    `steer` is called after each step.
    """
    for step in play(match, settle + seconds, actions):
        steer(step)
        if step >= settle * match.league.control_rate:
            yield step


def record(match: Match, steps: Iterable[Any], read: Callable[[], dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    """Read values (M,) after each of the steps and close the matches; return the values by name as arrays (M, T)."""
    frames = [read() for _ in steps]
    match.close()
    return {name: np.stack([frame[name] for frame in frames], axis=1) for name in frames[0]}


def still_actions(match: Match) -> np.ndarray:
    """Return actions by which robots stand and heads move by themselves: (M, R, 4), with actions="full" (M, R, 7)."""
    actions = np.zeros((match.count, match.robots.shape[1], match.settings.actions.size))
    actions[..., 4:5] = -1.0
    return actions


def point_ahead(match: Match, r: int, distance: Any, bearing: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the point (x, y) [m, field frame] at a distance and bearing from robot r."""
    robot = match.robots[:, r]
    angle = robot["heading"] + bearing
    return robot["x"] + distance * np.cos(angle), robot["y"] + distance * np.sin(angle)


def distance_to_ball(match: Match, r: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """Return the true distance [m] and bearing [rad] of the ball from robot r (M,)."""
    return distance_to_point(match, r, match.balls["x"], match.balls["y"])


def distance_to_point(match: Match, r: int, x: Any, y: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return the true distance [m] and bearing [rad] of a point from robot r (M,)."""
    robot = match.robots[:, r]
    dx, dy = x - robot["x"], y - robot["y"]
    return np.hypot(dx, dy), wrap_angle(np.arctan2(dy, dx) - robot["heading"])


def wrap_angle(angle: np.ndarray) -> np.ndarray:
    """Wrap angles [rad] to [-pi, pi)."""
    return (angle + np.pi) % (2.0 * np.pi) - np.pi
