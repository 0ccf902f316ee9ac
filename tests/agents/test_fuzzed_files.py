"""A slice of the fuzz of policies and settings; `python -m tests.agents.fuzzed_files COUNT` reads more of them."""

import os
from pathlib import Path

import pytest

pytest.importorskip("onnx")
pytest.importorskip("onnxruntime")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="children of Unix")
def test_faulty_files_are_refused_in_one_line_and_end_no_process() -> None:
    from tests.agents.fuzzed_files import fuzz

    assert fuzz(500) == 0


@pytest.mark.skipif(not hasattr(os, "fork"), reason="children of Unix")
def test_the_fuzz_sees_a_death_and_a_traceback(tmp_path: Path) -> None:
    from tests.agents.fuzzed_files import watched

    def use(path: Path) -> None:
        if path.stem == "3":
            os.abort()
        if path.stem == "5":
            raise KeyError("text")

    at, found = 0, []
    while (at := watched(use, tmp_path / f"{at}.toml", 8)) < 8:
        found.append(at)
        at += 1
    assert found == [3, 5]
