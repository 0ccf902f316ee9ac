"""What consoles and notebooks show of an env: the settings that were changed, and a picture."""

import sys

import gymnasium
import pytest

from soccer_env import soccer_v0
from tests.scenes.staged_envs import make, make_many


def test_an_env_is_written_as_the_call_that_makes_it():
    env = soccer_v0.parallel_env(home=1, away=2, opponents="chaser", max_cycles=20)
    written = "ParallelSoccer(league='legged-2001', home=1, away=2, max_cycles=20, opponents='chaser')"
    assert repr(env) == written and str(env) == "soccer_v0"
    assert repr(soccer_v0.raw_env(home=1, away=1)) == "TurnSoccer(league='legged-2001', home=1, away=1)"
    solo = gymnasium.make("soccer_env/Legged2001-1v1-v0").unwrapped
    assert repr(solo) == "SoloSoccer(league='legged-2001', home=1, away=1, max_cycles=1000)"
    assert repr(make_many(3)).startswith("SoccerVectorEnv(league='legged-2001', home=2, away=2, opponents='random'")


@pytest.mark.parametrize("maker", [soccer_v0.parallel_env, soccer_v0.raw_env, make, make_many])
def test_a_notebook_shows_a_picture(maker):
    pytest.importorskip("pygame")
    env = maker(home=1, away=1)
    env.reset(seed=1)
    assert env._repr_png_().startswith(b"\x89PNG\r\n")


def test_without_pygame_a_notebook_shows_the_text(monkeypatch):
    env = soccer_v0.parallel_env(home=1, away=1)
    monkeypatch.setitem(sys.modules, "pygame", None)
    assert env._repr_png_() is None
