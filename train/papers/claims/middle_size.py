"""Middle-size robots: vision in changing light by two colour tables, and the own pose.  [Heinemann et al. 2006, 1]"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import Ablation, Batch, claim
from soccer_env.train.papers.plots import plot, plot_shares, plots
from soccer_env.train.papers.staging import MIDDLE
from soccer_env.train.papers.values import median, middles_of, quantile
from soccer_env.train.papers.verdicts import Samples, counted, measured

MATCHES = 64
SECONDS = 16.0  # [s] of play: about an eighth of the light's period, from a random phase
NEAR, FAR = 1.0, 5.0  # [m] of ball and player
BINS = (0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0)  # [1] edges of the light's distance from the table's own light
CHANGED = 3  # first bin in which the light counts as changed: half of "glaring"
CLEAN = {"false_balls": 0.0}  # no false balls
DRIFT = CLEAN | {"light_drift": 1.0}  # from dark to glaring
VARIANTS: dict[str, dict[str, Any]] = {
    "constant": CLEAN | {"light_drift": 0.0},
    "adaptive": DRIFT | {"colour_table": "adaptive"},
    "fixed": DRIFT | {"colour_table": "fixed"},
}
LABELS = {"constant": "constant light", "adaptive": "table that adapts", "fixed": "fixed table"}
THINGS = ("ball", "player", "own goal", "opponents' goal")


def watch_in_light(batch: Batch, sensors: dict[str, Any]) -> dict[str, np.ndarray]:
    """Return for each frame (M, T): the light, the number of THINGS seen, the ball's range error [m]."""
    rng = batch.rng()
    match = staging.stage(batch, MIDDLE, matches=MATCHES, sensors=sensors, senses={"home": "sensors", "away": "ideal"})
    x, y = rng.uniform(-0.8, 0.8, (2, MATCHES))
    staging.put(match, 0, x, y, rng.uniform(-np.pi, np.pi, MATCHES))
    course = rng.choice([0.0, np.pi], MATCHES) + rng.uniform(-0.5, 0.5, MATCHES)  # the ball here, the player there
    away, beyond = rng.uniform(NEAR, FAR, MATCHES), rng.uniform(NEAR, FAR, MATCHES)
    staging.put_ball(match, x + away * np.cos(course), y + away * np.sin(course))
    staging.put(match, 1, x - beyond * np.cos(course), y - beyond * np.sin(course))
    match.rebuild()  # without `begin`: the table has adapted to the light before
    true, _ = staging.distance_to_point(match, 0, match.balls["x"], match.balls["y"])

    def read() -> Samples:
        percept = match.percepts[:, 0]
        ball = percept["ball"]["seen"] == 1
        others = [percept["players"]["seen"][:, 0], percept["own_goal"]["seen"], percept["opponent_goal"]["seen"]]
        return {
            "light": percept["light"].astype(float),
            "found": ball + sum((seen == 1).astype(int) for seen in others),
            "error": np.where(ball, percept["ball"]["distance"] - true, np.nan),
        }

    late = match.league.sensors.camera_delay + 1  # frames until the first picture is delivered
    return staging.record(match, (step for step in staging.play(match, SECONDS) if step >= late), read)


def compare_tables(batch: Batch, **adaptive: Any) -> Samples:
    """Return sums of frames, sightings, range readings and squared errors (M, bins), by variant and bin of the light.

    All three variants see the same scenes, and their frames are binned by the changing light. `adaptive`: further
    settings of the sensors of the variant whose table adapts.
    """
    seen = {name: watch_in_light(batch, VARIANTS[name] | (adaptive if name == "adaptive" else {})) for name in VARIANTS}
    place = np.digitize(np.abs(seen["fixed"]["light"]), BINS[1:-1])
    samples: Samples = {}
    for name, frames in seen.items():
        known = np.isfinite(frames["error"])
        parts = {
            "frames": np.ones_like(place), "found": frames["found"], "read": known,
            "square": np.where(known, frames["error"], 0.0) ** 2,
        }  # fmt: skip
        for part, values in parts.items():
            summed = [np.where(place == b, values, 0).sum(axis=1) for b in range(len(BINS) - 1)]
            samples[f"{part} {name}"] = np.stack(summed, axis=1).astype(float)
    return samples


def seen_shares_by_light(samples: Samples, name: str) -> np.ndarray:
    """Return the share of things seen [1] in each bin of the light, for the variant `name`."""
    frames = samples[f"frames {name}"].sum(axis=0)
    share: np.ndarray = samples[f"found {name}"].sum(axis=0) / np.maximum(len(THINGS) * frames, 1.0)
    return np.where(frames > 0, share, np.nan)


