"""The numbers of the potential field: zero and unit forces, walls, computing time.  [Sacks 2001, 4.2, 4.3]"""

from collections.abc import Sequence
from functools import partial
from time import perf_counter
from typing import Any

import numpy as np

from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.baselines.sacks_2001.steering import force_of_players
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.records.beliefs import BELIEF, TRACK
from soccer_env.train.papers.claim import NO_MATCH, PLAYED, Ablation, Batch, Curve, Figure, claim
from soccer_env.train.papers.claims.field import points
from soccer_env.train.papers.claims.field.point_world import players
from soccer_env.train.papers.claims.field.points import FIELD, ROBOTS, SCENES, START, TOUCH
from soccer_env.train.papers.staging import LEGGED, kick_off
from soccer_env.train.papers.values import mean, median, quantile
from soccer_env.train.papers.verdicts import Samples, exact, measured, reported

K = constants_of(find_league(LEGGED))[0]


def forces_aside(batch: Batch, **play: Any) -> Samples:
    """Return the forces (M,) of players 90 to 180 degrees off the goal's direction, 5 to 99 cm away."""
    rng, record = batch.rng(), SacksSettings(**play).record()[0]
    distance, goal = rng.uniform(0.05, 0.99, SCENES), rng.uniform(-np.pi, np.pi, SCENES)
    angle = goal + np.radians(np.linspace(90.0, 270.0, SCENES))
    places = list(zip(distance * np.cos(angle), distance * np.sin(angle), np.cos(goal), np.sin(goal), strict=True))
    return {
        "force": np.array([np.hypot(*FIELD.player_force(*place, record)) for place in places]),
        "middles": np.array([player_force_on_robot(*place, record) for place in places]),
    }


def player_force_on_robot(x: float, y: float, goal_x: float, goal_y: float, record: np.void) -> float:
    """Return the force of a player with its middle at x, y [m] on a robot that heads along x."""
    belief, tracks = np.zeros(1, BELIEF), np.zeros(1, TRACK)
    tracks["present"], tracks["x"], tracks["y"] = 1, x, y
    force: Any = force_of_players  # a kernel
    return float(np.hypot(*force(belief[0], tracks, goal_x, goal_y, K, record)))


S48 = claim(
    "S48", "4.3.1", "A player beside or behind the dribbler exerts no force.",
    f"Force of {SCENES} players a batch that are 90 to 180 degrees off the goal's direction, 5 to 99 cm away.",
    exact("greatest force, in units of the goal's", lambda s: float(s["force"].max()), at_most=1e-12),
    reported("players that exert none as seen from the robot's middle, and some as seen from its camera",
             lambda s: 100.0 * mean(s["middles"] > 1e-12), unit="%"),
    rules=NO_MATCH, measure=forces_aside, batches=1, seconds=0.1,
    without=Ablation("the cosine factor, which is 0 there", partial(forces_aside, cosine_factor=False)),
)  # fmt: skip


def unit_distance(batch: Batch, **play: Any) -> Samples:
    """Return the distance [m] between middles at which a robot's force from a player straight ahead is 1.

    By bisection. "middles": if the force counts the paper's distance, from camera to surface; "middle": if it counts
    the distance between middles; "distance": "middles" converted to the distance from camera to surface.
    """
    samples = {}
    for name, way in (("middles", "surface"), ("middle", "middle")):
        record = SacksSettings(distance_from=way, **play).record()[0]
        near, far = 0.05, 2.0
        while far - near > 1e-9:
            half = 0.5 * (near + far)
            pushes = player_force_on_robot(half, 0.0, 1.0, 0.0, record) > 1.0
            near, far = (half, far) if pushes else (near, half)
        samples[name] = np.array([near])
    return samples | {"distance": samples["middles"] - K["head_camera_ahead"] - K["body_front"]}


S49 = claim(
    "S49", "4.3.2", "With k2 = 800, x0 = 1 m a player's force at 45 cm equals the goal's.",
    "The distance from camera to surface at which the force of a player straight ahead is 1, by bisection.",
    exact("distance", lambda s: 1000 * float(s["distance"][0]), unit="mm", at_least=440.0, at_most=460.0),
    reported("between the middles of both then", lambda s: 1000 * float(s["middles"][0]), unit="mm"),
    reported("between the middles, if that were the distance", lambda s: 1000 * float(s["middle"][0]), unit="mm"),
    rules=NO_MATCH, measure=unit_distance, batches=1, seconds=0.1,
    without=Ablation("the constants and the exponent 1 of the last version; here the exponent is the theory's 3",
                     partial(unit_distance, exponent=3)),
    note="Exactly 444.4 mm: 1 / (1/800 + 1/1000).",
)  # fmt: skip


def compare_walls(batch: Batch, **play: Any) -> Samples:
    """Return the greatest ratio of a wall's force to a player's, and passes (M,) with walls on and off.

    "robots ..." (M,): whether robots pass cleanly in the first scenes.
    """
    record = SacksSettings(**play).record()[0]
    ratios = [
        abs(FIELD.wall_force(1.0 - x, 1.0, record)) / np.hypot(*FIELD.player_force(x, 0.0, 1.0, 0.0, record))
        for x in np.linspace(0.02, 0.99, 98)
    ]
    rng = batch.rng()
    y = rng.uniform(0.5, 0.85, SCENES) * rng.choice([-1.0, 1.0], SCENES)  # [m] 15 to 50 cm from a wall
    start = np.column_stack([np.full(SCENES, START), y])
    place = np.column_stack([rng.uniform(-0.6, 0.2, SCENES), y - np.sign(y) * rng.uniform(0.0, 0.25, SCENES)])
    crowd = players(place[:, None])
    samples: Samples = {"ratio": np.full(SCENES, max(ratios))}
    for name, walls in (("with", True), ("without", False)):
        runs = points.run_points(batch.rng(1), start, crowd, {"body": True}, **{"walls": walls, **play})
        at_wall = np.nanmax(np.abs(runs.path[..., 1]), axis=0) > 1.0 - TOUCH / 2.0
        samples[f"clean {name}"] = (points.is_clean(runs) & ~at_wall).astype(float)
        samples[f"at wall {name}"] = at_wall.astype(float)
        samples[f"clearance {name}"] = runs.clearance
        robots = points.run_robots(batch, start, crowd, walls=walls, **play)
        samples[f"robots {name}"] = points.pad_with_nan(robots.is_clean)
    return samples


