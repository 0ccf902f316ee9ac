"""Windows and sound of every test go nowhere; tests import what they share as `tests.scenes.staging`.

`make test` has a process for each core. They share one cache of compiled code, which they fill together before they
begin (`warm_up.py`); files and ports of a test are its own.
"""

import os
import signal
import sys
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
