"""The code for a cluster, and the option that asks for one; no test here needs Ray."""

import io
import sys
import zipfile
from collections.abc import Callable
from pathlib import Path

import pytest

from soccer_env.train.cluster import Tasks
from soccer_env.train.cluster.packing import pack_code
from soccer_env.train.command.parsing import read_settings
from soccer_env.train.evaluate import EvaluateSettings
from soccer_env.train.ppo.updating.matches import share_blocks


def test_the_code_has_one_hash_until_a_module_is_loaded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert pack_code() == pack_code()
    (tmp_path / "lions").mkdir()
    (tmp_path / "lions" / "my_lions.py").write_text("TEAM = 1\n")
    monkeypatch.syspath_prepend(tmp_path)
    digest, _ = pack_code()
    from lions import my_lions  # type: ignore[import-not-found]

    other, packed = pack_code()
    names = zipfile.ZipFile(io.BytesIO(packed))
    assert other != digest and my_lions.TEAM == 1
    assert names.read("lions/my_lions.py") == b"TEAM = 1\n" and names.read("lions/__init__.py") == b""
    assert {"soccer_env/train/cluster/node.py", "soccer_env/agents/policies/learned.safetensors"} <= {*names.namelist()}


@pytest.mark.parametrize(
    ("words", "address"),
    [(["--ray"], "local"), (["--ray", "--seed", "1"], "local"), (["--ray", "head:6379"], "head:6379"), ([], None)],
)
def test_ray_alone_means_a_cluster_of_this_machine(words: list[str], address: str | None) -> None:
    assert read_settings(EvaluateSettings, words, "evaluate").ray == address


def test_workers_share_the_rows_of_blocks_as_neighbours() -> None:
    assert share_blocks([64, 64, 64, 64], 2) == [slice(0, 2), slice(2, 4)]
    assert share_blocks([22, 22, 66], 2) == [slice(0, 2), slice(2, 3)]
    assert share_blocks([9, 9], 16) == [slice(0, 1), slice(1, 2)]


def test_settings_that_name_no_cluster_are_refused(soccer: Callable[..., str], monkeypatch: pytest.MonkeyPatch) -> None:
    assert "ray must be local, auto or HOST:PORT, got 'S05'" in soccer("reproduce", "--ray", "S05", code=2)
    assert "threads does not go with ray" in soccer("evaluate", "--threads", 2, "--ray", code=2)
    monkeypatch.setitem(sys.modules, "ray", None)
    assert "pip install 'soccer_env[ray]'" in soccer("evaluate", "--ray", code=2)
    with pytest.raises(ValueError, match="needs Ray"):
        Tasks("auto")
