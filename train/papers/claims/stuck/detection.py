"""How a robot notices that it is stuck: the ball does not come nearer; false alarms.  [Sacks 2001, 3, 3.3]"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, SEARCH
from soccer_env.match import Match
from soccer_env.train.papers.claim import PLAYED, PLAYED_AND_STAGED, Batch, claim
from soccer_env.train.papers.claims.stuck import sampled
from soccer_env.train.papers.claims.stuck.runs import immobilise_robots, is_recovering, set_up_seekers, set_up_walk
from soccer_env.train.papers.claims.stuck.sampled import MATCHES, SECONDS
from soccer_env.train.papers.plots import columns, plot, plots
from soccer_env.train.papers.staging import begin_scene, distance_to_ball, kick_off, play, point_ahead, put, put_ball
from soccer_env.train.papers.values import known, least_fall, least_rise, middles_of
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

HELD = 64  # robots a batch that are held
WALK = 1.5  # [s] of free walk before
WAIT = 12.0  # [s] for a held robot to notice
NEAREST = 0.2  # [m] of the ball, assumed, like the farthest
NEAR = 0.35  # [m] 3.3
FARTHEST = 0.8  # [m]
WINDOW = 2.5  # [s] over which the velocity is averaged, assumed


def latencies(batch: Batch, **settings: Any) -> tuple[np.ndarray, np.ndarray]:
    """Hold robots on their path to a still ball; return the ball's distance [m] and the time to notice [s], (M,).

    The distance is from the camera. inf: not within WAIT; NaN: noticed before the hold.
    """
    match = set_up_walk(batch, HELD, NEAREST + 0.1, FARTHEST + 0.1, **settings)
    for _ in play(match, WALK):
        pass
    immobilise_robots(match)
    distance = sampled.distance_from_camera(match, *distance_to_ball(match))
    after, began = np.full(HELD, np.inf), is_recovering(match)
    for step in play(match, WAIT):
        after[is_recovering(match) & np.isinf(after)] = (step + 1) * match.league.dt
    match.close()
    after[began] = np.nan
    return distance, after


def velocity_windows(batch: Batch) -> Samples:
    """Return mean radial velocities [m/s] of free robots and of held robots in time windows of play (M, K).

    Windows do not overlap; NaN: no further window in the match.
    """
    match = kick_off(batch, matches=MATCHES, team=sampled.BASE)
    watch = sampled.MotionWindow(match, WINDOW)
    radial: list[np.ndarray] = []
    found: dict[str, list[np.ndarray]] = {"free": [], "stuck": []}
    for _ in play(match, SECONDS):
        watch.look()
        radial.append(match.beliefs["ball"]["radial"].copy())
        if len(radial) < watch.size:
            continue
        x, y = match.balls["x"][:, None] - match.robots["x"], match.balls["y"][:, None] - match.robots["y"]
        bearing = np.arctan2(y, x) - match.robots["heading"]
        near = sampled.distance_from_camera(match, np.hypot(x, y), bearing) <= FARTHEST
        free = (watch.mean(4) == 1.0) & (watch.mean(3) == 0.0)
        for name, there in (("free", free & near), ("stuck", watch.held() & near)):
            found[name].append(np.where(there, np.mean(radial, axis=0), np.nan))
        radial.clear()
    match.close()
    return {name: np.concatenate(values, axis=1) for name, values in found.items()}


def roc_area(samples: Samples) -> float:
    """Return the area under the ROC curve: the probability that a stuck robot reads more than a free robot."""
    free, stuck = known(samples["free"]), known(samples["stuck"])
    if len(stuck) == 0:
        return float("nan")
    ranks = np.argsort(np.argsort(np.concatenate([free, stuck]))) + 1
    count = len(stuck)
    return float((ranks[len(free) :].sum() - count * (count + 1) / 2) / (count * len(free)))


EDGES = np.linspace(-0.2, 0.1, 25)  # [m/s] of the figure's bins


def velocity_shares(samples: Samples, name: str) -> list[float]:
    """Return the mean radial velocities in each bin of EDGES, over the number of matches [%]."""
    counts, _ = np.histogram(known(samples[name]), EDGES)
    return list(100.0 * counts / max(len(samples[name]), 1))


S04 = claim(
    "S04", "3", "A robot that makes for the ball but comes no nearer is probably stuck.",
    f"{MATCHES} matches a batch of 3 v 3, {SECONDS:g} s each, in which nobody recovers; windows of {WINDOW:g} s "
    f"of robots that go for a ball nearer than {100 * FARTHEST:.0f} cm: mean of the filtered radial velocity of those "
    "that others hold (contact, a quarter of the way that their legs walk or less) and of those that touch nobody.",
    measured("area under the ROC curve of the mean velocity", roc_area, at_least=0.9),
    rules=PLAYED, measure=velocity_windows, least=4, batches=12, seconds=2.0,
    figures=plot(f"Radial velocity over {WINDOW:g} s", "mean radial velocity [cm/s]", "robots [%]",
                 middles_of(EDGES, 100), {title: partial(velocity_shares, name=name)
                                          for name, title in (("free", "walks freely"), ("stuck", "held"))}),
    ingredients=("sensors.dither", "memory.filter_length"),
)  # fmt: skip

# A

COUNTS = (3, 6, 9, 12, 15)  # thresholds, S25
ROLLS = (0.1, 0.5)  # [m/s] of a ball that rolls
TRIES, TIME = 48, 20.0  # approaches of each kind a batch, [s] of each at most


def approach(batch: Batch, rolls: bool, **settings: Any) -> np.ndarray:
    """Let robots that nothing stops go to a ball anywhere round them; return which have a false alarm (M,).

    An alarm is a recovery that begins before the robot has the ball.
    """
    rng = batch.rng(1)
    match = set_up_seekers(batch, TRIES, **settings)
    put(match, 0, 0.0, 0.0, rng.uniform(-np.pi, np.pi, TRIES))
    angle, speed = rng.uniform(-np.pi, np.pi, TRIES), rng.uniform(*ROLLS, TRIES) * float(rolls)
    place = point_ahead(match, 0, rng.uniform(0.4, 0.9, TRIES), rng.uniform(-np.pi, np.pi, TRIES))
    put_ball(match, *place, speed * np.cos(angle), speed * np.sin(angle))
    begin_scene(match, placed=True)
    alarms, over = np.zeros(TRIES), np.zeros(TRIES, bool)
    for _ in play(match, TIME):
        alarms[is_recovering(match) & ~over] = 1.0
        over |= is_recovering(match) | (match.robots["has_ball"][:, 0] == 1)
        if over.all():
            break
    match.close()
    return alarms


def sweep_thresholds(batch: Batch) -> Samples:
    """Return latencies of held robots [s] and false alarms of free robots at each threshold (M, thresholds)."""
    delay, false = [], []
    for count in COUNTS:
        distance, after = latencies(batch, stuck_count=count)
        far = (distance >= NEAR) & np.isfinite(after)
        delay.append(np.where(far, after, np.nan)[:TRIES])
        false.append(0.5 * sum(approach(batch, rolls, stuck_count=count) for rolls in (False, True)))
    return {"delay": np.stack(delay, axis=1), "false": np.stack(false, axis=1)}


delays, alarms = columns("delay", scale=1.0), columns("false")  # [s], [%] of approaches: means at each threshold

S25 = claim(
    "S25", "3.3", "Higher thresholds prevent false alarms, but delay the detection of collisions.",
    f"Thresholds of {', '.join(map(str, COUNTS))} readings: held robots as in S22, {TRIES} a batch, the ball at "
    f"35 to 80 cm, and {2 * TRIES} approaches to a ball 40 to 90 cm away in any direction, half of them to one that "
    f"rolls at {100 * ROLLS[0]:.0f} to {100 * ROLLS[1]:.0f} cm/s; each recovery there is a false alarm.",
    measured("least rise of the delay from threshold to threshold", lambda s: least_rise(delays(s)),
             unit="s", above=0.0),
    measured("least fall of the false alarms in 100 approaches", lambda s: least_fall(alarms(s)), at_least=0.0),
    measured("false alarms in 100 approaches: least threshold less greatest",
             lambda s: alarms(s)[0] - alarms(s)[-1], above=0.0),
    measure=sweep_thresholds,
    figures=plots(plot("Delay by threshold", "threshold [readings]", "mean time until noticed [s]", COUNTS,
                       {"held robots": delays}),
                  plot("False alarms by threshold", "threshold [readings]", "false alarms in 100 approaches", COUNTS,
                       {"free robots": alarms})),
    batches=6, seconds=4.0,
    ingredients=("the second counter stays at 8 s",),
)  # fmt: skip

# In play

GAMES, PLAY_TIME = 16, 60.0  # of 3 v 3, [s]
CAUSES = ("receding", "turning", "near", "other")
USUAL = [0, 1]  # the causes that the paper names
BEFORE = 3.0  # [s] before an alarm that decide its cause
FREE = 0.5  # [1] share of this time in contact, below which nobody stopped the robot
AWAY = 0.01  # [m/s] least speed of a receding ball
ASIDE = 0.3  # [rad] least bearing of a ball aside
SLOWLY = 0.2  # [rad/s] least turn rate


def signs_of(match: Match, r: int) -> np.ndarray:
    """Return for robot r the ball's speed away [m/s], |bearing| [rad], |turn rate| [rad/s] and distance [m]: (4, M).

    The distance is from the camera.
    """
    distance, bearing = distance_to_ball(match, r)
    angle = match.robots["heading"][:, r] + bearing
    away = match.balls["vx"] * np.cos(angle) + match.balls["vy"] * np.sin(angle)
    turn = np.abs(match.robots["omega"][:, r])
    return np.stack([away, np.abs(bearing), turn, sampled.distance_from_camera(match, distance, bearing)])


def cause_of(signs: np.ndarray) -> int:
    """Return the index in CAUSES of an alarm's cause, from the mean signs (4,) before the alarm."""
    away, bearing, turn, distance = signs
    tests = (away > AWAY, bearing > ASIDE or turn > SLOWLY, distance < NEAR, True)
    return tests.index(True)


