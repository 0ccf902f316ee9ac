"""Clips: the part of a recorded match around a moment, as a replay of its own that plays again bit for bit.

A replay begins with a save, which rebuilds the physics and clears the history of contacts. A clip that begins during a
contact would soon differ from the recorded play. So a clip begins at the last moment, early enough, from which playing
agrees with the recording; at worst with the start of the recording.
"""

from collections import deque

from soccer_env.match import Match, saving
from soccer_env.replay.replay_file import Recorder, Replay

EVERY = 0.25  # [s] between moments at which a clip may begin
FARTHEST = 120.0  # [s] for which such moments are kept

Moment = tuple[int, bytes]  # control steps since the recording began, and the records at that step


class Clips:
    """Clips of a match that is being recorded: call `note` after every control step, `mark` where a clip is wanted.

    before, after: [s] of the match in a clip, at least before its mark, and at most after it.
    """

    def __init__(self, match: Match, recorder: Recorder, before: float, after: float) -> None:
        self._match, self._recorder = match, recorder
        rate = match.league.control_rate
        self._every, self._before, self._after = (round(rate * time) for time in (EVERY, before, after))
        self._moments: deque[Moment] = deque(maxlen=round(FARTHEST / EVERY))
        self._marks: list[tuple[int, list[Moment]]] = []

    def note(self) -> None:
        """Store the records of the match, every EVERY seconds."""
        step = len(self._recorder.hashes)
        if step % self._every == 0:
            self._moments.append((step, saving.dump(self._match, memory=False)))

    def mark(self) -> None:
        """Ask for a clip around this moment."""
        step = len(self._recorder.hashes)
        self._marks.append((step, [moment for moment in self._moments if moment[0] <= step - self._before]))

    def cut(self, whole: Replay) -> list[tuple[int, Replay]]:
        """Return the first control step of each clip, and the clip; `whole` is what the recorder has recorded."""
        return [exact_clip(whole, moments, min(step + self._after, len(whole))) for step, moments in self._marks]


def exact_clip(whole: Replay, moments: list[Moment], last: int) -> tuple[int, Replay]:
    """Return the shortest part of a replay up to step `last` that begins at one of `moments` and plays again."""
    for first, records in reversed(moments):
        clip = cut_steps(whole, records, first, last)
        try:
            clip.check()
        except ValueError:
            continue
        return first, clip
    return 0, cut_steps(whole, whole.start, 0, last)


def cut_steps(whole: Replay, start: bytes, first: int, last: int) -> Replay:
    """Return the control steps first, ..., last - 1 of a replay; `start`: the records at the first step."""
    log = [(step - first, rows, records) for step, rows, records in whole.log if first <= step < last]
    notes = whole.notes()
    return Replay(
        whole.settings, start, whole.commands[first:last], whole.gazes[first:last], whole.hashes[first:last], log,
        whole.made_by, {} if notes is None else notes.between(first, last),
    )  # fmt: skip
