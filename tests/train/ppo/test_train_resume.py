"""A run that is cut goes on as if it had not been: killed, out of room on the disk, or damaged by others."""

import hashlib
import io
import itertools
import json
import os
import pickle
import re
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import pytest
import torch

from soccer_env.train.ppo.checkpoints import LATEST, NAMES, read_checkpoint
from tests.agents.staged_zips import Canary
from tests.train.ppo.staged_training import ROLLOUT, copy_of, outcome, records, tiny_settings, train_plainly, whole_run

ROOT = Path(__file__).parents[3]

# Trains in one child process after the other until one gets to the end. A child is cut: killed by its parent after a
# random time ("moment"), by itself in the middle of a write to the disk, the last bytes of which are then lost, as in a
# power failure ("write"), or by having no more room on the disk from some write on ("full").
CUTTING = r"""
import os, random, resource, signal, sys, time, traceback
from pathlib import Path
from soccer_env.train.ppo import training
from tests.train.ppo.staged_training import train_plainly, tiny_settings
from soccer_env.train.ppo.checkpoints import read_latest

training.CHECKPOINT_SHARE = 1e9  # one after each rollout, however short it is

base, cuts, draw, sync = Path(sys.argv[1]), sys.argv[2].split(","), random.Random(5), os.fsync
rollouts = 3 * len(cuts)
longer = {"steps": rollouts * 48, "evaluate_every": 400}
started = time.monotonic()
train_plainly(tiny_settings(base / "whole", **longer))
duration = time.monotonic() - started
settings = tiny_settings(base / "cut", **longer)
log = settings.out / "log.jsonl"

def lines():
    return log.read_bytes().count(b"\n") if log.exists() else 0

def tear(handle):
    try:
        os.ftruncate(handle, max(0, os.fstat(handle).st_size - 9))
    except OSError:
        pass  # a folder
    os.kill(os.getpid(), signal.SIGKILL)

def fill(handle):
    resource.setrlimit(resource.RLIMIT_FSIZE, (600, resource.RLIM_INFINITY))

def hook(number, act):
    left = [number]
    def fsync(handle):
        left[0] -= 1
        if left[0] == 0:
            act(handle)
        sync(handle)
    os.fsync = fsync

def child(cut):
    if cut in ("write", "full"):
        hook(draw.randrange(3, 23), tear if cut == "write" else fill)
    try:
        train_plainly(settings)
    except OSError:
        os._exit(2)
    except BaseException:
        traceback.print_exc()
        os._exit(1)
    os._exit(0)

for cut in [*cuts, "not"]:
    moment, before = draw.uniform(0.0, 2.0) * duration / rollouts, lines()
    process = os.fork()
    if not process:
        child(cut)
    if cut == "moment":
        while lines() == before and before < rollouts:
            time.sleep(0.002)
        time.sleep(moment)
        os.kill(process, signal.SIGKILL)
    status = os.waitpid(process, 0)[1]
    print(cut, os.waitstatus_to_exitcode(status), read_latest(settings.out).get("step", -1), lines(), flush=True)
"""
CUTS = ["write", "moment", "full"]


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="needs SIGKILL")
def test_a_run_cut_again_and_again_ends_as_one_that_was_not(tmp_path: Path) -> None:
    rollouts = 3 * len(CUTS)
    words = [sys.executable, "-c", CUTTING, str(tmp_path), ",".join(CUTS)]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, timeout=300, check=False)
    said = done.stdout + done.stderr
    assert done.returncode == 0, said
    ends = [(cut, *map(int, numbers)) for cut, *numbers in map(str.split, done.stdout.splitlines())]
    assert sum(code != 0 for _, code, _, _ in ends) >= len(CUTS) // 2, said
    for cut, code, step, lines in ends:
        assert code in (0, {"full": 2, "not": 0}.get(cut, -9)), said
        assert step >= (lines - 1) * ROLLOUT, f"more than one rollout was lost\n{said}"
        assert code != 0 or step == rollouts * ROLLOUT, said
    steps = [step for _, _, step, _ in ends]
    assert steps == sorted(steps) and len(set(steps)) > len(CUTS) // 2, said
    assert outcome(tmp_path / "cut") == outcome(tmp_path / "whole")
    assert_whole_logs(tmp_path / "cut", rollouts=rollouts, evaluations=[0, 432])
    assert not list((tmp_path / "cut").glob(".*.tmp")), "what a kill left half written is removed"


def assert_whole_logs(folder: Path, rollouts: int = 7, evaluations: Sequence[int] = (0, 192, 336)) -> None:
    steps = [line["step"] for line in records(folder / "log.jsonl")]
    assert steps == [ROLLOUT * number for number in range(1, rollouts + 1)]
    table = (folder / "progress.csv").read_text().splitlines()
    assert [line.split(",")[0] for line in table] == ["step", *map(str, steps)]
    assert len({line.count(",") for line in table}) == 1
    assert [one["step"] for one in records(folder / "evaluations.jsonl")] == list(evaluations)


