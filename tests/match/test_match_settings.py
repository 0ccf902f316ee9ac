"""A match setting is declared once: signatures, help, checks and errors of every API follow."""

import inspect
from dataclasses import fields
from typing import Any

import gymnasium
import pytest

from soccer_env import Match, soccer_v0
from soccer_env.api.gymnasium_vector import SoccerVectorEnv
from soccer_env.gymnasium_envs import SoloSoccer
from soccer_env.match.arguments import (
    FREE,
    REPLAYED,
    EnvArguments,
    MatchArguments,
    MatchSettings,
    SoloArguments,
    VectorArguments,
)
from soccer_env.match.settings import make_settings

APIS = [
    (Match, Match.__init__, MatchArguments),
    (soccer_v0.parallel_env, soccer_v0.parallel_env, EnvArguments),
    (soccer_v0.env, soccer_v0.env, EnvArguments),
    (soccer_v0.raw_env, soccer_v0.raw_env, EnvArguments),
    (SoloSoccer, SoloSoccer.__init__, SoloArguments),
    (SoccerVectorEnv, SoccerVectorEnv.__init__, VectorArguments),
]


@pytest.mark.parametrize(("api", "explained", "kind"), APIS)
def test_signature_and_help_show_every_setting_with_its_default(api: Any, explained: Any, kind: Any) -> None:
    shown = inspect.signature(api).parameters
    assert {name: parameter.default for name, parameter in shown.items()} == {x.name: x.default for x in fields(kind)}
    assert {x.name for x in fields(MatchSettings)} <= set(shown)
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
        "episode": "goal", "rewards": "sparse", "placement": "drive", "keeper": 1,
        "minutes": 3.0, "action_repeat": 2, "max_cycles": 9, "state_side": "away",
    }  # fmt: skip
    usual = make_settings(MatchSettings()).fingerprint()
    for name in {item.name for item in fields(MatchSettings)} - {"rules", "scene"}:
        changed = make_settings(MatchSettings(**{name: other[name]})).fingerprint()
        free = name in FREE and name != "max_cycles"  # the limit in control steps counts
        assert (changed == usual) == free, name
    assert {"home", "away", "keeper", "minutes"} <= set(REPLAYED)
