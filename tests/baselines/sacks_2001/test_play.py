"""sacks-2001 in whole matches: never stuck for long, weaker at less strength; left as right and finite."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match, make_team
from soccer_env.baselines.sacks_2001.memory import (
    APPROACH,
    BACK,
    BEHAVIOURS,
    DRIBBLE,
    ORBIT,
    PASS,
    ROTATE,
    SHOOT,
    SIDESTEP,
)
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.leagues import find_league
from soccer_env.teams import CompiledTeam, TeamRandom, View
from soccer_env.types import COMMAND, NOISE_STREAMS, Phase
from tests.scenes.sacks_beliefs import MEMORY_LATERAL, draw_beliefs, draw_tracks
from tests.scenes.staging import LEGGED
from tests.scenes.symmetry import mirrored_actions, mirrored_beliefs, mirrored_tracks

BUSY = (APPROACH, BACK, SIDESTEP, ROTATE, ORBIT, DRIBBLE, SHOOT, PASS)  # supporters and goalkeepers may stand
STANDS, LONG = 0.05, 30.0  # [m] within which a robot stands; [s] for which no busy one may
PAUSE = 3.0  # [s] of other things that end a standstill


def numbers(match: Match) -> np.ndarray:
    """Return the commands of all robots (M, R, 7)."""
    return np.stack([match.robots["command"][name] for name in COMMAND.names or ()], axis=-1)


@pytest.mark.parametrize(("changes", "message"), [
    ({"strength": 1.5}, "strength must be 0 to 1"), ({"exponent": 4}, "exponent must be 1 to 3"),
    ({"exponent": 1.5}, "exponent must be a whole number, 1 to 3"),
    ({"goal_force": "strong"}, "goal_force must be one of unit, proportional"),
    ({"player_range": 0.0}, "player_range must be 0.01 to 100"), ({"step_length": -0.01}, "step_length must be 0 to"),
    ({"recovery": 1}, "recovery must be True or False"),
])  # fmt: skip
def test_settings_that_cannot_be_are_refused(changes: dict[str, object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        SacksSettings().changed(changes)


@pytest.mark.parametrize("extreme", [{"replan": 10.0}, {"step_length": 1.0}, {"player_gain": 1e6}, {"settle": 0.01}])
def test_extreme_settings_give_commands_that_a_robot_can_obey(extreme: dict[str, float]) -> None:
    team = make_team("sacks-2001", **extreme)
    match = Match(LEGGED, home=2, away=2, matches=8, seed=2, controllers={"home": team, "away": "chaser"}, minutes=0.5)
    while not match.terminated.all():
        match.step()
        assert np.isfinite(numbers(match)).all()


@pytest.mark.slow
def test_no_busy_robot_stands_for_half_a_minute() -> None:
    """Neither a board nor an opponent, nor a ball that it cannot move, holds a player for 30 s of play.

    A search or another role in between counts as standing too, unless it lasts.
    """
    teams = {"home": "sacks-2001", "away": "chaser"}
    match = Match(LEGGED, controllers=teams, matches=12, threads=2, seed=11, minutes=4)
    squad = match.squads[0]
    since, idle, anchor, longest = np.zeros((12, 3)), np.zeros((12, 3)), np.zeros((2, 12, 3)), 0.0
    while not match.terminated.all():
        match.step()
        here = np.stack([match.robots["x"][:, squad.players], match.robots["y"][:, squad.players]])
        busy = np.isin(squad.memory["behaviour"], BUSY) & (match.matches["phase"] == Phase.PLAY)[:, None]
        idle = np.where(busy, 0.0, idle + match.league.dt)
        moved = (np.hypot(*(here - anchor)) > STANDS) | (idle > PAUSE)
        anchor, since = np.where(moved, here, anchor), np.where(moved, 0.0, since + match.league.dt)
        longest = max(longest, since.max())
    assert longest < LONG


LEAGUE = find_league("legged-2001")
MATCHES, PLAYERS, SLOTS = 60, 3, 5
MIRROR = 1e-12
SCENES, HELD = 12, 25  # scenes, and decisions for which each lasts


def decide(team: CompiledTeam, beliefs: np.ndarray, tracks: np.ndarray, memory: np.ndarray) -> np.ndarray:
    """Return the commands (M, P, 7) of one decision."""
    rng = TeamRandom(np.zeros((MATCHES, PLAYERS, NOISE_STREAMS), np.uint64), np.arange(PLAYERS))
    return team.act(View(LEAGUE, beliefs, tracks), memory, rng)


@pytest.mark.parametrize(("name", "settings"), [
    ("sacks-2001", {}), ("sacks-2001-future", {}), ("sacks-2001", {"avoidance": False, "avoid_chasing": True}),
    ("sacks-2001", {"decisive": True}), ("sacks-2001", {"patience": 3}), ("sacks-2001", {"clamp": False}),
    ("sacks-2001", {"exponent": 3, "goal_force": "proportional", "cosine_factor": False}),
])  # fmt: skip
def test_the_team_plays_the_mirrored_scene_in_the_mirror(name: str, settings: dict[str, Any]) -> None:
    team, rng = make_team(name, **settings), np.random.default_rng(4)
    memory, image = (np.zeros((MATCHES, PLAYERS), team.memory_dtype) for _ in range(2))
    chosen = set()
    for _ in range(SCENES):
        beliefs, tracks = draw_beliefs(rng, (MATCHES, PLAYERS)), draw_tracks(rng, (MATCHES, PLAYERS), SLOTS)
        for _ in range(HELD):
            commands = decide(team, beliefs, tracks, memory)
            other = decide(team, mirrored_beliefs(beliefs), mirrored_tracks(tracks), image)
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
        team = make_team(name, strength=strength)
        memory = np.zeros((MATCHES, PLAYERS), team.memory_dtype)
        for step in range(120):
            reach = 10.0 ** rng.integers(-12, 9)
            beliefs = draw_beliefs(rng, (MATCHES, PLAYERS), reach)
            tracks = draw_tracks(rng, (MATCHES, PLAYERS), SLOTS, reach)
            if step % 3 == 0:  # nobody seen yet, everybody at the same place
                beliefs["ball"]["age"], tracks["distance"], tracks["x"], tracks["y"] = np.inf, 0.0, 0.0, 0.0
                beliefs["heard"]["distance"] = beliefs["heard"]["age"] = np.inf
            commands = decide(team, beliefs, tracks, memory)
            assert np.isfinite(commands).all() and np.abs(commands).max() <= 1.0 + 1e-9
            assert all(np.isfinite(memory[field]).all() for field in MEMORY_LATERAL)
