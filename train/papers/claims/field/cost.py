"""The computing time of the potential field.  [Sacks 2001, 4.2]"""

from time import perf_counter

import numpy as np

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.leagues import find_league
from soccer_env.train.papers.claim import PLAYED, Batch, Claim
from soccer_env.train.papers.claims.field.point_world import players
from soccer_env.train.papers.claims.field.points import run_points, starts
from soccer_env.train.papers.staging import LEGGED, kick_off
from soccer_env.train.papers.values import quantile
from soccer_env.train.papers.verdicts import Samples, measured, reported

OTHERS = 5  # that a dribbler of 3 v 3 can know of
STEPS = 8  # frames in a repetition: about as long as the runs of points
WARM = 64  # frames before: 4 s of play
QUIET = 0.1  # [1] share of repetitions that no other program disturbs, assumed


def time_decisions(batch: Batch) -> Samples:
    """Time a decision among five other players and a robot's whole frame [us], in 32 repetitions."""
    rng, repetitions = batch.rng(), 32
    start = starts(rng, 64)
    crowd = players(np.stack([rng.uniform(-0.8, 1.2, (64, OTHERS)), rng.uniform(-0.9, 0.9, (64, OTHERS))], axis=-1))
    run_points(rng, start, crowd)
    match = kick_off(batch, matches=4, team="sacks-2001")
    for _ in range(WARM):
        match.step()
    times, frames = [], []
    for _ in range(repetitions):
        begun = perf_counter()
        steps = run_points(rng, start, crowd).steps.sum()
        times.append(1e6 * (perf_counter() - begun) / steps)
        begun = perf_counter()
        for _ in range(STEPS):
            match.step()
        frames.append(1e6 * (perf_counter() - begun) / (STEPS * match.robots.size))
    match.close()
    return {"time": np.array(times), "frame": np.array(frames), "way": np.full(repetitions, steps / len(start))}


def undisturbed_time(times: np.ndarray) -> float:
    """Return the QUIET quantile of repeated times [us], an estimate without disturbance by other programs."""
    return quantile(times, QUIET)


def planning_time_share(samples: Samples, steps: float = 1.0) -> float:
    """Return the time of `steps` decisions in each replan interval over the time of the robot's frames in it [%]."""
    each = SacksSettings().replan * find_league(LEGGED).control_rate  # [frames]
    return 100.0 * steps * undisturbed_time(samples["time"]) / (each * undisturbed_time(samples["frame"]))


S42 = Claim(
    id="S42",
    section="4.2",
    statement="The direction of travel costs few calculations: planning runs in real time.",
    method=f"32 repetitions a batch of 64 runs of the point simulator with {OTHERS} other players: time of the whole "
    "run over the number of decisions, on one core of the machine that runs this; against the time of a frame of 3 "
    "against 3 over its robots: a robot's sensing, beliefs, plan and body. One decision in "
    "half a second.",
    criteria=(
        measured("planning's share of a robot's computing", planning_time_share, unit="%", below=5.0),
        reported(
            "the same if each decision planned the whole way",
            lambda s: planning_time_share(s, float(s["way"].mean())),
            unit="%",
        ),
        reported("time for a decision, its point's motion included", lambda s: undisturbed_time(s["time"]), unit="us"),
        reported("time for a robot's whole frame", lambda s: undisturbed_time(s["frame"]), unit="us"),
        reported("share of the 62.5 ms between two frames", lambda s: undisturbed_time(s["time"]) / 625.0, unit="%"),
    ),
    rules=PLAYED,
    measure=time_decisions,
    seconds=1.0,
    batches=4,
    ingredients=("the machine, and compiled code: numbers differ from run to run",),
)
