"""Tidy tables hold what the match was, in every format: a row for each frame and object, and for each event."""

import csv
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.data_out.collect import Collected
from soccer_env.data_out.sportec import write_sportec
from soccer_env.data_out.standard import write_standard
from soccer_env.data_out.table_files import plain_cell, write_tables
from soccer_env.data_out.tables import EVENTS, TRACKING, event_table, tables_of, tracking_table
from soccer_env.replay import Replay
from soccer_env.train.command.command_line import main


def test_every_frame_has_a_row_for_the_ball_and_for_each_robot(replay: Replay, found: Collected) -> None:
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


def test_events_are_those_that_are_counted(replay: Replay, found: Collected) -> None:
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


def read_csv(path: Path) -> list[dict[str, str]]:
    with path.open(encoding="utf-8", newline="") as file:
        return [*csv.DictReader(file)]


def test_csv_holds_the_table(found: Collected, tmp_path: Path) -> None:
    paths = write_tables([tables_of(found)], tmp_path / "x.csv")
    rows, table = read_csv(paths["tracking"]), tracking_table(found)
    assert len(rows) == len(table["x"])
    assert [*rows[0]] == [column.name for column in TRACKING]
    assert [float(row["x"]) for row in rows] == pytest.approx(table["x"], abs=1e-6)
    assert rows[0]["heading"] == ""
    assert {row["on_pitch"] for row in rows} <= {"true", "false"}
    assert len(read_csv(paths["events"])) == len(found.events)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["x.csv", "x_events.csv"]


def test_parquet_holds_the_table_with_units(found: Collected, tmp_path: Path) -> None:
    parquet = pytest.importorskip("pyarrow.parquet")
    paths = write_tables([tables_of(found)] * 2, tmp_path / "x.parquet")
    read, table = parquet.read_table(paths["tracking"]), tracking_table(found)
    assert read.num_rows == 2 * len(table["x"])
    assert read["x"].to_numpy()[: len(table["x"])].tolist() == table["x"].tolist()
    assert read.schema.field("vx").metadata == {b"unit": b"m/s", b"text": b"velocity along x"}
    assert read["heading"][0].as_py() is None
    assert parquet.read_table(paths["events"]).num_rows == 2 * len(found.events)
    assert all(column.text for column in (*TRACKING, *EVENTS))


def test_a_match_that_fails_leaves_what_was_there(found: Collected, tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text("mine")

    def matches() -> Any:
        yield tables_of(found)
        raise ValueError("the second one is damaged")

    with pytest.raises(ValueError, match="damaged"):
        write_tables(matches(), tmp_path / "x.csv")
    assert [path.name for path in tmp_path.iterdir()] == ["x.csv"]
    assert (tmp_path / "x.csv").read_text() == "mine"


@pytest.mark.parametrize("text", ["=1+1", "+1", "-1", "@x"])
def test_no_cell_of_a_csv_is_a_formula(text: str) -> None:
    assert plain_cell(text) == f"'{text}"
    assert plain_cell("match-1") == "match-1"


def test_a_folder_gives_one_table_with_the_names_of_its_matches(folder: Path, tmp_path: Path) -> None:
    out = tmp_path / "all.csv"
    assert main(["export", str(folder), "--out", str(out)]) == 0
    assert list(dict.fromkeys(row["match"] for row in read_csv(out))) == ["deep/two", "one"]
    assert main(["export", str(folder), "--out", str(tmp_path / "each.xml")]) == 0
    assert sorted(path.name for path in tmp_path.glob("*.xml")) == ["each_deep_two.xml", "each_one.xml"]


@pytest.mark.parametrize("name", ["x.csv", "x.xml", "x.cdf"])
def test_nothing_is_written_over(folder: Path, tmp_path: Path, name: str, capsys: Any) -> None:
    source, out = str(folder / "one.replay"), tmp_path / name
    assert main(["export", source, "--out", str(out)]) == 0
    before = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")}
    assert main(["export", source, "--out", str(out)]) == 2
    assert "exists already" in capsys.readouterr().err
    assert {path: path.stat().st_mtime_ns for path in tmp_path.rglob("*")} == before
    assert main(["export", source, "--out", str(out), "--anew"]) == 0


def test_folders_of_other_things_and_without_replays_are_refused(folder: Path, tmp_path: Path, capsys: Any) -> None:
    (tmp_path / "x.cdf").mkdir()
    (tmp_path / "x.cdf" / "mine").touch()
    assert main(["export", str(folder / "one.replay"), "--out", str(tmp_path / "x.cdf"), "--anew"]) == 2
    assert "other files" in capsys.readouterr().err
    assert main(["export", str(tmp_path), "--out", str(tmp_path / "x.csv")]) == 2
    assert "there are no replays" in capsys.readouterr().err


@pytest.mark.skipif(not hasattr(os, "fork"), reason="limits of Unix")
@pytest.mark.parametrize("name", ["x.csv", "x.parquet", "x.xml", "x.cdf"])
def test_where_there_is_no_room_nothing_is_left_and_the_file_is_named(
    found: Collected, tmp_path: Path, name: str
) -> None:
    import resource

    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, before[1]))
    try:
        with pytest.raises(OSError, match=r"File too large: '.*x") as error:
            if name in ("x.csv", "x.parquet"):
                write_tables([tables_of(found)], tmp_path / name)
            else:
                (write_sportec if name == "x.xml" else write_standard)(found, tmp_path / name)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert Path(error.value.filename).is_relative_to(tmp_path)
    assert os.listdir(tmp_path) == []
