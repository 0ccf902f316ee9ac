"""How a stuck robot gets free: steps back, then aside or round, then to the ball again.  [Sacks 2001, 3.4]"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from math import pi
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.memory import BACK, SIDESTEP
from soccer_env.match import Match
from soccer_env.staging import memory_of
from soccer_env.teams import make_team
from soccer_env.train.reproduce.claim import SACKS, Batch, Claim, Curve, Figure, Without
from soccer_env.train.reproduce.claims.stuck.runs import behind_post, recover, recovers
from soccer_env.train.reproduce.staging import LEGGED, ball_from, play, wrapped
from soccer_env.train.reproduce.values import known, mean
from soccer_env.train.reproduce.verdicts import Samples, counted, measured, reported

RUNS = 64  # a batch and variant
SIGHT = 1.0  # [s] in which robots see the ball before they recover
BACK_STEPS = (2, 5, 10, 15)  # S26
AGAIN = 5.0  # [s] "instantly", assumed: S26
PUSHED, SLOW = 1.0, 0.02  # [s] of contact, [m/s]: that long, that slow, and a robot is stuck again
CLEAR = 15.0  # [s] after the recovery in which a robot may clear the one in its way
LONGEST = 60.0  # [s] of a run, S28, S29
WALL_RUNS = 48


class Watch:
    """What became of robots that recover: (M,) each."""

    def __init__(self, match: Match) -> None:
        count = match.count
        self.match = match
        self.free = np.full(count, np.nan)  # [s] at which the first recovery was over
        self.pushing, self.stuck = np.zeros(count), np.full(count, np.nan)  # [s] of contact, [s] stuck again
        self.got = np.full(count, np.nan)  # [s] at which it had the ball
        self.tries, self.was = np.ones(count), np.ones(count, bool)

    def note(self, now: float) -> None:
        """Look at the matches after a control step."""
        match, robot = self.match, self.match.robots[:, 0]
        self.free[np.isnan(self.free) & ~recovers(match)] = now
        still = np.hypot(robot["vx"], robot["vy"]) < SLOW
        pushes = ~np.isnan(self.free) & still & (match.robot_events["collision"][:, 0] == 1)
        self.pushing = np.where(pushes, self.pushing + match.league.dt, 0.0)
        self.stuck[np.isnan(self.stuck) & (self.pushing >= PUSHED)] = now
        self.tries += (memory_of(match)["behaviour"] == BACK) & ~self.was & np.isnan(self.got)
        self.was = memory_of(match)["behaviour"] == BACK
        self.got[np.isnan(self.got) & (robot["has_ball"] == 1)] = now


def begin_recovery(batch: Batch, ways: float, **settings: Any) -> Match:
    """Return matches in which robots that have seen the ball past somebody in the way have just begun to recover."""
    match = behind_post(batch, RUNS, ways, **settings)
    for _ in play(match, SIGHT):
        pass
    recover(match)
    return match


def run_recovery(match: Match, seconds: float) -> Watch:
    """Play on for a time."""
    watch = Watch(match)
    for step in play(match, seconds):
        watch.note((step + 1) * match.league.dt)
    return watch


def stuck_again(batch: Batch, way_back: bool = False) -> Samples:
    """Return who is stuck again within AGAIN after the recovery, for each number of steps back (M, numbers).

    `way_back`: the time that it takes to walk as far ahead as it went back does not count.
    """
    found = []
    for steps in BACK_STEPS:
        match = begin_recovery(batch, 0.4, back_steps=steps)
        watch = run_recovery(match, 0.5 * steps + 4.0 + 2.0 * AGAIN)
        ratio = match.league.drive.backward / match.league.drive.forward
        found.append(watch.stuck - watch.free - (0.5 * steps * ratio if way_back else 0.0))
        match.close()
    after = np.nan_to_num(np.stack(found, axis=1), nan=np.inf)
    return {"again": (after <= AGAIN).astype(float)}


def shares(samples: Samples) -> list[float]:
    """Return the share [%] stuck again for each number of steps back."""
    return [100.0 * mean(samples["again"][:, i]) for i in range(len(BACK_STEPS))]


def share(samples: Samples, number: int) -> float:
    """Return the share [%] stuck again for one of the numbers of steps back."""
    return shares(samples)[number]


def ten_over_fewer(samples: Samples) -> float:
    """Return the share stuck again after 10 steps over the mean of those after 2 and 5; NaN: nobody is."""
    two, five, ten, _ = shares(samples)
    return ten / (0.5 * (two + five)) if two + five > 0.0 else float("nan")


def again_figure(samples: Samples) -> Sequence[Figure]:
    """Draw the share against the steps."""
    curve = Curve("stuck again within 5 s", BACK_STEPS, shares(samples))
    return (Figure("Stuck again after a recovery", "steps back", "robots [%]", (curve,)),)


SCENE = (
    f"{RUNS} robots a batch see a still ball past a robot that stands in their way and that nobody pushes aside; after "
    f"{SIGHT:g} s, close to it, they begin to recover, "
)
OBSTACLE = "a robot in the way that is not pushed aside, aside of the straight way by 8 to 16 cm"

S26 = Claim(
    id="S26",
    paper=SACKS,
    section="3.4",
    statement="Ten steps back are more than is usually necessary, but help ensure that the robot will not immediately "
    "get stuck again.",
    method=SCENE + f"with {', '.join(map(str, BACK_STEPS))} steps back: who stands in contact with it for {PUSHED:g} s "
    f"within {AGAIN:g} s after the recovery is stuck again.",
    criteria=(
        measured("stuck again after 10 steps over the mean of 2 and 5", ten_over_fewer, at_most=0.5),
        *(
            reported(f"stuck again after {steps} steps back", partial(share, number=i), unit="%")
            for i, steps in enumerate(BACK_STEPS)
        ),
    ),
    measure=stuck_again,
    without=Without("the way back counts in the five seconds", partial(stuck_again, way_back=True)),
    figures=again_figure,
    ingredients=(OBSTACLE, "side_steps 5: assumed"),
    note="Ten steps back take the robot half a metre away, and it needs four of the five seconds to come back. Counted "
    "from then on, robots are stuck again about as often as after two steps: they return to the same place.",
    seconds=3.0,
    batches=12,
)


def misalignment(match: Match) -> np.ndarray:
    """Return the angle (M,) [rad] between the way from robot 0 to the ball and that from the ball to the goal."""
    _, bearing = ball_from(match)
    to_ball = match.robots["heading"][:, 0] + bearing
    to_goal = np.arctan2(-match.balls["y"], match.league.pitch.length / 2 - match.balls["x"])
    off: np.ndarray = np.abs(wrapped(to_ball - to_goal))
    return off


def sidestep(batch: Batch, either: bool) -> Samples:
    """Recover once (`either`: to a side that is drawn); return misalignments [deg] and who cleared, (M,) each."""
    match = begin_recovery(batch, 2.8)
    side = batch.rng(3).choice([-1.0, 1.0], RUNS)
    before = misalignment(match)
    after = np.full(RUNS, np.nan)
    watch = Watch(match)
    asides = np.zeros(RUNS, bool)
    for step in play(match, 9.0 + CLEAR):
        stepping = memory_of(match)["behaviour"] == SIDESTEP
        asides |= stepping
        if either:
            memory_of(match)["side"][stepping] = side[stepping]
        watch.note((step + 1) * match.league.dt)
        now = ~np.isnan(watch.free) & np.isnan(after)
        after[now] = misalignment(match)[now]
    match.close()
    clear = ~np.isnan(watch.got) & (np.isnan(watch.stuck) | (watch.got < watch.stuck))
    degrees = {"before": np.degrees(before), "after": np.where(asides, np.degrees(after), np.nan)}
    return {**degrees, "clear": (asides & clear).astype(float), "aside": asides.astype(float)}


def sides(batch: Batch) -> Samples:
    """Return both variants: the paper's side, and a drawn one."""
    own, either = sidestep(batch, False), sidestep(batch, True)
    return {**own, **{f"{name} either": values for name, values in either.items()}}


