"""The cache of compiled code never runs old code and never compiles without need."""

import os
import signal
import subprocess
import sys

import numba
import pytest

from soccer_env.compiling.sources import ROOT as PACKAGE
from soccer_env.compiling.sources import source_hashes
from soccer_env.geometry import wrap

# A small package: lower.py and numbers.py are what upper.py stands on, beside.py stands alone.
FILES = {
    "soccer_env/__init__.py": "",
    "soccer_env/numbers.py": "FACTOR = 2.0\n",
    "soccer_env/lower.py": """
from soccer_env.compiled import compiled
from . import numbers
FACTOR = numbers.FACTOR
@compiled
def scaled(x):
    return FACTOR * x
""",
    "soccer_env/leagues/__init__.py": "from .first import GRAVITY\n",
    "soccer_env/leagues/first.py": "GRAVITY = 9.0\n",
    "soccer_env/upper.py": """
from typing import TYPE_CHECKING
from soccer_env.compiled import compiled
from soccer_env.leagues import GRAVITY
from soccer_env.lower import scaled
if TYPE_CHECKING:
    from soccer_env import beside
@compiled
def value(x):
    return scaled(x) + GRAVITY
""",
    "soccer_env/beside.py": """
from soccer_env.compiled import compiled
@compiled
def other(x):
    return x + 1.0
""",
    "baselines/__init__.py": "",
    "baselines/chaser.py": """
from ..compiled import compiled
from ..upper import value
@compiled
def chase(x):
    return value(x) + 100.0
""",
}

# setuptools maps soccer_env.baselines to the folder beside the package; here a path entry does.
REPORT = """
import soccer_env
soccer_env.__path__.append({root!r})
from soccer_env.upper import value
from soccer_env.beside import other
from soccer_env.baselines.chaser import chase
results = value(1.0), other(1.0), chase(1.0)
print(*results, *(sum(f.stats.cache_misses.values()) for f in (value, other, chase)))
"""

VALUE = "from soccer_env.upper import value; print(value(1.0), sum(value.stats.cache_misses.values()))"


@pytest.fixture
def root(tmp_path):
    for name, text in FILES.items():
        write(tmp_path, name, text)
    for file in (PACKAGE / "compiled.py", *PACKAGE.glob("compiling/*.py"), *PACKAGE.glob("guards/*.py")):
        write(tmp_path, f"soccer_env/{file.relative_to(PACKAGE)}", file.read_text(encoding="utf-8"))
    return tmp_path


def write(root, name, text):
    path = root / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def start(root, code, **variables):
    environment = {k: v for k, v in os.environ.items() if not k.startswith(("NUMBA_", "SOCCER_ENV_", "PYTHON"))}
    # Python's own .pyc files go by whole seconds, and an edit here follows within one
    environment |= {"PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1", "SOCCER_ENV_CACHE": str(root / "cache")}
    pipe = subprocess.PIPE
    command = [sys.executable, "-c", code]
    return subprocess.Popen(command, env=environment | variables, stdout=pipe, stderr=pipe, text=True, cwd=root)


def finish(process):
    out, error = process.communicate(timeout=120)
    assert process.returncode == 0, error
    return out.split(), error


def run(root, code, **variables):
    return finish(start(root, code, **variables))


def report(root):
    numbers = [float(word) for word in run(root, REPORT.format(root=str(root)))[0]]
    return numbers[:3], numbers[3:]


def test_a_second_process_compiles_nothing_and_an_edit_recompiles_what_it_touches(root):
    assert report(root) == ([11.0, 2.0, 111.0], [1, 1, 1])
    assert report(root) == ([11.0, 2.0, 111.0], [0, 0, 0])
    write(root, "soccer_env/numbers.py", "FACTOR = 3.0\n")  # two files below `value`, three below `chase`
    assert report(root) == ([12.0, 2.0, 112.0], [1, 0, 1])
    write(root, "soccer_env/leagues/first.py", "GRAVITY = 8.0\n")  # reached through the package's __init__
    assert report(root) == ([11.0, 2.0, 111.0], [1, 0, 1])
    write(root, "baselines/chaser.py", FILES["baselines/chaser.py"].replace("100", "200"))
    assert report(root) == ([11.0, 2.0, 211.0], [0, 0, 1])
    write(root, "soccer_env/beside.py", FILES["soccer_env/beside.py"] + "# imported for type checkers only\n")
    assert report(root) == ([11.0, 2.0, 211.0], [0, 1, 0])
    write(root, "soccer_env/numbers.py", "FACTOR = 2.0\n")  # back to a version that is known
    write(root, "soccer_env/leagues/first.py", "GRAVITY = 9.0\n")
    assert report(root) == ([11.0, 2.0, 211.0], [0, 0, 1])


