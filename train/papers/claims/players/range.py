"""The accuracy of another player's range: against the ball's, by infrared, its head down.  [Sacks 2001, 4.1.2, 4.3.3]

In the scenes a robot stands and stares at a player, or at a ball, whatever it believes.
"""

from functools import partial
from typing import Any

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import Ablation, Batch, claim
from soccer_env.train.papers.claims.players import watching
from soccer_env.train.papers.claims.players.watching import distance_to_robot, nearest_seen, stage_player, stare
from soccer_env.train.papers.plots import plot_bins
from soccer_env.train.papers.true_sight import camera_of, stare_for, turn_head
from soccer_env.train.papers.values import gain, mean, ratio, rms
from soccer_env.train.papers.verdicts import Samples, measured, reported

MATCHES = 128
SETTLE = 1.0  # [s] in which the head finds what it looks at
SECONDS = 1.0  # [s] that are measured
NEAR, FAR = 0.45, 1.50  # [m] S40: from bodies that nearly touch to the range of the criterion of the ball
RANGER_NEAR, RANGER_FAR = 0.35, 0.70  # [m] S41: between bodies' centres; the beam begins 14 cm ahead of the looker's
RANGER_MOST = 0.40  # [m] "its maximum reliable range", Sacks 2001, 4.1.2
ASIDE = 0.4  # [rad] of the bearing


def look_at_players(batch: Batch, near: float, far: float, **settings: Any) -> Samples:
    """Let robots look at one other player; return believed and true values (M, T), "range" NaN in frames without it.

    "range": error of the distance of body centres; "true": this distance; "infrared": 0 if none; all [m].
    """
    rng = batch.rng()
    distance, bearing = rng.uniform(near, far, MATCHES), rng.uniform(-ASIDE, ASIDE, MATCHES)
    view = rng.uniform(-np.pi, np.pi, MATCHES)
    match = watching.stage_player(batch, MATCHES, distance, bearing, view, league=staging.OPEN_FLOOR, **settings)

    def read() -> Samples:
        true, infrared = watching.distance_to_robot(match), match.percepts["infrared"][:, 0].astype(float)
        return {"range": watching.nearest_seen(match)[0] - true, "true": true, "infrared": infrared}

    return staging.record(match, watching.stare(match, staging.still_actions(match), SETTLE, SECONDS), read)


def look_at_balls(batch: Batch) -> Samples:
    """Return the measured range of a ball ("range") and its true range ("true"), at the places of `look_at_players`."""
    rng = batch.rng()
    match = watching.stage_watchers(batch, MATCHES, league=staging.OPEN_FLOOR, sensors={"patches": 0.0})
    distance, bearing = rng.uniform(NEAR, FAR, MATCHES), rng.uniform(-ASIDE, ASIDE, MATCHES)
    staging.put_ball(match, *staging.point_ahead(match, 0, distance, bearing))
    staging.begin_scene(match)

    def read() -> Samples:
        true, ball = staging.distance_to_ball(match)[0], match.beliefs["ball"][:, 0]
        error = np.where(ball["age"] < 0.5 * match.league.dt, ball["distance"] - true, np.nan)
        return {"range": error, "true": true}

    return staging.record(match, stare_for(match, SETTLE, SECONDS), read)


def compare_player_and_ball(batch: Batch) -> Samples:
    """Return the relative range errors (M, T) of players and of balls at equal places."""
    player, ball = look_at_players(batch, NEAR, FAR), look_at_balls(batch)
    return {
        "player": player["range"] / player["true"], "ball": ball["range"] / ball["true"],
        "true": ball["true"][:, 0],
    }  # fmt: skip


def compare_ranger_rule(batch: Batch) -> Samples:
    """Return range errors (M, T) [m] with the ranger's rule and without, in frames where the rule takes its reading."""
    runs = {
        name: look_at_players(batch, RANGER_NEAR, RANGER_FAR, memory={"player_infrared": rule})
        for name, rule in (("with", True), ("without", False))
    }
    reading = runs["with"]["infrared"]
    taken = np.abs(runs["with"]["range"] - runs["without"]["range"]) > 1e-9
    samples = {name: np.where(taken, one["range"], np.nan) for name, one in runs.items()}
    near = (reading > 0.0) & (reading < RANGER_MOST)
    return samples | {"true": runs["with"]["true"], "near": near, "taken": taken}