def change(samples: Samples, name: str = "") -> float:
    """Return the mean change [deg] of the misalignment by a recovery."""
    return mean(samples[f"after{name}"] - samples[f"before{name}"])


S27 = Claim(
    id="S27",
    paper=SACKS,
    section="3.4",
    statement="The sidestep that keeps the ball between robot and goal does not always get it around the obstacle, but "
    "works well enough, and positions it to shoot.",
    method=SCENE + "on ways in all directions of the field: who has the ball within "
    f"{CLEAR:g} s of the recovery without being stuck again has cleared it. Angle between the ways from robot to ball "
    "and from ball to goal, before and after; beside it a side drawn at random.",
    criteria=(
        counted("cleared the obstacle: at least 50 %", "clear", "aside", at_least=50.0),
        counted("cleared the obstacle: at most 95 %", "clear", "aside", at_most=95.0),
        measured("change of the misalignment by the recovery", change, unit="deg", below=0.0),
        measured(
            "misalignment afterwards, less that with a random side",
            lambda s: mean(s["after"] - s["after either"]),
            unit="deg",
            below=0.0,
        ),
        reported("cleared with a random side", lambda s: 100.0 * mean(s["clear either"]), unit="%"),
        reported("change of the misalignment with a random side", lambda s: change(s, " either"), unit="deg"),
        reported("misalignment before", lambda s: mean(s["before"]), unit="deg"),
    ),
    measure=sides,
    ingredients=(OBSTACLE, "side_steps 5: assumed"),
    seconds=2.5,
    batches=16,
)


