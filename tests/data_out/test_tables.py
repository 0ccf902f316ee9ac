"""Tables hold what the match was, in every format, and every format tells what the records are, in its units."""

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.data_out.standard import write_standard
from soccer_env.data_out.table_files import escape_formula, write_tables
from soccer_env.data_out.tables import EVENTS, TRACKING, event_table, match_tables, tracking_table
from soccer_env.types import Phase
from tests.data_out.readers import READERS, frame_at


def test_every_frame_has_a_row_for_the_ball_and_for_each_robot(replay: Any, found: Any) -> None:
    table = tracking_table(found)
    assert [*table] == [column.name for column in TRACKING]
    assert len(table["x"]) == (len(replay) + 1) * 5
    *_, last = replay.play()
    rows = {name: values[-5:] for name, values in table.items()}
    assert rows["object"].tolist() == ["ball", "home_0", "home_1", "away_0", "away_1"]
    assert rows["x"].tolist() == [last.balls["x"][0], *last.robots["x"][0].tolist()]
    assert rows["vy"].tolist() == [last.balls["vy"][0], *last.robots["vy"][0].tolist()]
    assert np.isnan(rows["heading"][0])
    assert set(table["period"].tolist()) == {1, 2}
    assert set(table["home_direction"].tolist()) == {1, -1}
    assert table["time"][-1] == pytest.approx(len(replay) / found.league.control_rate)


def test_events_are_those_that_are_counted(replay: Any, found: Any) -> None:
    *_, last = replay.play()
    counts, table = last.statistics[0], event_table(found)
    kinds = table["event"].tolist()
    assert kinds.count("goal") == counts["goals"].sum() == found.score[-1].sum() > 0
    assert kinds.count("shot") == counts["shots"].sum() > 0
    assert kinds.count("pass") == counts["passes_tried"].sum()
    assert kinds.count("interception") == counts["interceptions"].sum()
    assert kinds.count("kick") == counts["kicks"].sum()
    assert kinds.count("half_time") == kinds.count("final_whistle") == 1
    assert (np.diff(table["frame"]) >= 0).all()
    goals = np.flatnonzero(table["event"] == "goal")
    assert (table["home_score"] + table["away_score"])[goals].tolist() == [*range(1, len(goals) + 1)]
    shot_goals = (table["event"] == "shot") & (table["outcome"] == "goal")
    assert set(table["end_frame"][shot_goals].tolist()) <= set(table["frame"][goals].tolist())


def test_parquet_holds_the_table_with_units(found: Any, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    paths = write_tables([match_tables(found)] * 2, tmp_path / "x.parquet")
    read, table = parquet.read_table(paths["tracking"]), tracking_table(found)
    assert read.num_rows == 2 * len(table["x"])
    assert read["x"].to_numpy()[: len(table["x"])].tolist() == table["x"].tolist()
    assert read.schema.field("vx").metadata == {b"unit": b"m/s", b"text": b"velocity along x"}
    assert read["heading"][0].as_py() is None
    assert parquet.read_table(paths["events"]).num_rows == 2 * len(found.events)
    assert all(column.text for column in (*TRACKING, *EVENTS))


def test_a_match_that_fails_leaves_what_was_there(found: Any, tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text("mine")

    def matches() -> Any:
        yield match_tables(found)
        raise ValueError("the second one is damaged")

    with pytest.raises(ValueError, match="damaged"):
        write_tables(matches(), tmp_path / "x.csv")
    assert [path.name for path in tmp_path.iterdir()] == ["x.csv"]
    assert (tmp_path / "x.csv").read_text() == "mine"


@pytest.mark.parametrize("text", ["=1+1", "+1", "-1", "@x"])
def test_no_cell_of_a_csv_is_a_formula(text: str) -> None:
    assert escape_formula(text) == f"'{text}"
    assert escape_formula("match-1") == "match-1"


@pytest.mark.parametrize("name", ["x.csv", "x.cdf"])
def test_nothing_is_written_over(folder: Path, tmp_path: Path, name: str, soccer: Any) -> None:
    words = ["export", folder / "one.replay", "--out", tmp_path / name]
    soccer(*words)
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")}
    assert "exists already" in soccer(*words, code=2)
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")} == before
    soccer(*words, "--anew")


def test_folders_of_other_things_and_without_replays_are_refused(folder: Path, tmp_path: Path, soccer: Any) -> None:
    (tmp_path / "x.cdf").mkdir()
    (tmp_path / "x.cdf" / "mine").touch()
    words = ["export", folder / "one.replay", "--out", tmp_path / "x.cdf", "--anew"]
    assert "other files" in soccer(*words, code=2)
    assert "there are no replays" in soccer("export", tmp_path, "--out", tmp_path / "x.csv", code=2)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="limits of Unix")
@pytest.mark.parametrize("name", ["x.csv", "x.parquet", "x.cdf"])
def test_where_there_is_no_room_nothing_is_left_and_the_file_is_named(found: Any, tmp_path: Path, name: str) -> None:
    import resource

    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, before[1]))
    try:
        with pytest.raises(OSError, match=r"File too large: '.*x") as error:
            if name in ("x.csv", "x.parquet"):
                write_tables([match_tables(found)], tmp_path / name)
            else:
                write_standard(found, tmp_path / name)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert Path(error.value.filename).is_relative_to(tmp_path)
    assert os.listdir(tmp_path) == []


NEEDS = {"parquet": "pyarrow", "kloppy": "kloppy"}
# [m, m/s, rad] half of the last digit, and a little
ROUNDED = {"kloppy": 1e-12, "page": 6e-4, "cdf": 1e-4, "csv": 1e-6}
Records = dict[str, np.ndarray]


@pytest.fixture(scope="module")
def records(replay: Any) -> Records:
    """Return copies of the records of each frame: match (T,), ball (T,), robots (T, R), events (T,)."""
    frames: list[tuple[Any, ...]] = []
    for match in replay.play():
        arrays = (match.matches, match.balls, match.robots, match.events)
        frames.append(tuple(array[0].copy() for array in arrays))
    return dict(zip(("match", "ball", "robots", "events"), map(np.array, zip(*frames, strict=True)), strict=True))


def expected_of(records: Any, frames: np.ndarray, rate: int) -> Records:
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
    kind: str, replay: Any, found: Any, records: Any, tmp_path: Path
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


def goals_in(records: Any) -> list[tuple[int, int, int]]:
    """Return frame, team and half (from 1) of each goal: where the score grows."""
    score = records["match"]["score"]
    grown = np.argwhere(np.diff(score, axis=0)).tolist()
    return [(frame + 1, team, int(records["match"]["half"][frame]) + 1) for frame, team in grown]


def test_every_format_tells_the_goals_of_the_score(replay: Any, found: Any, records: Any, tmp_path: Path) -> None:
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


def test_events_lie_where_the_ball_was_and_are_turned_with_the_half(found: Any, records: Any, tmp_path: Path) -> None:
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
    balls = [line["event"] for line in told if line["event"]["type"] in ("pass", "shot")]
    rows = np.flatnonzero(np.isin(table["event"], ("pass", "shot")))
    last = np.where(ends, table["end_frame"], table["frame"])[rows]
    spots = np.where(ends[:, None], end, np.stack([table["x"], table["y"]], axis=-1))[rows] * direction[last][:, None]
    told_ends = sorted((event["x_end"], event["y_end"]) for event in balls)
    np.testing.assert_allclose(told_ends, sorted(map(tuple, spots)), atol=0.01)
