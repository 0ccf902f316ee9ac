"""Report pages: one file without a network, whatever names it holds, in a real Chromium; and the pictures in them."""

import re
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.evaluate.page import page_of
from soccer_env.train.evaluate.replays import Kept
from soccer_env.train.evaluate.replays.keep import add_replays
from soccer_env.train.report import (
    MISSING,
    ReportPage,
    draw_bars,
    draw_curves,
    draw_heat_table,
    draw_intervals,
)
from soccer_env.train.report.charts import Row
from soccer_env.train.report.page import alignment
from soccer_env.train.report.pitch_maps import LONGEST, Maps, cut_team_name, draw_map, spread_places
from soccer_env.train.report.style import COLOURS, LINES, MARKERS, adapt_svg, shorten_svg_path
from tests.render.chromium import Chromium, needs_chromium

pytest.importorskip("matplotlib")
EVIL = "</script><script>window.evil = 1</script><img src=x onerror='window.evil = 1'>%%BODY%%`x`\"'&"


def hostile() -> ReportPage:
    """Return a page that is given markup wherever it takes a text."""
    page = ReportPage(EVIL, EVIL)
    page.say(EVIL, strong=True)
    page.section(EVIL)
    page.heading(EVIL)
    page.table((EVIL, "b"), [(EVIL, "2"), ("a", "10")], sorts=True)
    page.figure(draw_bars(EVIL, EVIL, EVIL, [(EVIL, [0], [1])], form="svg"), EVIL)
    page.figure(draw_bars("b", "x", "y", [("c", [0], [1])], form="svg"), "b")
    page.fold(EVIL)
    page.command(EVIL)
    page.unfold()
    kept = Kept("best", f"replays/{EVIL}.replay", 0, 3, 4, EVIL, EVIL, 1, 0, 0.0, 9.0, 100, "javascript:evil", "s")
    add_replays(page, [kept])
    return page


@pytest.fixture(scope="module")
def evaluated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("run") / "a"
    played = {"home": "chaser", "away": "still", "matches": 6, "minutes": 0.2, "players": 1}
    evaluate(EvaluateSettings(**played, keep="best", keep_pages=True, out=out))
    return out


@pytest.fixture(scope="module")
def browser(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chromium]:
    with Chromium(tmp_path_factory.mktemp("profile"), 390, 844, phone=True) as chromium:
        yield chromium


def test_texts_are_texts() -> None:
    text = hostile().html()
    assert "window.evil" in text and "<script>window.evil" not in text and "<img" not in text
    assert len(re.findall("<script", text)) == len(re.findall("</script", text)) == 1
    assert text.count("%%BODY%%") > 10  # a name, not a place to fill in
    assert 'href="javascript:' not in text.lower()


def test_a_page_names_nothing_outside_itself(evaluated: Path) -> None:
    text = (evaluated / "report.html").read_text(encoding="utf-8")
    outside = re.sub(r'xmlns(:xlink)?="http://www\.w3\.org/[^"]*"', "", text)
    assert re.findall(r"https?:|//\w+\.|@import|<link rel=\"stylesheet|src=\"", outside) == []
    assert "default-src 'none'" in text


def test_a_report_says_what_was_run_and_links_what_was_kept(evaluated: Path) -> None:
    text = (evaluated / "report.html").read_text(encoding="utf-8")
    assert "soccer evaluate --league legged-2001 --home chaser --away still --matches 6" in text
    for words in (
        "95 % interval",
        "numba",
        "settings hash",
        "Goal differences of 6 matches",
        "kB a minute",
        "Where it happened",
        "chaser: 0 passes",
        "share of the time",
        "shots: off target",
        "Completed passes",
    ):
        assert words in text
    figures = re.findall("<figure>.*?</figure>", text, re.DOTALL)
    assert len(figures) == 5 and sum(map(len, figures)) < 150_000 and not any("<image" in one for one in figures)
    links = re.findall(r'href="(replays/[^"]+)"', text)
    assert len(links) == 2 and all((evaluated / name).is_file() for name in links)


def test_without_matplotlib_a_report_has_its_tables_and_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    result = evaluate(EvaluateSettings(home="still", away="still", matches=2, minutes=0.05, players=1))
    monkeypatch.setattr("soccer_env.train.evaluate.page.can_draw", lambda: False)
    text = page_of(result, {"command": EVIL})
    assert "pip install &quot;soccer_env[plot]&quot;" in text and "<svg" not in text and "shots: off target" in text
    assert "Replays" not in text, "none were kept"


def test_columns_of_numbers_are_told_from_words() -> None:
    numbers = (
        "12",
        "+1.00",
        "91.7 %",
        "12 : 0",
        "1.2/min (0.3 to 4)",
        "10, 2, 0",
        "1:40",
        "164 kB",
        "-",
        "1844674407370",
    )
    assert all(alignment([text]) for text in numbers)
    assert not any(alignment([text]) for text in ("chaser", "2001 rules", "6 pairs, sides swapped", ""))