def test_code_of_a_file_that_changed_while_the_process_ran_is_not_kept(root):
    code = """
import pathlib
from soccer_env.upper import value
pathlib.Path("soccer_env/numbers.py").write_text("FACTOR = 5.0")
print(value(1.0), len(list(pathlib.Path("cache").glob("upper*"))))
"""
    assert run(root, code)[0] == ["11.0", "0"]
    assert report(root)[0][0] == 14.0


def test_a_team_outside_the_package_depends_on_its_own_files_and_on_the_packages(root):
    write(root, "mine/helpers.py", "BONUS = 1000.0\n")
    team = """
from helpers import BONUS
from soccer_env.compiled import compiled
from soccer_env.lower import scaled
@compiled
def act(x):
    return scaled(x) + BONUS
"""
    write(root, "mine/my_team.py", team)
    code = "from my_team import act; print(act(1.0), sum(act.stats.cache_misses.values()))"
    path = {"PYTHONPATH": os.pathsep.join([str(root), str(root / "mine")])}
    assert [run(root, code, **path)[0] for _ in range(2)] == [["1002.0", "1"], ["1002.0", "0"]]
    write(root, "mine/helpers.py", "BONUS = 2000.0\n")
    assert run(root, code, **path)[0] == ["2002.0", "1"]
    write(root, "soccer_env/numbers.py", "FACTOR = 3.0\n")
    assert run(root, code, **path)[0] == ["2003.0", "1"]


def test_functions_made_by_a_factory_are_kept_apart_and_found_again(root):
    factory = """
from soccer_env.compiled import compiled
from soccer_env.beside import other
@compiled
def third(x):
    return x / 3.0
def combine(first, second, weight):
    @compiled
    def total(x):
        return weight * first(x) + second(x)
    return total
terms = combine(other, third, 2.0), combine(third, other, 2.0), combine(other, third, 5.0)
"""
    write(root, "soccer_env/factory.py", factory)
    code = """
from soccer_env.factory import terms
print(*(term(3.0) for term in terms), *(sum(term.stats.cache_misses.values()) for term in terms))
"""
    assert run(root, code)[0] == ["9.0", "6.0", "21.0", "1", "1", "1"]
    assert run(root, code)[0] == ["9.0", "6.0", "21.0", "0", "0", "0"]
    write(root, "soccer_env/beside.py", FILES["soccer_env/beside.py"].replace("1.0", "2.0"))
    assert run(root, code)[0] == ["11.0", "7.0", "26.0", "1", "1", "1"]


def test_a_cold_start_is_announced_once_and_a_warm_one_is_not(root):
    code = "from soccer_env.upper import value; from soccer_env.beside import other; value(1.0); other(1.0)"
    assert run(root, code, SOCCER_ENV_QUIET="1", SOCCER_ENV_CACHE=str(root / "quiet"))[1] == ""
    cold = run(root, code, TMPDIR=str(root))[1]
    assert cold.startswith("soccer_env: compiling kernels (once") and cold.count("\n") == 1
    assert run(root, code)[1] == ""
    assert "what is new" in run(root, code.replace("1.0", "1"))[1]


def test_processes_that_start_together_do_not_disturb_each_other(root):
    code = "from soccer_env.upper import value; print(value({0}), value(1.0))"
    processes = [start(root, code.format(number)) for number in ("1", "1.0", "True", "1")]
    assert [finish(process)[0] for process in processes] == [["11.0", "11.0"]] * 4
    assert all(file.suffix == ".nbc" for file in (root / "cache").iterdir())
    assert report(root)[1][0] == 0


def test_a_cache_that_cannot_be_written_falls_back_to_the_temporary_folder(root):
    (root / "temporary").mkdir()
    write(root, "file", "")
    blocked = {"SOCCER_ENV_CACHE": str(root / "file" / "cache"), "TMPDIR": str(root / "temporary")}
    assert [run(root, VALUE, **blocked)[0] for _ in range(2)] == [["11.0", "1"], ["11.0", "0"]]


