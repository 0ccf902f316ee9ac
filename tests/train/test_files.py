"""Files survive crashes: a torn last line is dropped, a file is whole or untouched."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from soccer_env.train.files import LARGEST, append_lines, read_lines


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


def test_a_broken_line_in_the_middle_is_refused_and_kept(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.write_bytes(b'{"a": 1}\n{"a": \n{"a": 3}\n')
    with pytest.raises(ValueError, match="line 2: not a record"):
        read_lines(path)
    assert path.read_bytes().count(b"\n") == 3


def test_a_file_without_end_is_not_read(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.touch()
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
