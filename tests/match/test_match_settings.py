"""A match setting is declared once: signatures, checks and errors of every API follow; bad input changes nothing."""

import inspect
import re
from dataclasses import fields
from typing import Any

import gymnasium
import numpy as np
import pytest

from soccer_env import Match, soccer_v0
from soccer_env.api.gymnasium_vector import SoccerVectorEnv
from soccer_env.gymnasium_envs import SoloSoccer
from soccer_env.match import arguments as match_settings
from soccer_env.match.settings import make_settings
from tests.scenes.staging import refused

APIS = [
    (Match, Match.__init__, match_settings.MatchArguments),
    (soccer_v0.parallel_env, soccer_v0.parallel_env, match_settings.EnvArguments),
    (soccer_v0.env, soccer_v0.env, match_settings.EnvArguments),
    (soccer_v0.raw_env, soccer_v0.raw_env, match_settings.EnvArguments),
    (SoloSoccer, SoloSoccer.__init__, match_settings.SoloArguments),
    (SoccerVectorEnv, SoccerVectorEnv.__init__, match_settings.VectorArguments),
]


@pytest.mark.parametrize(("api", "explained", "kind"), APIS)
def test_signature_and_help_show_every_setting_with_its_default(api: Any, explained: Any, kind: Any) -> None:
    shown = inspect.signature(api).parameters
    assert {name: parameter.default for name, parameter in shown.items()} == {x.name: x.default for x in fields(kind)}
    assert {x.name for x in fields(match_settings.MatchSettings)} <= set(shown)
    text = " ".join(explained.__doc__.split())
    for item in fields(kind):
        assert f"{item.name} = {item.default!r}: {item.metadata['text']}." in text


@pytest.mark.parametrize(("api", "_", "kind"), APIS)
def test_an_unknown_setting_is_refused_alike_everywhere(api: Any, _: Any, kind: Any) -> None:
    known = ", ".join(item.name for item in fields(kind))
    with pytest.raises(TypeError) as error:
        api(homee=2)
    assert str(error.value) == f"unknown setting 'homee', did you mean 'home'? known: {known}"


@pytest.mark.parametrize("make", [gymnasium.make, gymnasium.make_vec])
def test_gymnasium_passes_the_error_on(make: Any) -> None:
    with pytest.raises(TypeError, match="unknown setting 'homee', did you mean 'home'. known: "):
        make("soccer_env/Legged2001-1v1-v0", homee=2)


def test_what_is_free_changes_no_fingerprint_and_the_rest_does() -> None:
    other: dict[str, Any] = {
        "league": "middle-size-2006", "home": 2, "away": 2, "max_players": 7, "observe": "belief", "senses": "ideal",
        "pose": "particles", "sensors": {"dither": 0.1}, "memory": {"grouping": 2.0}, "actions": "full",
        "episode": "goal", "starts": "training", "rewards": "sparse", "placement": "drive", "keeper": 1,
        "variation": {"ball.mass": (0.5, 1.0)}, "minutes": 3.0, "action_repeat": 2, "max_cycles": 9,
        "state_side": "away",
    }  # fmt: skip
    usual = make_settings(match_settings.MatchSettings()).fingerprint()
    for name in {item.name for item in fields(match_settings.MatchSettings)} - {"rules", "scene"}:
        changed = make_settings(match_settings.MatchSettings(**{name: other[name]})).fingerprint()
        free = name in match_settings.FREE and name != "max_cycles"  # the limit in control steps counts
        assert (changed == usual) == free, name
    assert {"home", "away", "keeper", "minutes"} <= set(match_settings.REPLAYED)


