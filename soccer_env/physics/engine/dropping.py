"""Free a pymunk Space with all that is in it, at a time of our own.

Each of pymunk's bodies, shapes and constraints holds a handle of itself: a circle that only Python's garbage collector
breaks, whenever and in whichever thread it runs next. Without the handles all of them go with the last reference.
"""

from __future__ import annotations

import weakref
from typing import Any

import pymunk


def drop(spaces: list[pymunk.Space]) -> None:
    """Take the first Space off a list; free it at once with its parts, unless somebody else keeps it.

    Interrupts have to be held back: half a Space must not stay behind.
    """
    space = spaces.pop(0)
    handled: list[Any] = [*space.constraints, *space.bodies, space.static_body]
    shapes: list[Any] = list(space.shapes)
    kept = weakref.ref(space)
    del space
    if kept() is None:
        for part in handled:
            part._data_handle = None
        for shape in shapes:
            shape._h = None
