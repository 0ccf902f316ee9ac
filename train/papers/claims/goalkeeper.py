"""A goalkeeper's use of the ball's velocity.  [Sacks 2001, 3.2, 5]

The paper's goalkeeper decides how to *block* a ball. So both claims are measured in a league whose goalkeepers can
spread their forelegs (`soccer_env/physics/block.py`), S67 also in the league where they can only sidestep.
"""

from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import Batch, claim
from soccer_env.train.papers.claims.ball.range import LAYERS
from soccer_env.train.papers.plots import plot_bins
from soccer_env.train.papers.staging import LEGGED, begin_scene, put, put_ball, stage_team
from soccer_env.train.papers.values import gain, mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

SHOTS = 32
LOOK, SECONDS = 0.5, 4.5  # [s] of looking at the ball before it is kicked, and longest of a shot
NEAREST, FARTHEST = 1.0, 2.2  # [m] of the ball from the middle of the goal
WIDEST = 0.6  # [rad] of the ball off the middle of the pitch
ARRIVES = 0.15  # [m/s] least speed on the line: slower kicks do not reach the goal
OUT = 0.30  # [m] of the goalkeeper from the middle of its goal, as it guards
ASIDE = 0.15  # [m] of it off the line from the ball to the goal, at most: 13 cm in 9 of 10 shots of matches
BLOCKING = "legged-2001-block"
BLOCKS = {"keeper_blocks": True, "keeper_speed": True}  # as in sacks-2001-future
FAR = (0.20, 0.35)  # [m] of it off this line, in the scenes "far", assumed
BINS = (0.75, 0.9, 1.05, 1.2, 1.35, 1.5)  # [m/s] edges of the speed at the kick


def face_shots(
    batch: Batch, settings: dict[str, Any], league: str = BLOCKING, far: bool = False, **more: Any
) -> tuple[np.ndarray, np.ndarray]:
    """Roll shots at the goal of one goalkeeper; return which go in (M,), and the speeds at the kick [m/s]."""
    rng, match = batch.rng(), stage_team(batch, "sacks-2001", settings, league, matches=SHOTS, home=2, **more)
    pitch, ball, fastest = match.league.pitch, match.league.ball, match.league.kicker.fastest
    goal = -pitch.length / 2
    away, angle = rng.uniform(NEAREST, FARTHEST, SHOTS), rng.uniform(-WIDEST, WIDEST, SHOTS)
    x, y = goal + away * np.cos(angle), np.clip(away * np.sin(angle), -0.9, 0.9)
    aim = rng.uniform(-0.9, 0.9, SHOTS) * (pitch.goal_width / 2 - ball.radius)
    way = np.arctan2(aim - y, goal - x)
    least = np.sqrt(ARRIVES**2 + 2.0 * ball.rolling * np.hypot(goal - x, aim - y))
    speed = rng.uniform(np.minimum(least, fastest), fastest)
    facing = np.arctan2(y, x - goal)
    off = rng.uniform(-1.0, 1.0, SHOTS)
    aside = np.sign(off) * (FAR[0] + (FAR[1] - FAR[0]) * np.abs(off)) if far else ASIDE * off
    there = goal + OUT * np.cos(facing) - aside * np.sin(facing), OUT * np.sin(facing) + aside * np.cos(facing)
    put(match, 0, *there, facing)
    put_ball(match, x, y)
    begin_scene(match, placed=True)
    return shoot(match, x, y, speed * np.cos(way), speed * np.sin(way)), speed


def shoot(match: Match, x: np.ndarray, y: np.ndarray, vx: np.ndarray, vy: np.ndarray) -> np.ndarray:
    """Hold the ball for LOOK seconds, let it roll, and tell which balls go in (M,)."""
    scored = np.zeros(match.count, bool)
    for step in range(round((LOOK + SECONDS) * match.league.control_rate)):
        if step <= LOOK * match.league.control_rate:
            moving = step == round(LOOK * match.league.control_rate)
            put_ball(match, x, y, vx * moving, vy * moving)
            match.rebuild()
        match.step()
        scored |= match.matches["score"][:, 1] > 0
    match.close()
    return scored


# With and without the angular velocity


def compare_angular_velocity(batch: Batch) -> Samples:
    """Return which shots go in (M,), for goalkeepers that use the ball's angular velocity ("on") or do not ("off").

    With a block; "far ...": starting far off the line to the ball; "ideal ...": far, with ideal senses; "step ...":
    with sidesteps alone, where "step guards" is a goalkeeper that does not react.
    """
    samples: Samples = {}
    for name, settings in (("on", {}), ("off", {"angular_keeper": False})):
        samples[name], samples["speed"] = face_shots(batch, {**BLOCKS, **settings})
        samples[f"far {name}"], _ = face_shots(batch, {**BLOCKS, **settings}, far=True)
        samples[f"ideal {name}"], _ = face_shots(batch, {**BLOCKS, **settings}, far=True, senses="ideal")
        samples[f"step {name}"], _ = face_shots(batch, settings, LEGGED)
    samples["step guards"], _ = face_shots(batch, {"keeper_alarm": 1e6}, LEGGED)
    return {name: values.astype(float) for name, values in samples.items()}


