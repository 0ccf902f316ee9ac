"""`soccer play`: a person plays a minute by keys; robots go where told, a pause stops time, the replay verifies."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("pygame")

import pygame
from pytest import MonkeyPatch

from soccer_env.render import Window
from soccer_env.replay import Replay
from soccer_env.train.command.command_line import main
from soccer_env.train.command.playing import playing
from soccer_env.train.command.playing.controls import HELP
from soccer_env.train.command.playing.person import Person
from soccer_env.train.command.playing.playing import Game
from soccer_env.train.command.playing.settings import PersonSettings
from soccer_env.train.evaluate.recording import start_match

RATE = 16  # [1/s] control steps of the legged league
Script = Iterator[set[str]]  # the keys that are held down from one frame to the next


def new_game(**settings: Any) -> Game:
    """Return a game of a person's side, home unless said otherwise."""
    made = PersonSettings(width=320, **settings)
    match, cast = start_match(made, actions="full")
    return Game(match, Person(match, made.person, made.drive), cast.names, made)


def play_by_keys(monkeypatch: MonkeyPatch, script: Any, *words: object) -> list[Game]:
    """Run `soccer play` in a dummy window, without waiting, in which a script of the game holds keys down."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    games: list[Game] = []
    scripts: list[Script] = []
    held: set[str] = set()
    flip = Window._flip

    def start(*arguments: Any) -> Game:
        games.append(Game(*arguments))
        scripts.append(script(games[0]))
        return games[0]

    def press(window: Window, image: pygame.Surface) -> None:
        flip(window, image)
        now = next(scripts[0], {"escape"})
        for keys, kind in ((now - held, pygame.KEYDOWN), (held - now, pygame.KEYUP)):
            for key in keys:
                code = pygame.key.key_code(key)
                pygame.event.post(pygame.event.Event(kind, key=code, window=window._window))
        held.clear()
        held.update(now)

    monkeypatch.setattr(playing, "Game", start)
    monkeypatch.setattr(Window, "_flip", press)
    monkeypatch.setattr(Window, "_wait", lambda window: None)
    assert main(["play", "--width", "320", *map(str, words)]) == 0
    pygame.quit()
    return games


def hold(keys: str, seconds: float) -> Script:
    """Hold keys down for some time of play at the speed of play."""
    for _ in range(round(seconds * RATE)):
        yield set(keys.split())


def test_a_minute_by_keys(monkeypatch: MonkeyPatch, tmp_path: Path, capsys: Any) -> None:
    checked = []

    def script(game: Game) -> Script:
        match, person, ball = game.match, game.person, game.match.balls[0]
        robot = match.robots[0, person.row]
        before, heading = robot.copy(), float(robot["heading"])
        yield from hold("w", 3.0)
        ahead = (robot["x"] - before["x"]) * np.cos(heading) + (robot["y"] - before["y"]) * np.sin(heading)
        assert ahead > 0.15
        yield from hold("", 1.0)
        heading = float(robot["heading"])
        yield from hold("q", 1.0)
        yield from hold("", 1.0)
        assert np.sin(robot["heading"] - heading) > 0.3
        step = int(match.matches["step"][0])
        yield {"p"}
        yield from hold("w", 2.0)
        assert game.paused and match.matches["step"][0] == step
        yield {"p"}
        yield from hold("h", 0.1)
        assert game.helps
        yield from hold("", 0.1)
        yield from hold("h b", 0.1)
        yield from hold("", 0.5)
        assert game.view == "belief" and not game.helps
        yield from hold("b", 0.1)
        first = person.agent
        yield from hold("tab", 0.1)
        yield from hold("", 0.1)
        assert person.agent != first
        yield from hold("n", 0.1)
        place = float(ball["x"]), float(ball["y"])
        for _ in range(20):
            yield from hold("r", 1.0)
            if np.hypot(ball["x"] - place[0], ball["y"] - place[1]) > 0.5 or match.matches["score"][0, 0]:
                break
        else:
            pytest.fail("the ball was not shot")
        checked.append(step)
        yield from hold("g", 60.0)

    out = tmp_path / "mine.replay"
    words = ("--players", 2, "--away", "still", "--rules", "simple", "--minutes", 1, "--seed", 3, "--out", out)
    (game,) = play_by_keys(monkeypatch, script, *words)
    printed = capsys.readouterr().out
    assert checked and game.over and "person + chaser against still: " in printed and f"written: {out}" in printed
    assert main(["replay", str(out), "--verify"]) == 0
    replay = Replay.read(out)
    assert len(replay) == 60 * RATE
    assert set(replay.settings["teams"].values()) == {"person", "still"}  # both of home were steered
    assert "960 control steps agree" in capsys.readouterr().out


def test_escape_ends_the_play_and_keeps_the_replay(monkeypatch: MonkeyPatch, tmp_path: Path) -> None:
    out = tmp_path / "short.replay"
    words = ("--league", "middle-size-2006", "--players", 2, "--person", "away_1", "--view", "belief", "--out", out)
    (game,) = play_by_keys(monkeypatch, lambda game: iter([{"w"}] * 5), *words)
    replay = Replay.read(out)
    assert len(replay) == 5 * game.stride == 10 and replay.check() == 10
    assert replay.settings["teams"]["away_1"] == "person" and replay.settings["teams"]["away_0"] == "chaser"
    assert (replay.commands["forward"][:, 0, 3] == 1.0).all()


def test_the_belief_is_all_that_is_drawn_in_the_fog() -> None:
    game = new_game(players=1, seed=1, view="belief")
    frame = game.frame()
    game.match.robots["x"][0, 1] += 0.3  # the truth about the opponent and the ball
    game.match.balls["y"][0] += 0.3
    assert np.array_equal(game.frame(), frame)
    game.press("b")
    by_truth = game.frame()
    game.match.balls["y"][0] -= 0.3
    assert not np.array_equal(game.frame(), by_truth)
    assert by_truth.astype(int).sum() > frame.astype(int).sum()  # fog is dark


def test_the_help_names_every_key() -> None:
    words = " ".join(HELP)
    singles = [f"{key}:" for key in "cnfrvgmbph"]
    assert [key for key in ("w a s d", "q, e", "space", "tab", "escape", *singles) if key not in words] == []
    game = new_game(players=1)
    plain = game.frame()
    game.press("h")
    assert not np.array_equal(game.frame(), plain)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("--person home_9", "unknown person 'home_9'"),
        ("--person hom", "did you mean 'home'?"),
        ("--home still --senses sensors", "team 'still' reads no beliefs"),
        ("--view truht", "did you mean 'truth'?"),
        ("--speed 9", "speed must be 0.0625 to 4, got 9"),
        ("--away nobody", "unknown team 'nobody'"),
    ],
)
def test_a_wrong_word_is_one_line(words: str, message: str, soccer: Any) -> None:
    assert message in soccer("play", *words.split(), code=2)


def test_a_folder_is_no_replay_file(tmp_path: Path, soccer: Any) -> None:
    assert "is a folder" in soccer("play", "--out", tmp_path, code=2)
