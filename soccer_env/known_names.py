"""What to say of a name that does not exist: which ones do, and the nearest of them."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches


def unknown(what: str, name: object, known: Iterable[str], *, more: str = "", where: str = "") -> str:
    """Return the message for an unknown name; `more` says what else could have been given.

    >>> unknown("team", "chasr", ["still", "chaser"])
    "unknown team 'chasr', did you mean 'chaser'? known: still, chaser"
    >>> unknown("team", 7, ["still", "chaser"], more="a policy file")
    'unknown team 7; known: still, chaser, or a policy file'
    """
    names = list(known)
    near = get_close_matches(name, names, n=1) if isinstance(name, str) else []
    question = f", did you mean {near[0]!r}? " if near else "; "
    place = f" in {where}" if where else ""
    return f"unknown {what} {name!r}{place}{question}known: {', '.join(names)}{', or ' + more if more else ''}"
