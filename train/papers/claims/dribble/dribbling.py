"""Keeping the ball between the paws: step length, angle off straight ahead, a robot in the way.  [Sacks 2001, 4.3]

Each claim is measured in two leagues: in `legged-2001`, whose legs swing, which decides (MS51), and with the one-piece
body of `legged-2001-smooth`. Geometry and gait decide in both; none of their numbers is fitted to a claim.
"""

from collections.abc import Callable
from math import pi

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import Batch, claim
from soccer_env.train.papers.dribble_runs import COUNTED, LOST, NO_SHOTS, losses, place_with_ball, record_dribble
from soccer_env.train.papers.plots import columns, plot
from soccer_env.train.papers.staging import LEGGED, put, stage, stage_team, still_actions
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

MATCHES = 64
STEPS = (0.030, 0.035, 0.040, 0.045)  # [m] of a gait step: 3.5 and 4 are the paper's
PAPER_STEP = 0.035  # [m] Sacks 2001, 4.3.2
SECONDS = 22.0  # [s] of a dribble: 1.5 m at 7 cm/s
ANGLES = (0.0, 15.0, 30.0, 40.0, 45.0, 50.0, 55.0, 60.0, 65.0, 70.0, 75.0)  # [degrees] off straight ahead
ASIDE_SECONDS = 8.0  # [s] of a walk at one angle: half a metre
KNEE, KNEE_ROOM = 45.0, 10.0  # [degrees] Sacks 2001, 4.3.3; tolerance for "near"
LIMITS = (45.0, 55.0)  # [degrees] Sacks 2001, 4.3.3
PUSH_SECONDS = 8.0  # [s] of a walk against a robot that stands right ahead
NEAREST, FARTHEST = 0.335, 0.40  # [m] distance of this robot: the ball between the two, or nearly
CAUGHT = 0.01  # [m/s] a robot that touches another and is slower than this is caught; it wants 7 cm/s
WORLDS = {"": LEGGED, "smooth ": "legged-2001-smooth"}  # prefix of the samples: league


def measure_in_both_worlds(measure: Callable[[Batch, str], Samples]) -> Callable[[Batch], Samples]:
    """Wrap a measurement to run with swinging legs and with the one-piece body (samples named "smooth ...")."""

    def both(batch: Batch) -> Samples:
        return {f"{name}{key}": array for name, world in WORLDS.items() for key, array in measure(batch, world).items()}

    return both


# Steps


def dribble_steps(batch: Batch, world: str) -> Samples:
    """Let the team dribble towards an empty goal at each step length; return arrays (M, len(STEPS)) of `losses`."""
    rng, runs = batch.rng(), []
    y, turned = rng.uniform(-0.5, 0.5, MATCHES), rng.uniform(-0.5, 0.5, MATCHES)
    for step in STEPS:
        settings = NO_SHOTS | {"step_length": step}
        match = stage_team(batch, "sacks-2001", settings, world, matches=MATCHES, keeper=0)
        place_with_ball(match, y=y, heading=turned)
        runs.append(losses(record_dribble(match, SECONDS)))
    columns = {name: np.stack([one[name] for one in runs], axis=1).astype(float) for name in runs[0]}
    at = STEPS.index(PAPER_STEP)
    return columns | {"kept at 3.5": columns["kept"][:, at], "tried at 3.5": columns["tried"][:, at]}


def losses_per_metre(samples: Samples, world: str = "") -> list[float]:
    """Return the number of balls lost per metre dribbled, for each step length."""
    lost, metres = samples[f"{world}lost"].sum(axis=0), samples[f"{world}metres"].sum(axis=0)
    return [float(value) for value in lost / np.maximum(metres, 1e-9)]


def loss_increase(samples: Samples) -> float:
    """Return the losses per metre at a step length of 4 cm minus twice the losses at 3.5 cm."""
    by_step = losses_per_metre(samples)
    return by_step[STEPS.index(0.040)] - 2.0 * by_step[STEPS.index(PAPER_STEP)]


S51 = claim(
    "S51", "4.3.2", "Steps of 4 cm kick the ball away too often; 3.5 cm mostly keep it.",
    f"{MATCHES} robots a batch and step length begin with the ball between their paws and dribble to an empty "
    f"goal by the team's own potential field for {SECONDS:g} s, without shots. A ball {100 * LOST:g} cm from the chest "
    "is lost. Beside it the same with the body of one piece.",
    counted(f"kept over {COUNTED:g} m at 3.5 cm", "kept at 3.5", "tried at 3.5", at_least=80.0),
    measured("losses per metre at 4 cm less twice those at 3.5 cm", loss_increase, above=0.0),
    measure=measure_in_both_worlds(dribble_steps),
    figures=plot("Balls lost by a dribbler", "length of a step [cm]", "losses per metre",
                 [100 * step for step in STEPS],
                 {"legs that swing": losses_per_metre, "body of one piece": lambda s: losses_per_metre(s, "smooth ")}),
    batches=12, seconds=5.5,
    ingredients=("the body's outline: the pocket between the paws", "the drive's acceleration", "the gait"),
    note="No ball was lost, at 4 cm as at 3.5. A body of one piece that slides with a constant speed does not kick. A "
    "paw that swings goes at twice the speed of the walk and reaches half a stroke ahead of where it stands; geometry "
    "and gait say how often that kicks.",
)  # fmt: skip

# Angle


