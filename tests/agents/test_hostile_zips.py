"""Hostile and broken zips: one plain line that names the file, no pickle run, no bomb unpacked."""

import base64
import io
import pickle
import re
import zipfile
from collections import OrderedDict
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.sb3_zip import MAX_DATA, MAX_MEMBER
from tests.agents import staged_zips
from tests.agents.staged_zips import Canary, assert_zip_refused, pth_of, read, replace_data_pkl, rewrite_zip, state_of

torch = pytest.importorskip("torch")
pytest.importorskip("stable_baselines3")


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return staged_zips.plain_zip(tmp_path_factory.mktemp("real"))


def evil_archives(canary: Canary, state: dict[str, Any]) -> list[bytes]:
    """Return files that do harm where torch.load runs pickles."""
    legacy = io.BytesIO()
    torch.save({**state, "x": canary}, legacy, _use_new_zipfile_serialization=False)
    stacked = io.BytesIO(pth_of(state))
    with zipfile.ZipFile(stacked, "a") as archive:  # a second data.pkl, in another folder
        archive.writestr("evil/data.pkl", pickle.dumps(canary))
    again = io.BytesIO(pth_of(state))
    with zipfile.ZipFile(again, "a") as archive, pytest.warns(UserWarning, match="Duplicate name"):
        archive.writestr("archive/data.pkl", pickle.dumps(canary))
    pickles = [pickle.dumps(canary, protocol) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
    saved = [pth_of(content) for content in (canary, {**state, "x": canary}, OrderedDict(x=[canary]))]
    inside = [replace_data_pkl(state, content) for content in pickles]
    return [*pickles, *saved, *inside, legacy.getvalue(), stacked.getvalue(), again.getvalue()]


def test_pickles_in_a_zip_are_never_run(plain: Path, tmp_path: Path) -> None:
    canary, state = Canary(tmp_path / "canary"), state_of(plain)
    for content in evil_archives(canary, state):
        assert_zip_refused(rewrite_zip(plain, tmp_path / "a.zip", policy_pth=content), "policy.pth")
    serialized = base64.b64encode(pickle.dumps(canary)).decode()
    for key in ("policy_class", "lr_schedule", "policy_kwargs", "clip_range"):
        changed = {":type:": "<class 'dict'>", ":serialized:": serialized}
        read(rewrite_zip(plain, tmp_path / "a.zip", data=staged_zips.data_of(plain, **{key: changed})))  # not decoded
    evil = pickle.dumps(canary)
    others = {"pytorch_variables_pth": evil, "policy.optimizer_pth": evil, "../../canary": evil, "/canary": evil}
    read(rewrite_zip(plain, tmp_path / "a.zip", **others))  # not read
    assert not (tmp_path / "canary").exists()


def test_lies_about_sizes_are_refused(plain: Path, tmp_path: Path) -> None:
    state = {"a": torch.arange(4.0)}
    with zipfile.ZipFile(io.BytesIO(pth_of(state))) as archive:
        content = archive.read("archive/data.pkl")
    for more in (b"J\xff\xff\xff\x7f", b"K\x05"):  # a storage of more numbers than its record holds
        lying = content.replace(b"K\x04tq", more + b"tq").replace(b"K\x04\x85", more + b"\x85")
        path = rewrite_zip(plain, tmp_path / "a.zip", policy_pth=replace_data_pkl(state, lying))
        assert_zip_refused(path, "policy.pth cannot be read")
    for broken in (content[:-1], content[:50], b"", b"K\x04.", b"." * 10, b"\x80\x02h\x05."):
        path = rewrite_zip(plain, tmp_path / "a.zip", policy_pth=replace_data_pkl(state, broken))
        assert_zip_refused(path, "policy.pth")


def test_a_table_that_hides_its_own_items_is_refused(plain: Path, tmp_path: Path) -> None:
    hiding = b"\x80\x02ccollections\nOrderedDict\n)R}X\x05\x00\x00\x00itemsK\x01sb."  # OrderedDict() with items = 1
    content = replace_data_pkl(state_of(plain), hiding)
    assert_zip_refused(rewrite_zip(plain, tmp_path / "a.zip", policy_pth=content), "the parameter None and no actor")


def test_deep_nesting_does_not_crash_the_process(plain: Path, tmp_path: Path) -> None:
    for depth, reason in ((200_000, "has 200006 instructions, the limit is 4000"), (3000, "must hold tensors with")):
        nested = b"\x80\x02}" + b")" + b"\x85" * depth + b"K\x01s."  # {((((...),),),): 1}, whose key has to be hashed
        content = replace_data_pkl(state_of(plain), nested)
        assert_zip_refused(rewrite_zip(plain, tmp_path / "a.zip", policy_pth=content), reason)


def test_bombs_are_refused_before_they_unpack(plain: Path, tmp_path: Path) -> None:
    pack = zipfile.ZIP_DEFLATED
    path = rewrite_zip(plain, tmp_path / "a.zip", pack, policy_pth=bytes(MAX_MEMBER + 1))
    assert path.stat().st_size < 2**17
    assert_zip_refused(path, f"'policy.pth' would unpack to {MAX_MEMBER + 1} bytes, the limit is {MAX_MEMBER}")
    assert_zip_refused(rewrite_zip(plain, tmp_path / "a.zip", pack, data=bytes(MAX_DATA + 1)), "'data' would unpack to")
    inner = io.BytesIO()
    with zipfile.ZipFile(inner, "w", pack) as archive:
        archive.writestr("archive/data.pkl", pickle.dumps({}, 2))
        for number in range(2):
            archive.writestr(f"archive/data/{number}", bytes(MAX_MEMBER // 2 + 1))
    path = rewrite_zip(plain, tmp_path / "a.zip", policy_pth=inner.getvalue())
    assert_zip_refused(path, "tensors of policy.pth would unpack to")
    assert_zip_refused(
        rewrite_zip(plain, tmp_path / "a.zip", **{f"m{n}": b"" for n in range(1001)}), "lists more than 1000 members"
    )
    assert_zip_refused(rewrite_zip(plain, tmp_path / "a.zip", zipfile.ZIP_LZMA), "packed in a way")
    assert read(rewrite_zip(plain, tmp_path / "a.zip", pack)).name == "a"


def test_broken_zips_are_refused(plain: Path, tmp_path: Path) -> None:
    content, path = plain.read_bytes(), tmp_path / "a.zip"
    rng = np.random.default_rng(3)
    for length in (0, 1, 22, 100, *rng.integers(0, len(content), 20), len(content) - 1):
        path.write_bytes(content[:length])
        assert_zip_refused(path, "zip")
    for place in (*range(len(content) - 150, len(content), 2), *rng.integers(0, len(content), 60)):
        changed = bytearray(content)
        changed[place] ^= 0xFF
        path.write_bytes(changed)
        try:
            read(path)
        except ValueError as refusal:
            assert re.match(r"policy file '[^\n]*a.zip': ", str(refusal)) and str(refusal).isprintable()
    assert_zip_refused(rewrite_zip(plain, path, data=None), "the zip lacks the member 'data'")
    assert_zip_refused(rewrite_zip(plain, path, policy_pth=None), "the zip lacks the member 'policy.pth'")
    assert_zip_refused(tmp_path, "is a folder")
    assert_zip_refused(tmp_path / "none.zip", "No such file")
