"""Clips: the part of a recorded match around a moment, as a replay of its own that plays again bit for bit.

A replay begins with a save, and a save rebuilds the physics. Where robots or the ball touch something, that loses what
the touch has built up, and play from there soon differs from what happened. Where nothing touches, it loses nothing: a
clip begins at the last such moment that is early enough, which playing it shows; at the worst with the recording.
"""

from collections import deque

from soccer_env.match import Match, saving
from soccer_env.replay.replay_file import Recorder, Replay

EVERY = 0.25  # [s] between moments at which a clip may begin
FARTHEST = 120.0  # [s] such moments before the latest are kept

Moment = tuple[int, bytes]  # control steps since the recording began, and the records then


class Clips:
    """Clips of a match that is being recorded: call `note` after every control step, `mark` where a clip is wanted.

    before, after: how much of the match a clip shows, at least, before a mark, and at most after it [s].
    """

    def __init__(self, match: Match, recorder: Recorder, before: float, after: float) -> None:
        self._match, self._recorder = match, recorder
        rate = match.league.control_rate
        self._every, self._before, self._after = (round(rate * time) for time in (EVERY, before, after))
        self._moments: deque[Moment] = deque(maxlen=round(FARTHEST / EVERY))
        self._marks: list[tuple[int, list[Moment]]] = []

    def note(self) -> None:
        """Note, now and then, how the match is."""
        step = len(self._recorder.hashes)
        if step % self._every == 0:
            self._moments.append((step, saving.dump(self._match, memory=False)))

    def mark(self) -> None:
        """Ask for a clip around this moment."""
        step = len(self._recorder.hashes)
        self._marks.append((step, [moment for moment in self._moments if moment[0] <= step - self._before]))

    def cut(self, whole: Replay) -> list[tuple[int, Replay]]:
        """Return the first control step of each clip, and the clip; `whole` is what the recorder has recorded."""
        return [exact(whole, moments, min(step + self._after, len(whole))) for step, moments in self._marks]


def exact(whole: Replay, moments: list[Moment], last: int) -> tuple[int, Replay]:
    """Return the shortest part of a replay, up to a control step, that begins at one of some moments and agrees."""
    for first, records in reversed(moments):
        clip = part_of(whole, records, first, last)
        try:
            clip.check()
        except ValueError:
            continue
        return first, clip
    return 0, part_of(whole, whole.start, 0, last)


def part_of(whole: Replay, start: bytes, first: int, last: int) -> Replay:
    """Return the control steps from `first` to before `last` of a replay; `start`: the records at the first."""
    log = [(step - first, rows, records) for step, rows, records in whole.log if first <= step < last]
    notes = whole.notes()
    return Replay(
        whole.settings, start, whole.commands[first:last], whole.gazes[first:last], whole.hashes[first:last], log,
        whole.made_by, {} if notes is None else notes.between(first, last),
    )  # fmt: skip