def push_at_angles(batch: Batch, world: str) -> Samples:
    """Let robots push the ball at each angle off straight ahead, half to the left; "lost" (M, angles) is 0 or 1."""
    side, lost = batch.rng().choice([-1.0, 1.0], MATCHES), []
    for angle in ANGLES:
        match = stage(batch, world, matches=MATCHES, senses="ideal")
        place_with_ball(match, -0.6, -0.4 * side)
        way = record_dribble(match, ASIDE_SECONDS, walking_actions(match, PAPER_STEP, side * angle))
        lost.append(losses(way)["lost"] > 0)
    return {"lost": np.stack(lost, axis=1).astype(float)}


def walking_actions(match: Match, step: float, angle: np.ndarray) -> np.ndarray:
    """Return actions by which robot 0 walks with steps [m] at angles [degrees] off straight ahead."""
    actions, drive = still_actions(match), match.league.drive
    speed = step / (drive.gait_steps * match.league.dt)
    actions[:, 0, 0] = speed * np.cos(angle * pi / 180.0) / drive.forward
    actions[:, 0, 1] = speed * np.sin(angle * pi / 180.0) / drive.sideways
    return actions


def wide_angle_loss_difference(samples: Samples) -> float:
    """Return the share of balls lost [%] at 60 degrees and more minus the share at 45 degrees and less."""
    shares, angles = np.array(columns("lost")(samples)), np.array(ANGLES)
    return float(shares[angles >= 60.0].mean() - shares[angles <= KNEE].mean())


def half_loss_angle(samples: Samples) -> float:
    """Return the angle [degrees] at which losses reach half of their maximum, by linear interpolation."""
    shares = columns("lost")(samples)
    half = 0.5 * max(shares)
    above = next((i for i, value in enumerate(shares) if value > half), 0)
    if above == 0:
        return np.nan
    part = (half - shares[above - 1]) / (shares[above] - shares[above - 1])
    return ANGLES[above - 1] + part * (ANGLES[above] - ANGLES[above - 1])


S59 = claim(
    "S59", "4.3.3", "Moving more than about 45 degrees to its side a robot frequently loses the ball.",
    f"{MATCHES} robots a batch and angle walk {ASIDE_SECONDS:g} s with steps of 3.5 cm at 0 to 75 degrees off "
    "straight ahead, half to each side, without turning, the ball between their paws at the start. Knee: where losses "
    "reach half of their greatest share. Beside it the same with the body of one piece.",
    measured("lost at 60 degrees and more, less lost at 45 and less", wide_angle_loss_difference, unit="%", above=10.0),
    measured("knee", half_loss_angle, unit="degrees", at_least=KNEE - KNEE_ROOM, at_most=KNEE + KNEE_ROOM),
    measure=measure_in_both_worlds(push_at_angles),
    figures=plot(f"Balls lost within {ASIDE_SECONDS:g} s of walking aside", "angle off straight ahead [degrees]",
                 "balls lost [%]", ANGLES,
                 {"legs that swing": columns("lost"), "body of one piece": columns("smooth lost")}),
    batches=8, seconds=4.0,
    ingredients=("the body's outline: how far the paws reach beside the ball", "the gait"),
    note="The paws of a body of one piece hold the ball from both sides; it slips out under a paw only if the robot "
    "walks almost sideways. Legs that swing open the pocket by a stroke.",
)  # fmt: skip

# A robot right ahead


def push_past_robot(batch: Batch, world: str) -> Samples:
    """Let robots walk with the ball at 45 and 55 degrees off straight ahead, with another robot right ahead.

    "caught": share of time (M, 2) for which the other robot blocks them; "made": distance walked [m].
    """
    rng, shares, made = batch.rng(), [], []
    side, distance = rng.choice([-1.0, 1.0], MATCHES), rng.uniform(NEAREST, FARTHEST, MATCHES)
    aside = rng.uniform(-0.03, 0.03, MATCHES)
    for angle in LIMITS:
        match = stage(batch, world, matches=MATCHES, senses="ideal")
        place_with_ball(match, -0.3, 0.0)
        put(match, 1, -0.3 + distance, aside, pi)
        way = record_dribble(match, PUSH_SECONDS, walking_actions(match, PAPER_STEP, side * angle))
        slow = way.step * match.league.control_rate < CAUGHT
        shares.append((way.touches & slow).mean(axis=0))
        made.append(np.hypot(way.x[-1] - way.x[0], way.y[-1] - way.y[0]))
    return {"caught": np.stack(shares, axis=1), "made": np.stack(made, axis=1)}


def blocked_time_difference(samples: Samples, world: str = "") -> float:
    """Return the share of time blocked by the other robot [%] at 45 degrees minus the share at 55 degrees."""
    by_limit = samples[f"{world}caught"].mean(axis=0)
    return 100.0 * float(by_limit[0] - by_limit[1])


S60 = claim(
    "S60", "4.3.3", "With a player directly in front 45 degrees interlock the legs; up to 55 help.",
    f"{MATCHES} robots a batch begin with the ball between their paws and a robot that stands "
    f"{100 * NEAREST:.0f} to {100 * FARTHEST:.0f} cm right ahead, and walk {PUSH_SECONDS:g} s with steps of 3.5 cm at "
    f"45 or 55 degrees. Caught: in touch with the other and slower than {100 * CAUGHT:g} cm/s of the 7 that it wants. "
    "Beside it the same with the body of one piece.",
    measured("share of time caught at 45 degrees less that at 55", blocked_time_difference, unit="%", above=0.0),
    reported("body of one piece: the difference", blocked_time_difference, "smooth ", unit="%"),
    measure=measure_in_both_worlds(push_past_robot), batches=16, seconds=2.0,
    ingredients=("the robots' outlines and their friction", "traction and thrust"),
    note="Robots slide past each other at either angle, and farther at 55 degrees. A leg is held only between two legs "
    "of the other robot (MS51), where hardly any comes from right ahead.",
)  # fmt: skip
