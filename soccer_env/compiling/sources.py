"""Find the source files that a function depends on, and hash them.

Import statements are parsed, not executed, and followed through the package. numba's own cache looks at the function's
file alone, and runs old code after an edit in an imported file.
"""

import ast
import functools
import hashlib
import os
import sys
import sysconfig
import time
from pathlib import Path

PACKAGE = "soccer_env"
ROOT = Path(__file__).resolve().parents[1]
OUTSIDE_FOLDERS = ("baselines", "agents", "train")  # beside the package in a checkout, inside it once installed
STARTED = time.time_ns()  # [ns] a file changed after this moment may differ from the imported module


_stamps: dict[tuple[str, Path], str] = {}


def source_stamp(module: str, path: Path) -> str | None:
    """Return one hash over `path` and all files that it depends on; None if a file changed since the process began."""
    known = _stamps.get((module, path))  # of the source that was imported, whatever the files become
    if known is not None:
        return known
    try:
        hashes = source_hashes(module, path)
        if any(_changed(file) for file in hashes):
            return None
    except (OSError, SyntaxError, ValueError):
        return None  # deleted or half-written: the imported source is unknown
    text = "".join([hashes[path], *sorted(hashes.values())])
    return _stamps.setdefault((module, path), hashlib.sha256(text.encode()).hexdigest())


def _changed(file: Path) -> bool:
    status = os.stat(file)
    return max(status.st_mtime_ns, status.st_ctime_ns) > STARTED


@functools.cache
def source_hashes(module: str, path: Path) -> dict[Path, str]:
    """Return {file: sha256} of `path` and of all files that it imports, directly or not; cached for the process."""
    waiting = [(module, path)]
    hashes: dict[Path, str] = {}
    while waiting:
        name, file = waiting.pop()
        if file in hashes:
            continue
        hashes[file], imports = _hash_and_imports(file, name)
        waiting += [(target, source) for target in imports if (source := source_file(target, name))]
    return hashes


@functools.cache
def _hash_and_imports(path: Path, module: str) -> tuple[str, frozenset[str]]:
    """Return the hash of a file and the modules that it imports."""
    content = path.read_bytes()
    imports = _Imports(module, path.name == "__init__.py")
    imports.visit(ast.parse(content))
    return hashlib.sha256(content).hexdigest(), frozenset(imports.found)


class _Imports(ast.NodeVisitor):
    """A visitor that collects the modules a file imports, inside functions too, but not for type checkers only."""

    def __init__(self, module: str, is_package: bool) -> None:
        self.module = module
        self.package = module if is_package else module.rpartition(".")[0]
        self.found: set[str] = set()

    def visit_If(self, node: ast.If) -> None:
        """Skip imports under `if TYPE_CHECKING:`."""
        unused = ast.unparse(node.test) in ("TYPE_CHECKING", "typing.TYPE_CHECKING")
        for child in node.orelse if unused else [*node.body, *node.orelse]:
            self.visit(child)

    def visit_Import(self, node: ast.Import) -> None:
        """Collect an imported module, and for `import a.b.c` its parent packages too."""
        for alias in node.names:
            self.found.add(alias.name)
            if alias.asname is None:
                parts = alias.name.split(".")
                self.found.update(".".join(parts[:n]) for n in range(1, len(parts)))

    def visit_ImportFrom(self, node: ast.ImportFrom) -> None:
        """Collect each imported submodule; for any other imported name collect the module that defines the name."""
        parents = self.package.split(".")
        base = parents[: len(parents) - node.level + 1] if node.level else []
        source = ".".join([*base, *([node.module] if node.module else [])])
        for alias in node.names:
            inner = f"{source}.{alias.name}"
            self.found.add(inner if source_file(inner, self.module) else source)


@functools.cache
def source_file(module: str, importer: str) -> Path | None:
    """Return the source file of a module, without importing it; None if the file cannot change between two runs.

    Modules of this package, of the importer's package, and loaded modules that are not installed may change.
    """
    if module.partition(".")[0] == PACKAGE:
        return _package_file(module)
    name = getattr(sys.modules.get(module), "__file__", None)
    if name is None or not name.endswith(".py"):
        return None
    neighbours = module.partition(".")[0] == importer.partition(".")[0]
    return Path(name).resolve() if neighbours or not _is_installed(name) else None


@functools.cache
def _package_file(module: str) -> Path | None:
    parts = module.split(".")[1:]
    roots = [ROOT, ROOT.parent] if parts and parts[0] in OUTSIDE_FOLDERS else [ROOT]
    for root in roots:
        path = root.joinpath(*parts)
        candidates = [path / "__init__.py", *([path.with_name(path.name + ".py")] if parts else [])]
        for candidate in candidates:
            if candidate.is_file():
                return candidate
    return None


@functools.cache
def _is_installed(name: str) -> bool:
    path = Path(name).resolve()
    library = Path(sysconfig.get_path("stdlib")).resolve()
    return path.is_relative_to(library) or not {"site-packages", "dist-packages"}.isdisjoint(path.parts)