def range_errors_by_light(samples: Samples, name: str) -> np.ndarray:
    """Return the rms range error of the ball [m] in each bin of the light, for the variant `name`."""
    read = samples[f"read {name}"].sum(axis=0)
    error: np.ndarray = np.sqrt(samples[f"square {name}"].sum(axis=0) / np.maximum(read, 1.0))
    return np.where(read > 0, error, np.nan)


def relative_to_constant_light(samples: Samples, name: str, quantity: Any) -> np.ndarray:
    """Return a quantity in each bin of the light, divided by its value for the same frames under constant light."""
    return np.asarray(quantity(samples, name) / quantity(samples, "constant"))


def by_light(samples: Samples, of: Callable[[Samples, str], np.ndarray], name: str) -> list[float]:
    """Return a quantity in hundredths in each bin of the light, for the variant `name`."""
    return list(100 * of(samples, name))


def seen_in_changed_light(samples: Samples, name: str) -> float:
    """Return the number of things seen in changed light, divided by the number seen under constant light."""
    frames, best = (samples[f"found {kind}"][:, CHANGED:].sum() for kind in (name, "constant"))
    return float(frames / max(best, 1.0))


H26 = claim(
    "H26", "abstract, 1", "A static colour table needs nearly constant light; the adapting one copes with changes.",
    f"{MATCHES} robots a batch look at a ball and a player {NEAR:g} to {FAR:g} m away and at both goals for "
    f"{SECONDS:g} s, while the light swings between dark and glaring (amplitude 1, period 120 s); share of these four "
    "that a picture shows and range error of the ball in bins of the light's change, against the same frames under "
    "constant light.",
    measured("adapting table: share seen in the worst light, of constant light",
             lambda s: 100 * float(np.nanmin(relative_to_constant_light(s, "adaptive", seen_shares_by_light))),
             unit="%", at_least=90.0),
    measured("adapting table: range error in the worst light, of constant light",
             lambda s: 100 * float(np.nanmax(relative_to_constant_light(s, "adaptive", range_errors_by_light))),
             unit="%", at_most=110.0),
    measured(f"fixed table: share seen in light that differs by {BINS[CHANGED]:g} or more",
             lambda samples: 100 * seen_in_changed_light(samples, "fixed"), unit="%", at_most=50.0),
    measure=compare_tables, pose="particles",
    figures=plots(*(plot(f"{title} under changing light", "difference of light from the table's own [1]", unit,
                         middles_of(BINS), {label: partial(by_light, of=of, name=name)
                                            for name, label in LABELS.items()})
                    for title, unit, of in (("Things seen", "frames that show a thing [%]", seen_shares_by_light),
                                            ("Range error of the ball", "rms error [cm]", range_errors_by_light)))),
    without=Ablation("the own pose, by which the table knows what a pixel must show: here no white line tells it",
                     lambda batch: compare_tables(batch, line_miss=1.0)),
    ingredients=("sensors.table_width and the laws of perception/omni/lighting.py", "sensors.table_time",
                 "sensors.light_period"),
    note="That light costs a table pixels, and that one which learns at known places follows, is put in; what is "
    "measured is whether it follows fast enough, with what a robot sees of the white lines. The paper gives no numbers "
    "of its algorithm: its speed and reach are assumed. Where light changes fastest the table lags by 2 pi table_time "
    "/ light_period = 0.105, at which 88 % of the pixels keep their class: the first criterion hangs on that.",
)  # fmt: skip

# The own pose

DRIVERS = 80
OTHERS = 9  # as in a match of 5 v 5; they drive about as well and block the view
SETTLE = 5.0  # [s] to localise from an unknown pose
DRIVEN = 6.0  # [s] measured
LONGEST = 6.0  # [s] after which a lost robot counts as not recovered
LOST = 0.5  # [m] error beyond which a robot is lost
TURNED = 20.0 * np.pi / 180.0  # [rad] error of the heading beyond which a robot is lost
HELD = 1.0  # [s] without being lost that count as recovered
CARRIED = 2.0  # [m] least distance of the carry
SPEED = 1.3  # [m/s] of driving robots: half of their top speed
COUNTED_ON = 0.05  # [m] error of the own place that CAMBADA's code of this league assumes (cambada.conf.xml)
THIRD_OF_ROBOT = 0.15  # [m] a third of a robot's width
EVERY = 5  # frames between two samples, and between two commands
REACHED = 0.5  # [m] from a target at which the next one is drawn


