"""What the referee's hand does to play: how far he carries robots, and whether goals follow from it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from soccer_env.train.play.figures import Figure, Measure, Samples, a_minute, most, percentile, ratio
from soccer_env.train.play.recording import Recording
from soccer_env.train.play.runs import by_match
from soccer_env.types import NO_TEAM, Phase

JUMP = 0.05  # [m] beyond what a robot drives in a step: a shorter move cannot be told from driving
SOON, LATER = 6.0, 25.0  # [s] in which a goal follows from a separation, from a dropped ball
FAR = 0.8  # [m] that a goalkeeper is carried out of its place


def after_separations(recording: Recording) -> Samples:
    """Goals of both teams in the 6 s after a separation and in all other play, with the time in play of both."""
    soon = since(recording.events["separated"] == 1, recording.steps(SOON))
    goal = (recording.events["goal"] != NO_TEAM) & recording.live
    return {
        "goals_soon": (goal & soon).sum(axis=0),
        "time_soon": recording.seconds(recording.in_play & soon),
        "goals_else": (goal & ~soon).sum(axis=0),
        "time_else": recording.seconds(recording.in_play & ~soon),
    }


def carried_apart(recording: Recording) -> Samples:
    """Distance by which a separation carries a robot, of all that it carries by 5 cm and more."""
    return {"carried_apart": pooled(recording, jumps(recording, recording.events["separated"] == 1))}


def carried_at_drops(recording: Recording) -> Samples:
    """Distance by which a dropped ball carries a robot, of all that it carries by 5 cm and more."""
    return {"carried_at_drops": pooled(recording, jumps(recording, is_drop(recording)))}


def keepers_at_drops(recording: Recording) -> Samples:
    """Goalkeepers that a dropped ball carries by more than 80 cm, and those that concede a goal in the next 25 s."""
    drop = is_drop(recording)
    keeper = (recording.robots["keeper"] == 1) & (jumps(recording, drop) > FAR)
    conceded = np.zeros(drop.shape[1])
    goal = np.where(recording.live, recording.events["goal"], NO_TEAM)
    for step, m, r in zip(*np.nonzero(keeper), strict=True):
        scorers = goal[step : step + recording.steps(LATER) + 1, m]
        conceded[m] += (scorers == 1 - recording.robots["team"][step, m, r]).any()
    return {"drops": drop.sum(axis=0), "keeper_drops": keeper.any(axis=-1).sum(axis=0), "conceded": conceded}


def is_drop(recording: Recording) -> np.ndarray:
    """Return where (T, M) a dropped ball is called."""
    found: np.ndarray = (recording.events["restart"] == Phase.DROP_BALL) & recording.live
    return found


def since(when: np.ndarray, steps: int) -> np.ndarray:
    """Return the steps (T, M), so many at most, after those in which something happens."""
    count = np.concatenate((np.zeros_like(when[:1], np.int64), np.cumsum(when, axis=0)))  # before each step
    first = np.maximum(np.arange(len(when)) - steps, 0)
    found: np.ndarray = count[:-1] > count[first]
    return found


def jumps(recording: Recording, when: np.ndarray) -> np.ndarray:
    """Return how far (T, M, R) [m] robots are carried in some steps (T, M); 0: driven. Penalties do not count."""
    robots, found = recording.robots, np.zeros(recording.robots.shape)
    x, y = (np.diff(robots[name], axis=0) for name in ("x", "y"))
    on = (robots["active"][1:] == 1) & (robots["active"][:-1] == 1) & (recording.deeds["returned"][1:] == 0)
    way = np.hypot(x, y)
    driven = recording.league.drive.forward * recording.league.dt
    found[1:] = np.where(on & when[1:, :, None] & (way > driven + JUMP), way, 0.0)
    return found


def pooled(recording: Recording, values: np.ndarray) -> np.ndarray:
    """Return the values above 0 of an array (T, M, R) as an array (M,) of arrays."""
    return by_match(values[values > 0.0], np.nonzero(values)[1], recording.live.shape[1], 1)


def rate(name: str, goals: str, time: str) -> Figure:
    """Return the goals in a minute of some part of play."""
    return Figure(name, "/min", lambda found: 60.0 * ratio(found[goals].sum(), found[time].sum()))


def more(found: Mapping[str, np.ndarray]) -> float:
    """Return the goals in a minute of play after separations less those of the rest."""
    soon = ratio(found["goals_soon"].sum(), found["time_soon"].sum())
    return 60.0 * (soon - ratio(found["goals_else"].sum(), found["time_else"].sum()))


def share(name: str, part: str, whole: str) -> Figure:
    """Return how many [%] of some events are of a kind."""
    return Figure(name, "%", lambda found: 100.0 * ratio(found[part].sum(), found[whole].sum()))


MEASURES = (
    Measure(
        after_separations,
        (
            rate("goals in the 6 s after a separation", "goals_soon", "time_soon"),
            rate("goals in the rest of play", "goals_else", "time_else"),
            Figure("goals after separations less the rest", "/min", more),
        ),
    ),
    Measure(carried_apart, (most("carried by a separation, most", "carried_apart", "m"),)),
    Measure(
        carried_at_drops,
        (
            percentile("carried at a dropped ball, 90 %", "carried_at_drops", 90.0, "m"),
            most("carried at a dropped ball, most", "carried_at_drops", "m"),
        ),
    ),
    Measure(
        keepers_at_drops,
        (
            a_minute("dropped balls", "drops"),
            share("drops that carry a keeper 80 cm", "keeper_drops", "drops"),
            share("of these, conceded in 25 s", "conceded", "keeper_drops"),
        ),
    ),
)
