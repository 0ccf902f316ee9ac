"""Imports point downward only: the layers of the package, read from the source without running it."""

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).parents[2]

# Where a package's folder stands when it is not soccer_env/<name>: as in [tool.setuptools.package-dir].
FOLDERS = {"soccer_env.baselines": "baselines", "soccer_env.agents": "agents", "soccer_env.train": "train"}

# Lowest first. Members of one layer do not see each other, except in the groups of PEERS and as BESIDE says.
LAYERS = (
    ("types", "guards", "geometry", "random_numbers", "compiled", "compiling"),
    ("records", "optics"),
    ("leagues",),
    ("physics", "perception", "belief", "referee", "skills"),
    ("actions", "observations", "rewards", "scenes", "statistics"),
    ("teams", "robot_kinds"),
    ("match",),
    ("thoughts",),
    ("render", "replay"),
    ("shows", "data_out"),
    ("soccer_v0", "gymnasium_envs", "api"),
    ("baselines", "agents"),
    ("train",),
    ("__main__",),
)
LEVEL = {name: level for level, names in enumerate(LAYERS) for name in names}
PEERS = (
    set(LAYERS[0]),  # one floor
    set(LAYERS[-4]),  # the single-agent APIs stand on the parallel one
)
# Who may import what stands beside it in the same layer: one entry each, with its reason.
BESIDE = {
    ("referee", "physics"),  # a restart lays the ball down as physics holds it
    ("rewards", "statistics"),  # a shot is paid as it is counted
}

PLAYERS = {"baselines", "agents"}
HIDDEN_FROM_PLAYERS = {"physics", "referee", "statistics", "perception", "robot_kinds", "match", "thoughts", "replay"}
HIDDEN_FROM_PLAYERS |= {"shows", "soccer_v0", "gymnasium_envs", "api"}
SHOWN_TO_PLAYERS = {"soccer_env.match.arguments"}  # a policy file names the settings that it was trained with
BELIEF_MAY_SEE = {*LAYERS[0], "records", "optics", "leagues", "belief"}
# Belief works on percepts. The records of types.py and records/ that hold the truth, by name:
TRUTH_RECORDS = {"MATCH", "BALL", "ROBOT", "EVENTS", "ROBOT_EVENTS"}
WORLD = ("World", "world")  # records.world, which bundles them
# `from soccer_env import Match` reaches upward, except for what is no part of any layer.
PUBLIC_TO_ALL = {"__version__"}


class Import(NamedTuple):
    """One imported name: a dotted module, and the name taken out of it (empty for the module itself)."""

    module: str
    name: str
    line: int


def modules_of(root: Path) -> dict[str, Path]:
    """Return the file of every module of the package, by import name."""
    folders = {"soccer_env": "soccer_env", **FOLDERS}
    files = {}
    for package, folder in folders.items():
        for file in sorted((root / folder).rglob("*.py")):
            parts = file.relative_to(root / folder).with_suffix("").parts
            parts = parts[:-1] if parts[-1] == "__init__" else parts
            files[".".join((package, *parts))] = file
    return files


def imports_of(module: str, file: Path) -> Iterator[Import]:
    """Yield every import of a file, wherever it stands: in functions and under TYPE_CHECKING as well."""
    package = module if file.name == "__init__.py" else module.rpartition(".")[0]
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"), str(file))):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield Import(alias.name, "", node.lineno)
        elif isinstance(node, ast.ImportFrom):
            source = node.module or ""
            if node.level:
                base = package.split(".")[: len(package.split(".")) - node.level + 1]
                source = ".".join([*base, source] if source else base)
            for alias in node.names:
                yield Import(source, alias.name, node.lineno)
        elif isinstance(node, ast.Call) and node.args and isinstance(node.args[0], ast.Constant):
            called = node.func.attr if isinstance(node.func, ast.Attribute) else getattr(node.func, "id", "")
            if called in {"import_module", "__import__"} and isinstance(node.args[0].value, str):
                name = node.args[0].value
                stripped = name.lstrip(".")
                if name != stripped:
                    up = len(package.split(".")) - (len(name) - len(stripped)) + 1
                    stripped = ".".join([*package.split(".")[:up], stripped])
                yield Import(stripped, "", node.lineno)


