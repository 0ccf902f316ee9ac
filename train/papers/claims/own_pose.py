"""The accuracy of a middle-size robot's own pose, and its recovery after it is carried away.  [H. 2006, 1]"""

from collections.abc import Sequence

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import Batch, Curve, Figure, claim
from soccer_env.train.papers.staging import MIDDLE, begin_scene, play, put, put_ball, stage, still_actions, wrap_angle
from soccer_env.train.papers.values import median, quantile
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

MATCHES = 80
OTHERS = 9  # as in a match of 5 v 5; they drive about as well and block the view
SETTLE = 5.0  # [s] to localise from an unknown pose
SECONDS = 6.0  # [s] measured
LONGEST = 6.0  # [s] after which a lost robot counts as not recovered
LOST = 0.5  # [m] error beyond which a robot is lost
TURNED = 20.0 * np.pi / 180.0  # [rad] error of the heading beyond which a robot is lost
HELD = 1.0  # [s] without being lost that count as recovered
CARRIED = 2.0  # [m] least distance of the carry
SPEED = 1.3  # [m/s] of driving robots: half of their top speed
COUNTED_ON = 0.05  # [m] error of the own place that CAMBADA's code of this league assumes (cambada.conf.xml)
NEAR = 0.15  # [m] a third of a robot's width
EVERY = 5  # frames between two samples, and between two commands
REACHED = 0.5  # [m] from a target at which the next one is drawn


class RandomDrivers:
    """Drive all robots from one random target to the next, turning slowly."""

    def __init__(self, match: Match, rng: np.random.Generator) -> None:
        self.match, self.rng = match, rng
        self.x, self.y = self.targets()
        self.turn = rng.uniform(-0.3, 0.3, match.robots.shape)  # [1] of the top turn rate
        self.actions = still_actions(match)

    def targets(self) -> tuple[np.ndarray, np.ndarray]:
        """Return random target places within the field (M, R) [m]."""
        pitch, shape = self.match.league.pitch, self.match.robots.shape
        half_length, half_width = 0.5 * pitch.length - 0.5, 0.5 * pitch.width - 0.5
        return self.rng.uniform(-half_length, half_length, shape), self.rng.uniform(-half_width, half_width, shape)

    def steer(self, step: int) -> None:
        """Replace reached targets and update the actions, every EVERY steps."""
        if step % EVERY:
            return
        drive, robots = self.match.league.drive, self.match.robots
        there = np.hypot(self.x - robots["x"], self.y - robots["y"]) < REACHED
        x, y = self.targets()
        self.x, self.y = np.where(there, x, self.x), np.where(there, y, self.y)
        course = np.arctan2(self.y - robots["y"], self.x - robots["x"]) - robots["heading"]
        self.actions[..., 0] = SPEED / drive.forward * np.cos(course)
        self.actions[..., 1] = SPEED / drive.sideways * np.sin(course)
        self.actions[..., 2] = self.turn


def pose_errors(match: Match) -> tuple[np.ndarray, np.ndarray]:
    """Return the errors of robot 0's own pose (M,) [m, rad]; home attacks +x, so that its frame is the field's."""
    own, robot = match.beliefs["own"][:, 0], match.robots[:, 0]
    place: np.ndarray = np.hypot(own["x"] - robot["x"], own["y"] - robot["y"])
    return place, np.abs(wrap_angle(own["heading"] - robot["heading"]))


def carry_away(match: Match, rng: np.random.Generator) -> None:
    """Carry robot 0 to another place, at least CARRIED away and clear of the others, without telling it."""
    pitch, robots = match.league.pitch, match.robots
    for m in range(match.count):
        while True:
            x = rng.uniform(-0.5, 0.5) * (pitch.length - 1.0)
            y = rng.uniform(-0.5, 0.5) * (pitch.width - 1.0)
            gaps = np.hypot(robots["x"][m] - x, robots["y"][m] - y)
            if gaps[0] > CARRIED and gaps[1:].min() > 0.8:
                break
        robots["x"][m, 0], robots["y"][m, 0] = x, y
    put(match, 0, robots["x"][:, 0].copy(), robots["y"][:, 0].copy(), rng.uniform(-np.pi, np.pi, match.count))
    match.rebuild()


