"""The shots (drawable states) of a match or a replay in order, with rewind."""

from collections.abc import Iterable, Iterator
from itertools import islice

from soccer_env.match import Match
from soccer_env.render.overlays.cast import Snapshot, take_snapshot
from soccer_env.replay import Thoughts

KEPT = 6000  # shots in memory, some 16 kB each


class Tape:
    """A sequence of drawable shots, one for every `stride` control steps, that rewinds over the last KEPT shots."""

    def __init__(self, shots: Iterable[Snapshot], stride: int = 1) -> None:
        self._coming = iter(shots)
        self._stride = stride
        self.shots: list[Snapshot] = [next(self._coming)]
        self.at = 0
        self.ended = False

    def move_by(self, shots: int) -> None:
        """Move forwards by a number of shots, backwards if negative, at most to either end."""
        self.at = max(0, self.at + shots)
        while self.at >= len(self.shots) and not self.ended:
            self._take()
        self.at = min(self.at, len(self.shots) - 1)

    def _take(self) -> None:
        """Append the next shot to the tape; drop the oldest shots beyond KEPT."""
        latest = None
        for shot in islice(self._coming, self._stride):
            latest = shot
        if latest is None:
            self.ended = True
            return
        self.shots.append(latest)
        if len(self.shots) > KEPT:
            del self.shots[: KEPT // 4]
            self.at -= KEPT // 4

    @property
    def shot(self) -> Snapshot:
        """Return the current shot."""
        return self.shots[self.at]

    def past(self, shots: int) -> list[Snapshot]:
        """Return up to `shots` shots before the current shot."""
        return self.shots[max(0, self.at - shots) : self.at]


def play_live(match: Match, thoughts: Thoughts | None = None) -> Iterator[Snapshot]:
    """Play a match and yield a shot of its kick-off and of each control step until its end.

    Robots' thoughts are noted at intervals, as in a replay: an overlay can be turned on at any moment.
    """
    step, note = 0, None
    while True:
        if thoughts is not None and thoughts.slots and step % thoughts.every == 0:
            note = thoughts.look(match)
        yield take_snapshot(match, note)
        if (match.terminated | match.truncated).all():
            return
        match.step()
        step += 1
