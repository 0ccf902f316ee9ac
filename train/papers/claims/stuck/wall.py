"""A robot that faces out at the field's edge and turns to a ball aside or behind.  [Sacks 2001, 3.4]"""

from math import pi
from typing import Any

import numpy as np

from soccer_env.match.staging import memory_of, put_ball
from soccer_env.teams import make_team
from soccer_env.train.papers.claim import STAGED, Batch, Claim
from soccer_env.train.papers.staging import begin_scene, play, point_ahead, stage_drill
from soccer_env.train.papers.values import mean, percent
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

RUNS, LONGEST = 48, 40.0  # a batch and variant, [s] of each
ASIDE, AWAY = (35.0, 90.0), (0.4, 0.8)  # [deg] in view of a panned head, [m] of a visible ball, assumed


def face_wall(batch: Batch, seen: bool, **settings: Any) -> tuple[np.ndarray, np.ndarray]:
    """Run the drill facing-wall; return which robots get the ball (M,) and the number of tries to get free.

    `seen`: the ball lies to the robot's side, in view, not behind the robot.
    """
    team, rng = make_team("sacks-2001", **settings), batch.rng()
    match = stage_drill(batch, "facing-wall", team, matches=RUNS)
    if seen:
        inwards = rng.choice([-1.0, 1.0], RUNS)
        place = point_ahead(match, 0, rng.uniform(*AWAY, RUNS), inwards * np.radians(rng.uniform(*ASIDE, RUNS)))
        half_length, half_width = match.league.pitch.length / 2 - 0.1, match.league.pitch.width / 2 - 0.1
        put_ball(match, np.clip(place[0], -half_length, half_length), np.clip(place[1], -half_width, half_width))
        begin_scene(match, placed=True)
    solved, tries = np.zeros(RUNS), np.zeros(RUNS)
    for _ in play(match, LONGEST):
        solved += match.events["drill"] == 1
        tries = np.where(match.matches["over"] == 1, tries, np.maximum(tries, memory_of(match)["tries"]))
        if match.matches["over"].all():
            break
    match.close()
    return solved, tries


def compare_turns_at_wall(batch: Batch) -> Samples:
    """Run both scenes with rotation to a ball far aside, always with sidesteps, and without recovery (`face_wall`)."""
    samples: Samples = {"one": np.ones(RUNS)}
    for scene, seen in (("aside", True), ("behind", False)):
        samples[f"{scene} rotate"], samples[f"{scene} tries"] = face_wall(batch, seen)
        samples[f"{scene} sidestep"], _ = face_wall(batch, seen, rotate_beyond=pi)
        samples[f"{scene} none"], _ = face_wall(batch, seen, recovery=False)
    samples["recovers"] = (samples["aside tries"] > 0).astype(float)  # equal with sidesteps: runs differ only later
    for way in ("rotate", "sidestep"):
        samples[f"recovered {way}"] = samples[f"aside {way}"] * samples["recovers"]
    return samples


S28 = Claim(
    id="S28",
    section="3.4",
    statement="With the ball over 30 degrees aside, as at a wall, backing away and rotating suffices.",
    method=f"{RUNS} runs a batch: a robot faces out, a paw at the board's foot (drill facing-wall), the ball "
    f"{ASIDE[0]:g} to {ASIDE[1]:g} degrees aside, where its head sees it; of those that come to recover, got "
    f"within {LONGEST:g} s, with the rule and with sidesteps always. Beside it all of them, also without any recovery, "
    "and the drill itself, the ball behind the robot.",
    criteria=(
        counted("those that recover: got the ball", "recovered rotate", "recovers", at_least=90.0),
        measured("those that recover: got the ball, rotation less sidesteps",
                 lambda s: percent(s, "recovered rotate", "recovers") - percent(s, "recovered sidestep", "recovers"),
                 unit="pp", above=0.0),
        reported("got the ball, all", "aside rotate", unit="%"),
        reported("got the ball without any recovery", "aside none", unit="%"),
        reported("robots that recovered at all", lambda s: 100.0 * mean(s["aside tries"] > 0), unit="%"),
        reported("ball behind: got", "behind rotate", unit="%"),
        reported("ball behind: got without any recovery", "behind none", unit="%"),
        reported("ball behind: robots that recovered at all", lambda s: 100.0 * mean(s["behind tries"] > 0), unit="%"),
    ),
    rules=STAGED,
    measure=compare_turns_at_wall,
    ingredients=("the counters run while the robot sees the ball and goes for it: what it searches for trips none",),
    note="At the board a turn is blocked, and who recovers gets away. Whether it then turns or steps aside matters "
    "little, for it turns to the ball on its way to it. Where the ball lies behind, a robot that has not seen it "
    "searches for it and turns against the board; no counter runs in a search, and recovery never begins.",
    seconds=4.0,
    batches=10,
)  # fmt: skip
