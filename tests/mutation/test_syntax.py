"""A mutant's piece of source is found by its syntax, however it is laid out, and only where it is meant."""

import ast

import pytest

from tests.mutation.syntax import replace

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
