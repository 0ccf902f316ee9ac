"""Collisions on the way to the ball: how common they are, and what noticing them is worth.  [Sacks 2001, 1, 3, 4]"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from soccer_env.baselines.sacks_2001.memory import APPROACH
from soccer_env.match import Match
from soccer_env.staging import memory_of
from soccer_env.teams import make_team
from soccer_env.train.reproduce.claim import SACKS, Batch, Claim, Curve, Figure
from soccer_env.train.reproduce.claims.stuck.runs import behind_post
from soccer_env.train.reproduce.staging import LEGGED, kick_off, play
from soccer_env.train.reproduce.values import mean
from soccer_env.train.reproduce.verdicts import Samples, counted, measured, reported

OFF = "sacks-2001:recovery=False,avoidance=False"  # "everything off": S01
MATCHES, SECONDS = 12, 120.0  # of 3 v 3, [s] of each: S01
CROWD, NEAR = 3, 0.5  # [1] robots within [m] of the ball, assumed: S01
PART = 1.0  # [s] without contact that ends an episode
TASKS = {"blocker": "ball-behind-robot", "wall": "facing-wall", "post": ""}  # S02; post: staged, see below
UNITS, DRILLS = 12, 4  # units of a batch, drills of each task in a unit
LONGEST = 60.0  # [s] of a drill
PLAY = 90.0  # [s] of 3 v 3, S02
PUSHES, DEADLOCK = 64, 20.0  # drills head-on-push a batch, [s] assumed: S03


def contacts(batch: Batch) -> Samples:
    """Count contact episodes (M,) and the time with three robots and more near the ball (M,) [s] in 3 v 3 play."""
    match = kick_off(batch, matches=MATCHES, team=OFF)
    episodes, crowded, touching = np.zeros((3, MATCHES))
    since = np.full(match.robots.shape, np.inf)
    for _ in play(match, SECONDS):
        touch = match.robot_events["collision"] == 1
        episodes += (touch & (since > PART)).sum(axis=1)
        since = np.where(touch, 0.0, since + match.league.dt)
        x, y = match.robots["x"] - match.balls["x"][:, None], match.robots["y"] - match.balls["y"][:, None]
        crowded += (np.hypot(x, y) < NEAR).sum(axis=1) >= CROWD
        touching += touch.any(axis=1)
    match.close()
    in_seconds = {"crowded": crowded * match.league.dt, "touching": touching * match.league.dt}
    return {"episodes": 0.5 * episodes, **in_seconds}


S01 = Claim(
    id="S01",
    paper=SACKS,
    section="abstract, 1",
    statement="Three or four robots often head for the ball at once, and collisions between robots are common.",
    method=f"{MATCHES} matches a batch of 3 v 3, {SECONDS:g} s each, sacks-2001 without recovery and avoidance: "
    f"contacts after {PART:g} s without, of two robots each; time with {CROWD} robots and more within "
    f"{100 * NEAR:.0f} cm of the ball.",
    criteria=(
        measured("contact episodes a minute and match", lambda s: mean(s["episodes"]) * 60.0 / SECONDS, at_least=1.0),
        measured(
            "time with three robots and more near the ball",
            lambda s: 100.0 * mean(s["crowded"]) / SECONDS,
            unit="%",
            at_least=10.0,
        ),
        reported("time with some robots in contact", lambda s: 100.0 * mean(s["touching"]) / SECONDS, unit="%"),
    ),
    measure=contacts,
    ingredients=("sacks-2001: one attacker, the others support", "recovery=False, avoidance=False"),
    seconds=8.0,
    batches=8,
)


def task(batch: Batch, scene: str, recovery: bool) -> np.ndarray:
    """Return the time [s] until the ball was got in each drill (M,); inf: not within LONGEST."""
    count = UNITS * DRILLS
    if not scene:
        return past_post(batch, count, recovery)
    team = make_team("sacks-2001", recovery=recovery)
    match = Match(
        LEGGED, matches=count, seeds=batch.seeds(count), threads=batch.threads, home=1, away=1, keeper=0, scene=scene,
        episode="drill", pose=batch.pose, controllers={"home": team, "away": "still"},
    )  # fmt: skip
    got = np.full(count, np.inf)
    for step in play(match, LONGEST):
        got[match.events["drill"] == 1] = (step + 1) * match.league.dt
        if match.matches["over"].all():
            break
    match.close()
    return got


def past_post(batch: Batch, count: int, recovery: bool) -> np.ndarray:
    """Return the time [s] until the ball was got that is seen past a robot in the way; inf: not within LONGEST."""
    match = behind_post(batch, count, recovery=recovery)
    got = np.full(count, np.inf)
    for step in play(match, LONGEST):
        has_ball = match.robots["has_ball"][:, 0] == 1
        got[has_ball & np.isinf(got)] = (step + 1) * match.league.dt
        if np.isfinite(got).all():
            break
    match.close()
    return got


def calls(batch: Batch, recovery: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return stuck balls that the referee calls in 3 v 3 play (M,), and robots that he pulls apart (M,)."""
    match = kick_off(batch, matches=UNITS, team=f"sacks-2001:recovery={recovery}")
    stuck, apart = np.zeros(UNITS), np.zeros(UNITS)
    for _ in play(match, PLAY):
        stuck += match.events["stuck"]
        apart += match.events["separated"]
    match.close()
    return stuck, apart


