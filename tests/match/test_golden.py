"""Golden hashes: play may change its bits only knowingly, with an entry under "Changes results" in CHANGELOG.md.

They are the same on Python 3.10 to 3.13 with the oldest and the newest dependencies (`make matrix`), pymunk 7.3.0 to
7.3.1, numba 0.61.0 to 0.68.1, numpy 1.26.0 to 2.5.5. On another kind of machine the test says so and is left out.
After a wanted change: `python tests/match/test_golden.py` prints the new table.
"""

import platform
from importlib.metadata import version

import numpy as np
import pytest

from soccer_env import Match

MACHINE = "Linux x86_64"
GOLDEN = {
    ("legged-2001", "actions"): "5c7db00e8c08edbb7a99c50f5874fdd5",
    ("legged-2001", "teams"): "c274bbcfad9b8c254d3f8082e1292cce",
    ("legged-2001", "senses"): "322bda214d5499741641a267ede0f2ee",
    ("middle-size-2006", "actions"): "af9379cd067befb3cdb7e28a9190dd89",
    ("middle-size-2006", "teams"): "a5da311e061dbdda1480b57e8732979f",
    ("middle-size-2006", "senses"): "b4194fec2ef8bd3b3ea751ebee048d54",
}


def here() -> str:
    versions = ", ".join(f"{name} {version(name)}" for name in ("pymunk", "numba", "numpy"))
    return f"Python {platform.python_version()}, {versions}"


def play(league: str, who: str) -> str:
    """Return the hash after 600 control steps of random actions, of random players, or of players with all senses."""
    team = {"actions": None, "teams": "random", "senses": "chaser"}[who]
    teams = None if team is None else {"home": team, "away": team}
    match = Match(
        league, home=3, away=2, matches=3, seed=2001, placement="drive", controllers=teams, minutes=0.3,
        pose="particles",
    )  # fmt: skip
    rng = np.random.default_rng(2006)
    for _ in range(600):
        match.step(None if teams else rng.uniform(-1.0, 1.0, (3, 5, 4)))
    return match.state_hash()


@pytest.mark.skipif(f"{platform.system()} {platform.machine()}" != MACHINE, reason=f"made on {MACHINE}")
@pytest.mark.parametrize(("league", "who"), GOLDEN)
def test_play_has_not_changed_unnoticed(league: str, who: str) -> None:
    assert play(league, who) == GOLDEN[league, who], here()


if __name__ == "__main__":
    print(here())
    for row in GOLDEN:
        print(row, play(*row))