def part_of(module: str) -> str:
    """Return the part of the package that holds a module: "physics" for soccer_env.physics.ball, "" for the root."""
    return [*module.split("."), ""][1]


def violations(root: Path) -> list[str]:
    """Return one sentence for each import, and each module, that breaks the order of layers."""
    files = modules_of(root)
    parts = {part_of(module) for module in files}
    found = []
    for module, file in files.items():
        part = part_of(module)
        if part and part not in LEVEL:
            found.append(f"{module}: no layer is known for it; add it to LAYERS")
            continue
        for taken in imports_of(module, file):
            where = f"{file.relative_to(root)}:{taken.line}"
            if taken.module.split(".")[0] == "pymunk" and part != "physics":
                found.append(f"{where}: only physics/ imports pymunk")
            if taken.module.split(".")[0] == "soccer_env":
                found += [f"{where}: {reason}" for reason in objections(part, taken, parts)]
        if part == "belief":
            found += [f"{file.relative_to(root)}:{line}: belief/ sees {name}" for name, line in truth_names(file)]
    return found


def objections(part: str, taken: Import, parts: set[str]) -> Iterator[str]:
    """Say what is wrong with one import from inside the package."""
    target = part_of(taken.module)
    if not target and taken.name in parts | set(LEVEL):
        target = taken.name
    if not target:
        yield from objections_to_root(part, taken)
        return
    if target not in LEVEL:
        yield f"soccer_env.{target} has no layer; add it to LAYERS"
        return
    if part == "":
        if LEVEL[target] >= LEVEL["baselines"]:
            yield f"the package root imports {target}; baselines, agents and train are resolved on first use"
        return
    if LEVEL[target] > LEVEL[part]:
        yield f"{part} imports {target}, which stands above it"
    elif LEVEL[target] == LEVEL[part] and not may_see_beside(part, target):
        yield f"{part} imports {target}, which stands beside it"
    if part in PLAYERS and target in HIDDEN_FROM_PLAYERS and taken.module not in SHOWN_TO_PLAYERS:
        yield f"{part}/ decides from beliefs alone and may not import {target}"
    if part == "belief" and target not in BELIEF_MAY_SEE:
        yield f"belief/ may not import {target}, which holds truth"


def may_see_beside(part: str, target: str) -> bool:
    """Say whether one member of a layer may import another."""
    return part == target or (part, target) in BESIDE or any({part, target} <= group for group in PEERS)


def objections_to_root(part: str, taken: Import) -> Iterator[str]:
    """Say what is wrong with `import soccer_env` or `from soccer_env import NAME` where NAME is no module."""
    allowed = part in {"", "train"} or taken.name in PUBLIC_TO_ALL
    if not allowed:
        yield f"{part} imports {taken.name or 'all'} from the package root, which stands above it; name the module"


