"""What others read of our files: the validator of the Common Data Format, kloppy's loader and datasets, mplsoccer."""

import json
import re
import sys
import warnings
from datetime import datetime
from pathlib import Path

import numpy as np
import pytest

from soccer_env.data_out import kloppy_tracking
from soccer_env.data_out.collect import MatchRecording
from soccer_env.data_out.standard import FILES, write_standard
from soccer_env.replay import Replay
from soccer_env.train.evaluate import EvaluateSettings, evaluate

PAGE = Path(__file__).parents[2] / "soccer_env/data_out/README.md"


def test_the_validator_of_the_common_data_format_accepts_every_line(found: MatchRecording, tmp_path: Path) -> None:
    cdf = pytest.importorskip("cdf")
    folder = write_standard(found, tmp_path / "x.cdf")
    assert sorted(path.name for path in folder.iterdir()) == sorted(FILES)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name, kind in zip(FILES, ("Meta", "Match", "Tracking", "Event"), strict=True):
            validator = getattr(cdf, f"{kind}SchemaValidator")()
            validator.validate_schema(sample=folder / name, mode="extreme", limit=None)


def test_the_common_data_format_tells_each_goal_once(found: MatchRecording, tmp_path: Path) -> None:
    folder = write_standard(found, tmp_path / "x.cdf")
    events = [json.loads(line)["event"] for line in (folder / "event.jsonl").read_text().splitlines()]
    shots = [event for event in events if event["type"] == "shot"]
    told = [shot for shot in shots if shot["outcome_type"] in ("successful", "own_goal")]
    sheet = json.loads((folder / "match.json").read_text())
    assert len(told) == len(sheet["events"]["goals"]) == found.score[-1].sum() > 0
    assert sheet["match"]["result"]["final"]["home"] == found.score[-1, 0]
    halves = json.loads((folder / "meta.json").read_text())["match"]["periods"]
    assert sorted(half["left_team_id"] for half in halves) == ["away", "home"]
    for number, half in enumerate(halves, 1):
        inside = np.flatnonzero(found.periods == number)
        assert (half["frame_id_start"], half["frame_id_end"]) == (inside[0], inside[-1])
        lasts = datetime.fromisoformat(half["end_time"][:-1]) - datetime.fromisoformat(half["start_time"][:-1])
        assert lasts.total_seconds() == pytest.approx(np.ptp(found.time[inside]), abs=1e-5)


def test_kloppy_turns_its_dataset_there_and_back(replay: Replay, found: MatchRecording) -> None:
    pytest.importorskip("kloppy")
    dataset = kloppy_tracking(replay)
    assert len(dataset) == len(found)
    assert dataset.metadata.frame_rate == found.league.control_rate
    ours = dataset.metadata.coordinate_system
    normed = dataset.transform(to_coordinate_system="kloppy")
    back = normed.transform(to_coordinate_system=ours)
    pitch = found.league.pitch
    for frame in range(0, len(found), 97):
        here, there, again = dataset.frames[frame], normed.frames[frame], back.frames[frame]
        assert there.ball_coordinates.x == pytest.approx(0.5 + found.ball[frame, 0] / pitch.length)
        assert there.ball_coordinates.y == pytest.approx(0.5 - found.ball[frame, 1] / pitch.width)
        for player, data in here.players_data.items():
            returned = again.players_data[player].coordinates
            assert (returned.x, returned.y) == pytest.approx((data.coordinates.x, data.coordinates.y), abs=1e-9)


def test_without_kloppy_it_says_what_to_install(replay: Replay, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "kloppy", None)
    with pytest.raises(ImportError, match=r'pip install "soccer_env\[data\]"'):
        kloppy_tracking(replay)


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_the_example_draws_the_maps_of_a_result(league: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("mplsoccer")
    result = evaluate(EvaluateSettings(league=league, home="chaser", away="still", matches=2, minutes=0.2, players=2))
    (tmp_path / "result.json").write_text(json.dumps(result.as_dict()), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    (example,) = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    exec(compile(example, str(PAGE), "exec"), {"__name__": "example"})
    assert (tmp_path / "maps.png").read_bytes().startswith(b"\x89PNG")
