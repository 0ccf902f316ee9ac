"""A ball that other robots hide in part: its estimated range, and the correction by infrared.  [Sacks 2001, 3.1.1]

Scenes: a robot looks at a ball 30 to 60 cm ahead of its camera; one or two other robots stand at random places that
hide part of the ball in plan view. The hidden share follows from two pictures without noise, with and without the
other robots.
"""

from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import Ablation, Batch, claim
from soccer_env.train.papers.claims.ball.range import OLD
from soccer_env.train.papers.plots import plot_bins
from soccer_env.train.papers.staging import LEGGED
from soccer_env.train.papers.true_sight import ball_angle, ball_in_sight, look_first, range_from_camera, stare_at_ball
from soccer_env.train.papers.values import least_rise, median, ratio
from soccer_env.train.papers.verdicts import Samples, counted, measured, reported

MATCHES = 192
NEAR, FAR = 0.45, 0.75  # [m] of the ball from the body's centre: 30 to 60 cm from the camera
LOOK, SETTLE = 0.75, 1.25  # [s] turned to the ball, until measuring begins
SECONDS = 0.5  # [s] measured
APART, CLEAR = 0.30, 0.205  # [m] between two robots' middles, and from a robot's middle to the ball's: nothing overlaps
SIGHT = 0.25  # [m] greatest distance of others from the line of sight
START = -0.3  # [m] x of the robot that looks
BODY, CAMERA_AHEAD = find_league(LEGGED).body, find_league(LEGGED).head.camera_ahead
SIDE, ENDS = BODY.hind_y + BODY.tip_radius, (BODY.hind_x - BODY.tip_radius, BODY.front)  # [m] of a trunk over its legs
TRUNK = np.array([(x, y) for x in ENDS for y in (-SIDE, SIDE)])  # [m] its corners
FINE = {"resolution": "176x144", "dither": 0.0, "scale_error": 0.0, "ball_miss": 0.0}
PLAIN = {"patches": 0.0, "red_as_orange": 0.0}  # nothing but the ball is orange
CUT = 0.9  # [1] a dimension counts as cut if less than this share is visible; a pixel is up to 5 % of it
HIDDEN = (0.0, 0.05, 0.25, 0.50, 0.75)  # [1] edges of the hidden share of the picture

Scene = dict[str, np.ndarray]


def draw_scene(batch: Batch) -> Scene:
    """Draw random places of a ball and of one or two other robots, in the frame of the observing robot; NaN: absent."""
    rng = batch.rng()
    scene = {"distance": rng.uniform(NEAR, FAR, MATCHES), "bearing": rng.uniform(-0.3, 0.3, MATCHES)}
    scene["others"] = np.full((MATCHES, 2, 3), np.nan)  # x, y, heading
    for m in range(MATCHES):
        ball = scene["distance"][m] * np.array([np.cos(scene["bearing"][m]), np.sin(scene["bearing"][m])])
        taken = [np.zeros(2)]
        for other in range(1 + int(rng.random() < 0.5)):
            place = free_place(rng, ball, taken)
            if place is not None:
                taken.append(place[:2])
                scene["others"][m, other] = place
    return scene


def free_place(rng: np.random.Generator, ball: np.ndarray, taken: list[np.ndarray]) -> np.ndarray | None:
    """Draw a free pose (x, y, heading) of a robot that hides part of the ball; None if 200 draws find none."""
    along = ball / np.linalg.norm(ball)
    for _ in range(200):
        share, aside = rng.uniform(0.3, 1.0), rng.uniform(-SIGHT, SIGHT)
        place: np.ndarray = share * ball + aside * np.array([-along[1], along[0]])
        heading = rng.uniform(-np.pi, np.pi)
        free = np.linalg.norm(place - ball) > CLEAR and all(np.linalg.norm(place - other) > APART for other in taken)
        if free and hides_part_of_ball(ball, place, heading):
            return np.array([*place, heading])
    return None


def hides_part_of_ball(ball: np.ndarray, place: np.ndarray, heading: float) -> bool:
    """Tell whether a robot's trunk hides part of the ball from the camera, in plan view."""
    turn = np.array([[np.cos(heading), np.sin(heading)], [-np.sin(heading), np.cos(heading)]])
    camera = CAMERA_AHEAD * ball / np.linalg.norm(ball)
    trunk, away = place + TRUNK @ turn - camera, ball - camera
    angles = staging.wrap_angle(np.arctan2(trunk[:, 1], trunk[:, 0]) - np.arctan2(away[1], away[0]))
    half = np.arcsin(find_league(LEGGED).ball.radius / np.linalg.norm(away))
    return bool(angles.min() < half and angles.max() > -half and np.ptp(angles) < np.pi)