class RandomDrivers:
    """Drive all robots from one random target to the next, turning slowly."""

    def __init__(self, match: Match, rng: np.random.Generator) -> None:
        self.match, self.rng = match, rng
        self.x, self.y = self.targets()
        self.turn = rng.uniform(-0.3, 0.3, match.robots.shape)  # [1] of the top turn rate
        self.actions = staging.still_actions(match)

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
    return place, np.abs(staging.wrap_angle(own["heading"] - robot["heading"]))


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
    staging.put(match, 0, robots["x"][:, 0].copy(), robots["y"][:, 0].copy(), rng.uniform(-np.pi, np.pi, match.count))
    match.rebuild()


def drive_and_carry(batch: Batch) -> Samples:
    """Return errors of place and heading while driving (M, T), and the time to recover after being carried (M,)."""
    rng = batch.rng()
    match = staging.stage(batch, MIDDLE, matches=DRIVERS, away=OTHERS, senses={"home": "sensors", "away": "ideal"})
    for r in range(1 + OTHERS):  # in two rows, apart from each other
        x, y = 2.0 * (r // 2) - 4.0, 3.0 * (r % 2) - 1.5
        aside = rng.uniform(-0.6, 0.6, (2, DRIVERS))
        staging.put(match, r, x + aside[0], y + aside[1], rng.uniform(-np.pi, np.pi, DRIVERS))
    staging.put_ball(match, 5.0, 3.5)
    staging.begin_scene(match)
    drivers = RandomDrivers(match, rng)
    for step in staging.play(match, SETTLE, drivers.actions):
        drivers.steer(step)
    rows = []
    for step in staging.play(match, DRIVEN, drivers.actions):
        drivers.steer(step)
        if step % EVERY == 0:
            rows.append(np.stack(pose_errors(match)))
    place, heading = np.stack(rows, axis=2)
    carry_away(match, rng)
    lost = []
    for step in staging.play(match, LONGEST + HELD, drivers.actions):
        drivers.steer(step)
        off, turned = pose_errors(match)
        lost.append((off > LOST) | (turned > TURNED))
    time = recovery(np.stack(lost, axis=1), match.league.dt)
    match.close()
    one = np.ones(DRIVERS)
    return {"place": place, "heading": np.degrees(heading), "time": time, "recovered": np.isfinite(time), "one": one}


def recovery(lost: np.ndarray, dt: float) -> np.ndarray:
    """Return the first time [s] (M,) from which a robot is not lost for HELD seconds, NaN if none; lost: (M, T)."""
    held = round(HELD / dt)
    apart = np.cumsum(np.pad(lost, ((0, 0), (1, 0))), axis=1)
    calm = apart[:, held:] == apart[:, :-held]  # no lost frame from i to i + held
    return np.where(calm.any(axis=1), calm.argmax(axis=1) * dt, np.nan)


H27 = claim(
    "H27", "1", "Self-localisation with the omnidirectional camera is efficient and reliable.",
    f"{DRIVERS} robots a batch drive about among {OTHERS} others at {SPEED:g} m/s; begun untold anywhere; error "
    f"of the own pose from {SETTLE:g} s on for {DRIVEN:g} s. Then each is carried {CARRIED:g} m or more and told "
    f"nothing: recovered if within {LONGEST:g} s it is right to {LOST:g} m and 20 degrees for {HELD:g} s.",
    measured("median error of the place", "place", of=median, unit="cm", below=100 * COUNTED_ON),
    measured("error of the place in 95 % of the time", lambda samples: 100 * quantile(samples["place"], 0.95),
             unit="cm", below=100 * THIRD_OF_ROBOT),
    counted("recovered after being carried", "recovered", "one", at_least=95.0),
    measure=drive_and_carry,
    figures=plots(plot_shares("Robots that know where they are again", "time since carried [s]", "robots [%]",
                              np.linspace(0.0, LONGEST, 41), {"within 0.5 m and 20 degrees": lambda s: np.nan_to_num(
                                  s["time"], nan=np.inf)}, rules=(95.0,)),
                  plot_shares("Error of the own pose while driving", "error [cm]", "share of the time [%]",
                              np.linspace(0.0, 0.5, 26), {"error at most": "place"}, place_scale=100.0)),
    pose="particles", batches=12, seconds=2.7,
    ingredients=("memory.particles = 96", "sensors.lines, line_range, goal_miss", "memory.pose_fresh"),
)  # fmt: skip
