"""Windows and sound of every test go nowhere; tests import what they share as `tests.scenes.staging`.

`make test` has a process for each core. They share one cache of compiled code, which they fill together before they
begin (`warm_up.py`); files and ports of a test are its own.
"""

import os
import signal
import sys
from collections.abc import Callable
from pathlib import Path

import pettingzoo  # noqa: F401  # first, for it sets the sound driver as it is imported
import pytest
from hypothesis import settings

settings.register_profile("busy machine", deadline=None)
settings.load_profile("busy machine")
os.environ["SDL_VIDEODRIVER"] = os.environ["SDL_AUDIODRIVER"] = "dummy"
sys.path.append(str(Path(__file__).parents[1]))


@pytest.fixture(scope="session", autouse=True)
def interrupts() -> None:
    """Let SIGINT interrupt tests and the processes that they start: a job in the background begins with it ignored."""
    signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="session", autouse=True)
def compiled_code(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Fill the cache of compiled code, if this is one of several processes."""
    worker = os.environ.get("PYTEST_XDIST_WORKER", "")
    if worker:
        from tests.warm_up import warm_up

        warm_up(tmp_path_factory.getbasetemp().parent, int(worker.removeprefix("gw")))


@pytest.fixture
def soccer(capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """Return a function that runs a `soccer` command, which ends with `code`, and returns what it printed.

    With 2 that is one line of error, and nothing else. quiet: no error or warning is printed.
    """
    from soccer_env.train.command.command_line import main

    def run(*words: object, code: int = 0, quiet: bool = False) -> str:
        capsys.readouterr()
        assert main([str(word) for word in words]) == code
        printed = capsys.readouterr()
        assert not (quiet and printed.err)
        if code == 2:
            assert printed.out == "" and printed.err.startswith("soccer: ") and printed.err.count("\n") == 1
        return printed.out if code == 0 else printed.out + printed.err

    return run
