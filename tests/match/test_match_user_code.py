"""Match with a user's own teams, rewards, observations, scenes and leagues, and the nonsense that they may return."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, Rewards, Scene
from soccer_env.leagues import find_league
from tests.scenes.staging import play, refused


class Walker:
    """A team that goes straight on and counts its steps."""

    name = "walker"
    memory_dtype = np.dtype([("steps", "i8")])

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        memory["steps"] += 1
        commands = view.stand()
        commands[..., 0] = 5.0 * rng.uniform(0.5, 1.0)
        return commands


def test_a_team_in_python_plays_remembers_and_is_clipped() -> None:
    match = Match(home=2, away=1, matches=3, controllers={"home": Walker()}, seed=1)
    play(match, steps=20)
    assert match.squads[0].memory["steps"].tolist() == [[20, 20]] * 3
    assert (match.robots["command"]["forward"][:, :2] == 1.0).all()
    assert (match.robots["vx"][:, 0] > 0.05).all()
    match.reset()
    assert not match.squads[0].memory["steps"].any(), "a new episode begins with an empty memory"


def test_a_team_draws_the_same_alone_and_among_many() -> None:
    many = Match(home=1, away=1, matches=4, controllers={"home": Walker(), "away": "random"}, seed=1)
    one = Match(home=1, away=1, controllers={"home": Walker(), "away": "random"}, seeds=[many.seeds[2]])
    for _ in range(50):
        many.step()
        one.step()
    assert one.state_hash(0) == many.state_hash(2)


class Broken:
    """A team that returns whatever it was made with."""

    name = "broken"
    memory_dtype = np.dtype([("unused", "i8")])

    def __init__(self, commands: Any) -> None:
        self.commands = commands

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> Any:
        return self.commands


@pytest.mark.parametrize("commands", [np.zeros((1, 1, 3)), np.full((1, 1, 4), np.nan), np.zeros(4)])
def test_a_team_that_returns_nonsense_is_named(commands: Any) -> None:
    match = Match(home=1, away=1, controllers={"home": Broken(commands), "away": "still"}, seed=1)
    with refused(match, "broken"):
        match.step()
    with pytest.raises(ValueError, match=r"give Walker\(\), not the class"):
        Match(home=1, away=1, opponents=Walker, seed=1)


def test_a_compiled_team_is_clipped_and_checked() -> None:
    from soccer_env.compiled import compiled
    from soccer_env.teams import CompiledTeam
    from soccer_env.teams.kernels import NO_MEMORY, STRENGTH

    @compiled
    def ask(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last):  # type: ignore[no-untyped-def]
        for m in range(first, last):
            for r in players:
                commands[m, r].turn = settings[0].strength

    for asked, expected in ((7.0, 1.0), (-3.0, -1.0)):
        team = CompiledTeam("wild", ask, NO_MEMORY, np.array([(asked,)], STRENGTH))
        match = Match(home=1, away=1, seed=1, controllers={"home": team, "away": "still"})
        match.step()
        assert match.robots["command"]["turn"][0, 0] == expected
    lost = CompiledTeam("lost", ask, NO_MEMORY, np.array([(np.nan,)], STRENGTH))
    match = Match(home=1, away=1, seed=1, opponents=lost)
    with pytest.raises(ValueError, match="team 'lost' gave robot 1 of match 0 a command that is not finite"):
        match.step(np.zeros((1, 2, 4)))
    assert np.isfinite(match.robots["x"]).all()


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        (np.zeros(3), "reward term 'mine' must return numbers of shape (1, 2), got shape (3,)"),
        (np.nan, "reward term 'mine' must return finite numbers, got nan at (0, 0)"),
        (None, "reward term 'mine' must return"),
    ],
)
def test_a_reward_term_that_returns_nonsense_is_named(returned: Any, message: str) -> None:
    match = Match(home=1, away=1, seed=1, rewards=Rewards(extra={"mine": lambda match: returned}))
    with pytest.raises(ValueError, match=re.escape(message)):
        match.step(np.zeros((1, 2, 4)))


def test_a_scene_of_ones_own_places_what_it_likes() -> None:
    def place(league: Any, ball: Any, robots: Any, draw: Any) -> None:
        ball["x"] = draw.between(0.2, 0.4)

    match = Match(home=1, away=1, matches=8, scene=Scene("ahead", "the ball lies ahead", place), seed=1)
    assert ((match.balls["x"] > 0.2) & (match.balls["x"] < 0.4)).all()
    assert len(set(match.balls["x"])) == 8


def at_one_place(ball: Any, robots: Any) -> None:
    robots["x"] = robots["y"] = 0.5


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        (lambda ball, robots: robots["x"].__setitem__(1, np.nan), "leave finite numbers, got x nan of away_0"),
        (lambda ball, robots: ball.__setitem__("vy", np.inf), "leave finite numbers, got vy inf of the ball"),
        (lambda ball, robots: robots["team"].__setitem__(0, 7), "leave team of home_0 0, got 7"),
        (lambda ball, robots: robots["number"].__setitem__(1, 5), "leave number of away_0 0, got 5"),
        (lambda ball, robots: ball.__setitem__("x", 99.0), "put the ball at x = -1.8 to 1.8 m, got 99$"),
        (lambda ball, robots: robots["y"].__setitem__(1, -1.2), "put away_0 at y = -1 to 1 m, got -1.2$"),
        (at_one_place, "put away_0 at least 0.077 m from home_0, got 0$"),
    ],
)
def test_a_scene_that_places_what_cannot_be_is_named(change: Any, complaint: str) -> None:
    """It is no bug of this package, and kernels index by team and number."""
    asked: list[Any] = [lambda ball, robots: None]

    def place(league: Any, ball: Any, robots: Any, draw: Any) -> None:
        asked[-1](ball, robots)

    match = Match(home=1, away=1, scene=Scene("own", "as it likes", place), seed=1)
    asked.append(change)
    with refused(match, f"scene 'own' must {complaint}"):
        match.reset()


def test_a_league_of_ones_own_is_checked_and_played() -> None:
    legged = find_league("legged-2001")
    fast = replace(legged, name="fast", drive=replace(legged.drive, forward=0.3, slip=0.0))
    match = Match(fast, home=1, away=1, seed=1)
    speeds = []
    for _ in range(40):
        match.step(np.array([[[1.0, 0, 0, 0], [0, 0, 0, 0]]]))
        speeds.append(np.hypot(match.robots["vx"], match.robots["vy"]).max())
    assert max(speeds) == pytest.approx(0.3, rel=0.01)
    with pytest.raises(ValueError, match=r"Drive\.forward must be a number above 0, got -1"):
        replace(legged.drive, forward=-1.0)
