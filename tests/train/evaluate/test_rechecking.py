"""`soccer evaluate --recheck`: what agrees bit for bit, what was changed is found, nothing is written."""

import json
import os
import shutil
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from pytest import CaptureFixture, MonkeyPatch, TempPathFactory

from soccer_env import make_team
from soccer_env.agents import learned
from soccer_env.train.command.command_line import main
from soccer_env.train.evaluate import EvaluateSettings, evaluate, recheck, rechecking

SHORT: dict[str, Any] = {"home": "chaser", "away": "random", "matches": 6, "minutes": 0.1, "players": 1, "seed": 5}
POLICY = Path(learned.__file__).parent / "policies" / "learned.safetensors"


@pytest.fixture(scope="module")
def finished(tmp_path_factory: TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("finished") / "run"
    evaluate(EvaluateSettings(**SHORT, out=folder))
    return folder


@pytest.fixture
def folder(finished: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(finished, tmp_path / "run"))


def changed(folder: Path, match: int, change: Callable[[dict[str, Any]], None]) -> None:
    lines = [json.loads(line) for line in (folder / "matches.jsonl").read_text().splitlines()]
    for line in lines:
        if line["match"] == match:
            change(line)
    (folder / "matches.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))


def content(folder: Path) -> dict[str, tuple[bytes, int]]:
    return {path.name: (path.read_bytes(), path.stat().st_mtime_ns) for path in folder.rglob("*") if path.is_file()}


def test_an_honest_folder_agrees_and_stays_as_it_is(folder: Path, soccer: Any) -> None:
    before = content(folder)
    printed = soccer("evaluate", "--recheck", folder, "--pairs", "2", "--seed", "3")
    assert "2 of 3 finished pairs played again (drawn with --pairs 2 --seed 3), 2 agree, 0 differ" in printed
    assert "result.json follows from matches.jsonl" in printed
    soccer("evaluate", "--recheck", folder, "--pairs", "all", "--threads", "2")
    assert content(folder) == before


@pytest.mark.parametrize(
    ("change", "found"),
    [
        (lambda line: line.update(goals_for=line["goals_for"] + 3), "match 3: goals_for is 3 there, 0 played again"),
        (lambda line: line["statistics"].update(shots_for=9), "match 3: statistics.shots_for is 9 there, 0 played"),
        (lambda line: line.update(state="0" * len(line["state"])), "match 3: state is '0000"),
        (lambda line: line["maps"]["heat_ball"][3].__setitem__(5, 77), "maps.heat_ball.3.5 is 77 there, 0 played"),
        (lambda line: line["statistics"].pop("shots_for"), "statistics.shots_for is nothing there, 0 played again"),
        (lambda line: line.update(seed=1), "match 3: seed is 1 there"),
    ],
)
def test_what_was_changed_is_named(change: Callable[[Any], None], found: str, folder: Path, soccer: Any) -> None:
    changed(folder, 3, change)
    before = content(folder)
    printed = soccer("evaluate", "--recheck", folder, "--pairs", "all", code=1)
    assert "pair 1, matches 2 and 3: differs" in printed and found in printed
    assert "3 of 3 finished pairs played again, 2 agree, 1 differ" in printed
    assert content(folder) == before


def test_a_changed_result_is_found_though_all_lines_agree(folder: Path, soccer: Any) -> None:
    record = json.loads((folder / "result.json").read_text())
    (folder / "result.json").write_text(json.dumps({**record, "wins": 6}))
    found = json.loads(soccer("evaluate", "--recheck", folder, "--pairs", "1", "--json", code=1))
    assert (found["differences"], found["result"], found["agrees"]) == ([], ["'wins'"], False)


@pytest.mark.parametrize(
    ("field", "value"),
    [("statistics", {"a": "x"}), ("goals_for", 10**400), ("steps", -1), ("maps", {"shots_for": [[1]]})],
)
def test_lines_that_no_match_writes_are_refused_by_all(field: str, value: Any, folder: Path, soccer: Any) -> None:
    changed(folder, 3, lambda line: line.update({field: value}))
    assert f"match 3: {field}" in soccer("evaluate", "--recheck", folder, "--pairs", "all", code=1)
    with pytest.raises(ValueError, match=r"match 3"):
        evaluate(EvaluateSettings(**SHORT, out=folder))


def test_lines_that_were_taken_away_are_missed(folder: Path, soccer: Any) -> None:
    lines = (folder / "matches.jsonl").read_text().splitlines(keepends=True)
    (folder / "matches.jsonl").write_text("".join(line for line in lines if json.loads(line)["pair"] != 1))
    printed = soccer("evaluate", "--recheck", folder, "--pairs", "all", code=1)
    assert "1 pairs of 3 are not finished" in printed
    assert "result.json: all of it, as 2 of its 6 matches have no line, does not follow" in printed


def test_the_draw_follows_from_its_seed_and_else_from_nothing_known(folder: Path) -> None:
    pairs = list(range(100))
    assert rechecking.sample(pairs, 5, 1) == rechecking.sample(pairs, 5, 1) != rechecking.sample(pairs, 5, 2)
    assert rechecking.sample(pairs, "all", 1) == rechecking.sample(pairs, 200, 1) == pairs
    assert recheck(folder, pairs=1).seed != recheck(folder, pairs=1).seed


def test_an_evaluation_that_was_stopped_or_has_grown_is_checked_as_far_as_it_is(folder: Path) -> None:
    evaluate(EvaluateSettings(**{**SHORT, "matches": 8}, out=folder))
    assert recheck(folder, pairs="all").agrees
    (folder / "result.json").unlink()  # else it does not follow from what is left
    lines = (folder / "matches.jsonl").read_bytes().splitlines(keepends=True)
    (folder / "matches.jsonl").write_bytes(b"".join(lines[:5]) + lines[5][:40])
    result = recheck(folder, pairs="all")
    assert result.agrees and result.result is None and 0 < result.finished < 4
    assert (folder / "matches.jsonl").read_bytes().endswith(lines[5][:40]), "a torn line is left as it is"


def test_a_policy_file_is_found_where_it_lies_now(tmp_path: Path, soccer: Any) -> None:
    policy, again = tmp_path / "mine.safetensors", ["evaluate", "--recheck", tmp_path / "run"]
    shutil.copy(POLICY, policy)
    evaluate(EvaluateSettings(**{**SHORT, "home": str(policy), "matches": 2}, out=tmp_path / "run"))
    soccer(*again)
    moved = policy.rename(tmp_path / "moved.safetensors")
    assert "--home and --away say where a file is now" in soccer(*again, code=2)
    soccer(*again, "--home", moved)
    assert "home_team" in soccer(*again, "--home", "chaser", code=2)


def test_a_team_of_a_program_is_given_in_python(tmp_path: Path, soccer: Any) -> None:
    team = {"mine": make_team("chaser", strength=0.5)}
    evaluate(EvaluateSettings(**{**SHORT, "home": "mine", "matches": 2}, out=tmp_path), teams=team)
    assert "recheck(folder, teams={name: team})" in soccer("evaluate", "--recheck", tmp_path, code=2)
    assert recheck(tmp_path, teams=team).agrees


def test_code_that_a_folder_names_is_not_run(tmp_path: Path, monkeypatch: MonkeyPatch, soccer: Any) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "lions_of_mine.py").write_text("from soccer_env import make_team\nteam = make_team('chaser')\n")
    evaluate(EvaluateSettings(**{**SHORT, "home": "lions_of_mine:team", "matches": 2}, out=tmp_path / "run"))
    monkeypatch.delitem(sys.modules, "lions_of_mine")
    assert "--home lions_of_mine:team" in soccer("evaluate", "--recheck", "run", code=2)
    assert "lions_of_mine" not in sys.modules
    soccer("evaluate", "--recheck", "run", "--home", "lions_of_mine:team")


def test_lines_of_another_version_are_compared_and_said(folder: Path, monkeypatch: MonkeyPatch, soccer: Any) -> None:
    monkeypatch.setattr("soccer_env.train.provenance.version_of", lambda package: "9.9")
    printed = soccer("evaluate", "--recheck", folder, "--pairs", "1")
    assert "made with other versions, so that lines may differ: soccer_env '" in printed


def test_ctrl_c_changes_nothing(folder: Path, monkeypatch: MonkeyPatch, capsys: CaptureFixture[str]) -> None:
    def interrupted(*rest: Any) -> None:
        raise KeyboardInterrupt

    before = content(folder)
    monkeypatch.setattr(rechecking, "play_batches", interrupted)
    assert main(["evaluate", "--recheck", str(folder)]) == 130
    assert capsys.readouterr().err == "stopped; no file was changed\n"
    assert content(folder) == before


@pytest.mark.parametrize(
    ("file", "text", "message"),
    [
        ("settings.json", None, "but no settings.json"),
        ("settings.json", "{}", "is of something else"),
        ("settings.json", "[[[", "cannot be read as JSON"),
        ("matches.jsonl", "x\n{}\n", "line 1: not a record"),
        ("matches.jsonl", '{"a": 1}\n', "a line has the fields"),
        ("matches.jsonl", "", "has no finished pair yet"),
        ("matches.jsonl", None, "has no finished pair yet"),
    ],
)
def test_a_damaged_folder_is_one_line(file: str, text: str | None, message: str, folder: Path, soccer: Any) -> None:
    (folder / file).unlink()
    if text is not None:
        (folder / file).write_text(text)
    assert message in soccer("evaluate", "--recheck", folder, code=2)


CONDITIONS: list[tuple[str, Any, str]] = [
    ("matches", 10**12, "matches must be an even number of 2 to"),
    ("minutes", "full", "minutes must be 20.0, got 'full'"),
    ("minutes", float("nan"), "minutes must be a number above 0"),
    ("players", [1, [2]], "players must be 1 to 11"),
    ("senses", "sensors", "players and senses must be two each"),
    ("league", "os:system", "is code, 'os:system', that is not run because a folder names it"),
    ("scene", "kick-off:0.5,os:system:0.5", "is code, 'kick-off:0.5,os:system:0.5', that is not run"),
    ("scene", 7, "scene must be a name, got 7"),
    ("scene", "empty-goal", "evaluate_drills"),
    ("seed", -1, "seed must be a whole number"),
    ("rules", "chess", "chess"),
    ("pose", None, "pose must be 'particles', got None"),
    ("home", "/dev/zero.safetensors", "cannot be made again"),
]


@pytest.mark.parametrize(("name", "value", "message"), CONDITIONS)
def test_conditions_that_cannot_be_are_one_line(name: str, value: Any, message: str, folder: Path, soccer: Any) -> None:
    record = json.loads((folder / "settings.json").read_text())
    record["conditions"][name] = value
    (folder / "settings.json").write_text(json.dumps(record))
    (folder / "matches.jsonl").write_text("")  # else the lines are of other settings already
    assert message in soccer("evaluate", "--recheck", folder, code=2)


def test_a_pipe_is_not_waited_for(folder: Path, soccer: Any) -> None:
    (folder / "matches.jsonl").unlink()
    os.mkfifo(folder / "matches.jsonl")
    assert "is not a regular file" in soccer("evaluate", "--recheck", folder, code=2)
