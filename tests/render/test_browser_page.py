"""The page of a replay in a real Chromium: it loads, plays, seeks and picks, and runs nothing that came from a file."""

import json
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from soccer_env import Match, shows
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.shows.browser.page import script_json, write_page
from soccer_env.thoughts.thought import NoteReader
from soccer_env.train.evaluate.recording import shown_memory_fields
from tests.render.chromium import Chromium, needs_chromium

EVIL = "</script><script>window.evil = 1</script><img src=x onerror='window.evil = 1'>"


def recorded(league: str = "legged-2001", home: str = "sacks-2001", thinks: bool = True) -> Replay:
    match = Match(league, home=2, away=2, controllers={"home": home, "away": "chaser"}, minutes=2, seed=4)
    recorder = Recorder(match, Thoughts(match, shown_memory_fields()) if thinks else None)
    for _ in range(20 * match.league.control_rate):
        match.step()
    return recorder.stop()


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> tuple[Replay, Path]:
    replay = recorded()
    for agent in replay.settings["teams"]:
        replay.settings["teams"][agent] = EVIL if agent.startswith("home") else "A & B <b>%%DATA%%</b>"
    replay.settings["league"]["name"] = EVIL
    replay.made_by = EVIL
    return replay, write_page(replay, tmp_path_factory.mktemp("page") / "<script>.html")


@pytest.fixture(scope="module")
def browser(page: tuple[Replay, Path], tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chromium]:
    with Chromium(tmp_path_factory.mktemp("profile")) as chromium:
        chromium.open(page[1])
        yield chromium


def test_names_from_a_file_are_text_and_the_page_names_nothing_outside_itself(page: tuple[Replay, Path]) -> None:
    text = page[1].read_text(encoding="utf-8")
    assert "window.evil" in text and "<script>window.evil" not in text and "<img" not in text
    assert len(re.findall("<script", text)) == len(re.findall("</script", text)) == 2
    assert json.loads(script_json({"a": EVIL + "\u2028"}))["a"] == EVIL + "\u2028"
    assert re.findall(r"https?:|//\w+\.|url\(|@import|<link rel=\"stylesheet|src=\"", text) == []
    assert "default-src 'none'" in text


@needs_chromium
def test_a_page_loads_without_an_error_or_a_request(browser: Chromium) -> None:
    assert browser.run("document.documentElement.dataset.ready") == "yes"
    assert browser.run("document.getElementById('home').textContent") == EVIL
    assert browser.run("document.title").startswith(EVIL)
    assert browser.run("typeof window.evil") == "undefined"
    assert browser.errors == []
    assert [url for url in browser.requests if not url.startswith(("file:", "data:"))] == []


@needs_chromium
def test_a_page_shows_what_was_played(browser: Chromium, page: tuple[Replay, Path]) -> None:
    for step, match in enumerate(page[0].play()):
        if step % 32 == 0 and step < 300 and match.events["goal"][0] < 0:
            shown = browser.run(
                f"(() => {{ const m = window.player.recording.at({step}); "
                "return [m.ball.x, m.ball.y, ...m.robots.flatMap((r) => [r.x, r.y])]; })()"
            )
            ball, robots = match.balls[0], match.robots[0]
            true = [ball["x"], ball["y"], *np.column_stack([robots["x"], robots["y"]]).ravel()]
            assert np.abs(np.array(shown) - true).max() < 1e-3


@needs_chromium
def test_a_page_shows_what_a_robot_believes(browser: Chromium, page: tuple[Replay, Path]) -> None:
    notes = page[0].notes()
    assert notes is not None
    asked = "const t = window.player.recording.thought(1, 150); return [t.step, t.own.x * 1e3];"
    found = browser.run(f"(() => {{ {asked} }})()")
    row = int(np.flatnonzero(notes.steps <= 150)[-1])
    assert found == [int(notes.steps[row]), int(notes.numbers[row, 1, 0])]


