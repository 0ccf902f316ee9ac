"""Pack the code that a task needs: this package as it is here, and the user's own modules, such as those of teams."""

import hashlib
import io
import sys
import zipfile
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path, PurePosixPath

from soccer_env.compiling.sources import OUTSIDE_FOLDERS, PACKAGE, source_file

KINDS = {".py", ".json", ".toml", ".safetensors"}  # what code reads at import, and the bundled policies
BEGAN = (1980, 1, 1, 0, 0, 0)  # the date of every file of the zip, whose bytes follow from the code alone
NOT_SENT = ("__main__", "__mp_main__")  # pickled by value


def pack_code() -> tuple[str, bytes]:
    """Return the hash of the code and the zip that holds it."""
    files = dict(files_of_package())
    for name, path in own_modules():
        files[name] = path.read_bytes()
        for folder in PurePosixPath(name).parents[:-1]:
            files.setdefault(f"{folder}/__init__.py", b"")  # else an installed package of that name would win
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name in sorted(files):
            archive.writestr(zipfile.ZipInfo(name, BEGAN), files[name], zipfile.ZIP_DEFLATED)
    return hashlib.sha256(packed.getvalue()).hexdigest(), packed.getvalue()


def files_of_package() -> Iterator[tuple[str, bytes]]:
    """Yield (place in the zip, content) of each file of this package, whose folders lie apart in a checkout."""
    for name in (PACKAGE, *(f"{PACKAGE}.{folder}" for folder in OUTSIDE_FOLDERS)):
        root = Path(import_module(name).__path__[0])
        for path in root.rglob("*"):
            if path.suffix in KINDS:
                yield f"{name.replace('.', '/')}/{path.relative_to(root).as_posix()}", path.read_bytes()


def own_modules() -> Iterator[tuple[str, Path]]:
    """Yield (place in the zip, file) of each loaded module that is neither of this package nor installed."""
    for name in [*sys.modules]:
        path = source_file(name, "") if name.partition(".")[0] != PACKAGE and name not in NOT_SENT else None
        if path is not None and path.is_file():
            yield f"{name.replace('.', '/')}{'/__init__' * (path.stem == '__init__')}.py", path
