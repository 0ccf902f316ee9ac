"""No folder is imported by what it imports, with baselines/, agents/ and the folders of train/ as they are imported."""

from collections import defaultdict
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

from tests.repository.test_layers import imports_of, modules_of

ROOT = Path(__file__).parents[2]
FRONTS = {"soccer_v0": "api", "gymnasium_envs": "api", "compiled": "compiling"}  # what users import, and its folder


def room_of(module: str) -> str:
    """Return the folder of soccer_env/ or train/ that holds a module, or the module, where it stands in neither's."""
    parts = module.split(".")[1:]
    room = ".".join(parts[:2] if parts[:1] == ["train"] else parts[:1])
    return FRONTS.get(room, room)


def arrows(root: Path) -> dict[str, set[str]]:
    """Return which rooms each room imports; the package's own file, which names what is public, is none."""
    files, found = modules_of(root), defaultdict(set)
    for module, file in files.items():
        for taken in imports_of(module, file):
            inner = f"{taken.module}.{taken.name}"
            room = room_of(inner if inner in files else taken.module)
            if taken.module.startswith("soccer_env") and room not in ("", room_of(module), "train"):
                found[room_of(module)].add(room)
    return {room: rooms for room, rooms in found.items() if room not in ("", "train")}


def test_no_folders_import_each_other_in_a_circle() -> None:
    try:
        TopologicalSorter(arrows(ROOT)).prepare()
    except CycleError as error:
        pytest.fail(" <- ".join(error.args[1]))


def test_a_circle_is_found(tmp_path: Path) -> None:
    for file, text in {
        "soccer_env/render/pitch.py": "def f():\n    from soccer_env.replay.file import Replay",
        "soccer_env/replay/file.py": "if TYPE_CHECKING:\n    from soccer_env.render import pitch",
        "train/evaluate/page.py": "from soccer_env.train.report import page",
    }.items():
        (tmp_path / file).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / file).write_text(text, encoding="utf-8")
    found = arrows(tmp_path)
    assert found == {"render": {"replay"}, "replay": {"render"}, "train.evaluate": {"train.report"}}
    with pytest.raises(CycleError):
        TopologicalSorter(found).prepare()
