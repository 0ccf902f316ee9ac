"""`Onlooker` follows a running match, `Reel` a replay, for the overlays of their pictures."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping
from math import ceil
from typing import TYPE_CHECKING, Any

from soccer_env.match import Match
from soccer_env.render.overlays.cast import Cast, Shot, cast_of, cast_of_replay, shot_of
from soccer_env.render.overlays.flags import OverlayFlags, flags_of
from soccer_env.render.overlays.layers import overlays_of
from soccer_env.render.overlays.paths import TRAVELLED
from soccer_env.render.overlays.shapes import Overlay
from soccer_env.thoughts.thought import Reader, note_at
from soccer_env.thoughts.thoughts import Thoughts

if TYPE_CHECKING:
    from soccer_env.thoughts.thoughts import Recorded


class Onlooker:
    """Looks at the first match whenever `see` is called, and remembers the last seconds.

        onlooker = Onlooker(match, "belief,trail")
        overlays = onlooker.see(match, width=960)
        frame = Picture(match.league).draw(match.matches[0], match.balls[0], match.robots[0], overlays=overlays)

    `overlays` as in `flags_of`. Thoughts are read only if a flag needs them, and reading does not change the play.
    """

    def __init__(self, match: Match, overlays: OverlayFlags | Mapping[str, Any] | str | None) -> None:
        self.flags = flags_of(overlays)
        self._thoughts = Thoughts(match, grouped=self.flags.need_groups) if self.flags.any else None
        reads = self._thoughts is not None and self._thoughts.slots > 0
        self._cast = cast_of(match, Reader.of(self._thoughts) if reads and self._thoughts is not None else None)
        self._past: deque[Shot] = past_of(self._cast)

    def see(self, match: Match, width: int) -> list[Overlay]:
        """Return the overlays of the present picture, `width` pixels wide; [] without flags."""
        if self._thoughts is None:
            return []
        note = self._thoughts.look(match) if self._cast.reader is not None else None
        shot = shot_of(match, note)
        overlays = overlays_of(self.flags, self._cast, shot, list(self._past), width)
        self._past.append(shot)
        return overlays


class Reel:
    """A replay as shots, with the robots' thoughts if `thoughts`; `cast` holds its teams."""

    def __init__(self, replay: Recorded, thoughts: bool = True) -> None:
        self._notes = replay.notes() if thoughts else None
        self._playing = replay.play()
        first = next(self._playing)
        self.first = self._shot(first, 0)
        self.cast = cast_of_replay(replay, first, None if self._notes is None else Reader.of(self._notes))

    def shots(self) -> Iterator[Shot]:
        """Yield a shot of the start and of every control step, only on the first call; ValueError if play differs."""
        yield self.first
        for step, match in enumerate(self._playing, 1):
            yield self._shot(match, step)

    def _shot(self, match: Match, step: int) -> Shot:
        return shot_of(match, None if self._notes is None else note_at(self._notes, step))


def past_of(cast: Cast) -> deque[Shot]:
    """Return an empty queue for past shots, which overlays of paths and trails need."""
    return deque(maxlen=ceil(TRAVELLED * cast.league.control_rate) + 1)
