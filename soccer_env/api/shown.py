"""Text and picture of an env for consoles and notebooks: its settings, and its match."""

from __future__ import annotations

import logging
from dataclasses import fields
from typing import TYPE_CHECKING, Any

from soccer_env.guards.checking import short_repr
from soccer_env.match.arguments import MatchSettings

if TYPE_CHECKING:
    from soccer_env.match import Match

LOG = logging.getLogger("soccer_env")
ALWAYS = ("league", "home", "away")


class ShowsMatch:
    """An env with a `match` that is made from `arguments`."""

    match: Match
    arguments: Any

    def __repr__(self) -> str:
        return f"{type(self).__name__}({env_in_words(self.arguments, self.match)})"

    def _repr_png_(self) -> bytes | None:
        """Return a picture of the first match for notebooks, or None without the extra `render`."""
        return match_png(self.match)


def env_in_words(arguments: MatchSettings, match: Any) -> str:
    """Return league, team sizes and changed settings, written as in a call."""
    settings = match.settings
    shown = {"league": settings.league.name, "home": settings.home, "away": settings.away}
    for item in fields(arguments):
        value = getattr(arguments, item.name)
        if item.name not in ALWAYS and value is not item.default and not (is_plain(value) and value == item.default):
            shown[item.name] = value if is_plain(value) else getattr(value, "name", value)
    return ", ".join(f"{name}={short_repr(value)}" for name, value in shown.items())


def is_plain(value: Any) -> bool:
    """Tell whether a value is a number or a text, which can be compared."""
    return isinstance(value, (str, int, float))


def match_png(match: Any, m: int = 0) -> bytes | None:
    """Return a picture of a match as PNG, or None if it cannot be drawn, as without the extra `render`."""
    try:
        from soccer_env.api.report import MatchScreen
        from soccer_env.render import png_of_frame

        return png_of_frame(MatchScreen(match).frame(m))
    except Exception as error:  # a notebook then shows the text of `repr`
        LOG.debug("no picture of %r: %s", match, error)
        return None
