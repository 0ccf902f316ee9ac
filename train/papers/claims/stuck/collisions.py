"""Collisions on the way to the ball: their frequency and duration; stealing the ball by one.  [Sacks 2001, 1, 3, 4]"""

from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import APPROACH
from soccer_env.match import Match
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import PLAYED, PLAYED_AND_STAGED, Batch, claim
from soccer_env.train.papers.claims.stuck.branches import count_hits, follow_moments
from soccer_env.train.papers.claims.stuck.runs import set_up_converging
from soccer_env.train.papers.claims.stuck.sampled import MotionWindow, behaviours
from soccer_env.train.papers.plots import plot_shares
from soccer_env.train.papers.staging import begin_scene, kick_off, play, point_ahead, put, put_ball, stage
from soccer_env.train.papers.values import mean, percent
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

OFF = "sacks-2001:recovery=False,avoidance=False"  # "everything off": S01
MATCHES, SECONDS = 12, 120.0  # of 3 v 3, [s] of each: S01
CROWD, NEAR = 3, 0.5  # [1] robots within [m] of the ball, assumed: S01
PART = 1.0  # [s] without contact that ends an episode
MOVED = 0.1  # [m] greatest movement of a still ball, assumed: S03
PAIRS, COME, DEADLOCK = 64, 12.0, 20.0  # pairs a batch, [s] for them to hold each other, [s] after that: S03


def count_near_ball(match: Match) -> np.ndarray:
    """Return the number of robots (M,) on the field within NEAR of the ball."""
    robots, ball = match.robots, match.balls
    away = np.hypot(robots["x"] - ball["x"][:, None], robots["y"] - ball["y"][:, None])
    return np.asarray(((away < NEAR) & (robots["active"] == 1)).sum(axis=1))


def contacts(batch: Batch) -> Samples:
    """Count contact episodes (M,), time with a crowd at the ball (M,) [s], approaches and approaches with a contact."""
    match = kick_off(batch, matches=MATCHES, team=OFF)
    episodes, crowded, touching, approaches, met = np.zeros((5, MATCHES))
    since, was = np.full(match.robots.shape, np.inf), np.zeros(match.robots.shape, bool)
    fresh = was.copy()  # an approach that has not met anybody yet
    for _ in play(match, SECONDS):
        touch = match.robot_events["collision"] == 1
        episodes += (touch & (since > PART)).sum(axis=1)
        since = np.where(touch, 0.0, since + match.league.dt)
        crowded += count_near_ball(match) >= CROWD
        touching += touch.any(axis=1)
        goes = behaviours(match) == APPROACH
        approaches += (goes & ~was).sum(axis=1)
        fresh = goes & (fresh | ~was)
        met += (fresh & touch).sum(axis=1)
        fresh, was = fresh & ~touch, goes
    match.close()
    in_seconds = {"crowded": crowded * match.league.dt, "touching": touching * match.league.dt}
    return {"episodes": 0.5 * episodes, **in_seconds, "approaches": approaches, "met": met}


S01 = claim(
    "S01", "abstract, 1", "Three or four robots often head for the ball at once, and collisions are common.",
    f"{MATCHES} matches a batch of 3 v 3, {SECONDS:g} s each, sacks-2001 without recovery and avoidance: "
    f"contacts after {PART:g} s without, of two robots each; time with {CROWD} robots and more within {100 * NEAR:.0f} "
    "cm of the ball; approaches to the ball in which the robot touches another.",
    measured("contact episodes a minute and match", lambda s: mean(s["episodes"]) * 60.0 / SECONDS, at_least=1.0),
    measured("time with three robots and more near the ball", lambda s: 100.0 * mean(s["crowded"]) / SECONDS,
             unit="%", at_least=10.0),
    counted("approaches in which the robot touches another", "met", "approaches", at_least=20.0),
    reported("time with some robots in contact", lambda s: 100.0 * mean(s["touching"]) / SECONDS, unit="%"),
    rules=PLAYED, measure=contacts, batches=8, seconds=4.0,
    ingredients=("sacks-2001: one attacker, the others support", "recovery=False, avoidance=False"),
)  # fmt: skip


