"""The ball in play: how often the head keeps it centred, and false sightings.  [Sacks 2001, 3.1.1]"""

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import PLAYED, Batch, Claim
from soccer_env.train.papers.staging import distance_to_ball, kick_off, play, stage, still_actions
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


def compare_head_tracking(batch: Batch) -> Samples:
    """Return the counts of `count_centred_frames` for the paper's team and for the team `chaser`."""
    chaser = {f"{name} by chasers": counts for name, counts in count_centred_frames(batch, "chaser").items()}
    return count_centred_frames(batch, "sacks-2001") | chaser


def count_centred_frames(batch: Batch, team: str) -> Samples:
    """Count robots' frames (M,) of 3 v 3 play with the ball in sight, and those with the camera's axis on the ball."""
    match = kick_off(batch, matches=MATCHES, team=team)
    on_ball, seen = np.zeros(MATCHES), np.zeros(MATCHES)
    for step in play(match, SETTLE + SECONDS):
        if (step + 1) * match.league.dt <= SETTLE:
            continue
        for r in range(match.robots.shape[1]):
            fresh = match.beliefs["ball"][:, r]["age"] < 0.5 * match.league.dt
            tracking = fresh & (match.robots["active"][:, r] == 1)
            distance, angle = ball_in_sight(match, r)
            seen += tracking
            on_ball += tracking & (angle <= ball_angle(match, distance))
    match.close()
    return {"on ball": on_ball, "seen": seen}


class JumpCounter:
    """Counts for each match (M,): jumps of the believed ball to a wrong distance, frames with a correct sighting."""

    def __init__(self, match: Match) -> None:
        self.jumps, self.right = np.zeros(match.count), np.zeros(match.count)
        self.before, self.place = self._believed(match), self._place(match)

    def note(self, match: Match) -> None:
        """Add the current frame to the counts."""
        now = self._believed(match)
        place = self._place(match)
        true = distance_to_ball(match)[0]
        put_elsewhere = np.hypot(*(place - self.place)) > MOVED
        known = np.isfinite(match.beliefs["ball"][:, 0]["age"])
        seen = match.beliefs["ball"][:, 0]["age"] < 0.5 * match.league.dt
        self.jumps += known & ~put_elsewhere & (now - self.before > JUMP) & (np.abs(now - true) > JUMP)
        self.right += seen & (np.abs(now - true) < RIGHT * true)
        self.before, self.place = now, place

    @staticmethod
    def _believed(match: Match) -> np.ndarray:
        return match.beliefs["ball"][:, 0]["distance"].copy()

    @staticmethod
    def _place(match: Match) -> np.ndarray:
        return np.stack([match.balls["x"], match.balls["y"]])


def count_jumps(batch: Batch, **memory: Any) -> JumpCounter:
    """Let a robot follow the ball of three opponents, who play identically in every call; return its counts."""
    senses = {"home": "sensors", "away": "ideal"}
    match = stage(batch, matches=WATCHED, home=1, away=3, opponents="chaser", senses=senses, memory=memory)
    match.reset(seeds=batch.seeds(WATCHED))
    counter, actions = JumpCounter(match), still_actions(match)
    for step in play(match, SETTLE + TIME, actions):
        actions[:, 0, :3] = follow_ball(match, KEPT)
        if (step + 1) * match.league.dt > SETTLE:
            counter.note(match)
    match.close()
    return counter


def compare_sighting_rules(batch: Batch) -> Samples:
    """Count jumps and correct sightings with both rules (horizon, double area), with each rule alone, and with none."""
    rules = {"none": (False, False), "both": (True, True), "horizon": (True, False), "area": (False, True)}
    samples: Samples = {}
    for name, (horizon, area) in rules.items():
        counter = count_jumps(batch, horizon=horizon, double_area=area)
        samples[f"jumps {name}"], samples[f"right {name}"] = counter.jumps, counter.right
    return samples


def fewer_jumps(samples: Samples, name: str) -> float:
    """Return the reduction [%] of jumps by the rules `name`, relative to no rules."""
    without = samples["jumps none"].sum()
    return float(100 * (1.0 - samples[f"jumps {name}"].sum() / without)) if without else float("nan")


S10 = Claim(
    id="S10", section="3.1.1",
    statement="While robots track the ball it is often at the image's centre.",
    method=f"{MATCHES} matches a batch of 3 v 3, sacks-2001 on its sensors, {SECONDS:g} s each: frames in which a "
    "robot sees the ball and the camera's axis meets it.",
    criteria=(
        counted("frames with the axis on the ball", "on ball", "seen", at_least=60.0),
        reported("the same by chasers, which glance up for landmarks", percent, "on ball by chasers", "seen by chasers",
                 unit="%"),
    ),
    rules=PLAYED, measure=compare_head_tracking, batches=32, seconds=2.5,
    ingredients=("speeds of neck joints", "belief/legged/head.py"),
)  # fmt: skip

S11 = Claim(
    id="S11", section="3.1.1",
    statement="Range jumps come from orange patches seen when the ball is lost; two rules fix them.",
    method=f"{WATCHED} matches a batch of {TIME:g} s in which a robot follows at 50 cm a ball that three opponents "
    "have, with orange patches round the field and on red stickers; jumps: over 50 cm farther in a frame, to a place "
    "more than 50 cm wrong; the same play with the two rules and without.",
    criteria=(
        measured("fewer jumps with both rules", fewer_jumps, "both", unit="%", at_least=80.0),
        measured("frames with a right sighting lost by the rules",
                 lambda samples: float(100
                                       * (1.0 - samples["right both"].sum() / max(samples["right none"].sum(), 1.0))),
                 unit="%", at_most=5.0),
        reported("fewer jumps by the height test alone", fewer_jumps, "horizon", unit="%"),
        reported("fewer jumps by the area thresholds alone", fewer_jumps, "area", unit="%"),
        reported("jumps a minute without the rules", lambda s: float(s["jumps none"].mean() * 60.0 / TIME)),
    ),
    measure=compare_sighting_rules, batches=24, seconds=4.0,
    ingredients=("sensors.patches, patch_low, red_as_orange", "memory.horizon_angle, area_small, area_large"),
)  # fmt: skip
