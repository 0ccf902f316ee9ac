"""What a page tells of a goal: who scored for whom, how, the score after it, and when the ball was played."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, shows
from soccer_env.match.staging import put_ball
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.shows.browser.events import EventCollector
from soccer_env.thoughts.thought import NoteReader
from soccer_env.train.evaluate.recording import shown_memory_fields
from tests.render.chromium import Chromium, needs_chromium
from tests.scenes.staging import LEGGED, MIDDLE, each_league, stand
from tests.statistics.staged_play import CASES, Scene

TEAMS = ("reds", "blues")
COLOURS = ("red", "blue")
each_case = pytest.mark.parametrize(("team", "half"), CASES)


class Told(Scene):
    """A scene that somebody listens to from `begin` on."""

    def begin(self) -> None:
        super().begin()
        self.stories, self.step, self.kicked = EventCollector(self.match, TEAMS), 0, -1

    def play(self, steps: int, idle: bool = False) -> None:
        if not hasattr(self, "stories"):
            return super().play(steps, idle)
        for _ in range(steps):
            before = self.match.robots[0].copy()
            super().play(1, idle)
            self.step += 1
            self.stories.listen(self.match, self.step, before)
            if self.match.robot_events["kick"][0].any():
                self.kicked = self.step
        return None

    def goal(self) -> tuple[list[Any], dict[str, Any]]:
        """Return the only goal that was told, and what is told more of it."""
        (goal,) = [event for event in self.stories.events if event[1] == "goal"]
        assert goal[5]["played"] < goal[0] <= self.step
        return goal[:5], goal[5]

    def named(self, row: int) -> str:
        robot = self.match.robots[0, row]
        return f"{COLOURS[int(robot['team'])]} {int(robot['number'])}{' (keeper)' if robot['keeper'] else ''}"

    def score(self, team: int) -> list[int]:
        return [int(team == 0), int(team == 1)]


@each_league
@each_case
def test_a_clean_kick(name: str, team: int, half: int) -> None:
    scene = Told(name, team, half)
    scene.feed(scene.row(), scene.line - 0.7, 0.05)
    scene.begin()
    scene.kick(scene.row())
    (_, _, side, r, words), more = scene.goal()
    assert (side, r, words) == (team, scene.row(), f"{scene.named(scene.row())} scores for {TEAMS[team]}")
    assert (more["kind"], more["score"], more["played"]) == ("clean_kick", scene.score(team), scene.kicked)
    assert more["how"].startswith("clean kick from 0.") and more["how"].endswith(" m, nobody else touched the ball")


@each_case
def test_a_deflected_kick_is_the_kickers_and_names_who_touched_it(team: int, half: int) -> None:
    scene = Told(LEGGED, team, half)
    body, ball = scene.match.league.body, scene.match.league.ball
    scene.feed(scene.row(), scene.line - 0.9, 0.0)
    scene.put(scene.row(opponent=True), scene.line - 0.3, body.tip_y + body.tip_radius + ball.radius + 0.002)
    scene.begin()
    scene.kick(scene.row())
    (_, _, side, r, words), more = scene.goal()
    assert (side, r, words) == (team, scene.row(), f"{scene.named(scene.row())} scores for {TEAMS[team]}")
    assert (more["kind"], more["played"]) == ("deflected_kick", scene.kicked)
    assert more["how"].endswith(f"deflected by {scene.named(scene.row(opponent=True))}")


@each_league
@each_case
def test_an_own_goal_names_whose_and_for_whom_it_counts(name: str, team: int, half: int) -> None:
    scene = Told(name, team, half)
    scene.feed(scene.row(), 0.7 - scene.line, 0.05, np.pi)
    scene.begin()
    scene.kick(scene.row())
    (step, _, side, r, words), more = scene.goal()
    other = 1 - team
    assert (side, r) == (other, scene.row())
    assert words == f"own goal by {scene.named(scene.row())}, counts for {COLOURS[other]} ({TEAMS[other]})"
    assert (more["kind"], more["score"], more["played"]) == ("own_goal", scene.score(other), scene.kicked)
    assert more["how"] == f"it kicked the ball {(step - scene.kicked) / scene.match.league.control_rate:.1f} s before"


@each_case
def test_a_dribble_a_push_and_a_scrum(team: int, half: int) -> None:
    told = {
        "clean_dribble": "dribbled in, without touching an opponent", "scrum": "bumped in out of a scrum",
        "pushed_in": "pushed in, in contact with an opponent",
    }  # fmt: skip
    for kind, how in told.items():
        scene = Told(LEGGED, team, half, players=2)
        if kind == "scrum":
            scene.feed(scene.row(1), scene.line - 0.15, 0.0)
            scene.put(scene.row(0), scene.line - 0.1, 0.26)
            scene.put(scene.row(1, opponent=True), scene.line - 0.1, -0.26)
            scene.ball(scene.line + 0.035, 0.0)
        else:
            scene.feed(scene.row(1), scene.line - 0.35, 0.0)
        if kind == "pushed_in":
            scene.put(scene.row(1, opponent=True), scene.line - 0.30, 0.155)
        scene.begin()
        scene.actions[:, scene.row(1), 0] = 1.0
        for _ in range(round(5.0 * scene.match.league.control_rate)):
            if scene.of("goals").sum() == 0:
                scene.play(1)
        (_, _, side, r, words), more = scene.goal()
        assert (side, r, words) == (team, scene.row(1), f"{scene.named(scene.row(1))} scores for {TEAMS[team]}")
        assert (more["kind"], more["how"], more["score"]) == (kind, how, scene.score(team))


def test_kicks_of_a_shoot_out_say_who_scores_and_the_score() -> None:
    match = Match(MIDDLE, home=3, away=3, seed=1, minutes=1.0, rules="league:shoot_out=True", placement="instant")
    match.matches["half"], match.matches["clock"] = 1, 30.0
    stories, score = EventCollector(match, TEAMS), [0, 0]

    def step(number: int) -> None:
        before = match.robots[0].copy()
        match.step(stand(match))
        stories.listen(match, number, before)

    step(1)
    first = int(match.matches["kick_off_team"][0])
    for number, scored in ((2, True), (3, False)):
        end = np.sign(match.matches["restart_x"][0])
        put_ball(match, end * 6.12, 0.0 if scored else 2.0)
        match.rebuild()
        step(number)
    told = [event for event in stories.events if event[1] == "penalty"]
    score[first] = 1
    words = [f"penalty kick: {COLOURS[first]} ({TEAMS[first]}) scores, {score[0]} : {score[1]}"]
    words += [f"penalty kick: {COLOURS[1 - first]} ({TEAMS[1 - first]}) misses, {score[0]} : {score[1]}"]
    assert [event[4] for event in told] == words and [event[2] for event in told] == [first, 1 - first]
    assert [event[5] for event in told] == [score, score]


EVIL = "</b><img src=x onerror='window.evil = 1'>"


def with_a_goal(thinks: bool = True) -> Replay:
    """Return a replay of 14 s in which red scores once, by a kick."""
    teams = {"home": "heinemann-2006", "away": "random"}
    match = Match("middle-size-2006", home=5, away=5, controllers=teams, minutes=2.0, seed=2, pose="particles")
    recorder = Recorder(match, Thoughts(match, shown_memory_fields()) if thinks else None)
    for _ in range(14 * match.league.control_rate):
        match.step()
    replay = recorder.stop()
    for agent, name in replay.settings["teams"].items():
        replay.settings["teams"][agent] = EVIL if name != "random" else name
    return replay


@needs_chromium
def test_a_page_says_who_scored_and_what_the_scorer_believed(tmp_path: Path) -> None:
    replay = with_a_goal()
    shows.html(replay, tmp_path / "a.html", belief=True)
    notes = replay.notes()
    assert notes is not None
    with Chromium(tmp_path / "profile") as browser:
        browser.open(tmp_path / "a.html")
        (event,) = browser.run("player.recording.events.filter((event) => event[1] === 'goal')")
        words = browser.run("document.querySelector('#events .goal').innerText").replace("\u00a0", " ")
        who, when = f"red {event[3]}", f"00:{event[0] // 50:02d}"
        assert browser.run("document.getElementById('scorers0').innerText") == f"{who} {when}"
        assert browser.run("document.getElementById('final').textContent") == "final score 1 : 0"
        near = browser.run("player.shown.picked")  # belief was asked for, but not whose
        after = browser.run(f"player.recording.thought({event[3]}, {event[0] + 5}).step")
        browser.run(f"(() => {{ player.seek({event[0]} + 5); player.show(0); }})()")
        assert browser.run("document.getElementById('phase').textContent") == f"GOAL: {who} scores for {EVIL}"
        assert browser.run("typeof window.evil") == "undefined" and browser.errors == []
    assert f"{when} 1 : 0 {who} scores for {EVIL} {event[5]['how']}" in " ".join(words.split())
    assert "attacker; " in words.partition("decided")[2]
    assert after == notes.steps[notes.steps > event[0]][0], "what it thought of its place before is past"
    assert number(r"then\s+kick (\d+) %", words) == round(100 * event[5]["kick"]) > 0
    row = int(np.flatnonzero(notes.steps < event[5]["played"])[-1])
    thought = NoteReader.of(notes).thought(notes.numbers[row], event[3])
    match = next(match for step, match in enumerate(replay.play()) if step == notes.steps[row])
    assert thought.ball is not None
    ball, robot = match.balls[0], match.robots[0, event[3]]
    ahead = np.hypot(*np.subtract(thought.ball, thought.pose[:2]))
    assert number(r"ball\s+(.*?) m ahead", words) == pytest.approx(ahead, abs=6e-3)
    wrong = np.hypot(ball["x"] - thought.ball[0], ball["y"] - thought.ball[1])
    assert number(r"ahead \(wrong by (.*?) m", words) == pytest.approx(wrong, abs=8e-3)
    assert number(r"m\), (\d+) % sure, sensed", words) == round(thought.ball_confidence)
    wrong = np.hypot(robot["x"] - thought.pose[0], robot["y"] - thought.pose[1])
    assert number(r"from the goal \(wrong by (.*?) m", words) == pytest.approx(wrong, abs=8e-3)
    goal_x = match.matches["home_direction"][0] * match.league.pitch.length / 2
    away = np.hypot(goal_x - thought.pose[0], thought.pose[1])
    assert number(r"itself\s+(.*?) m from the goal", words) == pytest.approx(away, abs=0.06)
    first = next(replay.play()).robots[0]
    assert near == int(np.argmin(np.hypot(first["x"], first["y"])))  # the ball is on the centre spot


@needs_chromium
def test_a_page_without_thoughts_says_so_of_the_scorer(tmp_path: Path) -> None:
    shows.html(with_a_goal(thinks=False), tmp_path / "a.html")
    with Chromium(tmp_path / "profile") as browser:
        browser.open(tmp_path / "a.html")
        words = browser.run("document.querySelector('#events .goal').innerText")
        assert " scores for " in words and "not in this replay" in words and browser.errors == []


def number(pattern: str, words: str) -> float:
    found = re.search(pattern, words)
    assert found is not None, (pattern, words)
    return float(found[1])