@needs_chromium
def test_a_report_opens_without_an_error_or_a_request(browser: Chromium, evaluated: Path) -> None:
    browser.open(evaluated / "report.html")
    assert browser.run("document.title") == "chaser against still"
    assert browser.run("document.querySelectorAll('figure svg').length") == 5
    assert browser.run("document.documentElement.scrollWidth") == 390  # nothing sticks out
    assert browser.errors == []
    assert [url for url in browser.requests if not url.startswith(("file:", "data:"))] == []


@needs_chromium
def test_a_report_is_light_or_dark_as_the_system_and_as_asked(browser: Chromium, evaluated: Path) -> None:
    seen = SimpleNamespace(
        ground="getComputedStyle(document.body).backgroundColor",
        ink="getComputedStyle(document.querySelector('svg text')).fill",
    )
    grounds, inks = [], []
    for system in ("light", "dark"):
        browser.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": system}])
        browser.open(evaluated / "report.html")
        for _ in range(2):
            grounds.append(browser.run(seen.ground))
            inks.append(browser.run(seen.ink))
            browser.run("document.getElementById('theme').click()")
    assert grounds == [grounds[0], grounds[1], grounds[1], grounds[0]] and grounds[0] != grounds[1]
    assert inks == [inks[0], inks[1], inks[1], inks[0]] and inks[0] != inks[1]


@needs_chromium
def test_hostile_names_are_shown_and_tables_sort(browser: Chromium, tmp_path: Path) -> None:
    (tmp_path / "report.html").write_text(hostile().html(), encoding="utf-8")
    browser.errors.clear()
    browser.open(tmp_path / "report.html")
    assert browser.run("document.querySelector('h1').textContent") == EVIL
    assert browser.run("typeof window.evil") == "undefined" and browser.errors == []
    browser.run("document.querySelectorAll('.sorts th')[1].click()")
    cells = "[...document.querySelectorAll('.sorts tbody tr')].map((row) => row.cells[1].textContent)"
    assert browser.run(cells) == ["2", "10"]
    browser.run("document.querySelectorAll('.sorts th')[1].click()")
    assert browser.run(cells) == ["10", "2"]


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
    "presence": lambda form: draw_map(replace(MAPS, teams=(NAME, "b")), "presence", form=form),
    "network": lambda form: draw_map(replace(MAPS, teams=(NAME, "b")), "network", form=form),
    "shots": lambda form: draw_map(replace(MAPS, teams=(NAME, "b")), "shots", form=form),
    "table": lambda form: draw_heat_table(NAME, [NAME, "b"], ["c"], [[None], [-1.0]], "x", "y", form=form),
}


@pytest.mark.parametrize("name", PICTURES)
def test_a_picture_is_the_same_each_time(name: str) -> None:
    for form, begin in (("png", b"\x89PNG"), ("svg", b"<?xml")):
        once, again = PICTURES[name](form), PICTURES[name](form)
        assert once == again and once.startswith(begin)


def test_lost_matches_are_red_and_won_ones_green_whichever_kinds_there_are() -> None:
    for kinds in (("won", "drawn", "lost"), ("drawn", "lost"), ("lost",)):
        part = adapt_svg(draw_bars("ends", "goals", "matches", [(kind, [0], [1]) for kind in kinds], form="svg"), "p1")
        used = {"won": "--c3" in part, "drawn": "--c1" in part, "lost": "--c6" in part}
        assert used == {kind: kind in kinds for kind in used}


@pytest.mark.parametrize("name", PICTURES)
def test_a_part_of_a_page_is_whole_takes_its_colours_and_leaves_names_as_they_are(name: str) -> None:
    part = adapt_svg(PICTURES[name]("svg"), "p1")
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
    assert cut_team_name("chaser") == "chaser" and len(cut_team_name("x" * 80)) == LONGEST


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
    moved = spread_places(places, 0.2)
    apart = np.hypot(*(moved[:, None] - moved).transpose(2, 0, 1)) + np.eye(11)
    assert apart.min() > 0.19 and (moved[0] == places[0]).all() and np.abs(moved - places).max() < 0.8
    assert (spread_places(places, 0.2) == moved).all()


def test_lines_of_a_path_lose_letters_and_digits_and_curves_keep_theirs() -> None:
    path = "M 1.23456 2 \nL 3 4.5678 \nL 5 6 \nz\nM 1 2 \nQ 3 4 5 6 \nL 7 8.125\n"
    assert shorten_svg_path(path) == "M 1.23 2 3 4.56 5 6 z M 1 2 Q 3 4 5 6 L 7 8.12"


def test_a_hatch_is_drawn_in_full_colour_on_a_pale_bar() -> None:
    groups = [("a", [0], [1]), ("b", [1], [1])]
    svg = adapt_svg(draw_bars("t", "x", "y", groups, form="svg"), "p1")
    filled = re.findall(r"fill: (url\(#[^)]*\)|var\(--c2\)); (fill-opacity: 0.33)?", svg)
    assert ("var(--c2)", "fill-opacity: 0.33") in filled
    assert [opacity for fill, opacity in filled if fill.startswith("url")] == ["", ""], "the bar and its legend"
    assert not re.search(r'<rect[^>]*fill="#', svg), "a page's colours reach patterns too"
