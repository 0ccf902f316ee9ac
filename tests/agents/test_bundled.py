"""The bundled team `learned`: a small policy file, made by the settings beside it, that beats the paper's team."""

import json
from pathlib import Path

import pytest

from soccer_env import make_team
from soccer_env.agents.learned import BUNDLED
from soccer_env.agents.policy_file import load
from soccer_env.leagues import find_league
from soccer_env.observations import names_of
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.ppo.toml_file import settings_of

LEAST_STEPS = 0.99  # [1] of the steps asked for: a run ends with whole rollouts


def test_the_policy_is_small_and_plays_by_beliefs() -> None:
    policy = load(BUNDLED)
    assert BUNDLED.stat().st_size < 1_000_000
    assert (policy.name, policy.league, policy.observe) == ("learned", "legged-2001", "belief")
    assert list(policy.inputs) == names_of(find_league("legged-2001"), "belief")


ALWAYS = {  # settings that there were then; every run has them so now
    "gradient_limit": 0.5, "value_weight": 0.5, "target_kl": 0.0, "hold_keeper": 0.0, "teacher_commands": False,
    "curriculum": True, "normalise_rewards": False,
}  # fmt: skip


def test_it_was_trained_by_the_settings_beside_it() -> None:
    policy, settings = load(BUNDLED), settings_of(BUNDLED.with_suffix(".toml"))
    recorded = json.loads(policy.made["settings"])  # those there were when it was trained
    now = {name: getattr(settings, name, ALWAYS.get(name)) for name in recorded}
    assert recorded == now | {"start": Path(settings.start).name}
    assert policy.made["seed"] == str(settings.seed)
    assert LEAST_STEPS * settings.steps <= int(policy.made["step"]) <= settings.steps + 100_000
    assert (policy.action_repeat, policy.mirror) == (settings.action_repeat, settings.mirror)
    assert tuple(len(bias) for bias in policy.biases[:-1]) == settings.hidden_sizes
    evaluations = BUNDLED.with_name("legged-2001.evaluations.jsonl").read_text(encoding="utf-8").splitlines()
    assert [json.loads(line)["step"] for line in evaluations][-1] == int(policy.made["step"])


def test_it_beats_the_papers_team() -> None:
    result = evaluate(EvaluateSettings(home="learned", away="sacks-2001", matches=24, minutes=2.0, players=3, seed=11))
    assert result.goal_difference.mean > 0.0
    assert result.points.mean > 0.5


def test_its_team_takes_no_settings() -> None:
    assert make_team("learned").name == "learned"


def test_a_bundled_setting_is_found_by_its_name_from_any_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("legged-2001", "legged-2001.toml"):
        assert settings_of(Path(name)) == settings_of(BUNDLED.with_suffix(".toml"))
    Path("legged-2001").write_text("steps = 5000\n", encoding="utf-8")  # a file of one's own comes first
    assert settings_of(Path("legged-2001")).steps == 5000
    with pytest.raises(ValueError, match=r"nobody\.toml cannot be read"):
        settings_of(Path("nobody.toml"))