def truth_names(file: Path) -> Iterator[tuple[str, int]]:
    """Yield the truth records that a file of belief/ names, however it came by them."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and {"types", "records"} & {*(node.module or "").split(".")}:
            for alias in node.names:
                if alias.name in (*TRUTH_RECORDS, *WORLD, "*"):
                    yield alias.name, node.lineno
        elif isinstance(node, ast.Attribute) and node.attr in TRUTH_RECORDS:
            yield node.attr, node.lineno


def test_imports_point_downward() -> None:
    assert violations(ROOT) == []


def test_the_truth_records_exist() -> None:
    tree = ast.parse((ROOT / "soccer_env/types.py").read_text(encoding="utf-8"))
    targets = [target for node in tree.body if isinstance(node, ast.Assign) for target in node.targets]
    assigned = {target.id for target in targets if isinstance(target, ast.Name)}
    assert assigned >= TRUTH_RECORDS


def package_with(root: Path, files: dict[str, str]) -> Path:
    """Write a small well-behaved package, then the given files over it."""
    good = {
        "soccer_env/__init__.py": "from soccer_env.match.match import Match\n__version__ = '0'\n",
        "soccer_env/types.py": "BALL = BELIEF = None\n",
        "soccer_env/compiled.py": "from soccer_env import __version__\n",
        "soccer_env/geometry.py": "from .compiled import compiled\n",
        "soccer_env/teams.py": "import importlib\nimportlib.import_module(name)\n",
        "soccer_env/leagues/__init__.py": "from soccer_env import types\n",
        "soccer_env/physics/__init__.py": "",
        "soccer_env/physics/ball.py": "import pymunk.batch\nfrom . import pitch\nfrom ..leagues import League\n",
        "soccer_env/physics/pitch.py": "from soccer_env.geometry import disc\n",
        "soccer_env/belief/ball.py": "from soccer_env.types import BELIEF\n",
        "soccer_env/rewards.py": "import soccer_env.referee.goals\n",
        "soccer_env/referee/goals.py": "",
        "soccer_env/match/match.py": "from soccer_env.physics import ball\n",
        "soccer_env/gymnasium_envs.py": "from soccer_env import soccer_v0\n",
        "soccer_env/soccer_v0.py": "def render():\n    from soccer_env.render import pictures\n",
        "soccer_env/render/pictures.py": "import pygame\n",
        "baselines/__init__.py": "",
        "baselines/chaser.py": "from soccer_env.belief.ball import track\nfrom .still import still\n",
        "baselines/still.py": "",
        "train/contest.py": "from soccer_env import Match, make_team\nfrom soccer_env.baselines import chaser\n",
    }
    for name, text in {**good, **files}.items():
        file = root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
    return root


def test_a_good_package_passes(tmp_path: Path) -> None:
    assert violations(package_with(tmp_path, {})) == []


@pytest.mark.parametrize(
    ("file", "text", "complaint"),
    [
        ("agents/learned.py", "from ..match.arguments import Match\nfrom ..match import step", "agents/ decides"),
        ("soccer_env/geometry.py", "import soccer_env.match", "geometry imports match, which stands above"),
        ("soccer_env/physics/ball.py", "def f():\n    from ..referee import goals", "physics imports referee"),
        ("soccer_env/physics/ball.py", "if TYPE_CHECKING:\n    from soccer_env import match", "physics imports match"),
        ("soccer_env/perception/i.py", "from ..physics import ball", "perception imports physics, which stands beside"),
        ("soccer_env/match/match.py", "import_module('soccer_env.train.ppo')", "match imports train"),
        ("soccer_env/match/m.py", "import importlib as i\ni.import_module('..render', 'x')", "match imports render"),
        ("soccer_env/match/match.py", "from soccer_env import make_team", "match imports make_team from the package"),
        ("soccer_env/match/match.py", "import pymunk", "only physics/ imports pymunk"),
        ("soccer_env/__init__.py", "from .train import evaluate", "the package root imports train"),
        ("soccer_env/manager.py", "", "soccer_env.manager: no layer is known"),
        ("soccer_env/match/match.py", "from soccer_env.manager import x", "soccer_env.manager has no layer"),
        ("baselines/chaser.py", "from soccer_env.physics import ball", "baselines/ decides from beliefs alone"),
        ("baselines/chaser.py", "from soccer_env import Match", "baselines imports Match from the package root"),
        ("soccer_env/belief/ball.py", "from soccer_env.perception import camera", "belief/ may not import perception"),
        ("soccer_env/belief/ball.py", "from soccer_env.types import BALL", "belief/ sees BALL"),
        ("soccer_env/belief/ball.py", "from soccer_env.types import *", "belief/ sees *"),
        ("soccer_env/belief/ball.py", "from soccer_env.records.world import World", "belief/ sees World"),
        ("soccer_env/belief/ball.py", "from soccer_env import types as t\nt.ROBOT", "belief/ sees ROBOT"),
    ],
)
def test_a_bad_import_is_found(tmp_path: Path, file: str, text: str, complaint: str) -> None:
    found = violations(package_with(tmp_path, {file: text}))
    assert any(complaint in sentence for sentence in found), found