@needs_chromium
def test_each_overlay_draws_something_and_has_a_button_and_a_key(browser: Chromium) -> None:
    browser.run("(() => { window.player.pick(1); window.player.seek(150); })()")
    look = "(() => { window.player.show(0); return window.player.pitch.canvas.toDataURL(); })()"
    keys = {"belief": "b", "sight": "v", "path": "w", "roles": "o", "infrared": "i", "trail": "t"}
    for name, key in keys.items():
        before, pressed = browser.run(look), browser.run(f"window.player.shown.{name}")
        browser.press(key, ord(key.upper()), key)
        assert browser.run(f"window.player.shown.{name}") is not pressed
        if name != "trail":  # the ball may lie still
            assert browser.run(look) != before, name
        browser.run(f"document.getElementById('{name}').click()")
        assert browser.run(f"document.getElementById('{name}').getAttribute('aria-pressed')") == str(pressed).lower()
    browser.run("window.player.pick(-1)")
    assert browser.errors == []


@needs_chromium
def test_a_page_knows_the_blobs_and_ways_that_were_noted(browser: Chromium, page: tuple[Replay, Path]) -> None:
    notes = page[0].notes()
    row = int(np.flatnonzero(notes.steps <= 150)[-1])
    found = browser.run("window.player.recording.thought(1, 150).more")
    thought = NoteReader.of(notes).thought(notes.numbers[row], 1)
    for name, _, parts in notes.groups:
        assert [[one[part] for part in parts] for one in found[name]] == thought.groups[name].tolist(), name


@needs_chromium
def test_space_plays_and_arrows_seek(browser: Chromium) -> None:
    browser.run("window.player.seek(0)")
    browser.press(" ", 32, " ")
    look = "const look = () => (window.player.time > 4 ? done(true) : setTimeout(look, 20)); look();"
    assert browser.run(f"new Promise((done) => {{ {look} }})")
    browser.press(" ", 32, " ")
    assert browser.run("window.player.playing") is False
    browser.run("window.player.seek(100)")
    browser.press("ArrowRight", 39)
    assert browser.run("window.player.time") == 116
    browser.press(",", 188, ",")
    assert browser.run("window.player.time") == 115
    browser.press("?", 191, "?")
    assert browser.run("document.getElementById('help').open") is True
    browser.run("document.getElementById('help').close()")
    moved = "const s = document.getElementById('scrub'); s.value = 200; s.dispatchEvent(new Event('input'));"
    browser.run(f"(() => {{ {moved} }})()")
    assert browser.run("window.player.time") == 200
    assert browser.errors == []


@needs_chromium
def test_a_tap_picks_the_robot_that_stands_there(browser: Chromium) -> None:
    place = browser.run(
        "(() => { const p = window.player, r = p.recording.at(p.time).robots[1];"
        "const b = p.pitch.canvas.getBoundingClientRect();"
        "return [b.left + p.pitch.px(r.x) / p.pitch.ratio, b.top + p.pitch.py(r.y) / p.pitch.ratio]; })()"
    )
    browser.click(*place)
    shown = "new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done("
    words = browser.run(f"{shown}document.getElementById('record').innerText))))").replace("\u00a0", " ")
    assert words.startswith("red 1") and "believes" in words.lower() and "% sure, wrong by" in words
    browser.press("Escape", 27)
    assert browser.run("window.player.shown.picked") == -1
    assert browser.errors == []


@needs_chromium
def test_a_page_without_thoughts_works_on_a_phone(tmp_path: Path) -> None:
    path = shows.html(recorded("middle-size-2006", "heinemann-2006", thinks=False), tmp_path / "a.html")
    with Chromium(tmp_path / "profile", 390, 844, phone=True) as phone:
        phone.open(path)
        phone.run("window.player.pick(0)")
        assert phone.run("document.documentElement.scrollWidth") == 390  # nothing sticks out
        assert phone.errors == []


def test_a_page_is_not_written_over_and_a_forged_replay_leaves_none(tmp_path: Path) -> None:
    replay = recorded()
    (tmp_path / "a.html").write_text("mine")
    with pytest.raises(ValueError, match=r"a\.html exists already; give another path or anew=True"):
        shows.html(replay, tmp_path / "a.html")
    replay.hashes[3] = "0" * 32
    with pytest.raises(ValueError, match="differs from the recorded match at control step 3"):
        shows.html(replay, tmp_path / "b.html")
    with pytest.raises(ValueError, match=r"must end with \.html"):
        shows.html(replay, tmp_path / "b.htm")
    assert [(path.name, path.read_text()) for path in tmp_path.iterdir()] == [("a.html", "mine")]
