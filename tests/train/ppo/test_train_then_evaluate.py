"""What was trained is evaluated on the senses that it learned by: by default, or as the error says."""

import re
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("stable_baselines3")


import stable_baselines3 as sb3

from soccer_env.train.ppo.vec_env import SoccerVecEnv

AGAINST = ["--away", "still", "--players", "1", "--matches", "2", "--minutes", "0.05", "--seed", "1"]


def saved(folder: Path, **settings: Any) -> str:
    rows = SoccerVecEnv(players=[(1, 1)], matches=2, opponents="still", minutes=0.1, **settings)
    model = sb3.PPO("MlpPolicy", rows, n_steps=8, batch_size=8, n_epochs=1, seed=1, device="cpu").learn(16)
    model.save(folder / "mine.zip")
    return str(folder / "mine.zip")


@pytest.fixture
def evaluated(soccer: Any) -> Any:
    words = ["evaluate", *AGAINST]
    return lambda home, *more, code=0: " ".join(soccer(*words, "--home", home, *more, code=code).split())


def test_what_was_trained_is_evaluated_with_either_flag_that_the_error_names(
    tmp_path: Path, soccer: Any, evaluated: Any
) -> None:
    short = "--players 1v1 --steps 64 --matches 2 --minutes 0.05 --rollout 16 --batch 32"
    judged = "--evaluate-every 1000000 --evaluate-matches 2 --evaluate-minutes 0.05 --evaluate-against still"
    words = ["train", *short.split(), *judged.split(), "--no-mirror"]
    soccer(*words, "--critic-first", "0", "--opponents", "still", "--out", tmp_path / "run")
    last = str(tmp_path / "run/last.safetensors")
    said = evaluated(last, code=2)
    assert f"{last!r} was trained with pose='percept', evaluations have 'particles' by default" in said
    flags = re.findall(r"--pose \w+", said)
    assert flags == ["--pose percept", "--pose particles"]
    assert "was trained with" not in evaluated(last, *flags[0].split())
    assert "policy was trained with pose percept." in evaluated(last, *flags[1].split())


def test_rows_of_the_truth_are_evaluated_with_the_flag_that_the_error_names(tmp_path: Path, evaluated: Any) -> None:
    path = saved(tmp_path)  # by default a SoccerVecEnv shows the truth, robots of an evaluation use their sensors
    said = evaluated(f"{path}:at_once=False", code=2)
    flags = re.search(r"a command takes (--senses \w+)", said)
    assert flags is not None, said
    evaluated(f"{path}:at_once=False", *flags[1].split())


def test_rows_of_beliefs_are_evaluated_as_the_error_says(tmp_path: Path, evaluated: Any) -> None:
    path = saved(tmp_path, observe="belief", action_repeat=8)
    said = evaluated(path, code=2)
    assert "takes 100 inputs, 'truth' of 'legged-2001' has 73: give observe=belief" in said
    evaluated(f"{path}:observe=belief,action_repeat=8,at_once=False")
    assert "with state=True?" in evaluated(saved(tmp_path, state=True), code=2)
