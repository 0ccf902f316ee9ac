"""`soccer watch`: a match that is played, or a replay, in a window that pauses, steps and goes back."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import ceil

import numpy as np

from soccer_env.match import Match
from soccer_env.render import Picture, Window, check_display
from soccer_env.render.captions import clock_words
from soccer_env.replay import Replay
from soccer_env.train.evaluate.play_settings import WatchSettings
from soccer_env.train.evaluate.recording import start

KEPT = 6000  # shots in memory, some 12 kB each
SMOOTH = 50.0  # [1/s] frames shown, at most
IDLE = 30.0  # [1/s] looks at the keyboard while nothing moves
JUMP = 5.0  # [s] that the arrows go
SLOWEST, FASTEST = 1 / 16, 100.0

Shot = tuple[np.void, np.void, np.ndarray]  # records of the first match, its ball and robots (R,)


class Tape:
    """Shots of a match, one for every `stride` control steps; those that were shown can be gone back to."""

    def __init__(self, matches: Iterable[Match], stride: int = 1) -> None:
        self._coming = iter(matches)
        self._stride = stride
        self.shots: list[Shot] = [shot_of(next(self._coming))]
        self.at = 0
        self.ended = False

    def go(self, shots: int) -> None:
        """Go on or back by some shots, as far as there are any."""
        self.at = max(0, self.at + shots)
        while self.at >= len(self.shots) and not self.ended:
            self._take()
        self.at = min(self.at, len(self.shots) - 1)

    def _take(self) -> None:
        """Take the next shot; the oldest are given up where there are too many."""
        latest = None
        for _ in range(self._stride):
            latest = next(self._coming, latest)
        if latest is None:
            self.ended = True
            return
        self.shots.append(shot_of(latest))
        if len(self.shots) > KEPT:
            del self.shots[: KEPT // 4]
            self.at -= KEPT // 4

    @property
    def shot(self) -> Shot:
        """Return the shot that is shown."""
        return self.shots[self.at]


def shot_of(match: Match) -> Shot:
    """Return a copy of what is drawn of a match."""
    return match.matches[0].copy(), match.balls[0].copy(), match.robots[0].copy()


class Deck:
    """What the keys have set: whether the tape runs, and how fast; `rate` is its shots a second of the match."""

    def __init__(self, tape: Tape, rate: float, speed: float) -> None:
        if not 0.0 < speed <= FASTEST:
            raise ValueError(f"speed must be above 0 and at most {FASTEST:g}, got {speed}")
        self.tape, self.rate, self.speed = tape, rate, speed
        self.paused = False

    def press(self, key: str) -> None:
        """Do what a key asks for; keys without a meaning do nothing."""
        if key == "space":
            self.paused = not self.paused
        elif key in (",", "."):
            self.paused = True
            self.tape.go(1 if key == "." else -1)
        elif key in ("left", "right"):
            self.tape.go(round(JUMP * self.rate) * (1 if key == "right" else -1))
        elif key in ("up", "down"):
            faster = 2.0 if key == "up" else 0.5
            self.speed = min(max(self.speed * faster, SLOWEST), FASTEST)
        elif key == "home":
            self.tape.go(-self.tape.at)

    @property
    def skip(self) -> int:
        """Return how many shots lie between two frames: no more than SMOOTH a second are shown."""
        return max(1, ceil(self.rate * self.speed / SMOOTH))

    @property
    def fps(self) -> float:
        """Return the frames to show a second [1/s]."""
        return IDLE if self.paused else self.rate * self.speed / self.skip

    def words(self) -> str:
        """Return the caption of the window."""
        state = "paused" if self.paused else "end" if self.over() else f"{self.speed:g}x"
        return f"soccer_env  {clock_words(self.tape.shot[0])}  {state}"

    def over(self) -> bool:
        """Tell whether the last shot of all is shown."""
        return self.tape.ended and self.tape.at == len(self.tape.shots) - 1


def show(tape: Tape, deck: Deck, picture: Picture, window: Window, teams: tuple[str, str], stays: bool) -> None:
    """Show a tape until the user closes the window, or until its end unless the window `stays`."""
    try:
        while True:
            window.fps = deck.fps
            window.say(deck.words())
            match, ball, robots = tape.shot
            if not window.show(picture.draw(match, ball, robots, title=teams)):
                return
            for key in window.pressed():
                deck.press(key)
            if deck.paused:
                continue
            tape.go(deck.skip)
            if deck.over() and not stays:
                return
    finally:
        window.close()


def moving(match: Match) -> Iterator[Match]:
    """Yield a match at its kick-off and after every control step until it ends."""
    yield match
    while not match.terminated.all():
        match.step()
        yield match


def watch(settings: WatchSettings) -> None:
    """Show a replay file, or play a match, in a window; ValueError where there is no display."""
    if settings.file is not None:
        replay = Replay.read(settings.file)
        check_display()
        league, teams, stride = replay.make_match().league, replay.teams, max(1, ceil(len(replay) / KEPT))
        tape = Tape(replay.play(), stride)
    else:
        check_display()
        match = start(settings)
        league, teams, stride = match.league, (settings.home, settings.away), 1
        tape = Tape(moving(match))
    deck = Deck(tape, league.control_rate / stride, settings.speed)
    stays = settings.file is not None
    show(tape, deck, Picture(league, settings.width), Window("soccer_env"), teams, stays)