BAD_SETTINGS = [
    ({"league": "small-size"}, "unknown league 'small-size'; known: legged-2001"),
    ({"home": 14}, "home must be 1 to 11, got 14"),
    ({"away": 2.5}, "away must be a whole number, 1 to 11, got 2.5"),
    ({"max_players": 2}, "max_players must be 3 to 11, got 2"),
    ({"matches": 0}, "matches must be 1"),
    ({"threads": 0}, "threads must be 1"),
    ({"observe": "smell"}, "observe must be one of truth, percepts, belief, an object with `names`"),
    ({"senses": "eyes"}, "senses must be one of ideal, sensors, got 'eyes'"),
    ({"pose": "compass"}, "pose must be one of percept, particles, got 'compass'"),
    ({"sensors": {"radar": 1.0}}, "unknown name 'radar' in LeggedSensors; known: resolution, "),
    ({"sensors": {"resolution": "640x480"}}, "resolution must be one of 44x36, 88x72, 176x144, got '640x480'"),
    ({"sensors": {"dither": -0.1}}, "LeggedSensors.dither must be 0 to 1000000, got -0.1"),
    ({"sensors": 3}, "sensors must be a mapping of names to values or a LeggedSensors, got 3"),
    ({"memory": {"grouping": -3.0}}, "LeggedMemory.grouping must be 0 to 1000000, got -3.0"),
    ({"memory": {"horizon": 1}}, "LeggedMemory.horizon must be True or False, got 1"),
    ({"memory": {"ball_size": "depth"}}, "ball_size must be one of closer, height, width, got 'depth'"),
    ({"senses": {"left": "ideal"}}, "keys home and away"),
    ({"actions": "torque"}, "actions must be one of box, full, discrete, multi, skills, got 'torque'"),
    ({"scene": "nowhere"}, "unknown scene 'nowhere'; known: kick-off"),
    ({"episode": "season"}, "episode must be one of match, goal, drill"),
    ({"episode": "drill"}, "needs a scene with a success test"),
    ({"rules": "no"}, "unknown rules 'no'"),
    ({"rewards": "lots"}, "unknown rewards 'lots'; known: default, sparse"),
    ({"placement": "fly"}, "placement must be one of instant, drive"),
    ({"minutes": 0.0}, "minutes must be a number above 0 and at most 1e+12, got 0.0"),
    ({"action_repeat": 0}, "action_repeat must be 1 to 1000, got 0"),
    ({"max_cycles": -1}, "max_cycles must be 1"),
    ({"autoreset": "maybe"}, "autoreset must be one of next_step, same_step, off"),
    ({"keeper": -1}, "keeper must be 0 to 2, got -1"),
    ({"seed": -1}, "seed must be a whole number of 0 or more, got -1"),
    ({"seeds": [1, 2]}, "seeds must be 1 whole numbers"),
    ({"seed": 1, "seeds": [2]}, "give seed or seeds, not both"),
    ({"opponents": "brazil"}, "unknown team 'brazil'; known: "),
    ({"opponents": "mine.pt"}, "save_policy(module, 'mine.safetensors', league=..., observe=...)"),
    ({"opponents": "random@2"}, "strength of team 'random@2' must be a number from 0 to 1"),
    ({"opponents": abs}, "a team needs name, memory_dtype and act, got <built-in function abs>: "),
    ({"opponents": abs}, "write team_of_function(abs)"),
    ({"rewards": abs}, "a function is one term of the rewards: give Rewards(extra={'abs': abs})"),
    ({"controllers": {"home_9": "still"}}, "unknown agent 'home_9' in controllers; known: home_0"),
    ({"controllers": "still"}, "controllers must map agents or sides to teams"),
]


@pytest.mark.parametrize(
    ("settings", "message"), BAD_SETTINGS, ids=[str(s).partition(" at 0x")[0] for s, _ in BAD_SETTINGS]
)
def test_bad_settings_are_refused_with_what_is_allowed(settings: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        Match(**settings)


BAD_ACTIONS = [
    ("box", None, "actions are missing for home_0"),
    ("box", np.zeros((1, 2, 3)), "must be numbers of shape (1, 2, 4)"),
    ("box", np.zeros((1, 2, 4), complex), "must be numbers"),
    ("box", np.zeros((1, 2, 4), bool), "must be numbers"),
    ("box", np.where(np.arange(8).reshape(1, 2, 4) == 6, np.nan, 0.0), "action of away_0 in match 0 is not finite"),
    ("box", np.where(np.arange(8).reshape(1, 2, 4) == 1, -np.inf, 0.0), "action of home_0 in match 0 is not finite"),
    ("discrete", np.array([[0, -1]]), "action of away_0"),
    ("discrete", np.array([[0.0, 1.5]]), "must be one integer"),
    ("multi", np.array([[[0, 0, 0, 0], [0, 0, 0, 5]]]), "action of away_0 in match 0 must be 0 to 4, got [0, 0, 0, 5]"),
    ("multi", np.zeros((1, 2, 4)), "action of home_0 in match 0 must be 4 integers"),
    ("multi", np.zeros((1, 2), int), "actions must be integers of shape (1, 2, 4), got shape (1, 2)"),
]


@pytest.mark.parametrize(("kind", "actions", "message"), BAD_ACTIONS)
def test_bad_actions_are_refused_and_change_nothing(kind: str, actions: Any, message: str) -> None:
    match = Match(home=1, away=1, seed=1, actions=kind)
    match.step(np.ones((1, 2, *match.settings.actions.shape), float if kind == "box" else int))
    with refused(match, re.escape(message)):
        match.step(actions)


def test_finite_actions_outside_the_box_are_clipped() -> None:
    wild, tame = Match(seed=1), Match(seed=1)
    wild.step(np.full((1, 6, 4), 1e300))
    tame.step(np.ones((1, 6, 4)))
    assert wild.state_hash() == tame.state_hash()


def test_rows_that_teams_play_may_hold_anything() -> None:
    match = Match(home=1, away=1, opponents="random", seed=1)
    actions = np.zeros((1, 2, 4))
    actions[:, 1] = np.nan
    match.step(actions)
    assert np.isfinite(match.robots["x"]).all()
