"""A second process compiles the step of a match while the first one does the rest, and only if there is need."""

import subprocess
from pathlib import Path
from typing import Any

import pytest

from soccer_env.compiled import compiled, config
from soccer_env.compiling.cache import is_kept
from soccer_env.train.command import compiling_beside
from soccer_env.train.command.compiling_beside import step_compiled_beside

pytestmark = pytest.mark.skipif(bool(config.DISABLE_JIT), reason="nothing is compiled")


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
    monkeypatch.setattr(compiling_beside, "cores", lambda: 2)
    return Started.every


def test_with_an_empty_cache_one_process_runs_beside_and_ends_with_the_block(
    started: list[Started], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("soccer_env.compiling.cache.folders", lambda: (tmp_path,))
    with pytest.raises(KeyboardInterrupt), step_compiled_beside():
        assert [one.command[1:] for one in started] == [["-m", "soccer_env.train.command.compiling_beside"]]
        assert not started[0].killed
        raise KeyboardInterrupt
    assert started[0].killed


def test_none_is_started_where_it_would_not_help(started: list[Started], monkeypatch: pytest.MonkeyPatch) -> None:
    compiling_beside.compile_step()
    with step_compiled_beside():
        pass
    monkeypatch.setattr(compiling_beside, "is_kept", lambda function: False)
    monkeypatch.setattr(compiling_beside, "cores", lambda: 1)
    with step_compiled_beside():
        pass
    assert started == []


@compiled
def one_more(x):  # type: ignore[no-untyped-def]
    return x + 1.0


def test_what_is_kept_is_told_from_what_is_not(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("soccer_env.compiling.cache.folders", lambda: (tmp_path / "cache",))
    assert not is_kept(one_more)
    assert one_more(1.0) == 2.0
    assert is_kept(one_more)
