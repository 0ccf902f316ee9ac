"""Policies, zips, ONNX files and settings with faults in them: refused in one plain line, or read; nothing else.

Each runs in a forked child whose end is watched: a signal, a hang, an error of another kind is a finding.

    python -m tests.agents.fuzzed_files 20000
"""

from __future__ import annotations

import contextlib
import faulthandler
import os
import resource
import signal
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.agents.onnx_team import OnnxPolicy
from soccer_env.agents.policy_file import load
from soccer_env.train.evaluate.map_pictures import of_result
from soccer_env.train.ppo.toml_file import BUNDLED, settings_of
from tests.agents.staged_files import GOOD
from tests.agents.staged_onnx import array, node, small
from tests.agents.staged_zips import plain_zip, read

SEED, LIMIT, MEMORY = 31, 20, 6 * 2**30  # LIMIT [s] for one file, MEMORY [bytes]
PIECES = (
    b"\0" * 8, b"\xff" * 8, b"\x80", b"\x7f\xff\xff\xff", b"[" * 3000, b"1e999", b"9" * 5000, b"NaN", b'"', b"\n", b"{",
)  # fmt: skip
ROWS = np.linspace(-1.0, 1.0, 12, dtype=np.float32).reshape(3, 4)


def sources(folder: Path) -> dict[str, tuple[bytes, Callable[[Path], Any]]]:
    """Return a good file of each kind by its ending, and what reads it; zips only where torch is installed."""
    nodes = [node("Shape", "x", "s"), node("Reshape", "x s", "r"), node("Gather", "r i", "g", axis=1)]
    nodes += [node("Concat", "g x", "c", axis=1), node("Slice", "c a b", "d")]
    nodes += [node("Softmax", "d", "e"), node("Tile", "e t", "y")]
    constants = [array("i", 0, 1), array("a", 0, 0), array("b", 3, 4), array("t", 1, 1)]
    maps = b'{"home": "a", "away": "b", "maps": {"heat_for": [[1, 2]], "heat_against": 3, "players_for": {}}}'
    found: dict[str, tuple[bytes, Callable[[Path], Any]]] = {
        "safetensors": (GOOD, load),
        "onnx": (small(*nodes, constants=constants).SerializeToString(), lambda path: plays(path.read_bytes())),
        "toml": (BUNDLED.joinpath("legged-2001.toml").read_bytes(), settings_of),
        "json": (maps, of_result),
    }
    with contextlib.suppress(ImportError):
        found["zip"] = plain_zip(folder).read_bytes(), read
    return found


def plays(content: bytes) -> None:
    """Let the network of an ONNX file decide."""
    OnnxPolicy(content, "fuzzed.onnx")(ROWS)


def faulty(good: bytes, rng: np.random.Generator) -> bytes:
    """Return a file with one to eight faults: bits, cuts, parts twice or elsewhere, and what parsers stumble over."""
    content = bytearray(good)
    for _ in range(int(rng.integers(1, 9))):
        a, b = sorted(rng.integers(0, len(content) + 1, 2).tolist())
        kind = int(rng.integers(6))
        if kind == 0 and content:
            content[min(a, len(content) - 1)] ^= 1 << int(rng.integers(8))
        elif kind == 1 and content:
            content[min(a, len(content) - 1)] = int(rng.integers(256))
        elif kind == 2:
            content[a:a] = PIECES[int(rng.integers(len(PIECES)))]
        elif kind == 3:
            content[a:a] = content[a : min(b, a + 64)]
        elif kind == 4:
            del content[a : min(b, a + 16)]
        elif rng.random() < 0.2:
            del content[a:]
    return bytes(content)


def complaint(use: Callable[[Path], Any], path: Path) -> str:
    """Return what is wrong with how a file is read: "" if it is, or is refused in one plain line."""
    try:
        use(path)
    except ValueError as error:
        line = str(error)
        return "" if path.name in line or "fuzzed.onnx" in line else f"names no file: {line!r}"
    except BaseException as error:
        return f"{type(error).__name__}: {error!r}"
    return ""


def watched(use: Callable[[Path], Any], path: Path, count: int) -> int:
    """Read the numbered files from this one on in a child, until one is a finding; return its number, or `count`."""
    reading, writing = os.pipe()
    child = os.fork()
    if not child:
        run_child(use, path, count, writing)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        at = int(path.stem) + len(pipe.read())
    status = os.waitpid(child, 0)[1]
    if os.WIFSIGNALED(status):
        print(f"{path.with_stem(str(at)).name}: signal {os.WTERMSIG(status)}", file=sys.stderr, flush=True)
    return at


def run_child(use: Callable[[Path], Any], path: Path, count: int, writing: int) -> None:
    """Read files one after the other; write a byte for each, and end the process."""
    faulthandler.disable()
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    for number in range(int(path.stem), count):
        signal.alarm(LIMIT)
        found = complaint(use, path.with_stem(str(number)))
        if found:
            print(found, file=sys.stderr, flush=True)
            os._exit(1)
        os.write(writing, b".")
    os._exit(0)


def fuzz(count: int, seed: int = SEED, keep: Path | None = None) -> int:
    """Read `count` faulty files, shared out among the kinds; return the number of findings, which `keep` keeps."""
    rng, findings = np.random.default_rng(seed), 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        kinds = sources(folder)
        for kind, (good, use) in kinds.items():
            share = count // len(kinds)
            for number in range(share):
                (folder / f"{number}.{kind}").write_bytes(faulty(good, rng))
            at = 0
            while (at := watched(use, folder / f"{at}.{kind}", share)) < share:
                findings += 1
                if keep is not None:
                    (keep / f"{seed}-{at}.{kind}").write_bytes((folder / f"{at}.{kind}").read_bytes())
                at += 1
    return findings


def main(count: int) -> int:
    found = fuzz(count, keep=Path())
    print(f"{count} faulty files of policies and settings: {found} findings")
    return int(found > 0)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1])))
