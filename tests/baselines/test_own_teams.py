"""A compiled team of a user: skills by their numbers, errors in one line, the chaser in a league of another family."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.chaser.team import NUMBERS
from soccer_env.compiled import compiled
from soccer_env.leagues import find_league
from soccer_env.skills import SIGHT, fill_sight, fitted, go, skill_settings
from soccer_env.teams import CompiledTeam, make_team
from soccer_env.teams.kernels import NO_MEMORY, STRENGTH, per_player
from tests.scenes.staging import play, refused


@compiled
def go_to_middle(belief, tracks, memory, noise, command, k, settings, scratch):  # type: ignore[no-untyped-def]
    scratch.pace, scratch.elapsed = settings.hurry, k.dt
    fill_sight(scratch, belief, tracks, k)
    go(command, scratch, k, settings, 0.0, 0.0, 0.0, 0.0)


@compiled
def add_words(belief, tracks, memory, noise, command, k, settings, scratch):  # type: ignore[no-untyped-def]
    command.forward = belief + "a word"


GOER, WORDS = per_player(go_to_middle, SIGHT), per_player(add_words)


def test_a_players_own_kernel_uses_skills_by_their_numbers() -> None:
    teams: dict[str, Any] = {"home": CompiledTeam("goer", GOER, NO_MEMORY, skill_settings(hurry=1.0), fit=fitted)}
    match = Match(home=1, away=1, seed=1, controllers=teams | {"away": "still"}, senses="ideal", rules="none")
    before = np.hypot(match.robots["x"], match.robots["y"])[0, 0]
    play(match, steps=48)
    assert np.hypot(match.robots["x"], match.robots["y"])[0, 0] < before - 0.1


@pytest.mark.parametrize(
    ("kernel", "message"),
    [(GOER, "team 'goer' cannot be compiled: it reads 'hurry'"), (WORDS, "team 'goer' cannot be compiled: ")],
)
def test_a_kernel_that_cannot_be_compiled_says_why_in_one_line(kernel: Any, message: str) -> None:
    team = CompiledTeam("goer", kernel, NO_MEMORY, np.array([(1.0,)], STRENGTH))
    match = Match(home=1, away=1, seed=1, controllers={"home": team, "away": "still"}, senses="ideal")
    with refused(match, rf"^.*{message}.*$(?!\n)"):
        match.step()


def test_numbers_follow_pitch_and_robot_in_a_league_of_another_family() -> None:
    known = find_league("middle-size-2006")
    pitch = replace(known.pitch, length=6.0, width=4.0, goal_width=1.0, penalty_depth=0.75, penalty_width=2.5)
    small = replace(known, name="small", family="small", pitch=pitch)
    chaser = make_team("chaser")
    kept, scaled = chaser.settings_in(known)[1], chaser.settings_in(small)[1]
    for name, (_, value, _) in NUMBERS.items():
        assert kept[name] == value
        halved = name in ("shot_range", "cover", "back", "aside", "change_side", "keeper_zone")
        assert scaled[name] == pytest.approx(value / 2.0 if halved else value)
    teams = {"home": "chaser", "away": "still"}
    match = Match(small, home=2, away=2, matches=8, seed=1, controllers=teams, senses="ideal")
    play(match, steps=2000)
    assert match.matches["score"][:, 0].sum() >= 2
