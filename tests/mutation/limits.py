"""A plugin of pytest that ends a process whose test takes too much time or memory, and says in a file which it was."""

from __future__ import annotations

import contextlib
import os
import resource
import time
from pathlib import Path

SECONDS = 200  # [s] of processor time for one test, compiling included
BYTES = 12 << 30  # of memory that a process may ask for

with contextlib.suppress(ValueError, OSError):
    resource.setrlimit(resource.RLIMIT_DATA, (BYTES, BYTES))


def pytest_runtest_logstart(nodeid: str) -> None:
    """Give the test that begins its time."""
    Path(os.environ["SOCCER_MUTANT_TEST"]).write_text(nodeid, encoding="utf-8")
    with contextlib.suppress(ValueError, OSError):
        most = int(time.process_time()) + SECONDS
        resource.setrlimit(resource.RLIMIT_CPU, (most, resource.getrlimit(resource.RLIMIT_CPU)[1]))
