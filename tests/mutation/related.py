"""Which tests are asked about a slip in a file: those that are about the file first, then the quick tests.

A test is about a file if their names and folders are alike, if it is the test of one of its mechanisms, or if it, or
what it stages scenes with, imports the file. Tests of the repository and of the mutants themselves are not asked.
"""

from __future__ import annotations

import ast
import functools
from pathlib import Path

from tests.mutation import mechanisms

MOST = 20  # files of tests that are asked first
GOLDEN = "tests/match/test_golden.py"  # notices that play is another, not what is wrong: asked second
LEFT_OUT = ("tests/repository", "tests/mutation")
ALSO = {  # what names and imports do not tell: tests that are about a folder or file
    "soccer_env/actions": ("tests/match",),
    "soccer_env/data_out": ("tests/train/evaluate/test_exporting.py",),
    "soccer_env/compil": ("tests/test_compiled.py", "tests/test_compiled_cache.py", "tests/test_compiled_inner.py"),
    "soccer_env/match/episodes": ("tests/api/test_soccer_v0_episodes.py",),
    "soccer_env/match": ("tests/match", "tests/api"),
    "soccer_env/optics": ("tests/perception",),
    "soccer_env/render": ("tests/render/test_golden_drawings.py",),
    "soccer_env/replay": ("tests/match/test_saving.py", "tests/match/test_hostile_replays.py", "tests/render"),
    "soccer_env/robot_kinds": ("tests/senses",),
    "soccer_env/match/saving": ("tests/match/test_saving.py", "tests/api/test_saving_envs.py"),
    "soccer_env/scenes": ("tests/drills", "tests/match/test_staging.py"),
    "soccer_env/match/senses": ("tests/senses",),
    "soccer_env/match/arguments": ("tests/match/test_match_settings.py",),
    "soccer_env/soccer_v0": ("tests/api",),
    "soccer_env/match/squads": ("tests/match/test_lineups.py", "tests/baselines/test_teams.py"),
    "soccer_env/match/user_code": ("tests/function_teams",),
    "soccer_env/teams/kernels": ("tests/baselines", "tests/api/test_opponents.py"),
    "soccer_env/skills": ("tests/baselines",),
    "soccer_env/shows": ("tests/render",),
    "soccer_env/teams": ("tests/baselines/test_teams.py", "tests/function_teams"),
    "soccer_env/types": ("tests/match", "tests/physics"),
    "soccer_env/gymnasium": ("tests/api",),
    "baselines": ("tests/baselines/test_teams.py",),
    "train/evaluate": (
        "tests/train/test_statistics.py",
        "tests/train/command/test_command_line.py",
        "tests/train/report",
    ),
}


class Related:
    """The tests of a checkout, by what they import."""

    def __init__(self, root: Path) -> None:
        self.root = root
        files = [
            f for top in ("soccer_env", "baselines", "agents", "train", "tests") for f in (root / top).rglob("*.py")
        ]
        self.modules = {module_of(name): name for name in (file.relative_to(root).as_posix() for file in files)}
        self.tests = sorted(n for n in self.modules.values() if "/test_" in n and not n.startswith(LEFT_OUT))
        self.of_mechanisms = {(one.file, one.test.partition("::")[0]) for one in mechanisms.read()}

    @functools.cache  # noqa: B019  # one for the run
    def imports(self, name: str) -> frozenset[str]:
        """Return the files of the checkout that a file imports, for tests those of what they share as well."""
        found = set()
        for node in ast.walk(ast.parse((self.root / name).read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module:
                inner = [f"{node.module}.{alias.name}" for alias in node.names]
                found |= {one if one in self.modules else node.module for one in inner}
        files = {self.modules[module] for module in found if module in self.modules}
        shared = [self.imports(file) for file in files if file.startswith("tests/") and name.startswith("tests/")]
        return frozenset(files.union(*shared))

    def first(self, file: str) -> list[str]:
        """Return the files of tests that are asked first about a file, the likeliest to notice first."""
        ranks = {test: self.rank(test, file) for test in self.tests}
        near = sorted((rank, test) for test, rank in ranks.items() if rank < 9)
        text = (self.root / file).read_text(encoding="utf-8")
        doctests = [file] if ">>>" in text and file.startswith("soccer_env/") else []
        return doctests + [test for _, test in near[:MOST]]

    def rank(self, test: str, file: str) -> int:
        """Return how far a test is from a file: 0 for its own, 9 for a stranger."""
        path = Path(file.removeprefix("soccer_env/")).with_suffix("")
        beside = Path(test).parent == Path("tests") / path.parent
        around = Path(test).is_relative_to(self.folder_about(path)) and path.parent != Path(".")
        stems = [path.name, path.parent.name] if path.name == "__init__" else [path.name]
        if (test, file)[::-1] in self.of_mechanisms or ((beside or around) and any(one in test for one in stems)):
            return 0
        if file in self.imports(test):
            return 1 if around else 2
        if any(file.startswith(start) and test.startswith(tests) for start, tests in ALSO.items()):
            return 3
        if around:
            return 4
        return 5 if any(file in self.imports(one) for one in self.imports(test) if "__init__" not in one) else 9

    def folder_about(self, path: Path) -> Path:
        """Return the folder of the tests about a file, or of those about the nearest folder above it that has any."""
        folders = (Path("tests") / above for above in path.parents if above != Path("."))
        return next((folder for folder in folders if (self.root / folder).is_dir()), Path("tests") / path.parent)

    def then(self, asked: list[str]) -> list[list[str]]:
        """Return the golden hashes, then the quick tests that were not asked yet, by folder."""
        lines = (self.root / "tests/quick.txt").read_text(encoding="utf-8").splitlines()
        folders = [line for line in lines if line.startswith("tests/") and not line.startswith(LEFT_OUT)]
        left = [test for test in self.tests if test not in asked and test != GOLDEN]
        quick = [[test for test in left if test.startswith(folder)] for folder in folders]
        return [[GOLDEN], *(tests for tests in quick if tests)]


def module_of(name: str) -> str:
    """Return the dotted name of a file."""
    inner = "" if name.startswith(("soccer_env/", "tests/")) else "soccer_env."
    return inner + name.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
