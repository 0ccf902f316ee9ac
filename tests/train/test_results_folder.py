"""A folder of results goes on where it was, refuses other settings, leaves others alone; files survive crashes."""

import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from soccer_env.train.evaluate.results import EVALUATION
from soccer_env.train.files import LARGEST, append_lines, read_lines
from soccer_env.train.papers.results import REPRODUCTION
from soccer_env.train.ppo.run_folder import TRAINING
from soccer_env.train.results_folder import SETTINGS, ResultsFolder, RunKind

MADE = {"soccer_env": "1.0", "code": "abc"}
ABOUT = {"command": "soccer evaluate --seed 3", "date": "2026-01-02", "commit": "1234567"}
ASKED: dict[str, Any] = {"seed": 3, "minutes": 10.0, "players": (3, 3)}
TOSSES = RunKind("a toss", ("seed",), ("tosses.jsonl", "report.md"), lambda asked: [f"plots/{asked['seed']}-*.png"])


@dataclass(frozen=True)
class Toss:
    """A finished part."""

    number: int
    heads: bool
    settings: str


def opened(path: Path, **changes: Any) -> ResultsFolder:
    """Return the folder of a run; changes of its conditions, `made` and `anew` by name."""
    made, anew, about = changes.pop("made", MADE), changes.pop("anew", False), changes.pop("about", ABOUT)
    return ResultsFolder(path, TOSSES, ASKED | changes, made, about, anew)


def tosses(folder: ResultsFolder) -> list[Toss]:
    return list(folder.results("tosses.jsonl", Toss, "number").values())


def tossed(folder: ResultsFolder, *numbers: int, settings: str = "") -> list[Toss]:
    made = [Toss(number, number % 2 == 0, settings or folder.settings) for number in numbers]
    folder.add("tosses.jsonl", made)
    return made


def test_a_folder_remembers(tmp_path: Path) -> None:
    made = tossed(opened(tmp_path / "a" / "b"), 1, 2)
    again = opened(tmp_path / "a" / "b", about={"command": "another", "date": "later", "commit": ""})
    assert tosses(again) == made
    assert again.about == ABOUT, "the report must not change because it is written on another day"


def test_settings_without_end_are_not_read(tmp_path: Path) -> None:
    with opened(tmp_path):
        os.truncate(tmp_path / SETTINGS, LARGEST + 1)
    with pytest.raises(ValueError, match=f"settings.json cannot be read .* more than the limit of {LARGEST}"):
        opened(tmp_path)


def test_without_a_path_nothing_is_kept() -> None:
    folder = ResultsFolder(None, TOSSES, ASKED, MADE, ABOUT)
    tossed(folder, 1)
    folder.write("report.md", "x")
    folder.close()
    assert tosses(folder) == []


def test_a_torn_line_is_dropped_and_a_part_written_twice_counts_once(tmp_path: Path) -> None:
    made = tossed(opened(tmp_path), 1, 2, 1, 3)
    path = tmp_path / "tosses.jsonl"
    path.write_bytes(path.read_bytes()[:-9])
    assert tosses(opened(tmp_path)) == made[:2]


@pytest.mark.parametrize(
    ("change", "complaint"),
    [
        ({"seed": 4}, "seed 3 there, 4 now"),
        ({"minutes": 2.0, "seed": 4}, "seed 3 there, 4 now; minutes 10.0 there, 2.0 now"),
        ({"players": (3, 5)}, "players"),
        ({"made": {**MADE, "code": "def"}}, "code 'abc' there, 'def' now"),
        ({"made": {**MADE, "league": "1"}}, "league None there, '1' now"),
    ],
)
def test_other_settings_are_refused_and_each_is_named(tmp_path: Path, change: dict[str, Any], complaint: str) -> None:
    opened(tmp_path)
    with pytest.raises(ValueError, match=f"{tmp_path} holds a toss with other settings .*{complaint}"):
        opened(tmp_path, **change)


def test_a_condition_that_came_later_was_at_its_default(tmp_path: Path) -> None:
    opened(tmp_path)
    ResultsFolder(tmp_path, TOSSES, {**ASKED, "coin": "fair"}, MADE, ABOUT, defaults={"coin": "fair"})
    with pytest.raises(ValueError, match="coin 'fair' there, 'bent' now"):
        ResultsFolder(tmp_path, TOSSES, {**ASKED, "coin": "bent"}, MADE, ABOUT, defaults={"coin": "fair"})


