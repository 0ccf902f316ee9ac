"""Checks of untrusted replay files, format and size, before anything is made of them."""

import io
from typing import Any
from zipfile import ZipFile

from soccer_env.match import saving
from soccer_env.match.arguments import version
from soccer_env.types import OTHER_WORLD, WORLD

FORMAT = "soccer_env replay 2"
LARGEST = 1 << 29  # [bytes] of a replay's parts, unpacked: three times a match of 22 robots over half an hour
MOST_ROBOTS = 8192  # of all matches of a replay: these take half a gigabyte of memory


def check_format(header: Any) -> None:
    """Raise ValueError for a header of another format or world; it names the version that wrote the file."""
    if not isinstance(header, dict) or "format" not in header:
        raise ValueError("it does not say which format it has")
    if header["format"] != FORMAT:
        wrote = f", written by soccer_env {str(header['version'])[:40]}" if header.get("version") else ""
        raise ValueError(
            f"its format is {str(header['format'])[:40]!r}{wrote}; soccer_env {version()} reads {FORMAT!r}"
        )
    world = header.get("world", 1)
    if world != WORLD:
        raise ValueError(f"it was recorded in world {str(world)[:9]}, this is world {WORLD}: {OTHER_WORLD}")


def check_size(content: io.BytesIO) -> None:
    """Raise ValueError if the parts of a file would unpack to more than LARGEST."""
    with ZipFile(content) as file:
        total = sum(part.file_size for part in file.infolist())
    if total > LARGEST:
        raise ValueError(f"it would unpack to {total} bytes, at most {LARGEST} are read")


def check_room(matches: int, robots: int) -> None:
    """Raise ValueError for more robots, over all matches, than a replay may hold."""
    if matches * robots > MOST_ROBOTS:
        raise ValueError(f"a replay holds at most {MOST_ROBOTS} robots, {matches} matches have {matches * robots}")


def check_start(start: bytes, wanted: dict[str, Any]) -> None:
    """Raise ValueError unless a replay starts with a sound save that has the matches and robots of its settings."""
    sides = [wanted["max_players"] or wanted[side] for side in ("home", "away")]
    matches, robots = wanted["matches"], sum(sides)
    check_room(matches, robots)
    parts = {name: shape for name, _, shape, _ in saving.open_save(start)[2]["parts"]}
    if parts["robots"] != [matches, robots]:
        raise ValueError(f"it begins with robots of shape {parts['robots']}, its settings say {[matches, robots]}")