class Approaches:
    """Approaches to the ball in play, by robots (M, R): counts of approaches, recoveries and false alarms by cause."""

    def __init__(self, match: Match) -> None:
        self.match, self.watch = match, sampled.MotionWindow(match, BEFORE)
        self.signs: list[np.ndarray] = []
        self.was = np.zeros(match.robots.shape, int)
        self.goes = np.zeros(match.robots.shape, bool)  # goes for the ball, also while it is lost for a moment
        self.found = {name: np.zeros(match.count) for name in ("approaches", "recoveries", "usual free", "free")}
        self.causes = np.zeros((match.count, len(CAUSES)))

    def look(self, step: int) -> None:
        """Update the counts after a control step."""
        match, rows = self.match, range(self.match.robots.shape[1])
        self.watch.look()
        self.signs = [*self.signs[1 - self.watch.size :], np.stack([signs_of(match, r) for r in rows], axis=-1)]
        now = sampled.behaviours(match)
        returns = self.was == sampled.OUT  # and resumes its behaviour
        begins = (now == BACK) & (self.was != BACK) & ~returns
        self.found["approaches"] += ((now == APPROACH) & ~self.goes).sum(axis=1)
        self.goes = (now == APPROACH) | (self.goes & (now == SEARCH))
        self.found["recoveries"] += begins.sum(axis=1)
        self.was = now
        alone = (self.watch.mean(3) < FREE) & self.watch.there()
        for m, r in np.argwhere(begins & alone):
            self.causes[m, self.cause(m, r)] += 1.0
        if step % self.watch.size == 0 and self.watch.full():  # free approaches, whether there is an alarm or not
            for m, r in np.argwhere(alone & (self.watch.mean(4) == 1.0)):
                self.found["free"][m] += 1.0
                self.found["usual free"][m] += self.cause(m, r) in USUAL

    def cause(self, m: int, r: int) -> int:
        """Return the cause of an alarm of robot r in match m, from its signs in the last seconds."""
        return cause_of(np.mean([sign[:, m, r] for sign in self.signs], axis=0))