def drive_and_carry(batch: Batch) -> Samples:
    """Return errors of place and heading while driving (M, T), and the time to recover after being carried (M,)."""
    rng = batch.rng()
    match = stage(batch, MIDDLE, matches=MATCHES, away=OTHERS, senses={"home": "sensors", "away": "ideal"})
    for r in range(1 + OTHERS):  # in two rows, apart from each other
        x, y = 2.0 * (r // 2) - 4.0, 3.0 * (r % 2) - 1.5
        aside = rng.uniform(-0.6, 0.6, (2, MATCHES))
        put(match, r, x + aside[0], y + aside[1], rng.uniform(-np.pi, np.pi, MATCHES))
    put_ball(match, 5.0, 3.5)
    begin_scene(match)
    drivers = RandomDrivers(match, rng)
    for step in play(match, SETTLE, drivers.actions):
        drivers.steer(step)
    rows = []
    for step in play(match, SECONDS, drivers.actions):
        drivers.steer(step)
        if step % EVERY == 0:
            rows.append(np.stack(pose_errors(match)))
    place, heading = np.stack(rows, axis=2)
    carry_away(match, rng)
    lost = []
    for step in play(match, LONGEST + HELD, drivers.actions):
        drivers.steer(step)
        off, turned = pose_errors(match)
        lost.append((off > LOST) | (turned > TURNED))
    time = recovery(np.stack(lost, axis=1), match.league.dt)
    match.close()
    one = np.ones(MATCHES)
    return {"place": place, "heading": np.degrees(heading), "time": time, "recovered": np.isfinite(time), "one": one}


def recovery(lost: np.ndarray, dt: float) -> np.ndarray:
    """Return the first time [s] (M,) from which a robot is not lost for HELD seconds, NaN if none; lost: (M, T)."""
    held = round(HELD / dt)
    apart = np.cumsum(np.pad(lost, ((0, 0), (1, 0))), axis=1)
    calm = apart[:, held:] == apart[:, :-held]  # no lost frame from i to i + held
    return np.where(calm.any(axis=1), calm.argmax(axis=1) * dt, np.nan)


def pose_figures(samples: Samples) -> Sequence[Figure]:
    """Plot the share of recovered robots against the time since they were carried, and the error while driving."""
    times = np.linspace(0.0, LONGEST, 41)
    share = [100 * float(np.mean(samples["time"] <= time)) for time in times]
    bounds = np.linspace(0.0, 0.5, 26)
    errors = [100 * float(np.mean(samples["place"] <= bound)) for bound in bounds]
    return (
        Figure("Robots that know where they are again", "time since carried [s]", "robots [%]",
               (Curve("within 0.5 m and 20 degrees", list(times), share),), rules=(95.0,)),
        Figure("Error of the own pose while driving", "error [cm]", "share of the time [%]",
               (Curve("error at most", list(100 * bounds), errors),)),
    )  # fmt: skip


H27 = claim(
    "H27", "1", "Self-localisation with the omnidirectional camera is efficient and reliable.",
    f"{MATCHES} robots a batch drive about among {OTHERS} others at {SPEED:g} m/s; begun untold anywhere; error "
    f"of the own pose from {SETTLE:g} s on for {SECONDS:g} s. Then each is carried {CARRIED:g} m or more and told "
    f"nothing: recovered if within {LONGEST:g} s it is right to {LOST:g} m and 20 degrees for {HELD:g} s.",
    measured("median error of the place", "place", of=median, unit="cm", below=100 * COUNTED_ON),
    measured("error of the place in 95 % of the time", lambda samples: 100 * quantile(samples["place"], 0.95),
             unit="cm", below=100 * NEAR),
    counted("recovered after being carried", "recovered", "one", at_least=95.0),
    reported("median error of the heading", "heading", of=median, unit="deg"),
    reported("median time to recover", "time", of=median, unit="s"),
    measure=drive_and_carry, figures=pose_figures, pose="particles", batches=12, seconds=2.7,
    ingredients=("memory.particles = 96", "sensors.lines, line_range, goal_miss", "memory.pose_fresh"),
)  # fmt: skip