S40 = claim(
    "S40", "4.1.2", "A player's distance is often harder to estimate accurately than the ball's.",
    f"{MATCHES} robots a batch stare at a standing player, seen from any side, and then at a ball in the same "
    f"place, {100 * NEAR:.0f} to {100 * FAR:.0f} cm away; error of the latest range over the true one, frames that "
    "show it; all rules of both systems on.",
    measured("relative range error of players over the ball's", ratio, "player", "ball", rms, above=1.0),
    measure=compare_player_and_ball,
    figures=plot_bins("Range error of a player and of the ball", "distance [cm]", "rms error [%]",
                      {"player": "player", "ball": "ball"}, "true", np.linspace(NEAR, FAR, 8), rms),
    batches=32, seconds=1.0,
    ingredients=("sizes of stickers and ball", "sensors.dither", "the same camera and ranger for both"),
)  # fmt: skip

S41 = claim(
    "S41", "4.1.2", "For a player in the picture's middle infrared under 40 cm gives the better distance.",
    f"{MATCHES} robots a batch stare at a player {100 * RANGER_NEAR:.0f} to {100 * RANGER_FAR:.0f} cm away, "
    "seen from any side; frames in which the rule takes the reading, being under 40 cm while the player's largest blob "
    "is in the middle, whatever the beam met; range error with the rule and without, same seeds.",
    measured("error without the rule less that with it", gain, "without", "with", rms, unit="cm", above=0.0),
    reported("frames with a reading under 40 cm", "near", unit="%"),
    reported("frames in which the rule takes it", "taken", unit="%"),
    measure=compare_ranger_rule,
    figures=plot_bins("Range error of a centred player, infrared below 40 cm", "distance between bodies' centres [cm]",
                      "rms error [cm]", {"by infrared": "with", "by size": "without"}, "true",
                      np.linspace(RANGER_NEAR, RANGER_FAR, 8), rms),
    seconds=1.0,
    ingredients=("sensors.infrared_noise, infrared_growth, infrared_pointing", "half a body behind the surface"),
)  # fmt: skip

# A robot nearby that looks down at the ball: its black head hides its jersey

HEAD_NEAR, HEAD_FAR = 0.35, 0.60  # [m] between the bodies' centres: from nearly touching to readings of 40 cm
FRONTAL = 0.6  # [rad] from head-on: an opponent that comes for the ball
DOWN = -1.0  # [rad] tilt of a head that looks at the ball before its paws
TILTS = {"up": 0.0, "down": DOWN}
MUCH = 25.0  # [%] of its distance that a player seems "much farther", assumed
OVERLOOKED = 1.5  # [1] of the true distance, beyond which a player is overlooked; as for "significantly" closer, MS49


def compare_head_tilts(batch: Batch, **sensors: float) -> Samples:
    """Return each run's mean range error (M,) [m] of a near player with its head up and down, NaN if it is not seen.

    "up", "down": by the size of the jersey; "... by infrared": by the ranger; also the share of frames that show the
    player, and the share in which robot 0 overlooks it, with and without the obstacle from the ranger.
    """
    samples: Samples = {}
    for name, tilt in TILTS.items():
        by_size, by_ranger, nearest, true = stare_at_head(batch, tilt, sensors, obstacle=True)
        samples[name] = np.array([mean(run) for run in by_size.T])
        samples[f"{name} by infrared"] = np.array([mean(run) for run in by_ranger.T])
        samples[f"seen {name}"] = np.isfinite(by_size).mean(axis=0)
        samples[f"overlooked, head {name}"] = (nearest > OVERLOOKED * true).mean(axis=0)
    _, _, nearest, true = stare_at_head(batch, DOWN, sensors, obstacle=False)
    samples["overlooked without the obstacle"] = (nearest > OVERLOOKED * true).mean(axis=0)
    return samples | {"distance": true[-1]}


def stare_at_head(batch: Batch, tilt: float, sensors: dict[str, float], obstacle: bool) -> tuple[np.ndarray, ...]:
    """Let robot 0 stare at a near player whose head is tilted by `tilt` [rad]; return arrays (T, M) [m].

    Errors of the player's range by size and by infrared, NaN without a reading; the distance of the nearest known
    player or obstacle; and the true distance.
    """
    rng = batch.rng()
    distance, view = rng.uniform(HEAD_NEAR, HEAD_FAR, MATCHES), rng.uniform(-FRONTAL, FRONTAL, MATCHES)
    memory = {"player_infrared": False, "obstacle": obstacle}
    match = stage_player(
        batch, MATCHES, distance, rng.uniform(-0.3, 0.3, MATCHES), view, sensors=sensors, memory=memory
    )
    actions = staging.still_actions(match)
    turn_head(match, actions, 1, 0.0, tilt)
    rows = []
    for _ in stare(match, actions, SETTLE, SECONDS):
        true = distance_to_robot(match)
        rows.append([nearest_seen(match)[0] - true, infrared_distance(match) - true, nearest_known(match), true])
    match.close()
    return tuple(np.moveaxis(np.array(rows), 1, 0))


