"""Public names that are imported on first use and pickled by name, and messages for unknown names."""

import re
import sys
from collections.abc import Callable, Iterable, Mapping
from difflib import get_close_matches
from importlib import import_module
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec
from importlib.util import spec_from_file_location
from os import getcwd
from pathlib import Path
from typing import Any, NamedTuple

MODULE_PATH = re.compile(r"([A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*):([A-Za-z_]\w*)")  # MODULE:NAME in a user's module
MOST_NAMED, FIRST_NAMED = 32, 8  # a message lists up to 32 names; of more names the first 8
LISTS = {  # word in a message -> word of `soccer list`
    "team": "teams", "scene": "scenes", "league": "leagues", "rule": "rules", "reward term": "rewards",
    "claim": "claims", "variation": "variations",
}  # fmt: skip
Made = tuple[Callable[..., Any], tuple[Any, ...]]  # result of __reduce__


def lazy_names(package: str, modules: Mapping[str, str]) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """Return `__getattr__` and `__dir__` for a package that imports its public names on first use.

    `modules`: the module of each name, within the package. Repeat the imports for type checkers under
    `if TYPE_CHECKING:`.
    """

    def find(name: str) -> Any:
        if name not in modules:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        module = import_module(f"{package}.{modules[name]}")
        return module if modules[name] == name else getattr(module, name)

    def names() -> list[str]:
        return sorted({*vars(import_module(package)), *modules})

    return find, names


class FoldersBeside(MetaPathFinder):
    """An import finder for subpackages whose folders lie beside the package in a checkout, inside when installed.

    An editable install has its own finder. This one serves Python that is started in a checkout without an install.
    """

    def __init__(self, package: str, file: str, names: Iterable[str]) -> None:
        root = Path(file).parents[1]
        self._files = {f"{package}.{name}": root / name / "__init__.py" for name in names}

    def find_spec(self, fullname: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Return the import spec of a subpackage beside the package; None for other modules or an installed package."""
        file = self._files.get(fullname)
        if file is None or not all(one.is_file() for one in self._files.values()):
            return None
        return spec_from_file_location(fullname, file, submodule_search_locations=[str(file.parent)])


def unknown(what: str, name: object, known: Iterable[str], *, more: str = "", where: str = "", listed: str = "") -> str:
    """Return an error message for an unknown name, with similar and known names; `more`: other allowed values.

    Of many names the first are listed, with the `soccer list` command that names all: `listed`, or that of LISTS.

    >>> unknown("team", "chasr", ["still", "chaser"])
    "unknown team 'chasr', did you mean 'chaser'? known: still, chaser"
    >>> unknown("team", 7, ["still", "chaser"], more="a policy file")
    'unknown team 7; known: still, chaser, or a policy file'
    >>> unknown("scene", 7, map(str, range(10, 50)))
    'unknown scene 7; known: 10, 11, 12, 13, 14, 15, 16, 17 and 32 more; `soccer list scenes` names all 40'
    """
    names = list(known)
    bare = {one.lstrip("-"): one for one in names}  # dashes of options do not count for similarity
    likest = 3 if len(names) > MOST_NAMED else 1
    near = [bare[one] for one in get_close_matches(name.lstrip("-"), bare, likest)] if isinstance(name, str) else []
    question = f", did you mean {' or '.join(map(repr, near))}? " if near else "; "
    place = f" in {where}" if where else ""
    shown = ", ".join(names)
    if len(names) > MOST_NAMED:
        shown = f"{', '.join(names[:FIRST_NAMED])} and {len(names) - FIRST_NAMED} more"
        shown += f"; `soccer list {listed or LISTS[what]}` names all {len(names)}" if listed or what in LISTS else ""
    return f"unknown {what} {name!r}{place}{question}known: {shown}{', or ' + more if more else ''}"


def object_in_module(what: str, text: object, kind: type, near: str = "") -> Any:
    """Import and return the object that MODULE:NAME names; None for other text, ValueError if it is not of `kind`.

    The module is imported, and so runs, from the places where Python looks for modules or from the working folder.

    >>> object_in_module("league", "legged-2001", type)
    """
    parts = MODULE_PATH.fullmatch(text) if isinstance(text, str) else None
    if parts is None:
        return None
    module, name = parts.groups()
    places = vars(import_user_module(what, module))
    if name not in places:
        known = [key for key, value in places.items() if isinstance(value, kind)]
        raise ValueError(unknown(what, name, known, where=f"module {module!r}"))
    if not isinstance(places[name], kind):
        raise ValueError(f"{what} {text!r} must be {near or f'a {kind.__name__}'}, got {places[name]!r}")
    return places[name]


def import_user_module(what: str, module: str) -> Any:
    """Import and return a user's module; ValueError if that fails, or if it is a module of Python itself."""
    if module.partition(".")[0] in sys.stdlib_module_names:
        raise ValueError(f"{what} must stand in a module of your own, {module!r} is one of Python's")
    if getcwd() not in sys.path and "" not in sys.path:
        sys.path.append(getcwd())  # unlike `python -m`, the command `soccer` does not have it there
    try:
        return import_module(module)
    except ImportError as error:
        raise ValueError(f"{what}: module {module!r} cannot be imported: {error}") from error


def reduce_by_names(made: Any, values: dict[str, Any]) -> Made:
    """Return the value of `__reduce__` for an object with these field values; functions are stored by name.

    A compiled function is found again by its name, where a copy would have to be compiled again.
    """
    return rebuild_by_names, (type(made), {name: function_place(value) for name, value in values.items()})


class FunctionPlace(NamedTuple):
    """Module and name of a function, pickled in place of the function."""

    module: str
    name: str


def function_place(value: Any) -> Any:
    """Return module and name of a function in a loaded module; any other value unchanged."""
    if callable(value):
        for module, names in [
            (name, vars(loaded)) for name, loaded in sys.modules.items() if hasattr(loaded, "__dict__")
        ]:
            for name, there in list(names.items()):
                if there is value and module != "__main__":
                    return FunctionPlace(module, name)
    return value


def rebuild_by_names(kind: Callable[..., Any], values: dict[str, Any]) -> Any:
    """Rebuild an object that `reduce_by_names` has pickled."""
    places = {name: value for name, value in values.items() if isinstance(value, FunctionPlace)}
    return kind(**values | {name: getattr(import_module(at.module), at.name) for name, at in places.items()})
