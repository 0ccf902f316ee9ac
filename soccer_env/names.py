"""Names that callers use: imported when they are first asked for, and what to say of one that does not exist."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from difflib import get_close_matches
from importlib import import_module
from typing import Any


def lazy_names(package: str, modules: Mapping[str, str]) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return `__getattr__` and `__dir__` for a package whose public names lie in the given modules.

    A name that is a module itself is given as that module. In the package, say the same imports to type checkers under
    `if TYPE_CHECKING:`.
    """

    def find(name: str) -> Any:
        if name not in modules:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module = import_module(modules[name])
        return module if modules[name].endswith(f".{name}") else getattr(module, name)

    def names() -> list[str]:
        return sorted({*vars(import_module(package)), *modules})

    return find, names


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
