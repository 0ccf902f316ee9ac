"""A stronger preference for the present side, with moving players.  [Sacks 2001, 4.3.3]"""

from collections.abc import Sequence

import numpy as np

from soccer_env.train.papers.claim import NO_MATCH, Batch, Claim
from soccer_env.train.papers.claims.field.point_world import players
from soccer_env.train.papers.claims.field.points import NOISE, SCENES, START, collided, run_points, starts
from soccer_env.train.papers.plots import each, plot, plots
from soccer_env.train.papers.values import mean
from soccer_env.train.papers.verdicts import Samples, measured, reported

PATIENCE = (0, 1, 2, 4, 8)  # decisions for which a change of side has to last
ANGLES = (135.0, 90.0, 45.0, 0.0)  # [degrees] beyond which the side is kept
SPEEDS = (0.03, 0.12)  # [m/s] of movers, up to a robot's top speed
MOVERS = {"comes": "one comes", "both": "one comes, one stands on the other side", "crosses": "one crosses"}
PAPERS = ("comes", "both")  # the classes in the paper


def collide_with_movers(batch: Batch) -> Samples:
    """Return whether points collide (M,) in each class of scenes with a mover, for each patience and angle."""
    rng, samples = batch.rng(), {}
    start = starts(rng)
    for scene, crowd in (
        ("comes", approaching_player(rng)),
        ("both", players_on_both_sides(rng)),
        ("crosses", crossing_player(rng)),
    ):
        for name, values in (("patience", PATIENCE), ("keep_side_angle", ANGLES)):
            for value in values:
                play = {name: np.radians(value) if name == "keep_side_angle" else value}
                runs = run_points(batch.rng(1), start, crowd, {"body": True, "range_noise": NOISE}, **play)
                samples[f"{scene} {name} {value:g}"] = collided(runs).astype(float)
    return samples


def approaching_player(rng: np.random.Generator) -> np.ndarray:
    """Return a player (M, 1) that comes from ahead, straight for the dribbler's start."""
    place = np.stack([rng.uniform(-0.2, 1.0, SCENES), rng.uniform(-0.3, 0.3, SCENES)], axis=-1)
    goal = np.stack([np.full(SCENES, START), rng.uniform(-0.15, 0.15, SCENES)], axis=-1)
    return players(place[:, None], velocities_towards(place, goal, rng)[:, None])


def players_on_both_sides(rng: np.random.Generator) -> np.ndarray:
    """Return two players (M, 2): one stands on one side of the path, the other comes from the other side."""
    side = rng.choice([-1.0, 1.0], SCENES)
    stands = np.stack([rng.uniform(-0.4, 0.2, SCENES), side * rng.uniform(0.05, 0.3, SCENES)], axis=-1)
    comes = np.stack([rng.uniform(-0.2, 0.8, SCENES), -side * rng.uniform(0.2, 0.7, SCENES)], axis=-1)
    velocity = velocities_towards(comes, np.stack([rng.uniform(-0.9, -0.3, SCENES), np.zeros(SCENES)], axis=-1), rng)
    return players(np.stack([stands, comes], axis=1), np.stack([0.0 * velocity, velocity], axis=1))


def crossing_player(rng: np.random.Generator) -> np.ndarray:
    """Return a player (M, 1) that crosses the straight path within 3 s of the dribbler's arrival at the crossing."""
    x, side = rng.uniform(-0.5, 0.2, SCENES), rng.choice([-1.0, 1.0], SCENES)
    when = (x - START) / 0.07 + rng.uniform(-3.0, 3.0, SCENES)
    velocity = velocities_towards(np.zeros((SCENES, 2)), np.stack([rng.uniform(-0.6, 0.0, SCENES), side], axis=-1), rng)
    place = np.stack([x, np.zeros(SCENES)], axis=-1) - when[:, None] * velocity
    return players(place[:, None], velocity[:, None])


def velocities_towards(place: np.ndarray, goal: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Return velocities (M, 2) from places towards goals, with random speeds within SPEEDS."""
    way = goal - place
    return np.asarray(way / np.linalg.norm(way, axis=-1, keepdims=True) * rng.uniform(*SPEEDS, (SCENES, 1)))


def collision_share(samples: Samples, name: str, value: float, scenes: Sequence[str] = PAPERS) -> float:
    """Return the share of runs with a collision [%] at a value of the setting `name`, over classes of scenes."""
    return 100 * mean([samples[f"{scene} {name} {value:g}"] for scene in scenes])


def collision_increase(samples: Samples, name: str, values: Sequence[float], scenes: Sequence[str] = PAPERS) -> float:
    """Return the share of runs with a collision [pp] at the last value minus the share at the first value."""
    return collision_share(samples, name, values[-1], scenes) - collision_share(samples, name, values[0], scenes)


S58 = Claim(
    id="S58", section="4.3.3",
    statement="Keeping the direction more often made the reaction to moving obstacles too slow.",
    method=f"{SCENES} points a batch and class of scenes, facing the goal, meet a player at {100 * SPEEDS[0]:.0f} to "
    f"{100 * SPEEDS[1]:.0f} cm/s: one that comes straight for them, or one that comes from one side while another "
    f"stands on the other (the classes of 4.3.4). Ranges have an error of {100 * NOISE:.0f} %. A change of side has to "
    f"last for {', '.join(map(str, PATIENCE))} decisions before it is made; beside it the side is kept beyond smaller "
    "angles than 135 degrees.",
    criteria=(
        measured(f"collisions at {PATIENCE[-1]} decisions less those at 0", collision_increase, "patience", PATIENCE,
                 unit="pp", above=0.0),
        *(reported(f"collisions at {n} decisions", collision_share, "patience", n, unit="%") for n in PATIENCE),
        *(reported(f"{title}: rise", collision_increase, "patience", PATIENCE, (key,), unit="pp")
          for key, title in MOVERS.items()),
        reported("side kept beyond 0 degrees less beyond 135", collision_increase, "keep_side_angle", ANGLES,
                 unit="pp"),
    ),
    rules=NO_MATCH, measure=collide_with_movers,
    figures=plots(*(plot("Collisions with movers", label, "runs with a collision [%]", values,
                         {title: each(values, lambda s, name, key, value: collision_share(s, name, value, (key,)), name,
                                      key) for key, title in MOVERS.items()})
                    for name, values, label in (("patience", PATIENCE,
                                                 "decisions for which a change of side has to last"),
                                                ("keep_side_angle", ANGLES,
                                                 "angle beyond which the side is kept [degrees]")))),
    batches=16, seconds=1.5,
    note="Keeping the side beyond smaller angles than 135 degrees changes next to nothing: who is pushed more than 70 "
    "degrees off the goal is nearly always pushed back by more than 135.",
)  # fmt: skip
