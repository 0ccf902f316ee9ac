"""Pictures of results: repeatable, labelled, told apart without colour, with names of teams as they are."""

import re
import subprocess
import sys
from dataclasses import replace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from soccer_env.train.report import MISSING, draw_bars, draw_curves, draw_heat_table, draw_intervals
from soccer_env.train.report.charts import Row
from soccer_env.train.report.pitch_maps import LONGEST, Maps, cut, draw_network, draw_presence, draw_shots, spread
from soccer_env.train.report.style import COLOURS, LINES, MARKERS, for_page, shortened

pytest.importorskip("matplotlib")
MAPS = Maps(
    ("a", "b"),
    {"length": 3.0, "width": 2.0, "goal_width": 0.6, "goal_depth": 0.3, "circle": 0.15, "penalty_depth": 0.5,
     "penalty_width": 1.0, "goal_area_depth": 0.2, "goal_area_width": 0.8},
    dict.fromkeys(("for", "against", "ball"), np.arange(384.0).reshape(16, 24)),
    dict.fromkeys(("for", "against"), np.array([[-1.0, 0.0, 1.0], [2.0, 1.0, 4.0], [2.0, 1.0, 4.0], [0.0, 0.0, 0.0]])),
    dict.fromkeys(("for", "against"), np.array([[0, 3, 0, 0], [1, 0, 2, 0], [0, 0, 0, 0], [0, 0, 0, 0]])),
    {"for": [("goal", 1.2, 0.1), ("off_target", 0.5, -0.2)], "against": []},
)  # fmt: skip
NAME = r"$\frac{</script>&$"  # of a team: bad mathematics, and markup


def curves(names: tuple[str, ...], points: int = 3) -> dict[str, Any]:
    x = list(range(points))
    given = [{"name": name, "x": x, "y": x, "low": x, "high": [v + 1 for v in x]} for name in names]
    return {"title": NAME, "x_label": "range [cm]", "y_label": "error [cm]", "curves": given, "rules": [1.0]}


PICTURES = {
    "curves": lambda form: draw_curves(curves((NAME, "b")), form=form),
    "bands": lambda form: draw_curves(curves(("a", "b"), 40), form=form),
    "bars": lambda form: draw_bars(NAME, "goals", "matches", [(NAME, [0, 1], [3, 4])], ("mean", 0.5, 0, 1), form=form),
    "intervals": lambda form: draw_intervals(NAME, [Row(NAME, "3 %", 3.0, 2.0, float("inf"), least=1.0)], form=form),
    "presence": lambda form: draw_presence(replace(MAPS, teams=(NAME, "b")), form=form),
    "network": lambda form: draw_network(replace(MAPS, teams=(NAME, "b")), form=form),
    "shots": lambda form: draw_shots(replace(MAPS, teams=(NAME, "b")), form=form),
    "table": lambda form: draw_heat_table(NAME, [NAME, "b"], ["c"], [[None], [-1.0]], "x", "y", form=form),
}


@pytest.mark.parametrize("name", PICTURES)
def test_a_picture_is_the_same_each_time(name: str) -> None:
    for form, begin in (("png", b"\x89PNG"), ("svg", b"<?xml")):
        once, again = PICTURES[name](form), PICTURES[name](form)
        assert once == again and once.startswith(begin)


def test_lost_matches_are_red_and_won_ones_green_whichever_kinds_there_are() -> None:
    for kinds in (("won", "drawn", "lost"), ("drawn", "lost"), ("lost",)):
        part = for_page(draw_bars("ends", "goals", "matches", [(kind, [0], [1]) for kind in kinds], form="svg"), "p1")
        used = {"won": "--c3" in part, "drawn": "--c1" in part, "lost": "--c6" in part}
        assert used == {kind: kind in kinds for kind in used}


@pytest.mark.parametrize("name", PICTURES)
def test_a_part_of_a_page_is_whole_takes_its_colours_and_leaves_names_as_they_are(name: str) -> None:
    part = for_page(PICTURES[name]("svg"), "p1")
    root = ElementTree.fromstring(part)
    ids = [element.get("id") for element in root.iter() if element.get("id")]
    assert all(one.startswith("p1-") for one in ids) and len(ids) == len(set(ids))
    assert set(re.findall(r"(?:url\(|href=\")#([^)\"]+)", part)) <= set(ids)
    assert "var(--ink)" in part and not re.search("#171b22", part)
    assert "width" not in root.attrib and "viewBox" in root.attrib
    if name != "bands":
        assert NAME in "".join(root.itertext())
        assert "<script" not in part


def test_quantities_stand_at_the_axes_curves_differ_without_colour_and_long_names_are_cut() -> None:
    words = "".join(ElementTree.fromstring(draw_curves(curves(("a",)), form="svg")).itertext())
    assert "range [cm]" in words and "error [cm]" in words and "in the criteria: 1" in words
    assert len(COLOURS) == len(set(COLOURS)) == len(set(MARKERS)) == len(set(map(str, LINES)))
    assert cut("chaser") == "chaser" and len(cut("x" * 80)) == LONGEST


def test_no_matplotlib_no_picture_but_a_word() -> None:
    program = (
        "import sys; sys.modules['matplotlib'] = None\n"
        "from soccer_env.train.report import can_draw, draw_heat_table\n"
        "assert not can_draw()\n"
        "try: draw_heat_table('', ['a'], ['b'], [[1.0]])\n"
        "except ImportError as error: print(error)"
    )
    found = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert found.stdout.strip() == MISSING


def test_discs_in_one_place_are_moved_apart_and_others_left() -> None:
    places = np.array([[-1.0, 0.0], *[[0.5, 0.1]] * 10])
    moved = spread(places, 0.2)
    apart = np.hypot(*(moved[:, None] - moved).transpose(2, 0, 1)) + np.eye(11)
    assert apart.min() > 0.19 and (moved[0] == places[0]).all() and np.abs(moved - places).max() < 0.8
    assert (spread(places, 0.2) == moved).all()


def test_lines_of_a_path_lose_letters_and_digits_and_curves_keep_theirs() -> None:
    path = "M 1.23456 2 \nL 3 4.5678 \nL 5 6 \nz\nM 1 2 \nQ 3 4 5 6 \nL 7 8.125\n"
    assert shortened(path) == "M 1.23 2 3 4.56 5 6 z M 1 2 Q 3 4 5 6 L 7 8.12"


def test_a_hatch_is_drawn_in_full_colour_on_a_pale_bar() -> None:
    groups = [("a", [0], [1]), ("b", [1], [1])]
    svg = for_page(draw_bars("t", "x", "y", groups, form="svg"), "p1")
    filled = re.findall(r"fill: (url\(#[^)]*\)|var\(--c2\)); (fill-opacity: 0.33)?", svg)
    assert ("var(--c2)", "fill-opacity: 0.33") in filled
    assert [opacity for fill, opacity in filled if fill.startswith("url")] == ["", ""], "the bar and its legend"
    assert not re.search(r'<rect[^>]*fill="#', svg), "a page's colours reach patterns too"
