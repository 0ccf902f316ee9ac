"""sacks-2001 decides for the mirrored scene as for the scene, and whatever it believes, its commands are finite."""

from typing import Any

import numpy as np
import pytest

from soccer_env import make_team
from soccer_env.baselines.sacks_2001.memory import BEHAVIOURS
from soccer_env.leagues import find_league
from soccer_env.teams import CompiledTeam, TeamRandom, View
from soccer_env.types import NOISE_STREAMS
from tests.scenes.sacks_beliefs import MEMORY_LATERAL, draw_beliefs, draw_tracks
from tests.scenes.symmetry import mirrored_actions, mirrored_beliefs, mirrored_tracks

LEAGUE = find_league("legged-2001")
MATCHES, PLAYERS, SLOTS = 60, 3, 5
MIRROR = 1e-12
SCENES, HELD = 12, 25  # scenes, and decisions for which each lasts


def play(team: CompiledTeam, beliefs: np.ndarray, tracks: np.ndarray, memory: np.ndarray) -> np.ndarray:
    """Return the commands (M, P, 7) of one decision."""
    rng = TeamRandom(np.zeros((MATCHES, PLAYERS, NOISE_STREAMS), np.uint64), np.arange(PLAYERS))
    return team.act(View(LEAGUE, beliefs, tracks), memory, rng)


def team_of(name: str, **settings: Any) -> CompiledTeam:
    """Return a team with its kernel."""
    team = make_team(name, **settings)
    assert isinstance(team, CompiledTeam)
    return team


@pytest.mark.parametrize(("name", "settings"), [
    ("sacks-2001", {}), ("sacks-2001-future", {}), ("sacks-2001", {"avoidance": False, "avoid_chasing": True}),
])  # fmt: skip
def test_the_team_plays_the_mirrored_scene_in_the_mirror(name: str, settings: dict[str, Any]) -> None:
    team, rng = team_of(name, **settings), np.random.default_rng(4)
    memory, image = (np.zeros((MATCHES, PLAYERS), team.memory_dtype) for _ in range(2))
    chosen = set()
    for _ in range(SCENES):
        beliefs, tracks = draw_beliefs(rng, (MATCHES, PLAYERS)), draw_tracks(rng, (MATCHES, PLAYERS), SLOTS)
        for _ in range(HELD):
            commands = play(team, beliefs, tracks, memory)
            other = play(team, mirrored_beliefs(beliefs), mirrored_tracks(tracks), image)
            worst = np.abs(mirrored_actions(other) - commands)
            m, p, c = np.unravel_index(worst.argmax(), worst.shape)
            assert worst.max() <= MIRROR, (BEHAVIOURS[memory["behaviour"][m, p]], c)
            chosen |= {BEHAVIOURS[code] for code in np.unique(memory["behaviour"])}
    assert (memory["behaviour"] == image["behaviour"]).all()
    for field in ("side", "way_side"):
        assert field in MEMORY_LATERAL and (memory[field] == -image[field]).all()
    assert {"search", "approach", "dribble", "support", "guard", "yield", "orbit"} - chosen <= {"dribble"}, chosen


@pytest.mark.parametrize("name", ["sacks-2001", "sacks-2001-future", "sacks-2001-tuned"])
def test_commands_are_finite_whatever_is_believed(name: str) -> None:
    rng = np.random.default_rng(5)
    for strength in (0.0, 1.0):
        team = team_of(name, strength=strength)
        memory = np.zeros((MATCHES, PLAYERS), team.memory_dtype)
        for step in range(120):
            reach = 10.0 ** rng.integers(-12, 9)
            beliefs = draw_beliefs(rng, (MATCHES, PLAYERS), reach)
            tracks = draw_tracks(rng, (MATCHES, PLAYERS), SLOTS, reach)
            if step % 3 == 0:  # nobody seen yet, everybody at the same place
                beliefs["ball"]["age"], tracks["distance"], tracks["x"], tracks["y"] = np.inf, 0.0, 0.0, 0.0
                beliefs["heard"]["distance"] = beliefs["heard"]["age"] = np.inf
            commands = play(team, beliefs, tracks, memory)
            assert np.isfinite(commands).all() and np.abs(commands).max() <= 1.0 + 1e-9
            assert all(np.isfinite(memory[field]).all() for field in MEMORY_LATERAL)
