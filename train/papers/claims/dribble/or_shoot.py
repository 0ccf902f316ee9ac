"""Dribbling round blockers against the team's former play: orbit and shoot.  [Sacks 2001, 4, 4.3.4]"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.match.staging import send_off
from soccer_env.train.papers.claim import PLAYED, Batch, claim, compare
from soccer_env.train.papers.dribble_runs import start_drill
from soccer_env.train.papers.plots import plot_shares
from soccer_env.train.papers.values import gain
from soccer_env.train.papers.verdicts import Samples, measured
from soccer_env.types import AWAY, HOME

MATCHES, SECONDS = 24, 60.0  # [s] of a run, until the first goal of either side
SCENE = "dribble-past-three"  # three standing players on the way to the goal
STRATEGIES: dict[str, dict[str, Any]] = {"dribble": {}, "orbit and shoot": {"avoidance": False}}
BLOCKERS = {"": "chaser", " still": "still", " alone": None}  # suffix of the samples: team; None: no blockers
PLAN = {f"{name}{where}": (how, team) for name, how in STRATEGIES.items() for where, team in BLOCKERS.items()}


def play_to_goal(batch: Batch, settings: dict[str, Any], blockers: str | None) -> Samples:
    """Play from the drill's start to a goal or for SECONDS, against the team `blockers` or, if None, against nobody.

    Return goals and goals against (M,), the ball's progress [m] towards the goal, and the time of the end [s].
    """
    match = start_drill(batch, SCENE, settings, MATCHES, 0.0, opponents=blockers, rules=batch.play_rules)
    if blockers is None:
        send_off(match, range(1, match.robots.shape[1]))
        match.rebuild()
    start, best = match.balls["x"].copy(), match.balls["x"].copy()
    goals, against = np.zeros((2, MATCHES))
    running = np.ones(MATCHES, bool)
    ended = np.full(MATCHES, SECONDS)
    for step in range(round(SECONDS * match.league.control_rate)):
        if not running.any():
            break
        match.step()
        scored, conceded = (running & (match.events["goal"] == team) for team in (HOME, AWAY))
        goals += scored
        against += conceded
        ended = np.where(scored | conceded, step * match.league.dt, ended)
        running &= ~(scored | conceded)
        best = np.where(running, np.maximum(best, match.balls["x"]), best)
    half = match.league.pitch.length / 2
    match.close()
    progress = np.where(goals > 0, half, best) - start
    return {"goals": goals, "against": against, "progress": progress, "ended": ended}


def goal_times(samples: Samples, name: str) -> np.ndarray:
    """Return the times of the goals [s] of a strategy, such as "dribble still", infinite for runs without one."""
    return np.where(samples[f"goals {name}"] > 0.0, samples[f"ended {name}"], np.inf)


S31 = claim(
    "S31", "4, 4.3.4", "Dribbling round other players adds to the strategy of orbiting the ball and shooting.",
    f"{MATCHES} runs a batch begin as the drill {SCENE}: ball between the paws, three players on the way, who "
    f"go for the ball as the team chaser does; goals within {SECONDS:g} s, until the first of either side, by "
    "sacks-2001, which dribbles round who is in its way and shoots where nobody is, against orbit and shoot "
    "(avoidance=False: from anywhere, whoever stands there). Beside it against three who stand, and with nobody there.",
    measured("goals, dribbling less orbit and shoot, blockers after the ball", gain,
             *(f"goals {name}" for name in STRATEGIES), unit="%", above=0.0),
    rules=PLAYED, measure=lambda batch: compare(PLAN, lambda how: play_to_goal(batch, *how)),
    figures=plot_shares("Goals of one robot with the ball", "time [s]", "runs with a goal [%]",
                        np.arange(0.0, SECONDS + 1.0, 5.0),
                        {f"{name}, {text}": partial(goal_times, name=f"{name}{where}") for name in STRATEGIES
                         for where, text in (("", "three who go for the ball"), (" still", "three still"),
                                             (" alone", "nobody"))}),
    batches=14, seconds=4.2,
    ingredients=("the drill's places", "kicks of 0.8 to 1.5 m/s with a spread of 10 degrees"),
    note="Against players who only stand a blind shot that hits somebody is fetched and tried again, for nobody takes "
    "the ball away.",
)  # fmt: skip
