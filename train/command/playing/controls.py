"""What a person asks for, by the keys held down and by a gamepad whose buttons count as keys."""

from __future__ import annotations

from collections.abc import Collection
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from soccer_env.actions import SOFT

if TYPE_CHECKING:
    from pygame.joystick import JoystickType

WAYS = {  # parts of an action, and the keys that raise and lower them
    "forward": (("w", "up"), ("s", "down")),
    "left": (("a", "left"), ("d", "right")),
    "turn": (("q",), ("e",)),
}
KICKS = {"c": SOFT, "space": 1.0}  # strength
CARRY, SHOOT, PASS, TEAM = "carry", "shoot", "pass", "team"
SKILLS = {"f": CARRY, "r": SHOOT, "v": PASS, "g": TEAM}  # while the key is held
HELP = (
    "w a s d, arrows: drive     q, e: turn",
    "space: kick     c: kick softly",
    "tab: next robot     n: the robot nearest to the ball",
    "hold f: go for the ball and carry it",
    "hold r: shoot     hold v: pass     hold g: let the team play it",
    "m: drive as the robot faces, or as you see the pitch",
    "b: the truth, or what the robot believes",
    "p: pause     comma, full stop: slower, faster",
    "h: these keys     escape: end",
    "gamepad: sticks drive and turn, A kicks, B passes, X shoots,",
    "Y carries, left and right button: nearest, next robot",
)
BUTTONS = {  # of a gamepad laid out as the Xbox 360's, and the keys that they stand for
    0: "space", 1: "v", 2: "r", 3: "f", 4: "n", 5: "tab", 6: "b", 7: "p",
}  # fmt: skip
STICKS = {"left": 0, "forward": 1, "turn": 3}  # axes of such a gamepad; all grow to the right and down
DEAD = 0.15  # [1] of the way of a stick in which it counts as let go, assumed


@dataclass(frozen=True)
class Wish:
    """What a person asks of a robot at one moment; the numbers are those of an action, in [-1, 1]."""

    forward: float = 0.0
    left: float = 0.0
    turn: float = 0.0
    kick: float = 0.0
    skill: str = ""  # one of SKILLS, which replaces the numbers


def wish_of_keys(held: Collection[str]) -> Wish:
    """Return the wish of the keys that are held down, by pygame's names."""
    ways = {name: float(any(key in held for key in more)) - any(key in held for key in less)
            for name, (more, less) in WAYS.items()}  # fmt: skip
    kick = max((strength for key, strength in KICKS.items() if key in held), default=0.0)
    skill = next((skill for key, skill in SKILLS.items() if key in held), "")
    return Wish(**ways, kick=kick, skill=skill)


class Gamepad:
    """The first gamepad that is plugged in, from the start or later; without one it asks for nothing."""

    def __init__(self) -> None:
        import pygame

        self.held: set[str] = set()  # keys that its buttons stand for
        self._stick: JoystickType | None = None
        with suppress(pygame.error):  # no joysticks on this system
            pygame.joystick.init()

    def pressed(self) -> list[str]:
        """Read the gamepad; return the keys that stand for the buttons that were pressed since the last call."""
        import pygame

        pygame.event.clear((pygame.JOYAXISMOTION, pygame.JOYBUTTONDOWN, pygame.JOYBUTTONUP))  # lest the queue fill up
        if self._stick is None and pygame.joystick.get_init() and pygame.joystick.get_count():
            self._stick = pygame.joystick.Joystick(0)
        stick = self._stick
        count = 0 if stick is None else stick.get_numbuttons()
        down = {key for button, key in BUTTONS.items() if button < count and stick and stick.get_button(button)}
        new = [key for key in BUTTONS.values() if key in down - self.held]
        self.held = down
        return new

    def steer(self, wish: Wish) -> Wish:
        """Return the wish with the ways of all sticks that are off their middle."""
        stick = self._stick
        if stick is None:
            return wish
        ways = {name: -stick.get_axis(axis) for name, axis in STICKS.items() if axis < stick.get_numaxes()}
        steered: dict[str, Any] = {name: way for name, way in ways.items() if abs(way) > DEAD}
        return replace(wish, **steered)