def set_up(batch: Batch, scene: Scene, others: bool, **settings: Any) -> Match:
    """Set up matches with the observing robot and the ball of a scene, with or without the scene's other robots."""
    match = staging.stage(batch, matches=MATCHES, away=2, actions="full", **settings)
    staging.put(match, 0, START, 0.0, 0.0)
    staging.put_ball(match, *staging.point_ahead(match, 0, scene["distance"], scene["bearing"]))
    for other in range(2):
        there = np.isfinite(scene["others"][:, other, 0]) & others
        row = match.robots[:, 1 + other]
        for axis, (name, shift) in enumerate((("x", START), ("y", 0.0), ("heading", 0.0))):
            row[name] = np.where(there, scene["others"][:, other, axis] + shift, row[name])
        row["active"] = there
    staging.begin_scene(match)
    return match


def visible_shares(batch: Batch, scene: Scene) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the visible shares (M,) [1] of the ball's width, height and area in the picture; NaN: unknown."""
    sizes = []
    for others in (False, True):
        match = set_up(batch, scene, others, sensors=PLAIN | FINE)
        look_first(match, SETTLE)
        blob = match.percepts["ball"][:, 0, 0]
        width, height = blob["left"] - blob["right"], blob["high"] - blob["low"]
        sizes.append(np.stack([width, height, blob["area"]]).astype(float))
        match.close()
    free, hidden = sizes
    left = np.where((free[2] > 0) & (hidden[2] > 0), hidden / np.maximum(free, 1.0), np.nan)
    return left[0], left[1], left[2]


def watch_scene(batch: Batch, scene: Scene, others: bool, staring: bool, memory: dict[str, Any]) -> Samples:
    """Return relative errors of the range (M, T) in frames that show the ball, and true ranges from the camera [m].

    Heads are first turned to the true ball; then, unless `staring`, they track the believed ball. "centred": the
    camera's axis meets the ball.
    """
    match = set_up(batch, scene, others, sensors=PLAIN, memory=memory)
    actions, dt = staging.still_actions(match), match.league.dt

    def steer(step: int) -> None:
        actions[:, 0, 4] = -1.0
        if staring or (step + 1) * dt <= LOOK:
            stare_at_ball(match, actions)

    def read() -> Samples:
        ball = match.beliefs["ball"][:, 0]
        (distance, angle), ground, seen = ball_in_sight(match), range_from_camera(match), ball["age"] < 0.5 * dt
        return {
            "error": np.where(seen, (ball["distance"] - staging.distance_to_ball(match)[0]) / ground, np.nan),
            "believed": np.where(seen, ball["distance"], np.nan), "range": ground,
            "centred": seen & (angle < ball_angle(match, distance)),
        }  # fmt: skip

    return staging.record(match, staging.watch(match, SECONDS, actions, SETTLE, steer), read)


def compare_dimensions(batch: Batch, **memory: Any) -> Samples:
    """Return range errors of partly hidden balls by width, by height and by the closer of both; and visible shares."""
    scene = draw_scene(batch)
    samples = dict(zip(("width left", "height left", "area left"), visible_shares(batch, scene), strict=True))
    for size in ("width", "height", "closer"):
        samples[size] = watch_scene(batch, scene, True, True, OLD | {"ball_size": size} | memory)["error"]
    return samples


def bias_by_share(samples: Samples) -> list[float]:
    """Return the median error [%] of ranges by width or height alone (pooled), in each bin of the hidden share."""
    gone = 1.0 - samples["area left"]
    both = np.concatenate([samples["width"], samples["height"]], axis=1)
    edges = zip(HIDDEN, (*HIDDEN[1:], 1.01), strict=True)
    return [100 * median(both[(gone >= low if low else gone < high) & (gone < high)]) for low, high in edges]


def bias_of_hidden_balls(samples: Samples, dimensions: int, size: str = "closer") -> float:
    """Return the median range error [%] of balls that are partly hidden in `dimensions` of width and height."""
    width, height = samples["width left"], samples["height left"]
    hidden = np.where(np.isfinite(width), (width < CUT).astype(float) + (height < CUT), np.nan)
    return 100 * median(samples[size][hidden == dimensions])


