"""A person's robot: keys and sticks are actions, directions on the pitch, and skills that play the ball."""

from math import pi
from typing import Any

import numpy as np
import pytest

pytest.importorskip("pygame")

from pytest import MonkeyPatch

from soccer_env import Match
from soccer_env.actions import SOFT
from soccer_env.train.command.playing.controls import CARRY, PASS, SHOOT, TEAM, Gamepad, Wish, wish_of_keys
from soccer_env.train.command.playing.person import Person, ways_on_pitch

LEAGUES = ("legged-2001", "middle-size-2006")
TEAMS = {"home": "chaser", "away": "still"}


def new_match(league: str = "legged-2001", **settings: Any) -> Match:
    """Return a match in which a person's robots know the truth."""
    given = {"home": 2, "away": 1, "seed": 2, "rules": "none", "senses": "ideal", "controllers": TEAMS, **settings}
    return Match(league, actions="full", **given)


def place(match: Match, row: int, x: float, y: float, heading: float = 0.0) -> None:
    """Put a robot down somewhere [m, rad]."""
    for name, value in (("x", x), ("y", y), ("heading", heading)):
        match.robots[name][0, row] = value


def test_keys_are_numbers_of_an_action() -> None:
    assert wish_of_keys({"w", "a", "e"}) == Wish(forward=1.0, left=1.0, turn=-1.0)
    assert wish_of_keys({"up", "down", "right"}) == Wish(left=-1.0)
    assert (wish_of_keys({"space", "c"}).kick, wish_of_keys({"c"}).kick, wish_of_keys(()).kick) == (1.0, SOFT, 0.0)
    assert [wish_of_keys({key}).skill for key in "frvgx"] == [CARRY, SHOOT, PASS, TEAM, ""]


class Stick:
    """A gamepad with two sticks and eight buttons."""

    def __init__(self) -> None:
        self.axes, self.down = [0.0] * 6, set[int]()

    def get_numaxes(self) -> int:
        return len(self.axes)

    def get_numbuttons(self) -> int:
        return 8

    def get_axis(self, axis: int) -> float:
        return self.axes[axis]

    def get_button(self, button: int) -> bool:
        return button in self.down


def test_a_gamepad_steers_and_its_buttons_are_keys(monkeypatch: MonkeyPatch) -> None:
    import pygame

    stick = Stick()
    pygame.display.init()
    gamepad = Gamepad()
    assert gamepad.pressed() == [] and gamepad.steer(Wish(turn=1.0)) == Wish(turn=1.0)  # none is plugged in
    monkeypatch.setattr(pygame.joystick, "get_init", lambda: True)
    monkeypatch.setattr(pygame.joystick, "get_count", lambda: 1)
    monkeypatch.setattr(pygame.joystick, "Joystick", lambda number: stick)
    stick.axes[:4], stick.down = [0.5, -1.0, 0.0, 0.1], {5, 0}
    assert gamepad.pressed() == ["space", "tab"] and gamepad.held == {"space", "tab"}
    assert gamepad.pressed() == []  # they are still down
    assert gamepad.steer(Wish(turn=1.0)) == Wish(forward=1.0, left=-0.5, turn=1.0)  # the right stick is let go
    stick.down = set()
    assert gamepad.pressed() == [] and gamepad.held == set()
    pygame.quit()


@pytest.mark.parametrize(
    ("wish", "heading", "ways"),
    [
        (Wish(left=-1.0), 0.0, (1.0, 0.0, 0.0)),  # to the right of the picture, which the robot faces
        (Wish(forward=1.0), 0.0, (0.0, 1.0, 1.0)),  # up: to its left, and it turns there
        (Wish(forward=1.0), pi / 2, (1.0, 0.0, 0.0)),
        (Wish(left=1.0), pi / 2, (0.0, 1.0, 1.0)),
        (Wish(forward=-1.0), pi / 2 - 0.1, (-0.995, -0.0998, -1.0)),
        (Wish(turn=-1.0), 1.0, (0.0, 0.0, -1.0)),
    ],
)
def test_directions_on_the_pitch(wish: Wish, heading: float, ways: tuple[float, ...]) -> None:
    assert ways_on_pitch(wish, heading) == pytest.approx(ways, abs=1e-3)


def test_the_next_robot_is_one_that_plays_and_the_nearest_is_at_the_ball() -> None:
    match = new_match(home=3)
    for row, x in enumerate((-1.2, -0.9, -0.3)):
        place(match, row, x, 0.0)
    person = Person(match, "home")
    assert person.agent == "home_2"
    person.take_next()
    assert person.agent == "home_0"
    match.robots["active"][0, 1] = 0
    person.take_next()
    assert person.agent == "home_2"
    alone = Person(match, "home_0")
    alone.take_next()
    assert alone.agent == "home_0"


def test_the_team_plays_all_robots_but_the_one_that_is_steered() -> None:
    match, person = new_match(home=2), None
    person = Person(match, "home_0")
    match.step(person.actions(Wish(forward=-1.0)))
    assert match.robots["command"]["forward"][0, 0] == -1.0 and person.steered == {"home_0"}
    before = match.robots["command"].copy()
    match.step(person.actions(Wish(skill=TEAM)))
    assert match.robots["command"]["forward"][0, 0] != -1.0 and match.learns.sum() == 0
    assert before["forward"][0, 1] != 0.0  # the attacker


@pytest.mark.parametrize("league", LEAGUES)
def test_a_held_key_shoots_a_goal(league: str) -> None:
    match = new_match(league, home=1, scene="empty-goal", episode="goal")
    person = Person(match, "home")
    for _ in range(40 * match.league.control_rate):
        match.step(person.actions(Wish(skill=SHOOT)))
        if match.terminated.all():
            break
    assert match.matches["score"][0].tolist() == [1, 0]


@pytest.mark.parametrize("league", LEAGUES)
def test_a_held_key_passes_to_the_mate(league: str) -> None:
    match = new_match(league, keeper=1, controllers={"home": "chaser", "away": "still"})
    size = match.league.pitch.length
    place(match, 0, -0.12 * size, 0.0)
    place(match, 1, 0.0, 0.2 * size, -pi / 2)
    place(match, 2, -0.45 * size, -0.25 * size)
    match.balls["x"][0] = match.balls["y"][0] = 0.0
    match.rebuild()
    person = Person(match, "home_0")
    nearest = np.inf
    for _ in range(25 * match.league.control_rate):
        actions = person.actions(Wish(skill=PASS))
        actions[0, 1], match.learns[1] = (0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0), 1  # the mate waits
        match.step(actions)
        robot, ball = match.robots[0, 1], match.balls[0]
        nearest = min(nearest, float(np.hypot(robot["x"] - ball["x"], robot["y"] - ball["y"])))
    assert nearest < 2.0 * match.league.body.reach


def test_a_held_key_carries_the_ball_without_a_kick() -> None:
    match = new_match(home=1, scene="empty-goal", episode="goal")
    person = Person(match, "home")
    x, kicks = float(match.balls["x"][0]), 0.0
    for _ in range(20 * match.league.control_rate):
        actions = person.actions(Wish(skill=CARRY))
        kicks = max(kicks, float(actions[0, 0, 3]))
        match.step(actions)
        if match.terminated.all():
            break
    assert kicks == 0.0 and match.balls["x"][0] > x + 0.1
