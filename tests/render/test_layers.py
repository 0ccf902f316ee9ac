"""Overlays are what robots believe, see and plan, live and in a replay alike; what is missing is said."""

from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("pygame")

from soccer_env import Match, shows
from soccer_env.render import Picture
from soccer_env.render.overlays.cast import Cast, Snapshot, cast_of, take_snapshot
from soccer_env.render.overlays.flags import FLAGS, OverlayFlags, parse_flags
from soccer_env.render.overlays.layers import make_overlays, planned_path
from soccer_env.render.overlays.onlooker import Onlooker, ReplaySnapshots
from soccer_env.render.overlays.panels import TextPanel
from soccer_env.render.overlays.roles import activity_words
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.teams import explanation_of, shipped_team
from soccer_env.thoughts.thought import NoteReader, Thought

TEAMS = {"legged-2001": "sacks-2001", "middle-size-2006": "heinemann-2006"}


@cache
def played(league: str, away: str = "chaser", steps: int = 90) -> tuple[Match, Replay]:
    match = Match(league, home=2, away=2, controllers={"home": TEAMS[league], "away": away}, seed=5)
    recorder = Recorder(match, Thoughts(match))
    for _ in range(steps):
        match.step()
    return match, recorder.stop()


def looked_at(match: Match) -> tuple[Cast, Snapshot]:
    thoughts = Thoughts(match)
    return cast_of(match, NoteReader.of(thoughts)), take_snapshot(match, thoughts.look(match))


def thought_of(match: Match, r: int) -> Thought:
    cast, shot = looked_at(match)
    thought = cast.thought(shot, r)
    assert thought is not None
    return thought


def said(flags: str, cast: Cast, shot: Snapshot, robot: str = "home_1") -> list[str]:
    given = dict.fromkeys(flags.split(","), True)
    overlays = make_overlays(parse_flags({**given, "robot": robot}), cast, shot, [shot], 480)
    return [line for one in overlays if isinstance(one, TextPanel) for line in one.lines]


@pytest.mark.parametrize("league", TEAMS)
def test_a_replay_draws_what_the_match_drew(league: str, tmp_path: Path) -> None:
    match, replay = played(league)
    reel = ReplaySnapshots(Replay.read(replay.write(tmp_path / "a.replay")))
    shots = list(reel.shots())
    cast, shot = looked_at(match)
    flags = OverlayFlags(**dict.fromkeys(FLAGS, True), robot="home_1")
    picture = Picture(league, 480)
    both = ((reel.cast, shots[-1]), (cast, shot))
    layers = [make_overlays(flags, who, last, shots[:-1], 480) for who, last in both]
    assert np.array_equal(*(picture.draw(*last[:3], overlays=given) for (_, last), given in zip(both, layers)))
    frame = shows.frame(replay, 90 / match.league.control_rate, width=480)
    assert np.array_equal(frame[200:], picture.draw(*shot[:3])[200:])


def test_the_plan_is_the_teams_own_and_leads_from_the_robot_to_its_end() -> None:
    match = Match("middle-size-2006", home=2, away=2, controllers={"home": "heinemann-2006", "away": "chaser"}, seed=5)
    for _ in range(150):
        match.step()
        if len(planned_path(thought_of(match, 1))):
            break
    before = (match.squads[0].memory.tobytes(), match.robots["noise"].tobytes(), match.beliefs.tobytes())
    thought = thought_of(match, 1)
    assert before == (match.squads[0].memory.tobytes(), match.robots["noise"].tobytes(), match.beliefs.tobytes())
    plan = planned_path(thought)
    assert np.hypot(*(plan[0] - thought.pose[:2])) < 2.6 * 0.1 + 0.02  # from where it will be, 0.1 s on, at 2.6 m/s
    steps = np.hypot(*np.diff(plan, axis=0).T)
    assert len(plan) == 10 and steps.max() < 1.5 * steps.mean() + 0.03  # evenly spaced along the path


