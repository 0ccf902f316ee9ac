"""`soccer watch`: pause, single steps, speed and going back; a replay or a live match; no display is said."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pytest import CaptureFixture, MonkeyPatch

pytest.importorskip("pygame")

import pygame

from soccer_env import Match
from soccer_env.render import Picture, Window
from soccer_env.render.closeup import Closeup
from soccer_env.render.colours import TEAMS
from soccer_env.render.overlays.cast import Cast, cast_of
from soccer_env.replay import Recorder, Thoughts
from soccer_env.thoughts.thought import NoteReader
from soccer_env.train.command.command_line import main
from soccer_env.train.command.watching.deck import PlaybackControls, Tape, play_live
from soccer_env.train.command.watching.watching import frame_of


def played(steps: int = 40) -> Match:
    minutes = steps / 16.0 / 60.0
    return Match(home=1, away=1, controllers={"home": "chaser", "away": "random"}, minutes=minutes, seed=2)


def step_of(tape: Tape) -> int:
    return int(tape.shot[0]["step"])


def test_a_tape_goes_on_and_back_and_stops_at_both_ends() -> None:
    tape = Tape(play_live(played()), stride=4)
    tape.move_by(3)
    assert step_of(tape) == 12
    tape.move_by(-2)
    assert step_of(tape) == 4
    tape.move_by(-99)
    assert step_of(tape) == 0
    tape.move_by(99)
    assert step_of(tape) == 40 and tape.ended


def test_keys_pause_step_seek_and_change_the_speed() -> None:
    tape = Tape(play_live(played(200)))
    deck = PlaybackControls(tape, 16.0, 1.0)
    assert (deck.fps, deck.skip) == (16.0, 1)
    for key, step, paused in ((".", 1, True), (".", 2, True), (",", 1, True), ("right", 81, True), ("left", 1, True)):
        deck.press(key)
        assert (step_of(tape), deck.paused) == (step, paused)
    deck.press("space")
    deck.press("up")
    deck.press("up")
    assert (deck.paused, deck.speed, deck.skip, deck.fps) == (False, 4.0, 2, 32.0)
    deck.press("home")
    deck.press("x")
    assert step_of(tape) == 0
    with pytest.raises(ValueError, match="speed must be above 0 and at most 100, got 0"):
        PlaybackControls(tape, 16.0, 0.0)


def test_a_replay_is_shown_until_escape_and_keys_reach_it(monkeypatch: MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    match = played()
    recorder = Recorder(match)
    while not match.terminated.all():
        match.step()
    recorder.stop().write(tmp_path / "a.replay")
    keys = [pygame.K_SPACE, pygame.K_PERIOD, None, None, pygame.K_SPACE, None, pygame.K_ESCAPE]
    shown: list[int] = []
    draw, flip = Picture.draw, Window._flip

    def note(picture: Picture, match: object, *rest: object, **named: object) -> object:
        shown.append(int(match["step"]))  # type: ignore[index]
        return draw(picture, match, *rest, **named)  # type: ignore[arg-type]

    def press(window: Window, image: pygame.Surface) -> None:
        flip(window, image)
        key = keys.pop(0)
        if key is not None:
            pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key, window=window._window))

    monkeypatch.setattr(Picture, "draw", note)
    monkeypatch.setattr(Window, "_flip", press)
    assert main(["watch", str(tmp_path / "a.replay"), "--speed", "50", "--width", "320"]) == 0
    assert shown == [0, 0, 1, 1, 1, 17, 33] and keys == []
    pygame.quit()


def test_a_match_is_watched_from_a_time_on(monkeypatch: MonkeyPatch, soccer: Any) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    shown: list[int] = []

    def close(picture: Picture, match: np.void, *rest: object, **named: object) -> object:
        shown.append(int(match["step"]))
        pygame.event.post(pygame.event.Event(pygame.QUIT))
        return draw(picture, match, *rest, **named)  # type: ignore[arg-type]

    draw = Picture.draw
    monkeypatch.setattr(Picture, "draw", close)
    words = ("watch", "--players", 1, "--minutes", 0.1, "--width", 320)
    soccer(*words, "--start", 2.5)
    assert shown == [40]
    assert "start must lie before the end of the match, got 7" in soccer(*words, "--start", 7, code=2)
    pygame.quit()


def watched(steps: int = 180) -> tuple[PlaybackControls, Cast]:
    match = Match(home=2, away=1, controllers={"home": "sacks-2001", "away": "chaser"}, seed=2)
    thoughts = Thoughts(match)
    deck = PlaybackControls(Tape(play_live(match, thoughts)), 16.0, 1.0, agents=tuple(match.agents))
    deck.tape.move_by(steps)
    while np.hypot(deck.tape.shot.ball["vx"], deck.tape.shot.ball["vy"]) < 0.3:  # until it rolls, and leaves a trail
        deck.tape.move_by(1)
    deck.tape.move_by(8)
    return deck, cast_of(match, NoteReader.of(thoughts))


def test_keys_pick_a_robot_and_the_picture_follows_it_or_the_ball() -> None:
    deck, cast = watched()
    picture = Closeup("legged-2001", 480)
    whole = frame_of(deck, cast, picture, ("a", "b"))
    assert deck.flags.robot == "ball"
    deck.press("r")
    deck.press("r")
    assert deck.flags.robot == "home_1" and cast.selected_row(deck.flags, deck.tape.shot) == 1
    deck.press("f")
    near = frame_of(deck, cast, picture, ("a", "b"))
    assert deck.follow == "robot" and near.shape == whole.shape and not np.array_equal(near, whole)
    robot = deck.tape.shot.robots[1]
    assert abs(float(robot["x"])) < 0.7 and abs(float(robot["y"])) < 0.4  # far from the edges: it stands in the middle
    middle = near[(picture.header_height + picture.height) // 2 - 12 :, 480 // 2 - 12 : 480 // 2 + 12][:24]
    assert (np.abs(middle.astype(int) - TEAMS[0]).max(axis=-1) < 30).sum() > 30
    deck.press("f")
    assert deck.follow == "ball"
    deck.press("f")
    assert np.array_equal(frame_of(deck, cast, picture, ("a", "b")), whole)


def test_without_a_display_it_says_so(monkeypatch: MonkeyPatch, capsys: CaptureFixture[str], tmp_path: Path) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XDG_RUNTIME_DIR"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(pygame.display, "get_driver", lambda: "offscreen")
    assert main(["watch", "--minutes", "0.02"]) == 2
    assert main(["watch", str(tmp_path / "missing.replay")]) == 2
    first, second = capsys.readouterr().err.splitlines()
    assert "there is no display to open a window on; soccer export makes" in first
    assert "missing.replay" in second
    pygame.quit()
