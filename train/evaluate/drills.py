"""Count how often a team succeeds in a drill."""

import numpy as np

from soccer_env.match import Match
from soccer_env.scenes import Scene, find_scene
from soccer_env.train.casting import controllers_of, sizes_of

SEED = 1


def run_drill(league: str, scene: str | Scene, team: str, runs: int, seed: int = SEED, threads: int = 2) -> int:
    """Play a drill `runs` times with sensors, under the drill's own rules; return the number of successes."""
    scene = find_scene(scene)
    home, away = sizes_of(scene)
    match = Match(
        league, home=home, away=away, matches=runs, seed=seed, threads=threads, scene=scene, episode="drill",
        controllers=controllers_of(scene, team), senses="sensors",
    )  # fmt: skip
    succeeded = np.zeros(runs, bool)
    while not (match.terminated | match.truncated).all():
        match.step()
        succeeded |= match.events["drill"] == 1
    match.close()
    return int(succeeded.sum())
