"""Policies as teams: named by their files, with messages that say why one does not play, and told apart in results."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.policy import Policy, training_fields
from soccer_env.agents.policy_file import dump
from soccer_env.leagues import find_league
from soccer_env.observations import entry_names
from soccer_env.teams import ObservingTeam, make_team
from soccer_env.train.provenance import team_hash

LEAGUE = "legged-2001"


def policy(seed: int = 0, league: str = LEAGUE, **changes: str) -> Policy:
    rng, trained = np.random.default_rng(seed), find_league(league)
    inputs = tuple(entry_names(trained, "belief"))
    made = Policy(
        name="tiny", **training_fields(trained), observe="belief", inputs=inputs, actions="box", action_repeat=8,
        activation="tanh", mirror=False, weights=(rng.normal(size=(4, len(inputs))).astype(np.float32),),
        biases=(np.zeros(4, np.float32),), made={},
    )  # fmt: skip
    return replace(made, **changes)


def written(path: Path, made: Policy) -> str:
    path.write_bytes(dump(made))
    return str(path)


@pytest.fixture
def evaluate(soccer: Any, tmp_path: Path) -> Any:
    match = ["--away", "still", "--players", "1", "--matches", "2", "--minutes", "0.1", "--seed", "1"]
    words = ["evaluate", *match, "--out", tmp_path / "out"]
    return lambda home, *more, **expected: soccer(*words, "--home", home, *more, **expected)


def test_a_policy_plays_by_the_name_of_its_file(tmp_path: Path, evaluate: Any) -> None:
    file = written(tmp_path / "tiny.safetensors", policy())
    assert isinstance(make_team(file), ObservingTeam) and evaluate(file, quiet=True)
    assert len((tmp_path / "out" / "matches.jsonl").read_text().splitlines()) == 2
    assert json.loads((tmp_path / "out" / "result.json").read_text())["home"] == file


@pytest.mark.parametrize("name", ["none.safetensors", "none.zip", "broken.safetensors", "broken.zip"])
def test_a_missing_file_or_one_that_is_no_policy_is_said(tmp_path, name, evaluate) -> None:
    if name.startswith("broken"):
        (tmp_path / name).write_bytes(b"not a policy")
    said = evaluate(tmp_path / name, code=2)
    assert name in said and ("No such file" in said) == name.startswith("none")
    assert not (tmp_path / "out").exists()


def test_a_policy_of_another_league_or_a_setting_that_it_does_not_have_is_refused(tmp_path, evaluate) -> None:
    file = written(tmp_path / "tiny.safetensors", policy())
    said = "was trained in 'legged-2001' of family legged, 'middle-size-2006' is of family middle-size"
    assert f"policy 'tiny' {said}" in evaluate(file, "--league", "middle-size-2006", code=2)
    assert not (tmp_path / "out").exists()
    with pytest.raises(ValueError, match="has no setting 'observe'"):
        make_team(file, observe="belief")


def test_teams_of_other_weights_have_other_hashes(tmp_path: Path) -> None:
    one, same, other = (written(tmp_path / f"{i}.safetensors", policy(seed)) for i, seed in enumerate((1, 1, 2)))
    assert team_hash(one) == team_hash(same) == team_hash(make_team(one))
    assert len({team_hash(one), team_hash(other), team_hash("still")}) == 3


def test_an_evaluation_does_not_go_on_with_another_policy(tmp_path: Path, evaluate: Any) -> None:
    file = written(tmp_path / "tiny.safetensors", policy(1))
    evaluate(file)
    lines = (tmp_path / "out" / "matches.jsonl").read_bytes()
    evaluate(file)  # nothing is left to do
    written(tmp_path / "tiny.safetensors", policy(2))
    assert "home_team" in evaluate(file, code=2)
    assert (tmp_path / "out" / "matches.jsonl").read_bytes() == lines
    evaluate(file, "--anew")
