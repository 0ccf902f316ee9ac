"""Policies, zips, ONNX files and settings with faults in them: refused in one plain line, or read; nothing else.

Forked children read them, whose ends are watched: a signal, a hang, an error of another kind is a finding.

    python -m tests.agents.fuzzed_files 20000
"""

from __future__ import annotations

import contextlib
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.agents.onnx_team import OnnxPolicy
from soccer_env.agents.policy_file import load
from soccer_env.train.evaluate.map_pictures import maps_from_result
from soccer_env.train.ppo.toml_file import BUNDLED, settings_of
from tests.agents.staged_files import GOOD
from tests.agents.staged_onnx import array, node, small
from tests.agents.staged_zips import plain_zip, read
from tests.fuzz.children import Task, outcomes

SEED, GROUP = 31, 25  # files that one child reads
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
        "toml": (BUNDLED.joinpath("first-win.toml").read_bytes(), settings_of),
        "json": (maps, maps_from_result),
    }
    with contextlib.suppress(ImportError):
        found["zip"] = plain_zip(folder).read_bytes(), read
    return found


def plays(content: bytes) -> None:
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


def reading(use: Callable[[Path], Any], path: Path) -> Task:
    """Return the task to read a file, which may refuse it in one plain line that names it."""

    def read_it() -> str:
        try:
            use(path)
        except ValueError as error:
            line = str(error)
            return "" if path.name in line or "fuzzed.onnx" in line else f"names no file: {line!r}"
        return ""

    return read_it


def fuzz(count: int, seed: int = SEED, keep: Path | None = None) -> int:
    """Read `count` faulty files, shared out among the kinds; return the number of findings, which `keep` keeps."""
    rng, tasks, findings = np.random.default_rng(seed), [], 0
    with tempfile.TemporaryDirectory() as name:
        kinds = sources(Path(name))
        for kind, (good, use) in kinds.items():
            for number in range(count // len(kinds)):
                path = Path(name) / f"{seed}-{number}.{kind}"
                path.write_bytes(faulty(good, rng))
                tasks.append((path, reading(use, path)))
        for path, outcome in outcomes(tasks, GROUP):
            if outcome != "played":
                findings += 1
                print(f"{path.name}: {outcome}", file=sys.stderr, flush=True)
                if keep is not None:
                    (keep / path.name).write_bytes(path.read_bytes())
    return findings


def main(count: int) -> int:
    found = fuzz(count, keep=Path())
    print(f"{count} faulty files of policies and settings: {found} findings")
    return int(found > 0)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1])))
