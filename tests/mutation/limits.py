"""A plugin of pytest that ends a process whose test takes too much time or memory, and says in a file which it was."""

import contextlib
import os
import resource
import time
from pathlib import Path

SECONDS, BYTES = 200, 12 << 30  # of processor time for one test, compiling included; of memory for a process


def pytest_runtest_logstart(nodeid: str) -> None:
    """Give the test that begins its time."""
    Path(os.environ["SOCCER_MUTANT_TEST"]).write_text(nodeid, encoding="utf-8")
    for limit, most in ((resource.RLIMIT_CPU, int(time.process_time()) + SECONDS), (resource.RLIMIT_DATA, BYTES)):
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(limit, (most, resource.getrlimit(limit)[1]))
