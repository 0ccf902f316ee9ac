"""What consoles and notebooks show of matches, teams, leagues, rows and envs: short words, and a picture or nothing."""

import sys
from dataclasses import replace
from typing import Any

import gymnasium
import pytest

from soccer_env import Match, soccer_v0
from soccer_env.api.report import MatchScreen
from soccer_env.leagues import find_league
from tests.scenes.staged_envs import make_single_env, make_vector_env


def test_a_notebook_shows_a_match_as_it_stands() -> None:
    pytest.importorskip("pygame")
    match = Match("legged-2001", home=1, away=1, matches=2, seed=1)
    pictures = [match._repr_png_() for _ in range(2) if match.robots["x"].__iadd__(0.1) is not None]
    assert all(png is not None and png.startswith(b"\x89PNG\r\n") for png in pictures) and pictures[0] != pictures[1]


@pytest.mark.parametrize("error", [ImportError("no pygame"), RuntimeError("no video"), OSError("no disk")])
def test_what_cannot_be_drawn_is_shown_in_words(monkeypatch: pytest.MonkeyPatch, error: Exception) -> None:
    def fail(*_: Any) -> None:
        raise error

    match = Match(home=1, away=1, seed=1)
    monkeypatch.setattr(MatchScreen, "frame", fail)
    assert match._repr_png_() is None and repr(match).startswith("<Match legged-2001: 1 learners v 1 learners")
    monkeypatch.setitem(sys.modules, "pygame", None)
    assert match._repr_png_() is None


def test_a_league_is_shown_by_its_size_and_told_in_full_by_every_number() -> None:
    league = find_league("legged-2001")
    assert repr(league) == "<League legged-2001: legged, 3 x 2 m, 3 a side, 16 steps a second>"
    other = replace(league, ball=replace(league.ball, radius=0.05))
    assert repr(other) == repr(league) and other.in_full() != league.in_full()
    assert "radius=0.05" in other.in_full()


def test_an_env_is_written_as_the_call_that_makes_it():
    env = soccer_v0.parallel_env(home=1, away=2, opponents="chaser", max_cycles=20)
    written = "ParallelSoccer(league='legged-2001', home=1, away=2, max_cycles=20, opponents='chaser')"
    assert repr(env) == written and str(env) == "soccer_v0"
    assert repr(soccer_v0.raw_env(home=1, away=1)) == "TurnSoccer(league='legged-2001', home=1, away=1)"
    solo = gymnasium.make("soccer_env/Legged2001-1v1-v0").unwrapped
    assert repr(solo) == "SoloSoccer(league='legged-2001', home=1, away=1, max_cycles=1000)"
    shown = "SoccerVectorEnv(league='legged-2001', home=2, away=2, opponents='random'"
    assert repr(make_vector_env(3)).startswith(shown)


@pytest.mark.parametrize("maker", [soccer_v0.parallel_env, soccer_v0.raw_env, make_single_env, make_vector_env])
def test_a_notebook_shows_a_picture_and_without_pygame_the_text(maker, monkeypatch: pytest.MonkeyPatch):
    pytest.importorskip("pygame")
    env = maker(home=1, away=1)
    env.reset(seed=1)
    assert env._repr_png_().startswith(b"\x89PNG\r\n")
    monkeypatch.setitem(sys.modules, "pygame", None)
    assert env._repr_png_() is None
