"""The accuracy of another player's range: against the ball's, and by infrared.  [Sacks 2001, 4.1.2]

In the scenes a robot stands and stares at a player, or at a ball, whatever it believes.
"""

from typing import Any

import numpy as np

from soccer_env.train.papers.claim import Batch, claim
from soccer_env.train.papers.claims.players import watching
from soccer_env.train.papers.plots import plot_bins
from soccer_env.train.papers.staging import begin_scene, distance_to_ball, point_ahead, put_ball, record, still_actions
from soccer_env.train.papers.true_sight import stare_for
from soccer_env.train.papers.values import gain, ratio, rms
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
    match = watching.stage_player(batch, MATCHES, distance, bearing, rng.uniform(-np.pi, np.pi, MATCHES), **settings)

    def read() -> Samples:
        true, infrared = watching.distance_to_robot(match), match.percepts["infrared"][:, 0].astype(float)
        return {"range": watching.nearest_seen(match)[0] - true, "true": true, "infrared": infrared}

    return record(match, watching.stare(match, still_actions(match), SETTLE, SECONDS), read)


def look_at_balls(batch: Batch) -> Samples:
    """Return the measured range of a ball ("range") and its true range ("true"), at the places of `look_at_players`."""
    rng = batch.rng()
    match = watching.stage_watchers(batch, MATCHES, sensors={"patches": 0.0})
    distance, bearing = rng.uniform(NEAR, FAR, MATCHES), rng.uniform(-ASIDE, ASIDE, MATCHES)
    put_ball(match, *point_ahead(match, 0, distance, bearing))
    begin_scene(match)

    def read() -> Samples:
        true, ball = distance_to_ball(match)[0], match.beliefs["ball"][:, 0]
        error = np.where(ball["age"] < 0.5 * match.league.dt, ball["distance"] - true, np.nan)
        return {"range": error, "true": true}

    return record(match, stare_for(match, SETTLE, SECONDS), read)


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
    reported("relative error, player (root mean square)", "player", of=rms, unit="%"),
    reported("relative error, ball", "ball", of=rms, unit="%"),
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
    reported("error with the rule (root mean square)", "with", of=rms, unit="cm"),
    reported("error without the rule", "without", of=rms, unit="cm"),
    reported("frames with a reading under 40 cm", "near", unit="%"),
    reported("frames in which the rule takes it", "taken", unit="%"),
    measure=compare_ranger_rule,
    figures=plot_bins("Range error of a centred player, infrared below 40 cm", "distance between bodies' centres [cm]",
                      "rms error [cm]", {"by infrared": "with", "by size": "without"}, "true",
                      np.linspace(RANGER_NEAR, RANGER_FAR, 8), rms),
    seconds=1.0,
    ingredients=("sensors.infrared_noise, infrared_growth, infrared_pointing", "half a body behind the surface"),
)  # fmt: skip