def on_and_off(batch: Batch) -> Samples:
    """Return times to the ball of both tasks (U, drills) and referee's calls (U,), with the recovery and without."""
    found = {}
    for word, recovery in (("on", True), ("off", False)):
        for name, scene in TASKS.items():
            found[f"{name} {word}"] = task(batch, scene, recovery).reshape(UNITS, DRILLS)
        found[f"calls {word}"], found[f"apart {word}"] = calls(batch, recovery)
    return found


def success(samples: Samples, word: str, tasks: Sequence[str] = tuple(TASKS)) -> float:
    """Return the share [%] of drills in which the ball was got."""
    return 100.0 * mean([np.isfinite(samples[f"{name} {word}"]) for name in tasks])


def median_time(samples: Samples, word: str) -> float:
    """Return the median time [s] to the ball, drills without success last (at LONGEST)."""
    times = np.concatenate([samples[f"{name} {word}"].ravel() for name in TASKS])
    return float(np.median(np.minimum(times, LONGEST)))


def time_figure(samples: Samples) -> Sequence[Figure]:
    """Draw how many have the ball by when."""
    grid = np.linspace(0.0, LONGEST, 61)
    curves = []
    for name in TASKS:
        for word in ("on", "off"):
            times = samples[f"{name} {word}"].ravel()
            curves.append(
                Curve(f"{name}, recovery {word}", grid.tolist(), [100.0 * float((times <= t).mean()) for t in grid])
            )
    return (Figure("Who has the ball by when", "time [s]", "drills [%]", tuple(curves)),)


