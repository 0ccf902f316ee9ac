"""What pictures and tables ask of a replay, which stands above them."""

from collections.abc import Iterator
from typing import Any, Protocol

from soccer_env.match import Match
from soccer_env.thoughts.thoughts import Notes


class Recorded(Protocol):
    """A match that was written down: `soccer_env.replay.Replay`."""

    settings: dict[str, Any]

    @property
    def teams(self) -> tuple[str, str]:
        """Who played home and away."""

    def notes(self) -> Notes | None:
        """Return what robots thought, None where that was not recorded."""

    def play(self) -> Iterator[Match]:
        """Yield the match at its start and after every control step; ValueError names the first step that differs."""
