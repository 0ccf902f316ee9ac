"""Compile what most tests need, each part in one of pytest-xdist's processes, which would else compile it all twice."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

from filelock import FileLock, Timeout

from soccer_env import Match


def play(league: str, team: str, **settings: Any) -> None:
    Match(league, home=1, away=1, seed=0, controllers={"home": team, "away": team}, **settings).step()


SENSING = {"senses": "sensors", "observe": "belief", "pose": "particles"}
PARTS: dict[str, Callable[[], None]] = {  # the longest first; each leaves its code on disk for the others
    "legged": partial(play, "legged-2001", "chaser", **SENSING),
    "middle-size": partial(play, "middle-size-2006", "chaser", **SENSING),
    "learned": partial(play, "legged-2001", "learned", senses="ideal"),
    "sacks": partial(play, "legged-2001", "sacks-2001", senses="ideal", observe="percepts"),
}


def warm_up(folder: Path, worker: int) -> None:
    """Play every part once: each process begins with another one, and waits only for what others are compiling."""
    names = [*PARTS][worker % len(PARTS) :] + [*PARTS][: worker % len(PARTS)]
    waiting = []
    for name in names:
        try:
            with FileLock(folder / f"{name}.lock", timeout=0):
                PARTS[name]()
        except Timeout:
            waiting.append(name)
    for name in waiting:
        with FileLock(folder / f"{name}.lock"):
            PARTS[name]()
