"""Paths to no policy file, and files full of faults: read, or refused in one line."""

import os
import socket
from pathlib import Path
from typing import Any

import pytest

from soccer_env.agents.policy_file import load
from tests.agents.staged_files import GOOD, assert_refused_by


def refuses(path: Any, reason: str) -> None:
    assert_refused_by(lambda: load(path), reason, "policy file ")


def test_what_is_no_file_is_refused(tmp_path: Path) -> None:
    refuses(tmp_path, "is a folder")
    refuses(tmp_path / "none", "No such file")
    refuses("a\0b", "null")
    refuses("a\n" * 5000, "name too long")
    refuses(0, "not int")  # no reading from standard input
    refuses(None, "not NoneType")
    (tmp_path / "empty").touch()
    refuses(tmp_path / "empty", "0 bytes")
    (tmp_path / "good").write_bytes(GOOD)
    load(str(tmp_path / "good"))


@pytest.mark.skipif(os.name != "posix", reason="links, pipes and devices of Unix")
def test_links_pipes_and_devices_do_not_hang(tmp_path: Path) -> None:
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    refuses(tmp_path / "a", "symbolic links")
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("pipe")
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(os.path.relpath(tmp_path / "socket"))
    for strange in (tmp_path / "pipe", tmp_path / "link", tmp_path / "socket", "/dev/zero"):
        refuses(strange, "is not a regular file")


def test_a_sparse_giant_is_not_read(tmp_path: Path) -> None:
    with (tmp_path / "giant").open("wb") as file:
        file.truncate(2**40)
    refuses(tmp_path / "giant", "has 1099511627776 bytes, more than the limit")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="children of Unix")
def test_faulty_files_are_refused_in_one_line_and_end_no_process() -> None:
    pytest.importorskip("onnx")
    pytest.importorskip("onnxruntime")
    from tests.agents.fuzzed_files import fuzz

    assert fuzz(500) == 0
