"""The spread of a training over its seeds: every curve is drawn, and runs that are not alike are refused."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

pytest.importorskip("stable_baselines3")

from soccer_env.train.ppo.compare_seeds import check_alike, figure_of, main, read_run, table_of


def run(folder: Path, seed: int, last: float, **settings: object) -> Path:
    """Write the folder of a run with two evaluations."""
    folder.mkdir()
    conditions = {"seed": seed, "name": f"s{seed}", "steps": 8, "rules": "league", **settings}
    (folder / "settings.json").write_text(json.dumps({"conditions": conditions}))
    rows = [[{"opponent": "chaser", "goal_difference": value}] for value in (-1.0, last)]
    text = "".join(json.dumps({"step": 4 * n, "rows": row}) + "\n" for n, row in enumerate(rows))
    (folder / "evaluations.jsonl").write_text(text)
    return folder


def test_a_curve_for_each_seed_and_the_spread_of_where_they_ended(tmp_path: Path) -> None:
    runs = [read_run(run(tmp_path / str(seed), seed, last)) for seed, last in ((1, 0.5), (2, -0.25), (3, 1.25))]
    curves = figure_of(runs)["curves"]
    assert [curve["name"] for curve in curves] == [f"against chaser, seed {seed}" for seed in (1, 2, 3)]
    assert curves[1]["x"] == [0.0, 4.0] and curves[1]["y"] == [-1.0, -0.25]
    rounds = [{**one, "step": 0, "advised": 7 * n + 7} for n, one in enumerate(runs[0].evaluations)]
    advised = replace(runs[0], evaluations=rounds)
    assert figure_of([advised, runs[1]])["curves"][0]["x"] == [7.0, 14.0]
    assert table_of(runs) == ["chaser: +0.50, -0.25, +1.25; mean +0.50, from -0.25 to +1.25"]


def test_only_runs_of_one_recipe_and_different_seeds_are_put_together(tmp_path: Path) -> None:
    one, same = read_run(run(tmp_path / "a", 1, 0.0)), read_run(run(tmp_path / "b", 1, 0.0))
    other = read_run(run(tmp_path / "c", 2, 0.0, rules="simple"))
    with pytest.raises(ValueError, match="seeds must be different, got 1, 1"):
        check_alike([one, same])
    with pytest.raises(ValueError, match="different recipes: rules differ"):
        check_alike([one, other])
    with pytest.raises(ValueError, match="two runs at least, got 1"):
        main((tmp_path / "a",))
    with pytest.raises(ValueError, match="holds no training"):
        read_run(tmp_path)


def test_the_picture_is_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    main((run(tmp_path / "a", 1, 0.5), run(tmp_path / "b", 2, 0.75)), out=tmp_path / "spread.png")
    assert (tmp_path / "spread.png").read_bytes().startswith(b"\x89PNG")
    assert "mean +0.62" in capsys.readouterr().out
