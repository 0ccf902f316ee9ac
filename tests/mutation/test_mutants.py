"""The mutants can be made: those of every mechanism of the papers, and the slips that are drawn at random."""

import ast
import subprocess
import sys
from itertools import islice
from pathlib import Path

import pytest

from tests.mutation import mechanisms, mutate, sites
from tests.mutation.mechanisms import Mechanism
from tests.mutation.related import Related
from tests.mutation.syntax import replace
from tests.repository import test_references as references

ROOT = Path(__file__).parents[2]
MECHANISMS = mechanisms.read()
SAMPLE = "MS32"  # one that is quick
SOURCE = '''"""A module."""

def reach(x, y, count: int = 1):
    """Return x - 1."""
    if x < 0.5 and count > 1:
        raise ValueError(f"{x - 1}")
    for i in range(count):
        x.total[i] = hypot(x, -y)
    return x + sin(y)
'''
SLIPS = {
    ("sign", "y"), ("comparison", "x > 0.5"), ("comparison", "count >= 1"), ("logic", "x < 0.5 or count > 1"),
    ("logic", "x < 0.5"), ("logic", "count > 1"), ("condition", "True"), ("condition", "False"),
    ("condition", "not (x < 0.5 and count > 1)"), ("off by one", "range(0 + 1, count)"),
    ("off by one", "range(0, count - 1)"), ("lost statement", "pass"), ("arithmetic", "x - sin(y)"),
    ("constant", "return 0.0"), ("number", "0.75"), ("number", "0.25"), ("number", "0.0"), ("number", "2"),
    ("number", "0"), ("side", "x"), ("side", "y"), ("sign", "hypot(-x, -y)"), ("sign", "sin(-y)"),
}  # fmt: skip
LAID_OUT = '''WIDE = 3  # [m] two, "said"
def first(x):
    """Return x + 1."""  # é is two bytes
    if (
        x.size > 2 * WIDE  # a comment
        and x.live
    ):
        y = 'é'; x = grown(x, by=1)
    return x + 1
def second(x):
    return x + 1
'''


def test_every_mechanism_has_a_mutant_for_each_of_its_tests() -> None:
    rows, problems = references.rows_of((ROOT / references.TABLE).read_text(encoding="utf-8"))
    assert problems == []
    listed = {(row.mechanism, row.test) for row in rows}
    covered = {(one.id, one.test.partition("[")[0]) for one in MECHANISMS}
    assert listed - covered == set()
    assert {mechanism for mechanism, _ in listed} == {one.id for one in MECHANISMS}
    assert len(set(MECHANISMS)) == len(MECHANISMS)


@pytest.mark.parametrize("one", MECHANISMS, ids=lambda one: f"{one.id}-{one.original.strip()[:30]}")
def test_a_mechanism_can_be_switched_off_and_its_test_exists(one: Mechanism) -> None:
    text = (ROOT / one.file).read_text(encoding="utf-8")
    changed = ast.parse(one.changed(text))
    assert ast.dump(changed) != ast.dump(ast.parse(text))
    compile(changed, one.file, "exec")
    found = references.find_test(one.test, ROOT)
    assert found is not None and one.id in found.upper().replace("_", " ")


@pytest.mark.parametrize(
    ("original", "replacement", "where", "expected"),
    [
        ("x.size>2*WIDE and x.live", "0", "", ("x.size > 2 * WIDE  # a comment\n        and x.live", "(0)")),
        ("by=1", "by=2", "", ("by=1", "by=2")),
        ("x = grown(x, by=1)", "", "", ("x = grown(x, by=1)", "pass")),
        ('y = "é"\nx = grown(x, by=1)', "pass", "", ("y = 'é'; x = grown(x, by=1)", "pass")),
        ("return x + 1", "return x", "second", ("second(x):\n    return x + 1", "second(x):\n    return x")),
        ("x + 1", "x", "first", ("x + 1\ndef", "(x)\ndef")),
        ("return x + 1", "if x:\n    return x\nreturn 1", "first",
         ("return x + 1\ndef", "if x:\n        return x\n    return 1\ndef")),
    ],
)  # fmt: skip
def test_a_piece_is_replaced_however_it_is_laid_out_and_the_rest_stays(
    original: str, replacement: str, where: str, expected: tuple[str, str]
) -> None:
    assert replace(LAID_OUT, original, replacement, where) == LAID_OUT.replace(*expected)


@pytest.mark.parametrize(
    ("original", "where", "times"),
    [("x + 1", "", 2), ("return x + 1", "", 2), ("x - 1", "", 0), ("WIDE = 3", "first", 0), ("by=2", "", 0)],
)
def test_what_is_not_there_exactly_once_is_refused(original: str, where: str, times: int) -> None:
    with pytest.raises(ValueError, match=f"stands {times} times in {where or 'the file'}"):
        replace(LAID_OUT, original, "0", where)


def test_slips_are_made_in_what_runs_and_not_in_words() -> None:
    found = {(site.kind, option) for site in sites.sites_of("reach.py", SOURCE) for option in site.options}
    assert found == SLIPS


def test_a_draw_hardly_changes_with_the_source() -> None:
    def order(source: str) -> list[str]:
        drawn = sorted(sites.sites_of("reach.py", source), key=lambda site: site.rank(7))
        return [f"{site.original} {site.replacement(7)} {site.number}" for site in drawn]

    longer = order(SOURCE + "    print(1.5 * z)\n" + "\nwider = 3.5 + 2.25\n")
    assert [one for one in longer if one in order(SOURCE)] == order(SOURCE)


def test_slips_drawn_from_the_package_can_be_read_and_are_asked_about() -> None:
    related = Related(ROOT)
    asked = mutate.arguments(["--seed", "3", "--only", "soccer_env/re"])
    for row, changed in islice(mutate.drawn(asked), 40):
        text = (ROOT / row["file"]).read_text(encoding="utf-8")
        assert changed.splitlines()[: row["line"] - 1] == text.splitlines()[: row["line"] - 1] and changed != text
        tests = related.first(row["file"])
        assert len(tests) + sum(map(len, related.then(tests))) > 50
    assert related.first("soccer_env/physics/kicker.py")[0] == "tests/physics/test_kicker.py"


def test_equivalent_slips_are_those_that_could_be_drawn() -> None:
    for one in mechanisms.rows("equivalents.toml")["equivalent"]:
        found = sites.sites_of(one["file"], (ROOT / one["file"]).read_text(encoding="utf-8"))
        drawn = [{**one, "original": site.original, "line": site.node.lineno} for site in found
                 if one["replacement"] in site.options]  # fmt: skip
        assert one["reason"] in map(mechanisms.reason, drawn), one


@pytest.mark.whole
def test_a_mechanism_that_is_switched_off_is_noticed_by_its_test(tmp_path: Path) -> None:
    command = [sys.executable, "tests/mutation/mutate.py", "--jobs", "1", "--mechanisms", SAMPLE]
    command += ["--out", str(tmp_path / "mutants.jsonl")]
    found = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stdout + found.stderr
    assert "0 lived" in found.stdout and "killed" in found.stdout