def face_wall(batch: Batch, **settings: Any) -> tuple[np.ndarray, np.ndarray]:
    """Run the drill facing-wall; return who got the ball (M,) and the tries to get free."""
    team = make_team("sacks-2001", **settings)
    match = Match(
        LEGGED, matches=WALL_RUNS, seeds=batch.seeds(WALL_RUNS), threads=batch.threads, home=1, away=1, keeper=0,
        scene="facing-wall", episode="drill", pose=batch.pose, controllers={"home": team, "away": "still"},
    )  # fmt: skip
    solved, tries = np.zeros(WALL_RUNS), np.zeros(WALL_RUNS)
    for _ in play(match, LONGEST):
        solved += match.events["drill"] == 1
        tries = np.where(match.matches["over"] == 1, tries, np.maximum(tries, memory_of(match)["tries"]))
    match.close()
    return solved, tries


def walls(batch: Batch) -> Samples:
    """Run the drill with the rule that turns to a ball far aside, and with sidesteps always."""
    (rotate, tries), (aside, _) = face_wall(batch), face_wall(batch, rotate_beyond=pi)
    return {"rotate": rotate, "aside": aside, "tries": tries, "one": np.ones(WALL_RUNS)}


S28 = Claim(
    id="S28",
    paper=SACKS,
    section="3.4",
    statement="If the ball is more than 30 degrees aside the robot rotates instead: often it faces out at the field's "
    "edge and the wall prevents it from rotating; it need only back away and face the ball.",
    method=f"{WALL_RUNS} drills a batch, facing-wall: the paws at the board, the ball behind; got within "
    f"{LONGEST:g} s, with the rule and with sidesteps always.",
    criteria=(
        counted("got the ball", "rotate", "one", at_least=90.0),
        measured(
            "got the ball: rotation less sidesteps",
            lambda s: 100.0 * (mean(s["rotate"]) - mean(s["aside"])),
            unit="%",
            above=0.0,
        ),
        reported("robots that recovered at all", lambda s: 100.0 * mean(s["tries"] > 0), unit="%"),
    ),
    measure=walls,
    ingredients=("a board does not stop a robot here from turning on the spot",),
    note="A robot whose paws touch a board slides along it while it turns: it never gets stuck there, so that "
    "nearly all solve the drill without any recovery, and the rule has nothing to do.",
    seconds=2.0,
    batches=10,
)


def attempts(batch: Batch) -> Samples:
    """Recover as often as it takes; return who got the ball, within three tries, and the tries (M,)."""
    match = begin_recovery(batch, 0.4)
    watch = run_recovery(match, LONGEST)
    match.close()
    got = ~np.isnan(watch.got)
    few = got & (watch.tries <= 3)
    return {"few": few.astype(float), "tries": np.where(got, watch.tries, np.nan), "one": np.ones(RUNS)}


def tries_figure(samples: Samples) -> Sequence[Figure]:
    """Draw how many needed how many tries."""
    counts = [int((known(samples["tries"]) == n).sum()) for n in range(1, 7)]
    curve = Curve("robots that got the ball", range(1, 7), [100.0 * n / len(samples["one"]) for n in counts])
    return (Figure("Recoveries until the robot has the ball", "recoveries", "robots [%]", (curve,)),)


S29 = Claim(
    id="S29",
    paper=SACKS,
    section="3.4",
    statement="It sometimes takes a few tries to get around an obstacle, but the recovery seems relatively effective.",
    method=SCENE + f"and go on by themselves for {LONGEST:g} s: recoveries until they have the ball.",
    criteria=(
        counted("got the ball in at most three tries", "few", "one", at_least=90.0),
        measured("mean of the tries of those that got it", lambda s: mean(s["tries"]), above=1.0),
        reported("got the ball at all", lambda s: 100.0 * float(np.isfinite(s["tries"]).mean()), unit="%"),
    ),
    measure=attempts,
    figures=tries_figure,
    ingredients=(OBSTACLE, "side_steps 5: assumed"),
    note="About half of the recoveries do not clear the way (S27), and some are stopped again. Who got the ball had it "
    "in at most three tries; the others had not got it when the run ended.",
    seconds=3.0,
    batches=12,
)

CLAIMS = (S26, S27, S28, S29)
