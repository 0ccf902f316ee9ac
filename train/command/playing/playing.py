"""`soccer play`: a match that a person plays in, its window, and its replay."""

from __future__ import annotations

from math import ceil

import numpy as np

from soccer_env.match import Match
from soccer_env.render import Picture, Window, check_display
from soccer_env.render.captions import clock_words
from soccer_env.render.overlays.cast import cast_of, take_snapshot
from soccer_env.render.overlays.panels import HelpPanel
from soccer_env.replay import Recorder, Thoughts
from soccer_env.thoughts.thought import NoteReader
from soccer_env.train.command.playing.controls import HELP, Gamepad, Wish, wish_of_keys
from soccer_env.train.command.playing.person import Person
from soccer_env.train.command.playing.picture import draw_belief, draw_truth
from soccer_env.train.command.playing.settings import FASTEST, SLOWEST, PersonSettings
from soccer_env.train.evaluate.recording import check_target, shown_memory_fields, start_match

SMOOTH, IDLE = 30.0, 30.0  # [1/s] frames shown at most, and during a pause
SELF = "person"  # name in the replay of robots that the person has steered


class Game:
    """A match that a person plays: the state that keys set, the steps and the frames."""

    def __init__(self, match: Match, person: Person, teams: tuple[str, str], settings: PersonSettings) -> None:
        self.match, self.person, self.teams = match, person, teams
        self.thoughts = Thoughts(match, shown_memory_fields())
        self.cast = cast_of(match, NoteReader.of(self.thoughts))
        self.picture = Picture(match.league, settings.width)
        self.speed, self.view = settings.speed, settings.view
        self.paused = self.helps = False

    @property
    def over(self) -> bool:
        """Tell whether the match has ended."""
        return bool((self.match.terminated | self.match.truncated).all())

    @property
    def stride(self) -> int:
        """Return the number of control steps from frame to frame."""
        return max(1, ceil(self.match.league.control_rate * self.speed / SMOOTH))

    @property
    def fps(self) -> float:
        """Return the frame rate of the window [1/s]."""
        return IDLE if self.paused else self.match.league.control_rate * self.speed / self.stride

    def press(self, key: str) -> None:
        """Carry out the action of a key that is not held, or nothing for another key."""
        person = self.person
        if key == "p":
            self.paused = not self.paused
        elif key in (",", "."):
            self.speed = min(max(self.speed * (2.0 if key == "." else 0.5), SLOWEST), FASTEST)
        elif key in ("h", "f1"):
            self.helps = not self.helps
        elif key == "b":
            self.view = "truth" if self.view == "belief" else "belief"
        elif key == "m":
            person.drive = "robot" if person.drive == "pitch" else "pitch"
        elif key == "tab":
            person.take_next()
        elif key == "n":
            person.take_nearest()

    def advance(self, wish: Wish) -> None:
        """Play the control steps until the next frame, unless the person pauses."""
        for _ in range(0 if self.paused else self.stride):
            if not self.over:
                self.match.step(self.person.actions(wish))

    def frame(self) -> np.ndarray:
        """Return the frame (H, W, 3) uint8 that the person sees now."""
        believes = self.view == "belief"
        shot = take_snapshot(self.match, self.thoughts.look(self.match) if believes else None)
        panels = [HelpPanel(HELP)] if self.helps else []
        draw = draw_belief if believes else draw_truth
        return draw(self.picture, self.cast, shot, self.person.agent, self.teams, panels)

    def words(self) -> str:
        """Return the caption of the window: the clock, the robot, what driving follows, and the speed."""
        state = "paused" if self.paused else f"{self.speed:g}x"
        who = f"{self.person.agent} drives by the {self.person.drive}"
        return f"soccer_env  {clock_words(self.match.matches[0])}  {who}  {state}  (h: keys)"


def run(game: Game, window: Window, gamepad: Gamepad) -> None:
    """Play until the match ends or the person closes the window."""
    try:
        while not game.over:
            window.fps = game.fps
            window.say(game.words())
            if not window.show(game.frame()):
                return
            pressed = [*window.pressed(), *gamepad.pressed()]
            for key in pressed:
                game.press(key)
            game.advance(gamepad.steer(wish_of_keys({*pressed, *window.held, *gamepad.held})))
    finally:
        window.close()


def play(settings: PersonSettings) -> str:
    """Let a person play a match in a window, and write its replay; return the score in words."""
    check_display()
    if settings.out is not None:
        check_target(settings.out)
    match, cast = start_match(settings, actions="full")
    person = Person(match, settings.person, settings.drive)
    side = 0 if person.agent.startswith("home") else 1
    names = tuple(f"{SELF} + {name}" if at == side else name for at, name in enumerate(cast.names))
    game = Game(match, person, (names[0], names[1]), settings)
    person.compile_skills()
    recorder = None if settings.out is None else Recorder(match, game.thoughts)
    try:
        run(game, Window("soccer_env"), Gamepad())
    finally:
        if recorder is not None and settings.out is not None:
            replay = recorder.stop()
            replay.settings["teams"] |= dict.fromkeys(person.steered, SELF)
            replay.write(settings.out)
    home, away = match.matches["score"][0].tolist()
    return f"{names[0]} against {names[1]}: {home} to {away}"