S02 = Claim(
    id="S02",
    paper=SACKS,
    section="1",
    statement="A robot that avoids collisions and recovers from them reaches the ball more quickly and more reliably; "
    "collisions slow the game down.",
    method=f"Drills ball-behind-robot and facing-wall, and a ball that is seen past a robot which nobody pushes aside, "
    f"{UNITS * DRILLS} of each a batch, sacks-2001 with the stuck counters and recovery and without, the same seeds: "
    f"ball got within {LONGEST:g} s. Referee's calls of a stuck ball in "
    f"{UNITS} matches of 3 v 3, {PLAY:g} s each, both sides with or without.",
    criteria=(
        measured(
            "success with recovery less without",
            lambda s: success(s, "on") - success(s, "off"),
            unit="%",
            at_least=20.0,
        ),
        measured(
            "median time to the ball, with less without",
            lambda s: median_time(s, "on") - median_time(s, "off"),
            unit="s",
            below=0.0,
        ),
        measured(
            "stuck balls a minute of play, with less without",
            lambda s: (mean(s["calls on"]) - mean(s["calls off"])) * 60.0 / PLAY,
            below=0.0,
        ),
        *(
            reported(f"success, {name}, recovery {word}", partial(success, word=word, tasks=(name,)), unit="%")
            for name in TASKS
            for word in ("on", "off")
        ),
        reported("stuck balls a minute without recovery", lambda s: mean(s["calls off"]) * 60.0 / PLAY),
        reported("robots pulled apart a minute, with recovery", lambda s: mean(s["apart on"]) * 60.0 / PLAY),
        reported("robots pulled apart a minute, without", lambda s: mean(s["apart off"]) * 60.0 / PLAY),
    ),
    measure=on_and_off,
    figures=time_figure,
    ingredients=("where a robot stands between, it hides the ball", "bodies slide past each other and along boards"),
    note="Recovery helps where somebody in the way stands fast (post). A robot right before the ball (blocker) hides "
    "it, and the team searches; at a board (wall) it turns unhindered: there recovery has next to nothing to do.",
    seconds=12.0,
    batches=6,
)


def push(batch: Batch) -> Samples:
    """Let two robots push against each other over a ball; return who is still undecided after DEADLOCK (M,)."""
    found: Samples = {"one": np.ones(PUSHES)}
    for name, recovery in (("off", False), ("on", True)):
        match = Match(
            LEGGED, matches=PUSHES, seeds=batch.seeds(PUSHES), threads=batch.threads, home=1, away=1, keeper=0,
            scene="head-on-push", episode="drill", pose=batch.pose,
            controllers={side: make_team("sacks-2001", recovery=recovery) for side in ("home", "away")},
        )  # fmt: skip
        until = np.full(PUSHES, np.inf)
        for memory in (memory_of(match, r) for r in range(2)):  # they have been after the ball before
            memory["begun"] = memory["attacks"] = 1
            memory["behaviour"] = APPROACH
        for step in play(match, DEADLOCK):
            until[match.events["drill"] != 0] = (step + 1) * match.league.dt
        match.close()
        found[name], found[f"until {name}"] = np.isinf(until).astype(float), np.minimum(until, DEADLOCK)
    return found


def push_figure(samples: Samples) -> Sequence[Figure]:
    """Draw how many are still stuck by when."""
    grid = np.linspace(0.0, DEADLOCK, 41)[:-1]
    curves = tuple(
        Curve(title, grid.tolist(), [100.0 * float((samples[f"until {name}"] > t).mean()) for t in grid])
        for name, title in (("off", "no detection"), ("on", "detection and recovery"))
    )
    return (Figure("Two robots over a still ball", "time [s]", "still stuck [%]", curves, rules=(80.0,)),)


S03 = Claim(
    id="S03",
    paper=SACKS,
    section="3",
    statement="Two robots that push against each other over a still ball would go on, and none would move anywhere.",
    method=f"{PUSHES} drills a batch, head-on-push: face to face, the ball between the paws of both, both sacks-2001 "
    f"without the stuck counters, {DEADLOCK:g} s; free is who has the ball with nobody near it, or carried it 30 cm.",
    criteria=(
        counted("still stuck at 20 s", "off", "one", at_least=80.0),
        reported(
            "median time until somebody is free (20: nobody)", lambda s: float(np.median(s["until off"])), unit="s"
        ),
        reported("still stuck at 20 s with detection and recovery", lambda s: 100.0 * mean(s["on"]), unit="%"),
    ),
    measure=push,
    figures=push_figure,
    ingredients=("friction of bodies and ball", "bodies are a trunk and four posts, which can interlock"),
    note="Detection changes nothing here: most of the time a robot takes the ball between its paws for its own, else "
    "it pushes on, for the ball is contested. The counters run only in the latter, and a second with the ball sets "
    "both back: the first nearly gets to its nine readings, the second one never to its 8 s.",
    seconds=1.2,
    batches=24,
)

CLAIMS = (S01, S02, S03)
