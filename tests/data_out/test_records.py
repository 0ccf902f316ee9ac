"""Every format tells the places, speeds, owners, halves and goals that the records of the match have, in its units."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.data_out.collect import Collected
from soccer_env.data_out.standard import write_standard
from soccer_env.data_out.tables import event_table
from soccer_env.replay import Replay
from soccer_env.types import Phase
from tests.data_out.readers import READERS, frame_at

NEEDS = {"parquet": "pyarrow", "kloppy": "kloppy"}
# [m, m/s, rad] half of the last digit, and a little
ROUNDED = {"kloppy": 1e-12, "page": 6e-4, "xml": 6e-4, "cdf": 1e-4, "csv": 1e-6}
Records = dict[str, np.ndarray]


@pytest.fixture(scope="module")
def records(replay: Replay) -> Records:
    """Return copies of the records of each frame: match (T,), ball (T,), robots (T, R), events (T,)."""
    frames: list[tuple[Any, ...]] = []
    for match in replay.play():
        arrays = (match.matches, match.balls, match.robots, match.events)
        frames.append(tuple(array[0].copy() for array in arrays))
    return dict(zip(("match", "ball", "robots", "events"), map(np.array, zip(*frames, strict=True)), strict=True))


def expected_of(records: Records, frames: np.ndarray, rate: int) -> Records:
    """Return what formats tell of some frames, by the names that readers have for it."""
    match, ball, robots = (records[name][frames] for name in ("match", "ball", "robots"))
    on_pitch, has_ball = robots["active"] == 1, robots["has_ball"] == 1
    home = robots["team"][0] == 0
    ours, theirs = has_ball[:, home].any(axis=1), has_ball[:, ~home].any(axis=1)
    place, velocity = (np.stack([robots[x], robots[y]], axis=-1) for x, y in (("x", "y"), ("vx", "vy")))
    ball_place = np.stack([ball["x"], ball["y"]], axis=-1)
    there = np.where(on_pitch[..., None], place, np.nan)
    return {
        "frame": frames, "time": frames / rate, "period": match["half"] + 1, "clock": match["clock"],
        "home_direction": match["home_direction"], "score": match["score"],
        "in_play": (match["phase"] == Phase.PLAY) & (match["placing"] == 0), "has_ball": has_ball, "on_pitch": on_pitch,
        "owner": np.select([ours & ~theirs, theirs & ~ours], [0, 1], -1),
        "ball": ball_place, "turned_ball": ball_place * match["home_direction"][:, None],
        "ball_velocity": np.stack([ball["vx"], ball["vy"]], axis=-1), "ball_speed": np.hypot(ball["vx"], ball["vy"]),
        "every_robot": place, "robots": there, "turned_robots": there * match["home_direction"][:, None, None],
        "velocities": velocity, "speeds": np.where(on_pitch, np.linalg.norm(velocity, axis=-1), np.nan),
        "headings": robots["heading"],
    }  # fmt: skip


@pytest.mark.parametrize("kind", READERS)
def test_a_format_tells_what_the_records_of_the_match_are(
    kind: str, replay: Replay, found: Collected, records: Records, tmp_path: Path
) -> None:
    pytest.importorskip(NEEDS.get(kind, "numpy"))
    told = READERS[kind](replay, found, tmp_path)
    frames = told["frame"].astype(int)
    expected = expected_of(records, frames, found.league.control_rate)
    assert set(told["period"]) == {1, 2}
    assert set(expected["owner"]) == {0, 1, -1}, "the ball is at home, at away and at nobody"
    assert np.abs(expected["ball"]).max(axis=0).min() > 0.2, "not on an axis alone"
    for name, numbers in told.items():
        tolerance = 0.06 if (kind, name) == ("page", "clock") else ROUNDED.get(kind, 0.0)
        wanted = expected[name].astype(float)
        if kind == "kloppy" and name == "headings":
            wanted = np.where(expected["on_pitch"], wanted, np.nan)
        np.testing.assert_allclose(numbers.astype(float), wanted, rtol=0.0, atol=tolerance, err_msg=f"{kind}: {name}")


def goals_in(records: Records) -> list[tuple[int, int, int]]:
    """Return frame, team and half (from 1) of each goal: where the score grows."""
    score = records["match"]["score"]
    grown = np.argwhere(np.diff(score, axis=0)).tolist()
    return [(frame + 1, team, int(records["match"]["half"][frame]) + 1) for frame, team in grown]


def test_every_format_tells_the_goals_of_the_score(
    replay: Replay, found: Collected, records: Records, tmp_path: Path
) -> None:
    goals, rate = goals_in(records), found.league.control_rate
    assert len({half for _, _, half in goals}) == 2, "goals in both halves"
    table = event_table(found)
    rows = np.flatnonzero(table["event"] == "goal")
    sides = {"home": 0, "away": 1}
    assert [(table["frame"][at], sides[table["team"][at]], table["period"][at]) for at in rows] == goals
    sheet = json.loads((write_standard(found, tmp_path / "x.cdf") / "match.json").read_text())
    halves = {"first_half": 1, "second_half": 2}
    told = [(frame_at(g["time"], rate), sides[g["team_id"]], halves[g["period"]]) for g in sheet["events"]["goals"]]
    assert told == goals
    for half, name in (("first_half", 1), ("second_half", 2)):
        scored = [sum(team == side for _, team, when in goals if when == name) for side in (0, 1)]
        assert [*sheet["match"]["result"][half].values()] == scored
    final = sheet["match"]["result"]["final"]
    home, away = records["match"]["score"][-1].tolist()
    winner = None if home == away else "home" if home > away else "away"
    assert final == {"home": home, "away": away, "winning_team_id": winner}


def test_events_lie_where_the_ball_was_and_are_turned_with_the_half(
    found: Collected, records: Records, tmp_path: Path
) -> None:
    ball = np.stack([records["events"]["ball_x"], records["events"]["ball_y"]], axis=-1)  # before any restart
    table = event_table(found)
    kinds = ("pass", "shot", "interception", "save")
    at = np.flatnonzero(np.isin(table["event"], kinds))
    places = np.stack([table["x"], table["y"]], axis=-1)[at]
    reach = 1.5 * found.league.body.reach
    assert len(at) > 2 and np.linalg.norm(places - ball[table["frame"][at]], axis=1).max() < reach
    ends = table["end_frame"] >= 0
    end = np.stack([table["end_x"], table["end_y"]], axis=-1)
    np.testing.assert_array_equal(end[ends], ball[table["end_frame"][ends]])
    lines = (write_standard(found, tmp_path / "x.cdf") / "event.jsonl").read_text().splitlines()
    told = [json.loads(line) for line in lines]
    direction = records["match"]["home_direction"]
    for line in told:
        event, frame = line["event"], line["tracking"]["frame_id"]
        if event["type"] in ("pass", "shot"):
            place = np.array([event["x"], event["y"]]) * direction[frame]
            assert np.linalg.norm(place - ball[frame]) < reach
            assert event["x_end"] is not None and abs(event["x_end"]) <= 0.55 * found.league.pitch.length
    assert {line["event"]["period"] for line in told} == {"first_half", "second_half"}