def test_files_that_are_cut_or_have_a_flipped_bit_are_compiled_again(root):
    """Machine code with another bit would crash, or compute something else."""
    report(root)
    for shares in ((None, 0.0, 0.3, 0.6), (0.6, 0.9, 0.999, 0.0)):  # a file of each function
        for share, file in zip(shares, sorted((root / "cache").iterdir()), strict=True):
            content = bytearray(file.read_bytes())
            if share is None:
                del content[1000:]
            else:
                content[int(share * len(content))] ^= 4
            file.write_bytes(content)
        assert report(root) == ([11.0, 2.0, 111.0], [1, 1, 1])
    assert report(root) == ([11.0, 2.0, 111.0], [0, 0, 0])


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such permissions")
def test_a_cache_that_anybody_can_write_to_is_not_used(root):
    for name in ("temporary", "other", "cache"):
        (root / name).mkdir()
    (root / "cache").chmod(0o777)
    for misses in ("1", "0"):
        printed, said = run(root, VALUE, TMPDIR=str(root / "temporary"))
        assert printed == ["11.0", misses]
        assert f"the cache {root / 'cache'} is not used: it is another user's, or anybody can write to it" in said
    assert list((root / "cache").iterdir()) == []
    (root / "cache").chmod(0o775)
    assert run(root, VALUE, TMPDIR=str(root / "temporary"))[0] == ["11.0", "0"], "it lies in the temporary folder"
    assert run(root, VALUE, TMPDIR=str(root / "other"))[0] == ["11.0", "1"]
    assert len(list((root / "cache").glob("upper*"))) == 1 and not list((root / "other").iterdir())


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such permissions")
def test_a_folder_of_the_cache_is_its_users_alone_and_made_only_when_it_is_needed(root):
    (root / "temporary").mkdir()
    code = "import os; os.umask(0); from soccer_env.upper import value; value(1.0)"
    run(root, code, TMPDIR=str(root / "temporary"))
    assert (root / "cache").stat().st_mode & 0o777 == 0o700
    assert list((root / "temporary").iterdir()) == []


def test_without_any_file_a_function_is_compiled_and_not_kept(root):
    code = """
import pathlib
from soccer_env.compiled import compiled
@compiled
def double(x):
    return 2 * x
print(double(4), pathlib.Path("cache").exists())
"""
    assert run(root, code)[0] == ["8", "False"]


def test_the_physics_kernels_depend_on_their_imports_and_on_nothing_beside_them():
    physics = PACKAGE / "physics"
    found = source_hashes("soccer_env.physics.engine.chipmunk", physics / "engine" / "chipmunk.py")
    engine = {f"engine/{name}.py" for name in ("chipmunk", "memory", "pools", "prefetch", "pymunk_parts")}
    engine |= {"engine/space.py", "engine/surfaces.py"}
    solver = {f"solver/{file.name}" for file in (physics / "solver").glob("*.py")} - {"solver/__init__.py"}
    within = {file.relative_to(physics).as_posix() for file in found if file.is_relative_to(physics)}
    assert within == engine | solver | {"block.py", "gait.py"} and len(solver) > 4
    beside = {file.relative_to(PACKAGE).parts[0] for file in found} - {"physics"}
    ground = {"compiled.py", "geometry.py", "types.py"}
    assert beside == ground | {"compiling", "guards", "leagues"}


@pytest.mark.skipif(not hasattr(wrap, "_cache"), reason="nothing is compiled")
def test_an_interrupt_waits_until_numba_has_filled_its_registries(monkeypatch):
    """One that comes in between leaves generators of numba's closed: each function after it fails in this process."""
    ended = []

    def look(*rest):
        ended.append(signal.raise_signal(signal.SIGINT))
        return "", None

    monkeypatch.setattr(type(wrap._cache), "_key", look)
    with pytest.raises(KeyboardInterrupt):
        wrap.compile((numba.int16,))
    assert ended == [None]


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such permissions")
@pytest.mark.parametrize(("mode", "misses"), [(0o777, "1"), (0o1777, "0"), (0o775, "0")])
def test_a_cache_that_anybody_can_put_another_in_place_of_is_not_used(root, mode, misses):
    """Where all may write, whoever likes renames a folder, unless only its owner may (the sticky bit)."""
    (root / "shared" / "mine").mkdir(parents=True)
    cache = root / "shared" / "mine" / "cache"
    (root / "none").mkdir(mode=0o777)
    (root / "none").chmod(0o777)  # nor is anything kept in the temporary folder, then
    places = {"SOCCER_ENV_CACHE": str(cache), "TMPDIR": str(root / "none")}
    run(root, VALUE, **places)
    (root / "shared").chmod(mode)
    printed, said = run(root, VALUE, **places)
    assert printed == ["11.0", misses]
    assert (f"the cache {cache} is not used" in said) == (misses == "1")
