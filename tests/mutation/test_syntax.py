"""A mutant's piece of source is found by its syntax, however it is laid out, and only where it is meant."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

from tests.mutation.mutants import MUTANTS
from tests.mutation.syntax import replace

ROOT = Path(__file__).parents[2]
SOURCE = '''"""A module."""

WIDE = 3  # [m] two, "said"


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


@pytest.mark.parametrize(
    ("original", "replacement", "where", "expected"),
    [
        ("x.size>2*WIDE and x.live", "0", "", ("        x.size > 2 * WIDE  # a comment\n        and x.live", "0")),
        ("2 * WIDE", "1 + WIDE", "", ("2 * WIDE", "(1 + WIDE)")),
        ("WIDE = 3", "WIDE = 4", "", ("WIDE = 3", "WIDE = 4")),
        ("by=1", "by=2", "", ("by=1", "by=2")),
        ('x = grown(x, by=1)', "", "", ("x = grown(x, by=1)", "pass")),
        ('y = "é"\nx = grown(x, by=1)', "pass", "", ("y = 'é'; x = grown(x, by=1)", "pass")),
        ("return x + 1", "return x", "second", ("second(x):\n    return x + 1", "second(x):\n    return x")),
        ("x + 1", "x", "first", ("    return x + 1\n\n\ndef second", "    return (x)\n\n\ndef second")),
        ("return x + 1", "if x:\n    return x\nreturn 1", "first",
         ("    return x + 1\n\n\n", "    if x:\n        return x\n    return 1\n\n\n")),
    ],
)  # fmt: skip
def test_a_piece_is_replaced_and_the_rest_stays_as_it_was(
    original: str, replacement: str, where: str, expected: tuple[str, str]
) -> None:
    changed = replace(SOURCE, original, replacement, where)
    wanted = SOURCE.replace(*(piece.strip() if expected[0].strip() == piece else piece for piece in expected))
    assert ast.dump(ast.parse(changed)) == ast.dump(ast.parse(wanted))
    assert changed.count("#") == SOURCE.count("#") - expected[0].count("#")


@pytest.mark.parametrize(
    ("original", "where", "times"),
    [("x + 1", "", 2), ("return x + 1", "", 2), ("x - 1", "", 0), ("WIDE = 3", "first", 0), ("by=2", "", 0)],
)
def test_what_is_not_there_exactly_once_is_refused(original: str, where: str, times: int) -> None:
    with pytest.raises(ValueError, match=f"stands {times} times in {where or 'the file'}"):
        replace(SOURCE, original, "0", where)


def test_a_formatter_leaves_every_mutant_as_it_was(tmp_path: Path) -> None:
    """Other line lengths and quotes, and no comments: each mutant can still be made, and is the same one."""
    files = sorted({mutant.file for mutant in MUTANTS})
    before = {name: (ROOT / name).read_text(encoding="utf-8") for name in files}
    for name in files:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(before[name], encoding="utf-8")
    style = ["--line-length=60", "--config=format.quote-style='single'"]
    ruff = [sys.executable, "-m", "ruff", "format", "-q", "--isolated", "--no-cache", *style, str(tmp_path)]
    subprocess.run(ruff, check=True)
    after = {name: (tmp_path / name).read_text(encoding="utf-8") for name in files}
    assert sum(after[name] != before[name] for name in files) > 0.9 * len(files)
    for mutant in MUTANTS:
        expected = ast.dump(ast.parse(mutant.changed(before[mutant.file])))
        for text in (after[mutant.file], ast.unparse(ast.parse(before[mutant.file]))):
            assert ast.dump(ast.parse(mutant.changed(text))) == expected
