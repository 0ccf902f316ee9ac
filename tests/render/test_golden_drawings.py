"""Golden drawings: pictures and pages of staged scenes may change only knowingly, after somebody has looked at them.

Nothing is played, so they stay the same when play changes. Pixels belong to one version of pygame-ce and of SDL, and
to one kind of machine; with another the pictures are left out, which the test says. After a wanted change,
`python -m tests.render.test_golden_drawings FOLDER` writes all pictures and texts into a folder, to look at, and
prints the new table.
"""

import hashlib
import platform
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from soccer_env.render import save_png
from tests.render import golden_frames, golden_overlays, golden_pages

MACHINE = "Linux x86_64"
DRAWN_WITH = "pygame-ce 2.5.8, SDL 2.32.10"
PICTURES: dict[str, Callable[[], np.ndarray]] = {
    scene.__name__: scene for scene in (*golden_frames.SCENES, *golden_overlays.SCENES, *golden_pages.SCENES)
}
TEXTS: dict[str, Callable[[], str]] = {scene.__name__: scene for scene in golden_pages.TEXTS}
GOLDEN = {
    "legged_play": "3b9579f9cbdf59950956544cc8bb5a20",
    "middle_play": "df437720f7a48647c63a47b4c4a7ac9f",
    "legged_small": "df834a548b58075714f560787e4ff409",
    "middle_large": "4e16130c03b406ae582c2271fb5eec09",
    "pitches": "398b19355d015b5070314bd2e54cd77b",
    "headers": "f1b41e6890783f490baebeb7e11103e1",
    "shapes": "09cba351692b4abf9dee3415cc3ed900",
    "closeups": "667582d7125ddb8bda6ed4768fc04be4",
    "words": "02c6364477aabe5c06db5f40d2aee49d",
    "sheet": "db97e5c99f922e4ae5402c7856baf633",
    "legged_mind": "148f6433f496348a22bdac0fed590df7",
    "legged_other_way": "4fad32dfa9900b83616c93c2f3d79a4e",
    "middle_mind": "aa8312274fd6eb09556df287f05cc483",
    "middle_other_way": "8c59bb503d218b10dbe9638ac890b2c7",
    "crowd": "142a1d318f76ab60e36422e1e55aaa1a",
    "corners": "b508588a1a7b3381c56d45923247cd8c",
    "missing": "f01902b7ef31df3e47605fc6c0b10539",
    "film": "273fff4efbebb2cb318f11e5ace7c550",
    "live": "8050c53ee7668840310af2a06a9bc41a",
    "legged_page": "4e11afb13cc2b1889177737f191dd405",
    "middle_page": "a59eb003fc017f244c50f4a6ee8b5e98",
    "page_of_the_truth": "00fb6b75be64d38c89d6309b89bc8aca",
    "notes": "bc79a37a0e3557c41c19480b554e97ae",
    "casts": "e1db70de67873592d840033d40489546",
}
RENEW = "python -m tests.render.test_golden_drawings FOLDER"


def drawing_library() -> str:
    import pygame

    return f"pygame-ce {pygame.version.ver}, SDL {'.'.join(map(str, pygame.get_sdl_version()))}"


def machine() -> str:
    return f"{platform.system()} {platform.machine()}"


def digest(found: np.ndarray | str) -> str:
    content = found.encode() if isinstance(found, str) else f"{found.shape} {found.dtype} ".encode() + found.tobytes()
    return hashlib.md5(content).hexdigest()


def kept(name: str, found: np.ndarray | str, folder: Path) -> Path:
    """Write a picture or a text into a folder and return its path."""
    path = folder / f"{name}{'.txt' if isinstance(found, str) else '.png'}"
    if isinstance(found, str):
        path.write_text(found, encoding="utf-8")
    else:
        save_png(found, path)
    return path


def compare(name: str, found: np.ndarray | str, folder: Path) -> None:
    """Fail unless a scene is as it was, and say where to look and how to renew its hash."""
    if digest(found) != GOLDEN[name]:
        pytest.fail(f"{name} has changed: look at {kept(name, found, folder)}; if it is right: {RENEW}", pytrace=False)


@pytest.mark.skipif(machine() != MACHINE, reason=f"made on {MACHINE}")
@pytest.mark.parametrize("name", PICTURES)
def test_a_picture_has_not_changed_unnoticed(name: str, tmp_path: Path) -> None:
    pytest.importorskip("pygame")
    if drawing_library() != DRAWN_WITH:
        pytest.skip(f"drawn with {DRAWN_WITH}, this is {drawing_library()}")
    compare(name, PICTURES[name](), tmp_path)


@pytest.mark.skipif(machine() != MACHINE, reason=f"made on {MACHINE}")
@pytest.mark.parametrize("name", TEXTS)
def test_a_page_and_what_it_is_made_of_have_not_changed_unnoticed(name: str, tmp_path: Path) -> None:
    compare(name, TEXTS[name](), tmp_path)


if __name__ == "__main__":
    print(f"{drawing_library()}, {machine()}")
    for scene, make in {**PICTURES, **TEXTS}.items():
        made = make()
        kept(scene, made, Path(sys.argv[1]))
        print(f'    "{scene}": "{digest(made)}",')