GROWING = RunKind("a toss", ("seed",), ("tosses.jsonl", "report.md"), grows=("tosses",))


def growing(path: Path, tosses: int, **changes: Any) -> ResultsFolder:
    return ResultsFolder(path, GROWING, ASKED | {"tosses": tosses} | changes, MADE, ABOUT | {"command": f"{tosses}"})


def test_a_run_may_grow_again_and_again_and_never_shrinks(tmp_path: Path) -> None:
    tossed(growing(tmp_path, 2), 0, 1)
    for size in (4, 6):
        folder = growing(tmp_path, size)
        assert [toss.number for toss in tosses(folder)] == list(range(size - 2))
        assert {toss.settings for toss in tosses(folder)} <= {folder.settings}, "they count as this run's own"
        tossed(folder, size - 2, size - 1)
    again = growing(tmp_path, 6)
    assert len(tosses(again)) == 6 and again.about == ABOUT | {"command": "6", "grown_from": [4, 2]}
    with pytest.raises(ValueError, match="other settings .tosses 6 there, 4 now"):
        growing(tmp_path, 4)
    with pytest.raises(ValueError, match="other settings .seed 3 there, 5 now"):
        growing(tmp_path, 8, seed=5)
    assert len(tosses(growing(tmp_path, 6))) == 6
    with pytest.raises(ValueError, match="tosses 6 there, 8 now"):
        ResultsFolder(tmp_path, TOSSES, ASKED | {"tosses": 8}, MADE, ABOUT)


@pytest.mark.parametrize(
    ("line", "complaint"),
    [
        ('{"number": [], "heads": true, "settings": "a"}', r"number of a line must be a whole number, got \[\]"),
        ('{"number": 1e308, "heads": true, "settings": "a"}', "number of a line must be a whole number, got 1e\\+308"),
        ('{"number": true, "heads": true, "settings": "a"}', "number of a line must be a whole number, got True"),
        ('{"number": 1, "heads": true, "settings": 7}', "settings of a line must be a text, got 7"),
        ("[" * 100_000, "line 1: not a record"),
    ],
)
def test_a_line_that_was_written_by_hand_is_refused_in_a_line(tmp_path: Path, line: str, complaint: str) -> None:
    opened(tmp_path)
    (tmp_path / "tosses.jsonl").write_text(f"{line}\n{line}\n")
    with pytest.raises(ValueError, match=complaint):
        tosses(opened(tmp_path))


def test_lines_of_another_run_or_of_other_things_are_refused(tmp_path: Path) -> None:
    tossed(opened(tmp_path), 1, settings="other")
    with pytest.raises(ValueError, match="tosses.jsonl: number 1 belongs to other settings"):
        tosses(opened(tmp_path))
    (tmp_path / "tosses.jsonl").write_text('{"number": 1}\n')
    with pytest.raises(ValueError, match="a line has the fields heads, number, settings, got number"):
        tosses(opened(tmp_path))


def test_anew_removes_what_the_run_left_and_nothing_else(tmp_path: Path) -> None:
    folder = opened(tmp_path)
    tossed(folder, 1)
    for name in ("report.md", "plots/3-1.png"):
        folder.write(name, "ours")
    for name in ("notes.txt", "plots/mine.png", "plots/4-1.png"):
        (tmp_path / name).write_text("mine")
    opened(tmp_path, anew=True)
    left = {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file()}
    assert left == {"settings.json", "notes.txt", "plots/mine.png", "plots/4-1.png"}