def deadlocks(batch: Batch, recovery: bool) -> Samples:
    """Let pairs go for a ball; return pairs held short of it, pairs without the ball 20 s later, and the times."""
    match = set_up_converging(batch, PAIRS, recovery=recovery)
    watch = MotionWindow(match)
    held, got = np.full(PAIRS, np.nan), np.full(PAIRS, np.inf)
    moved, lay_x, lay_y = np.zeros(PAIRS, bool), match.balls["x"].copy(), match.balls["y"].copy()
    for step in play(match, COME + DEADLOCK):
        now = (step + 1) * match.league.dt
        watch.look()
        got[np.isinf(got) & (match.robots["has_ball"] == 1).any(axis=1)] = now
        if watch.full() and now <= COME:
            held[np.isnan(held) & np.isinf(got) & watch.fell_short().any(axis=1)] = now
        moved |= (np.hypot(match.balls["x"] - lay_x, match.balls["y"] - lay_y) > MOVED) & (now <= held + DEADLOCK)
    match.close()
    after = got - held
    without = after > DEADLOCK
    flags = {"held": ~np.isnan(held), "without": without, "stuck": without & ~moved}
    return {**{name: values.astype(float) for name, values in flags.items()}, "until": after}


def compare_deadlocks(batch: Batch) -> Samples:
    """Return `deadlocks` without and with recovery (M,), and the robots held in play and not free 20 s later (M,)."""
    off, on = deadlocks(batch, False), deadlocks(batch, True)
    held, bound = count_hits(follow_moments(batch, recovery=False), lambda f: ~(f["freed"] <= DEADLOCK))
    lay, still = count_hits(follow_moments(batch, recovery=False), lambda f: ~(f["freed"] <= DEADLOCK), still=1.0)
    play_of = {"play": held, "play bound": bound, "lay": lay, "lay bound": still}
    padded = {name: np.concatenate([v, np.zeros(PAIRS - len(v))]) for name, v in play_of.items()}
    return {**off, **{f"{name} on": values for name, values in on.items()}, **padded, "one": np.ones(PAIRS)}


S03 = claim(
    "S03", "3", "Two robots pushing against each other over a still ball would both stay there.",
    f"{PAIRS} pairs a batch, both sacks-2001 without the stuck counters, go for a still ball 50 to 70 cm before "
    "their cameras, from ways that meet at 30 to 120 degrees; of those in which a robot comes to be held short of it "
    "(contact, and in 1.5 s no nearer to it than by a quarter of what its legs walk): neither has had the ball "
    f"{DEADLOCK:g} s later, and the ball has not moved. Beside it robots that are held in 3 v 3 play.",
    counted("held pairs without the ball 20 s later, the ball where it lay", "stuck", "held", at_least=80.0),
    reported("held pairs without the ball 20 s later, with recovery", percent, "without on", "held on", unit="%"),
    reported("robots held in play, not free 20 s later", percent, "play bound", "play", unit="%"),
    reported("the same where the ball lay still", percent, "lay bound", "lay", unit="%"),
    rules=PLAYED_AND_STAGED, measure=compare_deadlocks,
    figures=plot_shares("Two robots held short of a still ball", "time [s]", "without ball [%]",
                        np.linspace(0.0, DEADLOCK, 41),
                        {"no detection": lambda s: s["until"][s["held"] == 1.0],
                         "detection and recovery": lambda s: s["until on"][s["held on"] == 1.0]}, np.greater,
                        rules=(80.0,)),
    batches=12, seconds=4.0,
    ingredients=("friction of bodies and ball", "bodies are a trunk and four posts, which can interlock"),
    note="Bodies slide past each other: half of the pairs are held short of the ball, and half of these have it three "
    "seconds later. Where they stay together they push the ball on before both of them, and come no nearer.",
)  # fmt: skip

# Stealing the ball by running into the opponent that has it

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


S30 = claim(
    "S30", "4", "While chasing the ball a collision can help: avoid others only in possession.",
    f"{STEALS} scenes a batch: an opponent (sacks-2001) has the ball between its paws, a robot 50 to 80 cm "
    f"before it goes for it, walking round others or not; who has the ball alone within {STEAL_TIME:g} s, and who "
    "because the opponent lost it in contact with the robot. A whistle against one of them, a dropped ball and being "
    "pulled apart end a scene that nobody has won.",
    counted("not avoiding: balls won by contact", "contact", "one", at_least=5.0),
    reported("avoiding: balls won by contact", "on contact", unit="%"),
    reported("scenes that the referee ended", "called", unit="%"),
    reported("balls won: not avoiding less avoiding", lambda s: 100.0 * mean(s["off"] - s["on"]), unit="pp"),
    rules=PLAYED, measure=compare_avoidance, batches=16, seconds=3.0,
    ingredients=("how the team walks round others: soccer_env/skills/moves.py",),
)  # fmt: skip