def test_a_flag_without_data_says_so() -> None:
    legged, middle = looked_at(played("legged-2001")[0]), looked_at(played("middle-size-2006")[0])
    assert said("field", *legged, robot="away_1") == ["field: chaser computes no forces"]
    assert said("path", *legged, robot="blue 1") == ["path: chaser plans no ways; travelled only"]
    assert said("infrared", *middle) == ["infrared: robots of middle-size-2006 have no ranger"]
    blind = Match(home=1, away=1, seed=1)
    lines = said("belief,sight,field,path,roles,infrared", cast_of(blind, None), take_snapshot(blind), "home_0")
    assert [line.partition(":")[0] for line in lines] == ["field", "sight", "path", "infrared", "belief", "roles"]
    assert "field: a learner computes no forces" in lines and "belief: nobody here believes anything" in lines
    with pytest.raises(ValueError, match="robot must be one of home_0, away_0, or ball, got 'home_7'"):
        said("belief", cast_of(blind, None), take_snapshot(blind), "home_7")


def test_a_replay_without_thoughts_says_so_and_names_load_nothing() -> None:
    match = Match(home=1, away=1, controllers={"home": "chaser", "away": "random"}, seed=3)
    recorder = Recorder(match)
    match.step()
    replay = recorder.stop()
    replay.settings["teams"]["home_0"] = "os:getcwd"
    reel = ReplaySnapshots(replay)
    lacking = ["field: os:getcwd computes no forces", "belief: this replay keeps no thoughts: soccer record does"]
    assert said("belief,field", reel.cast, reel.first, "home_0") == lacking
    assert shipped_team("os:getcwd") is None and explanation_of(shipped_team("sacks-2001")) is not None


def test_notes_of_older_versions_still_read() -> None:
    replay = played("legged-2001")[1]
    notes = replay.notes()
    assert notes is not None
    about = bytes(replay.thoughts["thoughts_about"]).decode()
    start = about.index(', "groups"')
    wide = sum(count * len(parts) for _, count, parts in notes.groups)
    first = 19 + 3 * notes.slots
    changes = np.delete(replay.thoughts["thoughts"], np.s_[first : first + wide], axis=1)
    old = {"thoughts": changes, "thoughts_about": np.frombuffer((about[:start] + "}").encode(), np.uint8)}
    older = Replay(replay.settings, replay.start, replay.commands, replay.gazes, replay.hashes, replay.log, "", old)
    reel = ReplaySnapshots(older)
    last = list(reel.shots())[-1]
    lacking = ["sight: no camera was played or noted", "path: no plans were noted"]
    assert said("belief,sight,path", reel.cast, last) == [*lacking, said("belief", reel.cast, last)[0]]


def test_recovery_is_told_in_words() -> None:
    def told(words: tuple[str, ...], numbers: dict[str, float], keeper: bool = False) -> tuple[str, bool]:
        return activity_words(words, numbers, keeper, False)

    assert told(("back", "attacker"), {"tries": 2.0}) == ("back, attacker, try 2", True)
    assert told(("support", "supporter"), {}) == ("supporter", False)
    assert told((), {"rank": 0.0}, keeper=True) == ("goalkeeper", False)
    assert told(("defender",), {"detour": 0.4}) == ("defender, goes round", True)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ("belief,trial", "unknown overlay 'trial', did you mean 'trail'"),
        ({"robot": "goalie"}, "robot must be an agent, as home_1 or blue 2, or ball, got 'goalie'"),
        ({"belief": 3}, "belief must be"),
        (7, "overlays must be names of belief, sight"),
    ],
)
def test_wrong_overlays_are_named(given: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        parse_flags(given)


def test_an_env_draws_them_and_without_flags_nothing_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    from soccer_env import soccer_v0

    make: Callable[..., Any] = soccer_v0.parallel_env
    frames = []
    for overlays in (None, "belief,roles"):
        env = make(home=1, away=1, opponents="chaser", render_mode="rgb_array", overlays=overlays)
        env.reset(seed=3)
        env.step({"home_0": np.zeros(4, np.float32)})
        frames.append(env.render())
    assert not np.array_equal(*frames)
    match = played("legged-2001")[0]
    monkeypatch.setattr(Thoughts, "look", None)
    assert Onlooker(match, None).see(match, 480) == []