def contents(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


@pytest.mark.parametrize("anew", [False, True])
@pytest.mark.parametrize("kind", [EVALUATION, REPRODUCTION, TRAINING], ids=lambda kind: kind.what)
@pytest.mark.parametrize(
    ("files", "complaint"),
    [
        ({"report.md": "my thesis", "best.safetensors": "mine", "plots/S01-1.png": "mine"}, "but no settings.json"),
        ({"settings.json": "{}"}, "settings.json is of something else"),
        ({"settings.json": "// of my editor\n{}", "plots/mine.png": "mine"}, "settings.json cannot be read"),
    ],
)
def test_files_of_others_are_never_touched(
    tmp_path: Path, anew: bool, kind: RunKind, files: dict[str, str], complaint: str
) -> None:
    """With --anew or without, in a folder with a paper, an editor's settings or somebody's own pictures."""
    (tmp_path / "plots").mkdir()
    for name, text in files.items():
        (tmp_path / name).write_text(text)
    with pytest.raises(ValueError, match=complaint):
        ResultsFolder(tmp_path, kind, dict.fromkeys(kind.marks, ""), {}, {}, anew)
    assert contents(tmp_path).items() >= {name: text.encode() for name, text in files.items()}.items()
    assert contents(tmp_path).keys() <= {*files, ".lock"}


@pytest.mark.parametrize("owner", [EVALUATION, REPRODUCTION, TRAINING], ids=lambda kind: kind.what)
def test_a_run_never_replaces_one_of_another_kind(tmp_path: Path, owner: RunKind) -> None:
    ResultsFolder(tmp_path, owner, dict.fromkeys(owner.marks, ""), {}, {}).close()
    before = (tmp_path / "settings.json").read_bytes()
    for kind in (EVALUATION, REPRODUCTION, TRAINING):
        for anew in (False, True):
            if kind is not owner:
                with pytest.raises(ValueError, match=f"settings.json is of something else than {kind.what}"):
                    ResultsFolder(tmp_path, kind, dict.fromkeys(kind.marks, ""), {}, {}, anew)
    assert (tmp_path / "settings.json").read_bytes() == before


def test_the_current_folder_is_nobodys(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An unset shell variable gives --out "", which a path takes for the current folder."""
    monkeypatch.chdir(tmp_path)
    for path in (Path(""), Path(".")):
        with pytest.raises(ValueError, match="out must be a folder of the run's own, not the current one"):
            opened(path, anew=True)
    (tmp_path / "file").write_text("")
    with pytest.raises(ValueError, match="out: file is a file; give a folder"):
        opened(Path("file"))
    assert contents(tmp_path).keys() == {"file"}


def test_lines_come_back(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    assert read_lines(path) == []
    append_lines(path, [{"a": 1}, {"a": 2**64 - 1}])
    append_lines(path, [{"a": "line\nbreak \u2028"}])
    assert read_lines(path) == [{"a": 1}, {"a": 2**64 - 1}, {"a": "line\nbreak \u2028"}]


@pytest.mark.parametrize("torn", [b'{"a": 3', b'{"a": 3}', b"{", b"\x00" * 40, b"\x00" * 40 + b"\n", b"\xff\n", b"3\n"])
def test_a_torn_last_line_is_dropped_and_the_next_one_stands_alone(tmp_path: Path, torn: bytes) -> None:
    path = tmp_path / "lines.jsonl"
    append_lines(path, [{"a": 1}, {"a": 2}])
    with path.open("ab") as file:
        file.write(torn)
    assert read_lines(path) == [{"a": 1}, {"a": 2}]
    append_lines(path, [{"a": 4}])
    assert read_lines(path) == [{"a": 1}, {"a": 2}, {"a": 4}]


def test_a_broken_line_in_the_middle_is_refused_and_kept_and_a_file_without_end_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.write_bytes(b'{"a": 1}\n{"a": \n{"a": 3}\n')
    with pytest.raises(ValueError, match="line 2: not a record"):
        read_lines(path)
    assert path.read_bytes().count(b"\n") == 3
    os.truncate(path, LARGEST + 1)  # of zeros, which take no room on the disk
    with pytest.raises(ValueError, match=f"lines.jsonl has {LARGEST + 1} bytes, more than the limit of {LARGEST}"):
        read_lines(path)


@pytest.mark.skipif(os.name != "posix", reason="needs SIGKILL")
def test_killed_while_appending_loses_at_most_the_line_in_flight(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    program = (
        "import itertools, sys\nfrom pathlib import Path\nfrom soccer_env.train.files import append_lines\n"
        "for n in itertools.count():\n    append_lines(Path(sys.argv[1]), [{'n': n, 'text': 'x' * 5000}])\n"
    )
    for _ in range(3):
        before = read_lines(path)
        run = subprocess.Popen([sys.executable, "-c", program, str(path)])
        while not path.exists() or path.stat().st_size < 100_000 + 5000 * len(before):
            assert run.poll() is None
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.wait()
        after = read_lines(path)
        assert after[: len(before)] == before
        assert [line["n"] for line in after[len(before) :]] == list(range(len(after) - len(before)))
        assert path.read_text() == "".join(json.dumps(line) + "\n" for line in after)