@pytest.fixture
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a finished run, which is not to be changed."""
    return whole_run(tmp_path_factory)


@pytest.fixture
def run(tmp_path: Path, whole: Path) -> Path:
    """Return a copy of the folder of a finished run."""
    return copy_of(whole, tmp_path)


def newest(folder: Path) -> Path:
    return folder / json.loads((folder / LATEST).read_text())["file"]


def with_bytes(change: Callable[[bytes], bytes]) -> Callable[[Path], Path]:
    def damage(folder: Path) -> Path:
        newest(folder).write_bytes(change(newest(folder).read_bytes()))
        return newest(folder)

    return damage


def flipped(content: bytes) -> bytes:
    middle = len(content) // 2
    return content[:middle] + bytes([content[middle] ^ 4]) + content[middle + 1 :]


def remove(folder: Path) -> Path:
    newest(folder).unlink()
    return folder / LATEST


def overwritten(name: str, content: str) -> Callable[[Path], Path]:
    def damage(folder: Path) -> Path:
        (folder / name).write_text(content)
        return folder / name

    return damage


def signed(content: bytes) -> Callable[[Path], Path]:
    """Return what puts content in place of the checkpoint, with the sha256 that belongs to it."""

    def damage(folder: Path) -> Path:
        (folder / NAMES[0]).write_bytes(content)
        about = {"file": NAMES[0], "sha256": hashlib.sha256(content).hexdigest(), "step": 336}
        (folder / LATEST).write_text(json.dumps(about))
        return folder / NAMES[0]

    return damage


def torch_bytes(value: Any) -> bytes:
    file = io.BytesIO()
    torch.save(value, file)
    return file.getvalue()


@pytest.mark.parametrize(
    "damage",
    [
        with_bytes(flipped),
        with_bytes(lambda content: content[:-1]),
        remove,
        *(overwritten(LATEST, content) for content in ("", "[]", "[" * 100_000)),
        overwritten(LATEST, '{"file": "../whole/checkpoint-0.pt", "sha256": ""}'),
        overwritten(LATEST, '{"file": ["checkpoint-0.pt"], "sha256": ""}'),
        overwritten("settings.json", '{"league": '),
        overwritten("settings.json", "[]"),
        overwritten("log.jsonl", '{"step": 48}\n{"step": \n{"step": 96}\n'),
        overwritten("log.jsonl", '{"stop": 48}\n'),
        overwritten("evaluations.jsonl", '{"step": "many"}\n'),
        *map(signed, (b"", b"PK" * 100, torch_bytes([1, 2]))),
    ],
)
def test_a_damaged_run_is_refused_by_file_and_nothing_is_lost(run: Path, damage: Callable[[Path], Path]) -> None:
    culprit = damage(run)
    before = {path.name: path.read_bytes() for path in run.iterdir()}
    with pytest.raises(ValueError, match=re.escape(str(culprit))):
        train_plainly(tiny_settings(run, steps=400))
    assert {path.name: path.read_bytes() for path in run.iterdir()} | before == before
    assert set(before) == {path.name for path in run.iterdir()}


@pytest.mark.parametrize("write", [torch_bytes, lambda value: pickle.dumps(value, 2)])
def test_a_checkpoint_never_runs_code(run: Path, tmp_path: Path, write: Callable[[Any], bytes]) -> None:
    canary = tmp_path / "canary"
    content = write({"network": Canary(canary)})
    pickle.loads(pickle.dumps(Canary(canary)))
    assert canary.exists(), "the canary works where pickles are run"
    canary.rmdir()
    signed(content)(run)
    with pytest.raises(ValueError, match="no checkpoint of plain values"):
        train_plainly(tiny_settings(run, steps=400))
    assert not canary.exists()


@pytest.mark.parametrize("lacking", ["network", "matches", "curriculum", "generators", "stage"])
def test_a_checkpoint_that_lacks_something_is_refused(run: Path, lacking: str) -> None:
    state = torch.load(newest(run), weights_only=True)
    del state[lacking]
    signed(torch_bytes(state))(run)
    with pytest.raises(ValueError, match=f"is not of this run as it is now .*{lacking}"):
        train_plainly(tiny_settings(run, steps=400))


def test_a_checkpoint_of_another_network_is_refused(run: Path, tmp_path: Path) -> None:
    found = json.loads((run / "settings.json").read_text())
    (run / "settings.json").write_text(json.dumps(found | {"conditions": found["conditions"] | {"hidden": "9"}}))
    with pytest.raises(ValueError, match="is not of this run as it is now"):
        train_plainly(tiny_settings(run, hidden="9"))


def test_a_torn_last_line_of_a_log_is_dropped(run: Path) -> None:
    for name in ("log.jsonl", "evaluations.jsonl"):
        with (run / name).open("ab") as file:
            file.write(b'{"step": 38')
    (run / "progress.csv").write_text("step\n1,")
    train_plainly(tiny_settings(run))
    assert_whole_logs(run)


@pytest.mark.parametrize("write", [2, 15, 23])
def test_a_full_disk_leaves_the_last_good_checkpoint(tmp_path: Path, whole: Path, monkeypatch: Any, write: int) -> None:
    writes, sync = itertools.count(1), os.fsync

    def full(handle: int) -> None:
        if next(writes) > write:
            raise OSError(28, "No space left on device")
        sync(handle)

    with monkeypatch.context() as patched:
        patched.setattr(os, "fsync", full)
        with pytest.raises(OSError, match="No space left"):
            train_plainly(tiny_settings(tmp_path / "run"))
    state = read_checkpoint(tmp_path / "run")
    assert (state is None) == (write == 2)
    train_plainly(tiny_settings(tmp_path / "run"))
    assert outcome(tmp_path / "run") == outcome(whole)
    assert_whole_logs(tmp_path / "run")
