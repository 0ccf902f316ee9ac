"""Policies that choose skills: as a team they play as a learner that takes the greatest of the allowed values."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.agents import save_onnx, save_policy
from soccer_env.agents.learned import choose_skill, team_from_policy
from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import load
from soccer_env.skills.choices import SKILLS
from soccer_env.types import NOISE_STREAMS
from tests.agents.staged_policies import decide, random_policy, random_recurrent_policy, team_from_disk
from tests.scenes.staging import LEAGUES, LEGGED, MIDDLE

SEEN: dict[str, Any] = {"home": 2, "away": 2, "observe": "belief", "senses": "sensors", "rules": "none", "seed": 3}


def chooser(league: str, **changes: Any) -> Policy:
    """Return a policy with random weights that chooses a skill every 10 control steps, from the first one on."""
    return random_policy(8, league=league, **{"actions": "skills", "action_repeat": 10, "at_once": True, **changes})


@pytest.mark.parametrize("league", LEAGUES)
def test_a_team_of_skills_plays_bit_for_bit_as_its_policy_asked_from_outside(league: str, tmp_path: Path) -> None:
    policy = chooser(league)
    outside = Match(league, **SEEN, opponents="chaser", actions="skills", action_repeat=10, matches=3)
    team = team_from_disk(policy, tmp_path)
    inside = Match(league, **SEEN, controllers={"home": team, "away": "chaser"}, matches=3)
    chosen = set()
    for _ in range(40):
        rows = outside.observations[:, :2].reshape(6, -1)
        values = np.where(outside.action_masks()[:, :2].reshape(6, -1) == 1, decide(policy, rows), -np.inf)
        choices = values.argmax(axis=1).reshape(3, 2)
        chosen |= {outside.action_names[choice] for choice in choices.ravel()}
        outside.step(np.pad(choices, ((0, 0), (0, 2))))
        for _ in range(10):
            inside.step()
        assert (outside.robots["x"] == inside.robots["x"]).all() and (outside.balls == inside.balls).all()
    assert len(chosen) > 2


def test_skills_are_drawn_by_their_weights_and_a_single_one_costs_no_random_number() -> None:
    noise = np.full(NOISE_STREAMS, 7, np.uint64)
    weights = np.array([0.0, 1.0, 0.0, 3.0, 4.0, 0.0])
    drawn = np.bincount([choose_skill(weights, noise) for _ in range(8000)], minlength=6) / 8000
    assert np.abs(drawn - weights / 8.0).max() < 0.02 and (drawn[weights == 0.0] == 0.0).all()
    before = noise.copy()
    assert choose_skill(np.array([0.0, 0.0, 2.0]), noise) == 2 and (noise == before).all()


def test_a_temperature_makes_a_team_choose_more_variously_and_a_very_low_one_changes_nothing() -> None:
    hashes, kinds = {}, {}
    for temperature in (0.0, 1e-9, 1.0):
        team = team_from_policy(chooser(MIDDLE, temperature=temperature))
        match = Match(MIDDLE, **SEEN, controllers={"home": team, "away": "chaser"})
        chosen = []
        for _ in range(300):
            match.step()
            chosen += match.squads[0].memory["choice"].ravel().tolist()
        hashes[temperature], kinds[temperature] = match.robots["x"].tolist(), len(set(chosen))
    assert hashes[0.0] == hashes[1e-9] != hashes[1.0] and kinds[1.0] > kinds[0.0]


@pytest.mark.parametrize("temperature", [0.0, 0.3])
def test_its_skills_are_saved_and_restored_with_the_match(temperature: float) -> None:
    team = team_from_policy(chooser(MIDDLE, temperature=temperature))
    match = Match(MIDDLE, **SEEN, controllers={"home": team, "away": "chaser"})
    for _ in range(35):
        match.step()
    saved, after = match.save(), []
    for _ in range(2):
        for _ in range(25):
            match.step()
        after.append(match.state_hash())
        match.load(saved)
    assert after[0] == after[1]


def test_a_torch_module_of_26_outputs_is_saved_as_a_chooser(tmp_path: Path) -> None:
    torch = pytest.importorskip("torch")
    module = torch.nn.Sequential(torch.nn.Linear(133, 8), torch.nn.Tanh(), torch.nn.Linear(8, len(SKILLS)))
    saved = save_policy(module, tmp_path / "mine.safetensors", league=MIDDLE, observe="belief", action_repeat=10)
    assert saved.actions == "skills" and load(tmp_path / "mine.safetensors").actions == "skills"
    rows = np.random.default_rng(1).uniform(-1.0, 1.0, (5, 133)).astype(np.float32)
    assert np.allclose(decide(saved, rows), module(torch.tensor(rows)).detach(), atol=1e-5)


def test_what_cannot_be_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="mirror and squash must be False where actions are 'skills'"):
        chooser(LEGGED, squash=True)
    with pytest.raises(ValueError, match="temperature must be 0.0 to 100.0, got -1.0"):
        chooser(LEGGED, temperature=-1.0)
    with pytest.raises(ValueError, match="temperature must be 0.0 where actions are 'box': only skills are drawn"):
        random_policy(8, temperature=0.5)
    with pytest.raises(ValueError, match="can have no memory of its own"):
        replace(chooser(LEGGED), memory=random_recurrent_policy(8).memory)
    with pytest.raises(ValueError, match="chooses skills, which an ONNX file cannot carry out"):
        save_onnx(chooser(LEGGED), tmp_path / "lively.onnx")
