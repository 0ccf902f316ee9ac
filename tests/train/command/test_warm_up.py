"""`soccer warm-up` compiles each part once, a second process beside the first; long work says how far it is."""

import subprocess
from pathlib import Path
from typing import Any

import pytest

from soccer_env.compiled import compiled, config
from soccer_env.compiling import announcing, cache
from soccer_env.compiling.cache import is_cached
from soccer_env.teams import NAMES
from soccer_env.train import progress
from soccer_env.train.command import compiling_beside, warm_up
from soccer_env.train.command.command_line import main
from soccer_env.train.command.compiling_beside import compile_step_beside
from soccer_env.train.command.warm_up import WarmUpSettings, warm_up_parts
from soccer_env.train.progress import EVERY, Progress

if_compiled = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")


def test_every_team_is_played_in_its_league() -> None:
    names = [name for name, _ in warm_up_parts(WarmUpSettings())]
    assert len(names) == len(set(names))
    assert {name.split(", ")[1] for name in names} >= set(NAMES)
    assert "legged-2001, sacks-2001" in names and "middle-size-2006, sacks-2001" not in names
    assert {"legged-2001, a drill", "middle-size-2006, a drill"} <= set(names)
    one = [name for name, _ in warm_up_parts(WarmUpSettings(league="legged-2001", team="still"))]
    assert one[-1] == "legged-2001, still" and len(one) == 7


def test_the_second_time_nothing_is_left(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(warm_up, "WAYS", ({"senses": "ideal", "observe": "truth"},))
    words = ["warm-up", "--league", "legged-2001", "--team", "still"]
    for _ in range(2):
        assert main(words) == 0
    said = capsys.readouterr().out.splitlines()[-1]
    assert said == f"nothing was left to compile; the cache is in {cache.cache_folders()[0]}"


def test_wrong_words_are_refused(soccer: Any) -> None:
    assert "league must be one of all, legged-2001" in soccer("warm-up", "--league", "legged", code=2)
    assert "unknown team 'chasr', did you mean 'chaser'?" in soccer("warm-up", "--team", "chasr", code=2)


@if_compiled
def test_long_compiling_says_how_far_it_is(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    done = announcing.CompileProgress()
    for name, value in (("functions", 7), ("began", 100.0), ("said", 100.0)):
        setattr(done, name, value)
    now = iter([119.0, 121.0, 122.0])
    monkeypatch.setattr(announcing.time, "monotonic", lambda: next(now))
    done.expect(calls_two)
    for _ in range(3):
        done.count()
    assert capsys.readouterr().err == "soccer_env: compiling 9 of 11 functions in 21 s ...\n"


@compiled
def never_played(x):  # type: ignore[no-untyped-def]
    return x * 2.0


@compiled
def calls_another(x):  # type: ignore[no-untyped-def]
    return never_played(x)


def calls_two(x: float) -> Any:
    return calls_another(x) + never_played(x)


class Started:
    """A process that was asked for."""

    every: list["Started"] = []

    def __init__(self, command: list[str], **_: Any) -> None:
        self.command, self.killed = command, False
        self.every.append(self)

    def __enter__(self) -> "Started":
        return self

    def __exit__(self, *_: object) -> None:
        assert self.killed, "nobody waits for it"

    def kill(self) -> None:
        self.killed = True


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> list[Started]:
    monkeypatch.setattr(Started, "every", [])
    monkeypatch.setattr(subprocess, "Popen", Started)
    monkeypatch.setattr(compiling_beside, "count_cores", lambda: 2)
    return Started.every


@if_compiled
def test_with_an_empty_cache_one_process_runs_beside_and_ends_with_the_block(
    started: list[Started], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("soccer_env.compiling.cache.cache_folders", lambda: (tmp_path,))
    with pytest.raises(KeyboardInterrupt), compile_step_beside():
        assert [one.command[1:] for one in started] == [["-m", "soccer_env.train.command.compiling_beside"]]
        assert not started[0].killed
        raise KeyboardInterrupt
    assert started[0].killed


@compiled
def one_more(x):  # type: ignore[no-untyped-def]
    return x + 1.0


@if_compiled
def test_what_is_kept_is_told_from_what_is_not(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("soccer_env.compiling.cache.cache_folders", lambda: (tmp_path / "cache",))
    assert not is_cached(one_more)
    assert one_more(1.0) == 2.0
    assert is_cached(one_more)


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [100.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])
    return now


def test_short_work_and_no_work_say_nothing(clock: list[float], capsys: pytest.CaptureFixture[str]) -> None:
    with Progress("bench", 3.0) as work:
        clock[0] += 0.5 * EVERY
        work.advance(3.0)
    with Progress("reproduce", 0.0) as work:
        clock[0] += 2 * EVERY
        work.note("nothing")
    assert capsys.readouterr().err == ""