def nearest_known(match: Match) -> np.ndarray:
    """Return the believed distance (M,) [m] of the nearest player or obstacle from robot 0; inf without one."""
    slots, obstacle = match.tracks[:, 0], match.beliefs["obstacle"]["distance"][:, 0].astype(float)
    player = np.where(slots["present"] == 1, slots["distance"], np.inf).min(axis=1)
    return np.asarray(np.minimum(player, np.where(obstacle > 0.0, obstacle, np.inf)))


def infrared_distance(match: Match) -> np.ndarray:
    """Return the distance (M,) [m] from robot 0 to a player whose chest the ranger hits, NaN without a reading."""
    camera, axis = camera_of(match)
    robot, reading = match.robots[:, 0], match.percepts["infrared"][:, 0].astype(float)
    level = np.hypot(axis[:, 0], axis[:, 1])
    reach = reading + match.league.body.front / level  # to the middle of the body, half a body behind its chest
    place = np.hypot(camera[:, 0] + reach * axis[:, 0] - robot["x"], camera[:, 1] + reach * axis[:, 1] - robot["y"])
    return np.where(reading > 0.0, place, np.nan)


def head_down_excess(samples: Samples) -> float:
    """Return the believed range with the player's head down minus the range with its head up [cm]."""
    return 100 * mean(samples["down"] - samples["up"])


def remaining_error_share(samples: Samples) -> float:
    """Return the absolute range error by infrared with the head down, divided by `head_down_excess` [%].

    NaN where a lowered head does not make the player seem farther.
    """
    difference = head_down_excess(samples)
    return 100 * abs(100 * mean(samples["down by infrared"])) / difference if difference > 0.0 else np.nan


def detected_share(samples: Samples) -> float:
    """Return the share [%] of the frames in which a player is overlooked, head down, that the obstacle takes away."""
    left, all_ = (mean(samples[f"overlooked{name}"]) for name in (", head down", " without the obstacle"))
    return 100.0 - 100.0 * left / all_ if all_ > 0.0 else np.nan


S61 = claim(
    "S61", "4.3.3", "A near robot with its head down seems much farther; the infrared reading repairs that.",
    f"{MATCHES} robots a batch stare at a player {100 * HEAD_NEAR:.0f} to {100 * HEAD_FAR:.0f} cm away that faces them "
    f"(within {np.degrees(FRONTAL):.0f} degrees), its head level or {np.degrees(-DOWN):.0f} degrees down; mean range "
    "error of each run by the size of its jersey, and with the infrared reading in its place, same seeds; and how "
    "often the player is overlooked, with the obstacle that a reading makes (MS49) and, its head down, without. The "
    "paper: it \"saw this robot as being much farther than it actually was\", and infrared is \"to allow the robots to "
    "detect this situation\".",
    measured("head down: farther than it is, by size", lambda s: 100 * mean(s["down"] / s["distance"]), unit="%",
             at_least=MUCH),
    measured("bias by size, head down less head up", head_down_excess, unit="cm", above=0.0),
    measured("head down: overlooked frames that the obstacle detects", detected_share, unit="%", above=50.0),
    reported("head down: bias by infrared, of that difference by size", remaining_error_share, unit="%"),
    *(reported(f"frames that show it, head {name}", f"seen {name}", unit="%") for name in TILTS),
    *(reported(f"frames in which it is {name}", name, unit="%")
      for name in ("overlooked, head up", "overlooked, head down", "overlooked without the obstacle")),
    measure=compare_head_tilts,
    figures=plot_bins("Range bias of a near player by its head", "distance [cm]", "bias [cm]",
                      {f"head {name}": name for name in (*TILTS, "down by infrared")}, "distance",
                      np.linspace(HEAD_NEAR, HEAD_FAR, 6), mean),
    seconds=1.5,
    without=Ablation("sensors.head_down, the angle from which a head hides stickers",
                     partial(compare_head_tilts, head_down=np.pi)),
    ingredients=("sensors.head_down", "sensors.head_size", "stickers of the chest"),
    note="In the criteria the reading replaces the player's range whenever there is one. The paper's rule, by which a "
    "reading significantly closer than every player in memory is an obstacle (MS49), is what the shares of frames are "
    "about in which the player is overlooked: neither it nor an obstacle is believed to be within 1.5 times its true "
    "distance. In the frames that do not show it the lowered head leaves nothing of the jersey to be seen.",
)  # fmt: skip
