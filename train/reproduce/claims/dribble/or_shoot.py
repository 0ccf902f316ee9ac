"""Dribbling round blockers against what the team did before: orbit and shoot.  [Sacks 2001, 4, 4.3.4]"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from soccer_env.staging import send_off
from soccer_env.train.reproduce.claim import SACKS, Batch, Claim, Curve, Figure
from soccer_env.train.reproduce.drill_runs import start_drill
from soccer_env.train.reproduce.verdicts import Samples, measured, reported
from soccer_env.types import AWAY, HOME

MATCHES, SECONDS = 32, 60.0  # [s] of a run, until the first goal
SCENE = "dribble-past-three"  # three players who stand on the way to the goal
STRATEGIES: dict[str, dict[str, Any]] = {
    "dribble": {},
    "orbit and shoot": {"avoidance": False},
}


def play_to_goal(batch: Batch, settings: dict[str, Any], blockers: bool) -> tuple[np.ndarray, ...]:
    """Play until a goal or the end; return goals (M,), the ball's progress [m] towards the goal, and when it ended."""
    match = start_drill(batch, SCENE, settings, MATCHES, 0.0)
    if not blockers:
        send_off(match, range(1, match.robots.shape[1]))
        match.rebuild()
    start, best = match.balls["x"].copy(), match.balls["x"].copy()
    goals = np.zeros(MATCHES)
    running = np.ones(MATCHES, bool)
    ended = np.full(MATCHES, SECONDS)
    for step in range(round(SECONDS * match.league.control_rate)):
        if not running.any():
            break
        match.step()
        scored = running & (match.events["goal"] == HOME)
        goals += scored
        ended = np.where(scored, step * match.league.dt, ended)
        running &= ~scored & (match.events["goal"] != AWAY)
        best = np.where(running, np.maximum(best, match.balls["x"]), best)
    half = match.league.pitch.length / 2
    match.close()
    return goals, np.where(goals > 0, half, best) - start, ended


def both_strategies(batch: Batch) -> Samples:
    """Return goals, progress and time of both strategies, with blockers and without ("... alone")."""
    found: Samples = {}
    for name, settings in STRATEGIES.items():
        for where, blockers in (("", True), (" alone", False)):
            goals, progress, ended = play_to_goal(batch, settings, blockers)
            found |= {f"goals {name}{where}": goals, f"progress {name}{where}": progress, f"ended {name}{where}": ended}
    return found


def more(samples: Samples, what: str, where: str = "", factor: float = 100.0) -> float:
    """Return how much more of something dribbling brings than orbit and shoot."""
    new, old = (samples[f"{what} {name}{where}"].mean() for name in STRATEGIES)
    return factor * float(new - old)


def goals_of(samples: Samples, name: str) -> float:
    """Return the share of runs [%] with a goal among blockers."""
    return 100.0 * float(samples[f"goals {name}"].mean())


def goal_figure(samples: Samples) -> Sequence[Figure]:
    """Draw the share of runs with a goal against the time."""
    times = tuple(np.arange(0.0, SECONDS + 1.0, 5.0))
    curves = tuple(
        Curve(f"{name}, {'three blockers' if where == '' else 'nobody in the way'}", times, [
            100.0 * float((samples[f"goals {name}{where}"] * (samples[f"ended {name}{where}"] <= time)).mean())
            for time in times
        ])
        for name in STRATEGIES for where in ("", " alone")
    )  # fmt: skip
    return (Figure("Goals of one robot with the ball", "time [s]", "runs with a goal [%]", curves),)


S31 = Claim(
    id="S31",
    paper=SACKS,
    section="4, 4.3.4",
    statement="Dribbling round other players adds to the strategy of orbiting the ball and shooting.",
    method=f"{MATCHES} runs a batch begin as the drill {SCENE}: ball between the paws, three players stand on the way; "
    f"goals within {SECONDS:g} s by sacks-2001 as it is, against orbit and shoot (avoidance=False, and shots from "
    "anywhere that do not heed blockers). Beside it with nobody in the way.",
    criteria=(
        measured("runs with a goal, dribbling less orbit and shoot, three blockers", lambda s: more(s, "goals"),
                 unit="%", above=0.0),
        *(reported(f"goals, {name}", partial(goals_of, name=name), unit="%")
          for name in STRATEGIES),
        reported("ball's progress, dribbling less orbit and shoot", lambda s: more(s, "progress"), unit="cm"),
        reported("nobody in the way: goals, dribbling less orbit and shoot", lambda s: more(s, "goals", " alone"),
                 unit="%"),
    ),
    measure=both_strategies,
    figures=goal_figure,
    ingredients=("the drill's places", "kicks of 0.8 to 1.5 m/s with a spread of 10 degrees"),
    note="Against players who only stand both score alike: the new strategy shoots too where it can, and a blind shot "
    "that hits somebody is fetched and tried again, for nobody takes the ball away.",
    seconds=6.0,
    batches=24,
)  # fmt: skip

CLAIMS = (S31,)