def saved(goals: np.ndarray) -> float:
    """Return the share of shots saved [1]."""
    return 1.0 - mean(goals)


SHOT_SCENE = (
    f"{SHOTS} shots a batch at a goalkeeper who looks at the ball for {LOOK:g} s: from {100 * NEAREST:.0f} to "
    f"{100 * FARTHEST:.0f} cm before the goal, aimed between the posts, with any speed from the least that arrives to "
    f"1.5 m/s; the goalkeeper stands up to {100 * ASIDE:.0f} cm off the line from the ball to its goal."
)

S67 = claim(
    "S67", "3.2, 5", "The ball's angular velocity helps the goalkeeper to decide how to block.",
    f"{SHOT_SCENE} The goalkeeper can spread its forelegs ({BLOCKING}) and does it for a ball that will pass "
    "within their reach, in time. Share of the same shots saved, with angular_keeper on and off.",
    measured("saved with the angular velocity less saved without", gain, "on", "off", saved, unit="%", above=0.0),
    reported("far off the line: with less without", gain, "far on", "far off", saved, unit="%"),
    reported("far off, ideal senses: with less without", gain, "ideal on", "ideal off", saved, unit="%"),
    measure=compare_angular_velocity,
    figures=plot_bins("Shots saved by the goalkeeper", "speed at the kick [m/s]", "saved [%]",
                      {"with the angular velocity": "on", "by the bearing alone": "off", "with it, no block": "step on",
                       "by the bearing, no block": "step off", "guards the line, no reaction": "step guards"}, "speed",
                      BINS, saved, place_scale=1.0),
    least=4, batches=20, seconds=3.0,
    ingredients=("the block of legged-2001-block: CMPack'03's b_gcntr.mot, at the speed of the ERS-210's joints",
                 "when to block: goalkeeper.will_block, ours, for the paper does not say how its goalkeeper decides",
                 "drive.sideways and drive.delay: 8 cm/s after 0.1 s"),
    note="With its legs spread a goalkeeper reaches 23 cm to either side and covers 46 of the goal's 60 cm: where it "
    "stands about right nearly all shots come within reach, and there is nothing to decide. In matches it stands "
    f"within 13 cm of the line at 9 shots in 10. Beside it, therefore, the same from {100 * FAR[0]:.0f} to "
    f"{100 * FAR[1]:.0f} cm off the line. The block is the same to both sides: a motion to one side, which has to know "
    "the side, has no reach that a source gives.",
)  # fmt: skip

# Reactions by the ball's speed, at two resolutions


def compare_resolutions(batch: Batch) -> Samples:
    """Return which shots go in (M,), with keeper_speed on and off, at both camera resolutions."""
    samples: Samples = {}
    for layer in LAYERS:
        for name, on in (("on", True), ("off", False)):
            settings = {**BLOCKS, "keeper_speed": on}
            scored, speed = face_shots(batch, settings, sensors={"resolution": layer})
            samples[f"{name} {layer}"], samples["speed"] = scored.astype(float), speed
    return samples


def reaction_gain(samples: Samples, layer: str) -> float:
    """Return the share of shots saved with reactions by speed minus the share without such reactions [%]."""
    return gain(samples, f"on {layer}", f"off {layer}", saved)


S71 = claim(
    "S71", "5", "A better camera would allow goalkeeper reactions by the ball's speed.",
    f"{SHOT_SCENE} It can spread its forelegs ({BLOCKING}). With keeper_speed, a setting of sacks-2001-future, "
    "it does so by the time in which the ball will arrive, and steps aside faster for a fast ball; without, all balls "
    "count as fast. What that gains in saves at 88x72 and at 176x144 pixels.",
    reported("gain at 176x144 less gain at 88x72",
             lambda s: reaction_gain(s, LAYERS[1]) - reaction_gain(s, LAYERS[0]), unit="%"),
    reported("gain at 176x144", reaction_gain, LAYERS[1], unit="%"),
    reported("gain at 88x72", reaction_gain, LAYERS[0], unit="%"),
    reported("saved at 88x72, one reaction", "off 88x72", of=saved, unit="%"),
    reported("saved at 176x144, one reaction", "off 176x144", of=saved, unit="%"),
    measure=compare_resolutions,
    figures=plot_bins("Shots saved, by resolution", "speed at the kick [m/s]", "saved [%]",
                      {f"{layer}, {text}": f"{name} {layer}" for layer in LAYERS
                       for name, text in (("on", "by speed"), ("off", "one reaction"))}, "speed", BINS, saved,
                      place_scale=1.0),
    least=4, batches=8, seconds=2.0,
    ingredients=("what keeper_speed does: assumed, for the paper leaves it to the future",
                 "the block of legged-2001-block: CMPack'03's b_gcntr.mot, at the speed of the ERS-210's joints",
                 "drive.sideways: 8 cm/s"),
)  # fmt: skip
