"""The ball in play: how often the head keeps it centred, and false sightings.  [Sacks 2001, 3.1.1]"""

from typing import Any

import numpy as np

from soccer_env.train.papers.claim import PLAYED, Batch, claim
from soccer_env.train.papers.staging import distance_to_ball, kick_off, play, stage, still_actions, watch
from soccer_env.train.papers.true_sight import ball_angle, ball_in_sight, follow_ball
from soccer_env.train.papers.values import percent
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

MATCHES, SECONDS = 32, 20.0  # [s] of 3 v 3: S10
SETTLE = 3.0  # [s] after the kick-off, until heads have found the ball
WATCHED, TIME = 48, 20.0  # matches with one robot that watches, [s]: S11
KEPT = 0.5  # [m] from the ball, S11
JUMP = 0.5  # [m] in a frame, S11
RIGHT = 0.25  # [1] of the true distance within which a sighting is right
MOVED = 0.2  # [m] a ball that moves farther in a frame was moved by the referee


def count_centred_frames(batch: Batch) -> Samples:
    """Count robots' frames (M,) of 3 v 3 play with the ball in sight, and those with the camera's axis on the ball.

    Of the paper's team and, "... by chasers", of the team `chaser`.
    """
    samples: Samples = {}
    for team, words in (("sacks-2001", ""), ("chaser", " by chasers")):
        match = kick_off(batch, matches=MATCHES, team=team)
        on_ball, seen = np.zeros((2, MATCHES))
        for _ in watch(match, SECONDS, settle=SETTLE):
            for r in range(match.robots.shape[1]):
                fresh = match.beliefs["ball"][:, r]["age"] < 0.5 * match.league.dt
                tracking = fresh & (match.robots["active"][:, r] == 1)
                distance, angle = ball_in_sight(match, r)
                seen += tracking
                on_ball += tracking & (angle <= ball_angle(match, distance))
        match.close()
        samples |= {f"on ball{words}": on_ball, f"seen{words}": seen}
    return samples


def count_jumps(batch: Batch, **memory: Any) -> tuple[np.ndarray, np.ndarray]:
    """Let a robot follow the ball of three opponents, who play identically in every call.

    Return counts (M,): jumps of the believed ball to a wrong distance, and frames with a correct sighting.
    """
    senses = {"home": "sensors", "away": "ideal"}
    match = stage(batch, matches=WATCHED, home=1, away=3, opponents="chaser", senses=senses, memory=memory)
    match.reset(seeds=batch.seeds(WATCHED))
    (jumps, right), actions = np.zeros((2, WATCHED)), still_actions(match)

    def look() -> tuple[np.ndarray, np.ndarray]:
        return match.beliefs["ball"]["distance"][:, 0].copy(), np.stack([match.balls["x"], match.balls["y"]])

    before, place_before = look()
    for step in play(match, SETTLE + TIME, actions):
        actions[:, 0, :3] = follow_ball(match, KEPT)
        if (step + 1) * match.league.dt <= SETTLE:
            continue
        (now, place), age = look(), match.beliefs["ball"]["age"][:, 0]
        true, put_elsewhere = distance_to_ball(match)[0], np.hypot(*(place - place_before)) > MOVED
        jumps += np.isfinite(age) & ~put_elsewhere & (now - before > JUMP) & (np.abs(now - true) > JUMP)
        right += (age < 0.5 * match.league.dt) & (np.abs(now - true) < RIGHT * true)
        before, place_before = now, place
    match.close()
    return jumps, right


def compare_sighting_rules(batch: Batch) -> Samples:
    """Count jumps and correct sightings with both rules (horizon, double area), with each rule alone, and with none."""
    samples: Samples = {}
    for name, horizon, area in (("none", False, False), ("both", True, True), ("horizon", True, False),
                                ("area", False, True)):  # fmt: skip
        samples[f"jumps {name}"], samples[f"right {name}"] = count_jumps(batch, horizon=horizon, double_area=area)
    return samples


def fewer_jumps(samples: Samples, name: str) -> float:
    """Return the reduction [%] of jumps by the rules `name`, relative to no rules."""
    without = samples["jumps none"].sum()
    return float(100 * (1.0 - samples[f"jumps {name}"].sum() / without)) if without else float("nan")


S10 = claim(
    "S10", "3.1.1", "While robots track the ball it is often at the image's centre.",
    f"{MATCHES} matches a batch of 3 v 3, sacks-2001 on its sensors, {SECONDS:g} s each: frames in which a "
    "robot sees the ball and the camera's axis meets it.",
    counted("frames with the axis on the ball", "on ball", "seen", at_least=60.0),
    reported("the same by chasers, which glance up for landmarks", percent, "on ball by chasers", "seen by chasers",
             unit="%"),
    rules=PLAYED, measure=count_centred_frames, batches=32, seconds=2.5,
    ingredients=("speeds of neck joints", "belief/legged/head.py"),
)  # fmt: skip

S11 = claim(
    "S11", "3.1.1", "Range jumps come from orange patches seen when the ball is lost; two rules fix them.",
    f"{WATCHED} matches a batch of {TIME:g} s in which a robot follows at 50 cm a ball that three opponents "
    "have, with orange patches round the field and on red stickers; jumps: over 50 cm farther in a frame, to a place "
    "more than 50 cm wrong; the same play with the two rules and without.",
    measured("fewer jumps with both rules", fewer_jumps, "both", unit="%", at_least=80.0),
    measured("frames with a right sighting lost by the rules",
             lambda s: float(100 * (1.0 - s["right both"].sum() / max(s["right none"].sum(), 1.0))), unit="%",
             at_most=5.0),
    reported("fewer jumps by the height test alone", fewer_jumps, "horizon", unit="%"),
    reported("fewer jumps by the area thresholds alone", fewer_jumps, "area", unit="%"),
    reported("jumps a minute without the rules", lambda s: float(s["jumps none"].mean() * 60.0 / TIME)),
    measure=compare_sighting_rules, batches=24, seconds=4.0,
    ingredients=("sensors.patches, patch_low, red_as_orange", "memory.horizon_angle, area_small, area_large"),
)  # fmt: skip
