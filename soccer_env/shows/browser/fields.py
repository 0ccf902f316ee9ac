"""Potential fields for a page: the forces on each robot, on the grid of the pictures, as its own team computes them.

A frame has a byte for each point of the grid: 0 for no force, else the code of a direction and a strength.
"""

from __future__ import annotations

import base64
import zlib
from typing import TYPE_CHECKING, Any

import numpy as np

from soccer_env.match import Match
from soccer_env.render.overlays.cast import cast_of_replay, take_snapshot
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.render.overlays.forces import ACROSS, force_target, forces_at, grid, has_forces, relative_strengths
from soccer_env.thoughts.thought import NoteReader
from soccer_env.thoughts.thoughts import Notes

if TYPE_CHECKING:
    from soccer_env.replay.replay_file import Replay

DIRECTIONS, LEVELS = 24, 5  # of a force: 15 degrees each; fifths of the share that gives an arrow length and colour
APART = 5  # notes from frame to frame, about a second; 1 for the robot that the flags name


class ForceFrames:
    """Frames of all robots whose teams compute forces, taken while the replay is played; `flags` names one to follow.

    A frame is taken at every `APART`-th note, so a replay without notes has none; the frame of a robot without beliefs
    or plan is empty.
    """

    def __init__(self, replay: Replay, match: Match, notes: Notes | None, flags: OverlayFlags | None) -> None:
        self._notes = notes
        self._cast = cast_of_replay(replay, match, None if notes is None else NoteReader.of(notes))
        steps = [] if notes is None else notes.steps.tolist()
        self._numbers = {step: number for number, step in enumerate(steps)}
        followed = flags.agent if flags is not None and flags.field else None
        rows = [row for row, part in self._cast.parts.items() if has_forces(part)]
        self._every = {row: 1 if match.agents[row] == followed else APART for row in rows}
        self._frames: dict[int, list[np.ndarray]] = {row: [] for row in rows}
        pitch = match.league.pitch
        self._points = grid(pitch.length, pitch.width)[0]

    def look(self, match: Match, step: int) -> None:
        """Take the frames of a control step, if any are due."""
        number = self._numbers.get(step)
        if number is None or self._notes is None:
            return
        for row, every in self._every.items():
            if number % every == 0:
                self._frames[row].append(self._frame(match, row, self._notes.numbers[number]))

    def _frame(self, match: Match, row: int, note: np.ndarray) -> np.ndarray:
        """Return the frame (P,) uint8 of a robot now."""
        shot = take_snapshot(match, note)
        thought = self._cast.thought(shot, row)
        if thought is None or not thought.knows or not shot.robots["active"][row]:
            return np.zeros(len(self._points), np.uint8)
        target = force_target(self._cast.parts[row], thought)
        if target is None:
            return np.zeros(len(self._points), np.uint8)
        return encode_forces(forces_at(self._cast, shot, row, thought, target, self._points))

    @property
    def any(self) -> bool:
        """Tell whether any frame has a force."""
        return any(frame.any() for frames in self._frames.values() for frame in frames)

    def about(self) -> dict[str, Any]:
        """Return the size of the grid, how bytes code directions and sizes, whose frames follow, and how often."""
        size = {"across": ACROSS, "up": len(self._points) // ACROSS, "directions": DIRECTIONS, "levels": LEVELS}
        return size | {"robots": list(self._every), "every": list(self._every.values())}

    def packed(self) -> str:
        """Return the frames of all robots as packed text, one robot after the other."""
        return pack_bytes(b"".join(frame.tobytes() for frames in self._frames.values() for frame in frames))


def encode_forces(vectors: np.ndarray) -> np.ndarray:
    """Return forces (P, 2) as bytes (P,): 1 + LEVELS times the direction + the strength, 0 where there is none."""
    size = np.hypot(*vectors.T)
    acts = np.isfinite(size) & (size > 0.0)
    size = np.where(acts, size, 0.0)
    turns = np.where(acts, np.arctan2(vectors[:, 1], vectors[:, 0]), 0.0) / (2.0 * np.pi)
    direction = np.rint(DIRECTIONS * turns).astype(int) % DIRECTIONS
    level = np.clip(np.floor(LEVELS * relative_strengths(size)).astype(int), 0, LEVELS - 1)
    return np.where(acts, 1 + LEVELS * direction + level, 0).astype(np.uint8)


def pack_table(table: np.ndarray) -> str:
    """Pack a table (T, C) int16 as text; differences between rows wrap round."""
    changes = np.diff(table, axis=0, prepend=np.int16(0)).T  # (C, T): a column's changes lie together
    folded = ((changes.astype(np.int32) << 1) ^ (changes.astype(np.int32) >> 15)).astype("<u2")  # 0, -1, 1, -2, ...
    planes = np.concatenate([(folded & 255).astype(np.uint8).ravel(), (folded >> 8).astype(np.uint8).ravel()])
    return pack_bytes(planes.tobytes())


def pack_bytes(content: bytes) -> str:
    """Deflate bytes and return them as base64 text."""
    return base64.b64encode(zlib.compress(content, 9)).decode()
