"""Interrupt matches at random moments while their kernels are compiled, and tell how each interrupt ended.

Each process begins with an empty cache, makes a match, lets it decide, step and reset, each again and again until it
gets to its end, and sends itself Ctrl-C meanwhile. An interrupt has to end what it falls in within LIMIT of processor
time and to leave the match as it was. At the end the match stands as one does that nothing has interrupted.

    python -m tests.guards.interrupted_compiling 300 [SEED]    so many interrupts, and a line for each process
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import textwrap
from typing import Any

LIMIT = 1.0  # [s] of processor time, from an interrupt until it has ended what it fell in
MOST = 60  # interrupts of each thing that a process does
MATCH: dict[str, Any] = {"home": 1, "away": 1, "seed": 1, "senses": "ideal", "opponents": "chaser"}

INTERRUPTED = """
    import json, os, random, signal, sys, threading, time, traceback
    import numpy as np
    from numba.core.registry import cpu_target
    from soccer_env import Match
    from soccer_env.compiling.inner import Kernel
    from soccer_env.compiling.stops import compiling

    settings, seed, most = json.loads(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
    draw = random.Random(seed)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    unraisable = []
    sys.unraisablehook = unraisable.append
    kernels = []
    begun = Kernel.__init__
    Kernel.__init__ = lambda self, *a, **k: (kernels.append(self), begun(self, *a, **k))[1]
    slow = 0.9  # [s] from which on it is said where the main thread was
    at = []  # where the main thread was
    ended = []  # [s] of processor time that each interrupt took
    lost = 0

    def clean():
        assert not cpu_target.typing_context.callstack._stack, "numba believes that it compiles"
        assert not any(kernel._compiling_counter.counter for kernel in kernels), "a kernel counts itself"
        assert compiling.depth == 0 and not compiling.stoppable, "depth"
        assert not unraisable, unraisable

    def until_done(do):
        global lost
        for _ in range(most):
            sent = []
            def press():
                at.append("".join(traceback.format_stack(sys._current_frames()[threading.main_thread().ident])[-7:]))
                sent.append(time.process_time())
                os.kill(os.getpid(), signal.SIGINT)
            timer, made = threading.Timer(10.0 ** draw.uniform(-2.0, 1.2), press), []
            try:
                timer.start()
                made.append(do())
                timer.cancel()
                timer.join()
                time.sleep(0.001)  # one that was just sent comes
                lost += len(sent)
            except KeyboardInterrupt:
                if not made:
                    ended.append(time.process_time() - sent[0])
                    if ended[-1] > slow:
                        print(f"{ended[-1]:.2f} s after", at[-1], file=sys.stderr)
            timer.join()
            clean()
            if made:
                return made[0]
        return do()

    def unchanged(do):
        def done():
            before = match.state_hash()
            try:
                return do()
            except KeyboardInterrupt:
                assert match.state_hash() == before, "it has changed"
                raise
        return done

    hashes = []
    match = until_done(lambda: Match(**settings))
    actions = np.random.default_rng(1).uniform(-1.0, 1.0, (1, settings["home"] + settings["away"], 4))
    for name, do in [
        ("decide", unchanged(match.decide)),
        ("step", unchanged(lambda: match.step(actions))),
        ("reset", lambda: match.reset(seed=2)),
        ("step", unchanged(lambda: match.step(actions))),
    ]:
        until_done(do)
        hashes.append(match.state_hash())
    for _ in range(20):
        match.step(actions)
    print(json.dumps([ended, lost, [*hashes, match.state_hash()]]))
"""


def played(settings: dict[str, Any], cache: str, seed: int, most: int) -> tuple[list[float], int, Any]:
    """Play in a process of its own, with at most so many interrupts of each thing.

    Return what they took [s], how many came too late to end anything, and the hashes of the match on its way.
    """
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(INTERRUPTED), json.dumps(settings), str(seed), str(most)],
        env={**os.environ, "SOCCER_ENV_CACHE": cache, "TMPDIR": cache, "SOCCER_ENV_QUIET": "1"},
        capture_output=True, text=True, timeout=1800, check=False,
    )  # fmt: skip
    assert done.returncode == 0, (done.returncode, done.stderr)
    print(done.stderr, end="", file=sys.stderr)
    ended, lost, hashes = json.loads(done.stdout)
    return ended, lost, hashes


def main() -> None:
    wanted, seed = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1
    took: list[float] = []
    expected = None
    while len(took) < wanted:
        with tempfile.TemporaryDirectory() as cache:
            ended, lost, hashes = played(MATCH, cache, seed, MOST)
            if expected is None:
                _, _, expected = played(MATCH, cache, 0, 0)
        assert hashes == expected, ("it plays otherwise", seed, hashes, expected)
        took += ended
        late = sum(seconds > LIMIT for seconds in ended)
        longest = max(ended, default=0.0)
        print(f"seed {seed}: {len(ended)} interrupts, {lost} lost, {late} late, longest {longest:.2f} s", flush=True)
        seed += 1
    ordered = sorted(took)
    print(f"{len(took)} interrupts: median {ordered[len(took) // 2]:.3f} s, longest {ordered[-1]:.2f} s")
    sys.exit(1 if ordered[-1] > LIMIT else 0)


if __name__ == "__main__":
    main()
