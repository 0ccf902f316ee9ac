"""The potential fields of a page, in a real Chromium: the arrows are those of the pictures, as far as they are kept."""

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from soccer_env import Match, shows
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.render.overlays.forces import force_arrows, force_target, grid
from soccer_env.render.overlays.onlooker import ReplaySnapshots
from soccer_env.render.overlays.shapes import ArrowGrid
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.shows.browser.collect import collect_page_data
from soccer_env.shows.browser.fields import APART, DIRECTIONS, LEVELS, encode_forces
from tests.render.chromium import Chromium, needs_chromium

TEAMS = {"legged-2001": "sacks-2001", "middle-size-2006": "heinemann-2006"}


def recorded(league: str, home: str, seconds: int, thinks: bool = True) -> Replay:
    match = Match(league, home=2, away=2, controllers={"home": home, "away": "chaser"}, minutes=2, seed=5)
    recorder = Recorder(match, Thoughts(match) if thinks else None)
    for _ in range(seconds * match.league.control_rate):
        match.step()
    return recorder.stop()


@pytest.fixture(scope="module", params=TEAMS)
def replay(request: pytest.FixtureRequest) -> Replay:
    return recorded(request.param, TEAMS[request.param], 10)


@pytest.fixture(scope="module")
def browser(replay: Replay, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Chromium]:
    folder = tmp_path_factory.mktemp("page")
    shows.html(replay, folder / "a.html", field=True, robot="home_1")
    with Chromium(folder / "profile") as chromium:
        chromium.open(folder / "a.html")
        yield chromium


def drawn(replay: Replay, rows: tuple[int, ...], steps: list[int]) -> dict[tuple[int, int], ArrowGrid | None]:
    """Return what a picture shows at some control steps, by row and step: None where there is no field."""
    reel, found = ReplaySnapshots(replay), {}
    for step, shot in enumerate(reel.shots()):
        for row in rows if step in steps else ():
            thought = reel.cast.thought(shot, row)
            target = None if thought is None or not thought.knows else force_target(reel.cast.parts[row], thought)
            found[row, step] = None
            if thought is not None and target is not None:
                (arrows,) = force_arrows(reel.cast, shot, row, thought, target, 1.0)
                assert isinstance(arrows, ArrowGrid)
                found[row, step] = arrows
    return found


@needs_chromium
def test_a_page_draws_the_arrows_of_the_pictures(browser: Chromium, replay: Replay) -> None:
    notes = replay.notes()
    steps, compared = notes.steps.tolist(), 0
    for row, every in ((0, APART), (1, 1)):  # home_1 was asked for: it has a frame at every note
        for (_, step), truth in drawn(replay, (row,), steps[::every][::2]).items():
            found = browser.run(f"player.recording.pulls.arrows({row}, {step}, player.recording.pitch)")
            if truth is None:
                assert found == []
                continue
            x, y, angle, share = np.array(found).T
            assert np.column_stack([x, y]) == pytest.approx(np.asarray(truth.middles), abs=1e-9)
            off = angle - np.arctan2(*np.asarray(truth.vectors).T[::-1])
            assert np.abs(np.arctan2(np.sin(off), np.cos(off))).max() <= np.pi / DIRECTIONS + 1e-9
            assert np.abs(share - np.asarray(truth.shares)).max() <= 0.5 / LEVELS + 1e-9
            compared += 1
    assert compared > 8


@needs_chromium
def test_the_flag_switches_the_field_on_and_a_key_and_a_button_turn_it(browser: Chromium) -> None:
    look = "(() => { player.show(0); return player.pitch.canvas.toDataURL(); })()"
    pressed = "document.getElementById('field').getAttribute('aria-pressed')"
    assert browser.run("player.shown.picked") == 1 and browser.run(pressed) == "true"
    step = browser.run("player.recording.thoughts.steps.find((step) => player.recording.pulls.frame(1, step))")
    browser.run(f"player.seek({step})")
    on = browser.run(look)
    browser.press("f", ord("F"), "f")
    assert browser.run(pressed) == "false" and browser.run(look) != on
    browser.run("document.getElementById('field').click()")
    assert browser.run(pressed) == "true" and browser.run(look) == on
    assert browser.errors == []


@needs_chromium
def test_a_page_shows_the_frame_that_is_nearest(browser: Chromium) -> None:
    steps = browser.run("player.recording.thoughts.steps")[::APART]
    frame = "(player.recording.pulls.frame(0, {}) || {{}}).step"
    for early, late in zip(steps, steps[1:]):
        for step in range(early, late + 1):
            found = browser.run(frame.format(step))
            assert found is None or abs(found - step) == min(step - early, late - step)


@needs_chromium
@pytest.mark.parametrize(("home", "thinks"), [("chaser", True), ("sacks-2001", False)])
def test_a_page_without_fields_hides_the_switch(home: str, thinks: bool, tmp_path: Path) -> None:
    shows.html(recorded("legged-2001", home, 2, thinks), tmp_path / "a.html", field=True, robot="home_1")
    with Chromium(tmp_path / "profile") as browser:
        browser.open(tmp_path / "a.html")
        assert browser.run("document.getElementById('field').offsetParent") is None
        assert browser.run("document.getElementById('path').offsetParent !== null")
        browser.run("player.show(0)")
        assert browser.errors == []


def test_a_byte_keeps_direction_and_strength() -> None:
    turns = np.linspace(-np.pi, np.pi, 49)
    vectors = np.stack([np.cos(turns), np.sin(turns)], axis=1) * np.linspace(0.1, 9.0, 49)[:, None]
    vectors[7], vectors[8] = 0.0, np.nan
    codes = encode_forces(vectors)
    assert codes[7] == codes[8] == 0 and codes[codes > 0].min() >= 1 and codes.max() <= DIRECTIONS * LEVELS
    off = 2.0 * np.pi * ((codes - 1) // LEVELS) / DIRECTIONS - turns
    assert np.abs(np.arctan2(np.sin(off), np.cos(off)))[codes > 0].max() <= np.pi / DIRECTIONS + 1e-9
    strengths = (codes - 1.0) % LEVELS
    assert (np.diff(strengths[codes > 0]) >= 0).all() and strengths[codes > 0].min() == 0


@pytest.mark.parametrize("league", TEAMS)
def test_notes_of_nonsense_give_a_page_or_a_plain_error(league: str) -> None:
    replay = recorded(league, TEAMS[league], 2)
    table, random = replay.thoughts["thoughts"], np.random.default_rng(1)
    for share in (0.02, 1.0):
        noise = random.integers(-32768, 32768, table.shape)
        replay.thoughts["thoughts"] = np.where(random.random(table.shape) < share, noise, table).astype(np.int16)
        found = collect_page_data(replay, flags=OverlayFlags(field=True, robot="home_1"))
        assert found["fields"]["up"] * found["fields"]["across"] == len(grid(3.0, 2.0)[0])
    about = json.loads(replay.thoughts["thoughts_about"].tobytes())
    about["groups"] = [[name, 20, ["x"]] if name == "plan" else [name, *rest] for name, *rest in about["groups"]]
    replay.thoughts["thoughts_about"] = np.frombuffer(json.dumps(about).encode(), np.uint8)
    with pytest.raises(ValueError, match="the groups of its thoughts are damaged"):
        collect_page_data(replay)
