"""A sheet of frames for each goal: the ball in every one and in the goal last, as many sheets as are asked for."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("pygame")

import pygame

from soccer_env import Match, staging
from soccer_env.leagues import find_league
from soccer_env.render import Picture
from soccer_env.render.colours import BALL
from soccer_env.statistics.records import GoalKind
from soccer_env.train.play.__main__ import run
from soccer_env.train.play.goals.settings import GoalSettings
from soccer_env.train.play.goals.sheet import (
    AGO,
    COLUMNS,
    GAP,
    HEIGHT,
    WIDTH,
    corner_of,
    draw_sheets,
    frame_of,
    headlines,
    sheet_of,
    width_of,
)
from soccer_env.train.play.goals.watching import SeenGoal, SeenGoals, Watcher
from soccer_env.types import AWAY, Phase
from tests.scenes.staging import LEAGUES, each_league


def goal_of(league: str, seconds: float = 11.0) -> SeenGoal:
    """Return a goal of the robot-less ball of the away team, after some seconds of play."""
    match = Match(league, home=1, away=1, keeper=0, seed=1, controllers={"home": "still", "away": "still"})
    staging.set_phase(match, Phase.PLAY)
    pitch = match.league.pitch
    staging.put(match, 0, 0.0, 0.4 * pitch.width)
    staging.put(match, 1, 0.0, -0.4 * pitch.width)
    staging.begin(match)
    watcher = Watcher(match, 7)
    for left in range(round(seconds * match.league.control_rate), 0, -1):
        if left == round(0.5 * match.league.control_rate):
            staging.put_ball(match, -pitch.length / 2 + 0.2, 0.0, -2.0, 0.0)
            staging.begin(match)
        match.step(None)
        watcher.look()
    (goal,) = watcher.goals
    return goal


@pytest.fixture(scope="module", params=LEAGUES)
def drawn(request: pytest.FixtureRequest) -> tuple[Picture, SeenGoal]:
    """Return a picture of a league and a goal in it."""
    league = find_league(request.param)
    return Picture(league, width_of(league)), goal_of(request.param)


def test_every_frame_shows_the_ball_and_the_last_one_has_it_in_the_goal(drawn: tuple[Picture, SeenGoal]) -> None:
    picture, goal = drawn
    for place in (0, len(goal.moments) // 2, len(goal.moments) - 1):
        frame = frame_of(picture, goal, place)
        assert frame.shape == (HEIGHT, WIDTH, 3)
        assert (frame == BALL).all(axis=-1).any()
    left, _ = corner_of(picture, goal.moments[-1][1])
    columns = np.flatnonzero((frame == BALL).all(axis=-1).any(axis=0))
    line, _ = picture.pixel(-picture.league.pitch.length / 2, 0.0)
    assert left + np.median(columns) < line


def test_a_sheet_has_a_frame_for_each_time_and_words_above(drawn: tuple[Picture, SeenGoal]) -> None:
    picture, goal = drawn
    sheet = sheet_of(picture, goal, ("one", "two"))
    rows = len(AGO) // COLUMNS
    assert sheet.shape[1] == COLUMNS * (WIDTH + GAP) + GAP
    words = sheet.shape[0] - rows * (HEIGHT + GAP) - GAP
    assert 40 < words < 120
    assert len(np.unique(sheet[:words].reshape(-1, 3), axis=0)) > 2


def test_a_goal_soon_after_the_beginning_has_fewer_frames() -> None:
    goal = goal_of("legged-2001", seconds=0.5)
    league = find_league("legged-2001")
    sheet = sheet_of(Picture(league, width_of(league)), goal, ("one", "two"))
    assert sheet.shape[0] < 3 * HEIGHT


def test_the_words_say_who_scored_where_and_what_was_counted_and_called() -> None:
    goal = replace(
        goal_of("legged-2001", seconds=0.5),
        kind=GoalKind.PUSHED_IN,
        before={"goals_solo": True, "goals_after_separation": False},
        calls=((4.25, "home: pushing"), (1.0, "dropped ball")),
    )
    assert (goal.team, goal.direction) == (AWAY, -1)
    first, second, third = headlines(goal, ("chaser", "learned"))
    assert first.startswith("PUSHED IN: blue (away, learned) scores to the left, match 7, ")
    assert second == "counted as: solo"
    assert third == "called before: 4.2 s home: pushing; 1.0 s dropped ball"
    assert headlines(replace(goal, before={}, calls=()), ("a", "b"))[1:] == ["counted as: -", "called before: -"]


def test_as_many_sheets_are_written_as_asked_for(tmp_path: Path) -> None:
    goal = goal_of("legged-2001", seconds=0.5)
    seen = SeenGoals(find_league("legged-2001"), [goal, goal, goal], 3, 8)
    settings = GoalSettings(home="still", away="still", sheets=2, out=tmp_path)
    draw_sheets(SeenGoals(seen.league, [replace(goal, match=99)], 1, 1), settings)
    files = draw_sheets(seen, settings)
    assert sorted(tmp_path.iterdir()) == files and len(files) == 2
    assert files[1].name.startswith("goal-02-match-007-at-") and files[1].name.endswith("s-away-scrum.png")
    assert pygame.image.load(str(files[0])).get_width() > WIDTH


@each_league
@pytest.mark.parametrize(("along", "aside"), [(0.0, 0.0), (-0.49, 0.49), (0.52, 0.0), (0.49, -0.49)])
def test_a_close_up_holds_the_ball_and_is_of_one_size(name: str, along: float, aside: float) -> None:
    league = find_league(name)
    picture = Picture(league, width_of(league))
    match = Match(name, home=1, away=1, seed=1)
    staging.put_ball(match, along * league.pitch.length, aside * league.pitch.width)
    left, top = corner_of(picture, match.balls[0])
    column, row = picture.pixel(float(match.balls["x"][0]), float(match.balls["y"][0]))
    assert left <= column < left + WIDTH <= picture.width
    assert picture.header_height <= top <= row < top + HEIGHT <= picture.height


def test_the_command_writes_table_lines_and_sheets(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = "goals --home chaser --away still --players 1 --senses ideal --goals 2 --sheets 1 --minutes 1 --matches 4"
    assert run([*words.split(), "--seed", "2", "--out", str(tmp_path)]) == 0
    assert "2 goals of chaser against still" in capsys.readouterr().out
    assert len((tmp_path / "goals.jsonl").read_text().splitlines()) == 2
    assert len(list(tmp_path.glob("goal-*.png"))) == 1