def wall_figure(samples: Samples) -> Sequence[Figure]:
    """Plot the forces of walls and players against the distance."""
    record, x = SacksSettings().record()[0], np.linspace(0.06, 1.1, 53)
    forces = {
        "player": [float(np.hypot(*FIELD.player_force(d, 0.0, 1.0, 0.0, record))) for d in x],
        "wall": [abs(FIELD.wall_force(1.0 - d, 1.0, record)) if d < 1.0 else 0.0 for d in x],
    }
    curves = tuple(Curve(name, list(100 * x), values) for name, values in forces.items())
    return (Figure("Forces of players and walls", "distance [cm]", "force [goal's pull]", curves, rules=(1.0,)),)


S50 = claim(
    "S50", "4.3, 4.3.2", "Walls exert significantly less force than players; whether it is needed is unclear.",
    f"Greatest ratio of a wall's force to that of a player at the same distance; and {SCENES} points a batch "
    "that start 15 to 50 cm from a wall and pass a player that stands up to 25 cm farther inside, with the walls' "
    f"force and without: who comes through and keeps {50 * TOUCH:.0f} cm from the wall; the same with {ROBOTS} robots.",
    measured("wall over player at equal distances, greatest", lambda s: float(s["ratio"].max()), below=1.0),
    reported("clean with the walls' force", "clean with", unit="%"),
    reported("clean without", "clean without", unit="%"),
    reported("at the wall with its force", "at wall with", unit="%"),
    reported("at the wall without", "at wall without", unit="%"),
    reported("distance kept from the player with it", "clearance with", of=median, unit="cm"),
    reported("distance kept without", "clearance without", of=median, unit="cm"),
    reported("robots that pass and touch nobody, with it", "robots with", unit="%"),
    reported("robots that do so without", "robots without", unit="%"),
    measure=compare_walls, figures=wall_figure, batches=6, seconds=4.0,
    without=Ablation("the walls' constants 200 and 350 mm; here they are the players'",
                     partial(compare_walls, wall_gain=0.8, wall_range=1.0)),
    note="The effect of the walls' force is reported, not judged: the paper does not say which it is.",
)  # fmt: skip

# The computing time

OTHERS = 5  # that a dribbler of 3 v 3 can know of
STEPS = 8  # frames in a repetition: about as long as the runs of points
WARM = 64  # frames before: 4 s of play
QUIET = 0.1  # [1] share of repetitions that no other program disturbs, assumed


def time_decisions(batch: Batch) -> Samples:
    """Time a decision among five other players and a robot's whole frame [us], in 32 repetitions."""
    rng, repetitions = batch.rng(), 32
    start = points.starts(rng, 64)
    crowd = players(np.stack([rng.uniform(-0.8, 1.2, (64, OTHERS)), rng.uniform(-0.9, 0.9, (64, OTHERS))], axis=-1))
    points.run_points(rng, start, crowd)
    match = kick_off(batch, matches=4, team="sacks-2001")
    for _ in range(WARM):
        match.step()
    times, frames = [], []
    for _ in range(repetitions):
        begun = perf_counter()
        steps = points.run_points(rng, start, crowd).steps.sum()
        times.append(1e6 * (perf_counter() - begun) / steps)
        begun = perf_counter()
        for _ in range(STEPS):
            match.step()
        frames.append(1e6 * (perf_counter() - begun) / (STEPS * match.robots.size))
    match.close()
    return {"time": np.array(times), "frame": np.array(frames), "way": np.full(repetitions, steps / len(start))}


def undisturbed_time(times: np.ndarray) -> float:
    """Return the QUIET quantile of repeated times [us], an estimate without disturbance by other programs."""
    return quantile(times, QUIET)


def planning_time_share(samples: Samples, steps: float = 1.0) -> float:
    """Return the time of `steps` decisions in each replan interval over the time of the robot's frames in it [%]."""
    each = SacksSettings().replan * find_league(LEGGED).control_rate  # [frames]
    return 100.0 * steps * undisturbed_time(samples["time"]) / (each * undisturbed_time(samples["frame"]))


S42 = claim(
    "S42", "4.2", "The direction of travel costs few calculations: planning runs in real time.",
    f"32 repetitions a batch of 64 runs of the point simulator with {OTHERS} other players: time of the whole "
    "run over the number of decisions, on one core of the machine that runs this; against the time of a frame of 3 "
    "against 3 over its robots: a robot's sensing, beliefs, plan and body. One decision in half a second.",
    measured("planning's share of a robot's computing", planning_time_share, unit="%", below=5.0),
    reported("the same if each decision planned the whole way",
             lambda s: planning_time_share(s, float(s["way"].mean())), unit="%"),
    rules=PLAYED, measure=time_decisions, timed=True, batches=4, seconds=1.0,
    ingredients=("the machine, and compiled code: numbers differ from run to run",),
)  # fmt: skip