hidden_figure = plot_bins(
    "Range of a ball that is partly hidden", "hidden share of the ball's picture [%]", "median range error [%]",
    {"by width": "width", "by height": "height", "the closer of both": "closer"}, lambda s: 1.0 - s["area left"],
    np.linspace(0.0, 1.0, 9), median,
)  # fmt: skip
SCENES = f"{MATCHES} scenes a batch with one or two robots at random before a ball 30 to 60 cm from the camera"

S07 = claim(
    "S07", "3.1.1", "A partially obstructed ball seems farther away.",
    f"{SCENES}; median error of range by width and by height alone, in bins of the hidden share of the picture "
    f"({', '.join(f'{100 * edge:.0f}' for edge in HIDDEN)} % and more).",
    measured("least rise of the median error from bin to bin", lambda samples: least_rise(bias_by_share(samples)),
             unit="%", above=0.0),
    measured("median error once 5 % are hidden", lambda samples: bias_by_share(samples)[1], unit="%", above=0.0),
    measure=compare_dimensions, figures=hidden_figure,
    without=Ablation("ranges read from the blob's size, and a smaller blob reads farther: with the ranger's reading "
                     "instead", lambda batch: compare_dimensions(batch, ball_range="infrared")),
    ingredients=("bodies that hide what lies behind them, perception/legged/picture.py", "where the others stand"),
)  # fmt: skip

S08 = claim(
    "S08", "3.1.1", "The closer of height and width estimates guards against obstruction, unless in both dimensions.",
    f"{SCENES}; a dimension counts as cut if less than {100 * CUT:.0f} % of it is left.",
    measured("cut in one dimension: median error", lambda s: abs(bias_of_hidden_balls(s, 1)), unit="%", at_most=10.0),
    measured("cut in both: median error", bias_of_hidden_balls, 2, unit="%", at_least=30.0),
    reported("cut in one dimension, by width alone: median error", bias_of_hidden_balls, 1, "width", unit="%"),
    measure=compare_dimensions, figures=hidden_figure,
    ingredients=("bodies that hide what lies behind them, perception/legged/picture.py", "where the others stand"),
)  # fmt: skip

# Hidden in both dimensions

DEEP = 2.0 / 3.0  # [1] visible share of both dimensions below which a right reading is under 2/3 of the range by size
HIDDEN_FAR = 0.60  # [m] range along the ground from the camera


def compare_infrared_rule(batch: Batch) -> Samples:
    """Return range errors (M, T) [m] of balls cut in width and height, infrared rule on and off, and false triggers.

    "on", "off": visible shares below DEEP, camera's axis on the ball; "triggers": changed readings of free balls.
    """
    scene = draw_scene(batch)
    width, height, _ = visible_shares(batch, scene)
    samples = {}
    for name, rule in (("on", True), ("off", False)):
        seen = watch_scene(batch, scene, True, False, OLD | {"infrared_override": rule})
        deep = ((width < DEEP) & (height < DEEP))[:, None] & (seen["range"] <= HIDDEN_FAR)
        samples[name] = np.where(deep & seen["centred"], np.abs(seen["error"] * seen["range"]), np.nan)
        samples[f"free {name}"] = watch_scene(batch, scene, False, True, OLD | {"infrared_override": rule})["believed"]
    judged = np.isfinite(samples["free off"])
    samples["triggers"] = (judged & (np.abs(samples["free on"] - samples["free off"]) > 1e-6)).sum(axis=1)
    samples["judged"] = judged.sum(axis=1)
    return samples


S09 = claim(
    "S09", "3.1.1", "Infrared, where below 2/3 of the range by size, repairs obstruction in both dimensions.",
    f"{SCENES}, robots tracking what they see; balls of which less than 2/3 is left in both dimensions (of "
    "others the size says less than 3/2 of the range, and the rule has no business), up to 60 cm away, in frames in "
    "which the camera's axis meets the ball; and the same balls unobstructed, at the centre, for false triggers.",
    measured("mean error with the rule over that without", ratio, "on", "off", at_most=0.5),
    counted("unobstructed frames in which the rule changes the range", "triggers", "judged", at_most=2.0),
    measure=compare_infrared_rule, least=4,
    ingredients=("sensors.infrared_pointing, infrared_growth", "memory.centred", "belief/legged/head.py"),
)  # fmt: skip
