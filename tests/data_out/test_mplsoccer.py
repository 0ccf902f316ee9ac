"""The example of the page that draws the maps of a result.json with mplsoccer: as it stands, for both leagues."""

import json
import re
from pathlib import Path

import pytest

from soccer_env.train.evaluate import EvaluateSettings, evaluate

pytest.importorskip("mplsoccer")
PAGE = Path(__file__).parents[2] / "soccer_env/data_out/README.md"


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_the_example_draws_the_maps_of_a_result(league: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    result = evaluate(EvaluateSettings(league=league, home="chaser", away="still", matches=2, minutes=0.2, players=2))
    (tmp_path / "result.json").write_text(json.dumps(result.as_dict()), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MPLBACKEND", "agg")
    (example,) = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    exec(compile(example, str(PAGE), "exec"), {"__name__": "example"})
    assert (tmp_path / "maps.png").read_bytes().startswith(b"\x89PNG")
