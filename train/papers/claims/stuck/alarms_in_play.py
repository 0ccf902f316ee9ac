"""False alarms in play: a robot believes that it is stuck and is not.  [Sacks 2001, 3.3]"""

import numpy as np

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, SEARCH
from soccer_env.match import Match
from soccer_env.train.papers.claim import PLAYED_AND_STAGED, Batch, Claim
from soccer_env.train.papers.claims.stuck.detection import NEAR
from soccer_env.train.papers.claims.stuck.false_alarms import TRIES, approach
from soccer_env.train.papers.claims.stuck.sampled import OUT, MotionWindow, behaviours, distance_from_camera
from soccer_env.train.papers.staging import distance_to_ball, kick_off, play
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

MATCHES, PLAY_TIME = 16, 60.0  # of 3 v 3, [s]
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
    return np.stack([away, np.abs(bearing), turn, distance_from_camera(match, distance, bearing)])


def cause_of(signs: np.ndarray) -> int:
    """Return the index in CAUSES of an alarm's cause, from the mean signs (4,) before the alarm."""
    away, bearing, turn, distance = signs
    tests = (away > AWAY, bearing > ASIDE or turn > SLOWLY, distance < NEAR, True)
    return tests.index(True)


class Approaches:
    """Approaches to the ball in play, by robots (M, R): counts of approaches, recoveries and false alarms by cause."""

    def __init__(self, match: Match) -> None:
        self.match, self.watch = match, MotionWindow(match, BEFORE)
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
        now = behaviours(match)
        begins = (now == BACK) & (self.was != BACK) & (self.was != OUT)  # a robot that returns resumes its behaviour
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
    match = kick_off(batch, matches=MATCHES, team="sacks-2001")
    seen = Approaches(match)
    for step in play(match, PLAY_TIME):
        seen.look(step)
    match.close()
    alarms = approach(batch, rolls=False).reshape(MATCHES, -1)
    samples = {**seen.found, "causes": seen.causes, "false": alarms.sum(axis=1)}
    samples |= {"usual": seen.causes[:, USUAL].sum(axis=1), "alarms": seen.causes.sum(axis=1)}
    return {**samples, "staged": np.full(MATCHES, float(alarms.shape[1]))}


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


S24 = Claim(
    id="S24",
    section="3.3",
    statement="False alarms are infrequent, usually while the ball moves away or the robot turns slowly.",
    method=f"{MATCHES} matches a batch of 3 v 3, {PLAY_TIME:g} s each: recoveries of robots that touched nobody for "
    f"most of the {BEFORE:g} s before are false alarms; their cause by that time: the ball moved away, else the "
    "robot turned or had the ball aside, else the ball was nearer than 35 cm, else none of these. The same told of "
    f"{BEFORE:g} s of free approaches without an alarm. Beside it {TRIES} staged approaches a batch to a still ball 40 "
    "to 90 cm away in any direction, nothing in the way.",
    criteria=(
        counted("approaches in play that end in a false alarm", "alarms", "approaches", at_most=5.0),
        measured("receding or turning: before false alarms less in free approaches", sign_frequency_excess, unit="pp",
                 above=0.0),
        *(reported(f"false alarms in play: {name}", cause_share, i, unit="%") for i, name in enumerate(CAUSES)),
        reported("receding or turning in free approaches",
                 lambda s: 100.0 * s["usual free"].sum() / max(s["free"].sum(), 1.0), unit="%"),
        reported("recoveries in play, a minute and match", lambda s: mean(s["recoveries"]) * 60.0 / PLAY_TIME),
        reported("false alarms in play, in all", lambda s: float(s["alarms"].sum())),
        reported("recoveries that are false alarms",
                 lambda s: 100.0 * s["alarms"].sum() / max(s["recoveries"].sum(), 1.0), unit="%"),
        reported("staged approaches with a false alarm", lambda s: 100.0 * s["false"].sum() / s["staged"].sum(),
                 unit="%"),
    ),
    rules=PLAYED_AND_STAGED,
    measure=count_alarm_causes,
    ingredients=("stuck_count, near_zero, clearly, near_time: assumed",),
    seconds=4.5,
    batches=12,
    least=4,
)  # fmt: skip
