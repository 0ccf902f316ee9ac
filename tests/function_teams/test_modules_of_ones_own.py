"""MODULE:NAME stands for a team, a league, rewards or a scene of one's own wherever a name may stand."""

import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, Rewards, make_team

MINE = """
from dataclasses import replace
import numpy as np
from soccer_env import Rewards, Scene, team_of_function
from soccer_env.leagues import find_league

legged = find_league("legged-2001")
ICY = replace(legged, name="icy", ball=replace(legged.ball, rolling=0.05))
PAID = Rewards.only(goal=7.0, shot=1.0)
CENTRE = Scene("centre", "the ball on the centre spot", place=lambda league, ball, robots, draw: None)
number = 3


def ahead(observations):
    actions = np.zeros((*observations.shape[:2], 4))
    actions[..., 0] = 1.0
    return actions


team = team_of_function(ahead, fingerprint="ahead 1")
untold = team_of_function(ahead)


class Slow:
    name = "slow"
    memory_dtype = np.dtype([("unused", "i8")])

    def __init__(self, speed=1.0):
        self.speed = speed

    def act(self, view, memory, rng):
        commands = view.stand()
        commands[..., 0] = self.speed
        return commands


def factory(strength=1.0, brave=False):
    return Slow(strength * (0.5 if brave else 1.0))
"""


@pytest.fixture
def mine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Go to a folder with a module of a user's own, which Python does not look into as `soccer` is run."""
    (tmp_path / "my_own.py").write_text(MINE)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [path for path in sys.path if path not in ("", str(tmp_path))])
    yield tmp_path
    sys.modules.pop("my_own", None)


def forward(**who: Any) -> list[float]:
    match = Match(home=1, away=1, controllers=who, seed=1)
    match.step()
    found: list[float] = match.robots["command"]["forward"][0].tolist()
    return found


@pytest.mark.usefixtures("mine")
def test_leagues_rewards_and_scenes_of_a_module_are_found() -> None:
    match = Match("my_own:ICY", home=1, away=1, rewards="my_own:PAID", scene="my_own:CENTRE", seed=1)
    assert (match.league.name, match.settings.scene.name) == ("icy", "centre")
    assert match.settings.rewards == Rewards.only(goal=7.0, shot=1.0)


@pytest.mark.usefixtures("mine")
@pytest.mark.parametrize(
    ("setting", "name", "message"),
    [
        ("team", "teem", "unknown team 'teem' in module 'my_own', did you mean 'team'?"),
        ("team", "number", "team 'my_own:number' must be a team, or a function that takes strength=, got 3"),
        ("team", "ahead", "'my_own:ahead' must be a team, or a function that takes strength=, got <function ahead"),
        ("team", "Slow", "a team is an object: give Slow(), not the class"),
        ("team", "team@0.5", "team 'my_own:team' is no function: it takes neither strength nor settings"),
        ("team", "factory@2", "must be a number from 0 to 1, got '2'"),
        ("league", "ICI", "unknown league 'ICI' in module 'my_own', did you mean 'ICY'?"),
        ("league", "PAID", "league 'my_own:PAID' must be a League, got Rewards("),
        ("rewards", "ICY", "rewards 'my_own:ICY' must be a Rewards, got <League icy"),
        ("scene", "number", "scene 'my_own:number' must be a Scene, got 3"),
    ],
)
def test_what_a_module_does_not_hold_is_named(setting: str, name: str, message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        make_team(f"my_own:{name}") if setting == "team" else Match(**{setting: f"my_own:{name}"})


def test_a_module_that_is_missing_or_pythons_own_is_named() -> None:
    with pytest.raises(ValueError, match="team: module 'my_oun' cannot be imported: No module named 'my_oun'"):
        make_team("my_oun:team")
    with pytest.raises(ValueError, match="team must stand in a module of your own, 'os' is one of Python's"):
        make_team("os:abort")


EVALUATE = ["evaluate", "--away", "still", "--matches", "2", "--minutes", "0.1", "--players", "1", "--league"]


def test_the_command_evaluates_a_team_of_a_module(mine: Path, soccer: Any) -> None:
    words = [*EVALUATE, "my_own:ICY", "--home", "my_own:team", "--out", "run"]
    soccer(*words)
    assert "my_own:team" in (mine / "run" / "report.md").read_text()
    soccer(*words)  # the same run goes on
    source = mine / "my_own.py"
    source.write_text(MINE.replace("ahead 1", "another way ahead"))
    sys.modules.pop("my_own")
    assert "home_team" in soccer(*words, code=2)


@pytest.mark.usefixtures("mine")
def test_a_function_that_cannot_be_told_from_another_is_not_evaluated_into_a_folder(soccer: Any) -> None:
    words = [*EVALUATE, "legged-2001", "--home", "my_own:untold"]
    assert "give it a `fingerprint`" in soccer(*words, "--out", "run", code=2)
    soccer(*words)


def test_a_match_of_names_of_a_module_is_that_of_its_objects(mine: Path) -> None:
    by_name = Match("my_own:ICY", home=1, away=1, opponents="my_own:team", seed=3)
    import my_own  # type: ignore[import-not-found]

    by_object = Match(my_own.ICY, home=1, away=1, opponents=my_own.team, seed=3)
    for match in (by_name, by_object):
        for _ in range(5):
            match.step(np.ones((1, 2, 4)))
    assert by_name.state_hash() == by_object.state_hash()