def count_alarm_causes(batch: Batch) -> Samples:
    """Return false alarms of play by cause (M, causes), approaches, recoveries (M,), and alarms in staged runs (M,)."""
    match = kick_off(batch, matches=GAMES, team="sacks-2001")
    seen = Approaches(match)
    for step in play(match, PLAY_TIME):
        seen.look(step)
    match.close()
    alarms = approach(batch, rolls=False).reshape(GAMES, -1)
    samples = {**seen.found, "causes": seen.causes, "false": alarms.sum(axis=1)}
    samples |= {"usual": seen.causes[:, USUAL].sum(axis=1), "alarms": seen.causes.sum(axis=1)}
    return {**samples, "staged": np.full(GAMES, float(alarms.shape[1]))}


def sign_frequency_excess(samples: Samples) -> float:
    """Return the share of receding or turning before false alarms minus the share in free approaches [pp]."""
    alarms, free = samples["alarms"].sum(), samples["free"].sum()
    if not alarms or not free:
        return float("nan")
    return 100.0 * float(samples["usual"].sum() / alarms - samples["usual free"].sum() / free)


def cause_share(samples: Samples, cause: int) -> float:
    """Return the share [%] of one cause among all false alarms of play."""
    total = samples["causes"].sum()
    return 100.0 * float(samples["causes"][:, cause].sum()) / total if total else float("nan")


S24 = claim(
    "S24", "3.3", "False alarms are infrequent, usually while the ball moves away or the robot turns slowly.",
    f"{GAMES} matches a batch of 3 v 3, {PLAY_TIME:g} s each: recoveries of robots that touched nobody for "
    f"most of the {BEFORE:g} s before are false alarms; their cause by that time: the ball moved away, else the robot "
    "turned or had the ball aside, else the ball was nearer than 35 cm, else none of these. The same told of "
    f"{BEFORE:g} s of free approaches without an alarm. Beside it {TRIES} staged approaches a batch to a still ball 40 "
    "to 90 cm away in any direction, nothing in the way.",
    counted("approaches in play that end in a false alarm", "alarms", "approaches", at_most=5.0),
    measured("receding or turning: before false alarms less in free approaches", sign_frequency_excess, unit="pp",
             above=0.0),
    *(reported(f"false alarms in play: {name}", cause_share, i, unit="%") for i, name in enumerate(CAUSES)),
    reported("staged approaches with a false alarm", lambda s: 100.0 * s["false"].sum() / s["staged"].sum(), unit="%"),
    rules=PLAYED_AND_STAGED, measure=count_alarm_causes, least=4, batches=12, seconds=4.5,
    ingredients=("stuck_count, near_zero, clearly, near_time: assumed",),
)  # fmt: skip
