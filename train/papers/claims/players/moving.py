"""The movement of a player between an early sighting and the encounter.  [Sacks 2001, 4.3.1]"""

from functools import partial

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import Batch, claim
from soccer_env.train.papers.claims.players.watching import look_at, nearest_seen, stage_watchers
from soccer_env.train.papers.plots import columns, plot
from soccer_env.train.papers.staging import begin_scene, distance_to_point, play, put, still_actions
from soccer_env.train.papers.values import bin_masks, least_rise, median, middles_of
from soccer_env.train.papers.verdicts import Samples, measured

SCENES = 64
SPEEDS = (0.0, 0.03, 0.06, 0.12)  # [m/s] of the mover, up to a robot's top speed
DRIBBLE = 0.07  # [m/s] 3.5 cm in a step of half a second, Sacks 2001, 4.3.2
NEAREST, FARTHEST = 0.5, 2.2  # [m] of the mover at the sighting
COURSE = 0.4  # [rad] of the mover's bearing, so that it is on the field
EYE_X = -1.2  # [m] x of the robot that sees it
THERE = 0.3  # [m] distance at which the dribbler has arrived: two bodies end to end
BINS = (0.5, 0.8, 1.0, 1.3, 1.7, 2.2)  # [m] edges of distances
CUT_OFF = 1.0  # [m] beyond which obstacles exert no force, 4.3.2
LOOK = 1.0  # [s] for the head to find the mover
KEPT = 3.0  # [s] for which a mover keeps its turn, assumed
TURN = 0.5  # [1] greatest of the top turn rate, assumed


def walk_off(batch: Batch) -> Samples:
    """Let movers walk off after a sighting; return distances and errors of their believed places (scenes, speeds) [m].

    "distance" and "first", the error, at the sighting; "error" when a dribbler would arrive at the believed place.
    """
    rng = batch.rng()
    ranges = ((NEAREST, FARTHEST), (-COURSE, COURSE), (-0.3, 0.3), (-np.pi, np.pi))
    scenes = (np.repeat(rng.uniform(low, high, SCENES), len(SPEEDS)) for low, high in ranges)  # each at each speed
    distance, bearing, y, heading = scenes
    speeds = np.tile(SPEEDS, SCENES)
    match = stage_watchers(batch, len(speeds))
    put(match, 0, EYE_X, y, 0.0)
    put(match, 1, EYE_X + distance * np.cos(bearing), y + distance * np.sin(bearing), heading, forward=speeds)
    begin_scene(match)
    actions = still_actions(match)
    actions[:, 1, 0] = speeds / match.league.drive.forward
    walk_mover(match, actions, LOOK, batch.rng(1))
    distance, _ = distance_to_point(match, 0, match.robots["x"][:, 1], match.robots["y"][:, 1])
    seen, aside = nearest_seen(match)
    angle = match.robots["heading"][:, 0] + aside
    known_x = match.robots["x"][:, 0] + seen * np.cos(angle)
    known_y = match.robots["y"][:, 0] + seen * np.sin(angle)
    x, y = walk_mover(match, actions, (FARTHEST + LOOK * max(SPEEDS) - THERE) / DRIBBLE + 1.0, batch.rng(2))
    arrival = np.round(np.maximum(distance - THERE, 0.0) / DRIBBLE * match.league.control_rate).astype(int)
    rows = np.arange(len(speeds))
    off = np.hypot(x - known_x, y - known_y)  # (T, M)
    match.close()
    samples = {"distance": distance, "error": off[arrival, rows], "first": off[0]}
    return {name: values.reshape(SCENES, len(SPEEDS)) for name, values in samples.items()}


def walk_mover(match: Match, actions: np.ndarray, seconds: float, rng: np.random.Generator) -> np.ndarray:
    """Let the mover walk and change its turn rate every KEPT s while robot 0 watches; return its path (2, T, M) [m]."""
    robot = match.robots[:, 1]
    way = []
    every = round(KEPT * match.league.control_rate)
    for step in play(match, seconds, actions):
        way.append((robot["x"].copy(), robot["y"].copy()))
        look_at(match, actions)
        if step % every == 0:
            turns = np.repeat(rng.uniform(-TURN, TURN, SCENES), len(SPEEDS))
            actions[:, 1, 2] = np.where(actions[:, 1, 0] > 0.0, turns, 0.0)
    return np.moveaxis(np.array(way), 1, 0)


def error_by_distance(samples: Samples, speed: float) -> list[float]:
    """Return the median error of the believed place [cm] in each bin of distance, over movers of a speed."""
    column = SPEEDS.index(speed)
    distance, error = samples["distance"][:, column], samples["error"][:, column]
    return [100 * median(error[there]) for there in bin_masks(distance, BINS)]


def error_at_speed(samples: Samples, speed: float, beyond: bool) -> float:
    """Return the median error [cm] of movers at one speed, sighted beyond the cut-off distance or within it."""
    distance, error = (samples[name][:, SPEEDS.index(speed)] for name in ("distance", "error"))
    return 100 * median(error[(distance > CUT_OFF) == beyond])


S70 = claim(
    "S70", "4.3.1", "A distant obstacle may be elsewhere when the dribbler gets close to it.",
    f"{SCENES} scenes a batch at {len(SPEEDS)} speeds: a robot sees another player {100 * NEAREST:.0f} to "
    f"{100 * FARTHEST:.0f} cm away, who walks on, turning at random; error of the place that it believes against the "
    f"player's true place when a dribbler at {100 * DRIBBLE:.0f} cm/s has come within {100 * THERE:.0f} cm of it. The "
    "paper: with moving obstacles its place \"may be very different from its position when the dribbler gets closer to "
    "it\".",
    measured("median error of movers seen from beyond 1 m less that from within, least of the speeds",
             lambda s: min(error_at_speed(s, v, True) - error_at_speed(s, v, False) for v in SPEEDS[1:]), unit="cm",
             above=0.0),
    measured("least rise of the median error with the speed", lambda s: least_rise(columns("error", median)(s)),
             unit="cm", above=0.0),
    measure=walk_off,
    figures=plot("Error of a player's place when one gets there", "distance when seen [cm]", "error [cm]",
                 middles_of(BINS, 100),
                 {f"{100 * speed:.0f} cm/s": partial(error_by_distance, speed=speed) for speed in SPEEDS}),
    batches=10, seconds=6.0,
    ingredients=("the movers' way: constant speed, turns that change every 3 s, boards",),
)  # fmt: skip
