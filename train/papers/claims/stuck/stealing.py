"""Stealing the ball by running into the opponent that has it.  [Sacks 2001, 4]"""

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import PLAYED, Batch, Claim
from soccer_env.train.papers.staging import begin_scene, play, point_ahead, put, put_ball, stage
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, counted, reported

STEALS, STEAL_TIME = 64, 30.0  # scenes a batch, [s] of each
JUST = 0.25  # [s] after a touch in which a ball that is lost was lost by it, assumed


def steal(batch: Batch, avoid: bool) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Let a robot chase an opponent with the ball; return balls won (M,), balls won by contact, and referee's calls.

    By contact: the opponent loses the ball during a touch between the two or just after, and the robot has the ball
    next. The scene ends after STEAL_TIME, or when the referee whistles or moves the ball.
    """
    rng = batch.rng()
    sides: dict[str, Any] = {"home": make_team("sacks-2001", avoid_chasing=avoid), "away": make_team("sacks-2001")}
    match = stage(batch, matches=STEALS, controllers=sides, keeper=0, rules=batch.play_rules)
    x, y = rng.uniform(-0.3, 0.5, STEALS), rng.uniform(-0.4, 0.4, STEALS)
    heading = np.pi + rng.uniform(-0.8, 0.8, STEALS)
    put(match, 1, x, y, heading)
    put_ball(match, *point_ahead(match, 1, match.league.body.front + match.league.ball.radius + 0.003, 0.0))
    angle, away = np.pi + rng.uniform(-1.2, 1.2, STEALS), rng.uniform(0.5, 0.8, STEALS)
    put(match, 0, x + away * np.cos(angle), y + away * np.sin(angle), angle + np.pi + rng.uniform(-0.3, 0.3, STEALS))
    begin_scene(match, placed=True)
    won, by_contact, called = np.zeros(STEALS), np.zeros(STEALS), np.zeros(STEALS)
    over, lost, had = np.zeros(STEALS, bool), np.zeros(STEALS, bool), np.ones(STEALS, bool)
    touched = np.full(STEALS, np.inf)  # [s] since the two touched
    for _ in play(match, STEAL_TIME):
        touched = np.where(match.robot_events["collision"][:, 0] == 1, 0.0, touched + match.league.dt)
        ends = ended_by_referee(match) & ~over
        called[ends] = 1.0
        over |= ends
        has = match.robots["has_ball"][:, 1] == 1
        lost = (lost | (had & (touched <= JUST))) & ~has  # by contact, and it has not got it back
        had = has
        alone = (match.robots["has_ball"][:, 0] == 1) & (match.robots["has_ball"][:, 1] == 0)
        won[alone & ~over] = 1.0
        by_contact[alone & ~over & lost] = 1.0
        over |= alone | (match.events["goal"] >= 0)
    match.close()
    return won, by_contact, called


def ended_by_referee(match: Match) -> np.ndarray:
    """Tell in which scenes (M,) the referee whistles, moves the ball or pulls opponents apart."""
    events = match.events
    called: np.ndarray = (events["foul"] != 0) | (events["restart"] != 0) | (events["separated"] == 1)
    return called & (match.events["goal"] < 0)


def compare_avoidance(batch: Batch) -> Samples:
    """Return the results of `steal` with avoidance while chasing, and without avoidance (M,)."""
    (on, on_contact, on_called), (off, off_contact, off_called) = steal(batch, True), steal(batch, False)
    found = {"on": on, "off": off, "on contact": on_contact, "contact": off_contact}
    return {**found, "called": 0.5 * (on_called + off_called), "one": np.ones(STEALS)}


S30 = Claim(
    id="S30",
    section="4",
    statement="While chasing the ball a collision can help: avoid others only in possession.",
    method=f"{STEALS} scenes a batch: an opponent (sacks-2001) has the ball between its paws, a robot 50 to 80 cm "
    f"before it goes for it, walking round others or not; who has the ball alone within {STEAL_TIME:g} s, and who "
    "because the opponent lost it in contact with the robot. A whistle against one of them, a dropped ball and "
    "being pulled apart end a scene that nobody has won.",
    criteria=(
        counted("not avoiding: balls won by contact", "contact", "one", at_least=1.0),
        reported("avoiding: balls won by contact", "on contact", unit="%"),
        reported("balls won without avoidance", "off", unit="%"),
        reported("balls won with avoidance", "on", unit="%"),
        reported("scenes that the referee ended", "called", unit="%"),
        reported("balls won: not avoiding less avoiding", lambda s: 100.0 * mean(s["off"] - s["on"]), unit="pp"),
    ),
    rules=PLAYED,
    measure=compare_avoidance,
    ingredients=("how the team walks round others: soccer_env/skills/moves.py",),
    seconds=3.0,
    batches=16,
)
