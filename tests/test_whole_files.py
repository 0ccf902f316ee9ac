"""A file is written whole or not at all."""

import os
import threading
from pathlib import Path
from typing import Any

import pytest

from soccer_env.guards.whole_files import atomic_file, atomic_folder, write_atomically


def test_a_file_is_replaced_whole_and_a_failed_write_leaves_the_old_one(tmp_path: Path, monkeypatch: Any) -> None:
    path = tmp_path / "result.json"
    write_atomically(path, "older")
    write_atomically(path, b"old")
    assert path.read_text() == "old"

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left on device: '.*result.json'"):
        write_atomically(path, "new")
    assert path.read_text() == "old"
    assert os.listdir(tmp_path) == ["result.json"]


def test_a_folder_is_replaced_whole_and_one_that_fails_leaves_the_old_one(tmp_path: Path, monkeypatch: Any) -> None:
    path = tmp_path / "match.cdf"
    for content in ("older", "old"):
        with atomic_folder(path) as aside:
            (aside / content).write_text(content)
    assert os.listdir(path) == ["old"]
    with pytest.raises(KeyError), atomic_folder(path) as aside:
        (aside / "new").write_text("new")
        raise KeyError
    rename = os.rename

    def full(source: Path, target: Path) -> None:
        if source.suffix == ".tmp":
            raise OSError(28, "No space left on device")
        rename(source, target)

    monkeypatch.setattr(os, "rename", full)
    with pytest.raises(OSError, match="No space left"), atomic_folder(path):
        pass
    assert os.listdir(path) == ["old"]
    assert os.listdir(tmp_path) == ["match.cdf"]


def test_the_file_written_aside_follows_no_link(tmp_path: Path, monkeypatch: Any) -> None:
    """Somebody who guesses its name could have a file of the user's written over."""
    mine, path = tmp_path / "mine", tmp_path / "result.json"
    mine.write_text("mine")
    (tmp_path / f".result.json.{os.getpid()}.tmp").symlink_to(mine)
    write_atomically(path, "new")
    monkeypatch.setattr("soccer_env.guards.whole_files.token_hex", lambda _: "guessed")
    (tmp_path / ".result.json.guessed.tmp").symlink_to(mine)
    with pytest.raises(FileExistsError, match="result.json"):
        write_atomically(path, "newer")
    assert (mine.read_text(), path.read_text()) == ("mine", "new")


def test_threads_that_write_one_file_leave_one_of_the_contents_whole(tmp_path: Path) -> None:
    path, contents = tmp_path / "result.json", [str(number) * 100_000 for number in range(8)]
    wrong: list[BaseException] = []

    def write(content: str) -> None:
        try:
            for _ in range(10):
                write_atomically(path, content)
                assert path.read_text() in contents
        except BaseException as error:
            wrong.append(error)

    threads = [threading.Thread(target=write, args=(content,)) for content in contents]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong
    assert os.listdir(tmp_path) == ["result.json"]


def test_a_new_file_has_the_rights_that_the_user_gives_new_files(tmp_path: Path) -> None:
    (tmp_path / "plain").touch()
    write_atomically(tmp_path / "whole", "")
    assert (tmp_path / "whole").stat().st_mode == (tmp_path / "plain").stat().st_mode


def test_an_error_of_another_file_keeps_its_name(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="elsewhere"), atomic_file(tmp_path / "result.json"):
        (tmp_path / "elsewhere").read_text()
