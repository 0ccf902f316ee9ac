"""`soccer bench --peers` times others and ourselves by turns, and leaves out with a reason what it cannot time."""

import json
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from soccer_env.train.bench import peers, worker
from soccer_env.train.bench.settings import BenchSettings

# A worker whose peer needs 8 us a match step, and whose leagues need 2 and 4, with the noise of a busy machine.
PRETENDED = """
import random, runpy, sys

serve = runpy.run_path({worker!r})["serve"]
draw = random.Random(1)
name, *loads = sys.argv[1:]
if name == "dies":
    raise ImportError("no module named dies")
seconds = {{"legged-2001": 2e-6, "middle-size-2006": 4e-6}} if name == "soccer_env" else {{name: 8e-6}}

def timer(mean):
    print("what a peer says while it starts")
    if name == "odd":
        raise KeyError("no such scene")
    return lambda: mean * draw.lognormvariate(0.0, 0.05)

rows = {{}}
for load in loads:
    for one, mean in seconds.items():
        rows[f"{{one}} {{load}}".replace("x", " ")] = lambda mean=mean: timer(mean)
serve(rows)
"""


@pytest.fixture
def script(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr(peers, "install", lambda peer: Path(sys.executable))
    (tmp_path / "script.py").write_text(PRETENDED.format(worker=worker.__file__), encoding="utf-8")
    return tmp_path / "script.py"


FAST = peers.Peer("fast", "Fast 1.0", (), 10.0, ((32, 1), (512, 2)))


def test_ratios_are_ours_over_theirs_with_their_intervals(script: Path, tmp_path: Path) -> None:
    out = tmp_path / "sub" / "bench.json"
    report = peers.compare_peers(BenchSettings(quick=True, peers=True, out=out), (FAST,), script)
    assert [row["name"] for row in report["rows"]] == [
        "legged-2001 over Fast 1.0, 32 at a time, 1 thread", "middle-size-2006 over Fast 1.0, 32 at a time, 1 thread",
        "legged-2001 over Fast 1.0, 512 at a time, 2 threads",
        "middle-size-2006 over Fast 1.0, 512 at a time, 2 threads",
    ]  # fmt: skip
    for row, ratio, rate in zip(report["rows"], (4.0, 2.0) * 2, (16, 50) * 2, strict=True):
        assert 0.9 * ratio < row["low"] < row["ratio"] < row["high"] < 1.1 * ratio
        assert row["theirs"] == pytest.approx(125_000, rel=0.1)
        assert row["their_seconds"] == pytest.approx(row["theirs"] / 10) and row["our_seconds"] == row["ours"] / rate
    assert {len(pairs) for pairs in report["pairs"].values()} == {2 * 2 * 3}, "two a repetition, in each round"
    assert json.loads(out.read_text()) == json.loads(json.dumps(report))
    assert peers.screen_table(report).row_count == 4


def test_a_peer_that_cannot_be_timed_is_left_out_with_the_reason(script: Path) -> None:
    given = tuple(peers.Peer(name, name.title(), (), 10.0) for name in ("dies", "odd", "fine"))
    report = peers.compare_peers(BenchSettings(quick=True, peers=True), given, script)
    assert report["left_out"] == {
        "Dies": "ImportError: no module named dies", "Odd": "KeyError: 'no such scene'"
    }  # fmt: skip
    assert {row["name"].partition(" over ")[2] for row in report["rows"]} == {"Fine, 1 at a time, 1 thread"}
    assert "left out: Odd: KeyError: 'no such scene'" in str(peers.screen_table(report).caption)


def test_what_pip_cannot_install_is_left_out_and_tried_again(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    asked: list[list[str]] = []
    found = False

    def run(command: list[str], **_: Any) -> SimpleNamespace:
        asked.append(command)
        if "venv" in command:
            Path(command[-1]).mkdir(parents=True)
        missing = "pip" in command and not found
        said = "Looking\nERROR: No matching distribution found for fast==1.0\n[notice] a new pip\n"
        return SimpleNamespace(returncode=int(missing), stdout="", stderr=said)

    monkeypatch.setattr(subprocess, "run", run)
    monkeypatch.setattr(peers, "cache_folders", lambda: (tmp_path / "cache",))
    peer = peers.Peer("fast", "Fast 1.0", ("fast==1.0",), 10.0)
    with pytest.raises(peers.LeftOutError, match="cannot install it: ERROR: No matching distribution found for fast"):
        peers.install(peer)
    found = True
    assert peers.install(peer) == peers.install(peer)
    assert [command[1:3] for command in asked] == [["-m", "venv"], ["-m", "pip"]] * 2, "the last time it is there"
    assert asked[-1][-3:] == ["install", "--no-compile", "fast==1.0"]


def test_torch_is_the_version_that_the_makefile_pins() -> None:
    makefile = (Path(__file__).parents[3] / "Makefile").read_text(encoding="utf-8")
    assert f"TORCH := {peers.PEERS[0].requirements[0]}\n" in makefile
