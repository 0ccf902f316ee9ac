"""`Onlooker` follows a running match, `ReplaySnapshots` a replay, for the overlays of their pictures."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping
from math import ceil
from typing import TYPE_CHECKING, Any

from soccer_env.match import Match
from soccer_env.render.overlays.cast import Cast, Snapshot, cast_of, cast_of_replay, take_snapshot
from soccer_env.render.overlays.flags import OverlayFlags, parse_flags
from soccer_env.render.overlays.layers import make_overlays
from soccer_env.render.overlays.paths import TRAVELLED
from soccer_env.render.overlays.shapes import Overlay
from soccer_env.thoughts.thought import NoteReader, note_at
from soccer_env.thoughts.thoughts import Thoughts

if TYPE_CHECKING:
    from soccer_env.thoughts.thoughts import RecordedMatch


class Onlooker:
    """Looks at the first match whenever `see` is called, and remembers the last seconds.

        onlooker = Onlooker(match, "belief,trail")
        overlays = onlooker.see(match, width=960)
        frame = Picture(match.league).draw(match.matches[0], match.balls[0], match.robots[0], overlays=overlays)

    `overlays` as in `parse_flags`. Thoughts are read only if a flag needs them, and reading does not change the play.
    """

    def __init__(self, match: Match, overlays: OverlayFlags | Mapping[str, Any] | str | None) -> None:
        self.flags = parse_flags(overlays)
        self._thoughts = Thoughts(match, grouped=self.flags.need_groups) if self.flags.any else None
        reads = self._thoughts is not None and self._thoughts.slots > 0
        self._cast = cast_of(match, NoteReader.of(self._thoughts) if reads and self._thoughts is not None else None)
        self._past: deque[Snapshot] = new_past_queue(self._cast)

    def see(self, match: Match, width: int) -> list[Overlay]:
        """Return the overlays of the present picture, `width` pixels wide; [] without flags."""
        if self._thoughts is None:
            return []
        note = self._thoughts.look(match) if self._cast.reader is not None else None
        shot = take_snapshot(match, note)
        overlays = make_overlays(self.flags, self._cast, shot, list(self._past), width)
        self._past.append(shot)
        return overlays


class ReplaySnapshots:
    """A replay as shots, with the robots' thoughts if `thoughts`; `cast` holds its teams."""

    def __init__(self, replay: RecordedMatch, thoughts: bool = True) -> None:
        self._notes = replay.notes() if thoughts else None
        self._playing = replay.play()
        first = next(self._playing)
        self.first = self._shot(first, 0)
        self.cast = cast_of_replay(replay, first, None if self._notes is None else NoteReader.of(self._notes))

    def shots(self) -> Iterator[Snapshot]:
        """Yield a shot of the start and of every control step, only on the first call; ValueError if play differs."""
        yield self.first
        for step, match in enumerate(self._playing, 1):
            yield self._shot(match, step)

    def _shot(self, match: Match, step: int) -> Snapshot:
        return take_snapshot(match, None if self._notes is None else note_at(self._notes, step))


def new_past_queue(cast: Cast) -> deque[Snapshot]:
    """Return an empty queue for past shots, which overlays of paths and trails need."""
    return deque(maxlen=ceil(TRAVELLED * cast.league.control_rate) + 1)
