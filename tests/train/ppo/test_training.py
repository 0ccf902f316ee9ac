"""A training: the same weights from the same seed, whatever the threads; files that say what happened; its command."""

import csv
import itertools
import json
import os
import shlex
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.learned import BUNDLED
from soccer_env.agents.policy_file import load
from soccer_env.agents.rules_known import recorded
from soccer_env.guards.checking import Range
from soccer_env.leagues import find_league
from soccer_env.leagues.rules import rule_set
from soccer_env.skills.choices import SKILLS
from soccer_env.train.command.command_line import main
from soccer_env.train.ppo import training
from soccer_env.train.ppo.checks import make_curriculum, make_matches
from soccer_env.train.ppo.options import BOUNDS
from soccer_env.train.ppo.reports import ProgressBoard, policy_contest, rounded, step_unit
from soccer_env.train.ppo.settings import TrainSettings, command_of
from tests.train.ppo.staged_training import ROLLOUT, outcome, records, tiny_settings, train_plainly, weights, whole_run

ROOT = Path(__file__).parents[3]
PATIENCE = 1800.0  # [s] a run may have all kernels to compile first, on a machine that does much else


@pytest.fixture
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a finished run, which is not to be changed."""
    return whole_run(tmp_path_factory)


@pytest.mark.parametrize("change", [{}, {"threads": 2}])
def test_the_same_seed_gives_the_same_weights(tmp_path: Path, whole: Path, change: dict[str, Any]) -> None:
    train_plainly(tiny_settings(tmp_path / "run", **change))
    assert outcome(tmp_path / "run") == outcome(whole)


def test_a_policy_that_chooses_skills_learns_and_plays_as_one_in_a_mirror(tmp_path: Path) -> None:
    for threads in (1, 2):
        folder = tmp_path / f"{threads}"
        train_plainly(tiny_settings(folder, actions="skills", past=1, steps=144, threads=threads))
    assert outcome(tmp_path / "1") == outcome(tmp_path / "2")
    policy = load(tmp_path / "1" / "last.safetensors")
    assert policy.actions == "skills" and policy.mirror and len(policy.biases[-1]) == len(SKILLS)
    last = records(tmp_path / "1" / "log.jsonl")[-1]
    assert 1.0 < last["entropy"] < np.log(len(SKILLS)) and last["kl"] > 0.0


def test_policies_and_settings_say_by_which_rules_they_were_trained(tmp_path: Path, whole: Path) -> None:
    assert load(whole / "last.safetensors").rules == recorded(find_league("legged-2001").rules)
    rules = "simple:pushing=True"
    train_plainly(tiny_settings(tmp_path / "run", steps=1, past=0, rules=rules))
    policy = load(tmp_path / "run" / "last.safetensors")
    assert policy.rules == recorded(rule_set(find_league("legged-2001").rules, rules))
    told = json.loads((tmp_path / "run" / "settings.json").read_text())["conditions"]
    assert told["rules"] == json.loads(policy.made["settings"])["rules"] == rules


def test_matches_and_evaluations_are_played_by_the_rules_asked_for(tmp_path: Path) -> None:
    settings = tiny_settings(tmp_path / "run", rules="simple:pushing=True", scenes="scattered")
    matches = make_matches(settings, make_curriculum(settings), settings.sizes)
    judged = policy_contest(load(BUNDLED), "still", settings, (2, 2)).start("home", [1])
    for match in (*matches.matches, judged):
        assert match.league.rules.name == "simple:pushing=True" and match.league.rules.pushing
    assert {match.settings.scene.name for match in matches.matches} == {"scattered"}
    assert judged.settings.scene.name == "kick-off"
    matches.close()


@pytest.mark.parametrize(
    "change",
    [
        {"mirror": False, "central_critic": False},
        {"observe": "truth", "senses": "ideal", "past": 0, "critic_first": 0, "activation": "relu"},
        {"players": "1v1;1v2,2v2", "opponents": "still;chaser", "stage_steps": 20},
        {"scenes": "kick-off:2,scattered,lost-ball-behind", "rules": "simple", "players": "1v3,3v1,2v3", "matches": 6},
        {"observe": "percepts", "mirror": False, "pose": "particles"},
    ],
)
def test_other_kinds_of_runs_go_on_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, change: dict[str, Any]) -> None:
    train_plainly(tiny_settings(tmp_path / "whole", steps=4 * ROLLOUT, **change))
    show, shown = ProgressBoard.show, itertools.count(1)

    def cut(self: ProgressBoard, step: int) -> None:
        if next(shown) == 20:
            raise KeyboardInterrupt
        show(self, step)

    with monkeypatch.context() as patched:
        patched.setattr(ProgressBoard, "show", cut)
        with pytest.raises(KeyboardInterrupt):
            train_plainly(tiny_settings(tmp_path / "cut", steps=4 * ROLLOUT, **change))
    assert 0 < len(records(tmp_path / "cut" / "log.jsonl")) < len(records(tmp_path / "whole" / "log.jsonl"))
    train_plainly(tiny_settings(tmp_path / "cut", steps=4 * ROLLOUT, **change))
    assert outcome(tmp_path / "cut") == outcome(tmp_path / "whole")


def test_more_steps_go_on_with_a_finished_run(tmp_path: Path, whole: Path) -> None:
    """The weights are those of a run that was longer from the beginning."""
    for steps in (2 * ROLLOUT, 2 * ROLLOUT, 4 * ROLLOUT):  # a finished run that is asked again does nothing
        result = train_plainly(tiny_settings(tmp_path / "two", steps=steps))
        assert result.steps == steps
    train_plainly(tiny_settings(tmp_path / "one", steps=4 * ROLLOUT))
    assert weights(tmp_path / "one" / "last.safetensors") == weights(tmp_path / "two" / "last.safetensors")
    assert [line["step"] for line in records(tmp_path / "two" / "log.jsonl")] == [48, 96, 144, 192]
    assert [one["step"] for one in records(tmp_path / "two" / "evaluations.jsonl")] == [0, 96, 192]


def test_the_actor_waits_while_the_critic_alone_learns(tmp_path: Path) -> None:
    train_plainly(tiny_settings(tmp_path / "run", steps=2 * ROLLOUT, critic_first=2))
    begun = tmp_path / "run" / "best.safetensors"  # all evaluations are alike: the first one stays the best
    assert load(begun).made["step"] == "0"
    assert weights(tmp_path / "run" / "last.safetensors") == weights(begun)
    train_plainly(tiny_settings(tmp_path / "run", steps=3 * ROLLOUT, critic_first=2))
    assert weights(tmp_path / "run" / "last.safetensors") != weights(begun)


def test_the_files_of_a_run_say_what_happened(whole: Path) -> None:
    names = "settings.json progress.csv best.safetensors last.safetensors checkpoint-0.pt checkpoint-1.pt latest.json"
    assert {path.name for path in whole.iterdir()} >= {*names.split(" ")}
    lines = records(whole / "log.jsonl")
    assert [line["rollout"] for line in lines] == [1, 2, 3, 4, 5, 6, 7]
    assert sum(line["episodes"] for line in lines) > 4
    assert set(lines[0]["points"]) == {"still", "chaser@0.5", "past-0", "past-1"}
    assert all(time >= 0.0 for line in lines for time in line["seconds"].values())
    assert {line["noise"] for line in lines[:2]} == {0.6}, "the critic alone learned"
    with (whole / "progress.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [float(row["value_loss"]) for row in rows] == [line["value_loss"] for line in lines]
    evaluations = records(whole / "evaluations.jsonl")
    assert [one["step"] for one in evaluations] == [0, 192, 336]
    assert all(row["low"] <= row["goal_difference"] <= row["high"] for one in evaluations for row in one["rows"])


def test_slots_of_players_that_were_never_met_keep_the_weight_0(whole: Path) -> None:
    """Random weights of a slot that stays empty would be noise in a larger team."""
    policy = load(whole / "last.safetensors")
    weights = {name: policy.weights[0][:, index] for index, name in enumerate(policy.inputs)}
    never = [one for name, one in weights.items() if name.startswith(("teammate_1", "opponent_2"))]
    assert len(never) > 2 and not np.any(never) and weights["opponent_0_present"].any()


def test_a_policy_says_where_it_comes_from(whole: Path) -> None:
    policy = load(whole / "last.safetensors")
    asked = tiny_settings(whole)
    assert policy.made["command"] == command_of(replace(asked, out=TrainSettings.out)), "no folder of this machine"
    told = json.dumps({**asked.decisive(), "steps": asked.steps}, sort_keys=True)
    assert json.loads(policy.made["settings"]) == json.loads(told)
    assert (policy.made["step"], policy.made["seed"]) == ("336", "3")
    assert set(policy.made) >= {"date", "commit", "soccer_env", "torch", "stable_baselines3", "numba", "pymunk"}
    assert policy.mirror and policy.observe == "belief" and policy.action_repeat == 8


def test_the_best_policy_is_that_of_the_best_evaluation(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    differences = iter([0.0, 2.0, 1.0])

    def pretend(policy: Any, settings: TrainSettings, workers: Any) -> list[dict[str, Any]]:
        difference = next(differences)
        row = {"players": "1v1", "opponent": "still", "goal_difference": difference, "low": 0.0, "high": 0.0}
        return [{**row, "points": 0.5}]

    monkeypatch.setattr(training, "evaluate_policy", pretend)
    train_plainly(tiny_settings(tmp_path / "run"))
    assert load(tmp_path / "run" / "best.safetensors").made["step"] == "192"
    assert load(tmp_path / "run" / "last.safetensors").made["step"] == "336"


def test_weights_that_became_nan_are_said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(BOUNDS, "learning_rate", Range(0.0, 1e40))
    wild = tiny_settings(tmp_path / "run", learning_rate=1e30, critic_first=0)
    said = "weights became NaN or infinite by step [0-9]+: a smaller learning_rate"
    with np.errstate(all="ignore"), pytest.raises(ValueError, match=said):
        train_plainly(wild)
    assert np.isfinite(load(tmp_path / "run" / "best.safetensors").weights[0]).all()


def evaluation(step: int, *differences: float) -> dict[str, Any]:
    ends = [{"goal_difference": value, "low": value - 1, "high": value + 1, "points": 0.5} for value in differences]
    return {
        "step": step,
        "rows": [{"players": "1v1", "opponent": f"team-{number}", **row} for number, row in enumerate(ends)],
    }


def test_logs_are_json_that_others_can_read_and_steps_are_told_in_fitting_units() -> None:
    found = [rounded(value) for value in (1.23456789, np.float32(0.5), None, float("nan"), np.inf)]
    assert found == [1.234568, 0.5, None, None, None]
    assert step_unit(2_000_000) == (1e6, " [million]") and step_unit(336_000) == (1e3, " [thousand]")
    assert step_unit(336) == (1.0, "") == step_unit(0)


def words_of(out: Path, **changes: Any) -> list[str]:
    """Return a command as a user gives it to the shell, of a run long enough to be cut."""
    return [sys.executable, "-m", "soccer_env", *shlex.split(command_of(tiny_settings(out, **changes)))[1:]]


@contextmanager
def started(words: list[str], out: Path, rollouts: int) -> Iterator[subprocess.Popen[str]]:
    """Start a command and wait until its run has come to so many rollouts; it does not outlive the test."""
    process = subprocess.Popen(words, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        end = time.monotonic() + PATIENCE
        while rollouts_of(out) < rollouts:
            assert process.poll() is None, process.communicate()
            assert time.monotonic() < end, "nothing happens"
            time.sleep(0.02)
        yield process
    finally:
        process.kill()
        process.communicate()


def rollouts_of(out: Path) -> int:
    return (out / "log.jsonl").read_bytes().count(b"\n") if (out / "log.jsonl").exists() else 0


def test_a_command_that_is_interrupted_says_how_it_goes_on(tmp_path: Path, monkeypatch: Any, capsys: Any) -> None:
    words = words_of(tmp_path / "cut", steps=2 * ROLLOUT)[3:]
    monkeypatch.setattr(training, "learning_curve", lambda *_: b"")
    with monkeypatch.context() as patched:
        patched.setattr(ProgressBoard, "show", lambda *_: signal.raise_signal(signal.SIGINT))
        assert main(words) == 130
    assert capsys.readouterr().err.endswith(f"stopped; the same command continues the run in {tmp_path / 'cut'}\n")
    assert main(words) == 0
    assert "policy: 96 steps" in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.whole
@pytest.mark.skipif(os.name != "posix", reason="needs SIGSTOP")
def test_the_command_is_refused_beside_another_stops_and_goes_on(tmp_path: Path) -> None:
    out, steps = tmp_path / "cut", 40 * ROLLOUT
    changes = {"steps": steps, "evaluate_every": 400 * ROLLOUT}
    words = words_of(out, **changes)

    with started(words, out, 2) as process:
        process.send_signal(signal.SIGSTOP)  # so that it is not done before the second one has looked
        assert process.poll() is None and rollouts_of(out) < steps // ROLLOUT, "it was done before it was stopped"
        second = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
        assert second.returncode == 2, (second.stdout, second.stderr)
        assert f"soccer: another run uses {out}; give another folder" in second.stderr
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGCONT)
        said = process.communicate()[1]
    assert process.returncode == 130, said
    assert f"stopped; the same command continues the run in {out}" in said and "Traceback" not in said

    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "policy: 1,920 steps" in done.stdout and f"written: {out / 'best.safetensors'}" in done.stdout
    assert "Warning" not in done.stderr
    assert (out / "learning_curve.png").read_bytes().startswith(b"\x89PNG")
    train_plainly(tiny_settings(tmp_path / "whole", **changes))
    assert outcome(out) == outcome(tmp_path / "whole")
    assert [line["step"] for line in records(out / "log.jsonl")] == list(range(ROLLOUT, steps + 1, ROLLOUT))
