"""The kind "attention" in training: what a run makes fits its files, learns, and refuses what has no slots."""

from typing import Any

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.observations import layout

pytest.importorskip("stable_baselines3")

import torch

from soccer_env.agents.learned import team_from_policy
from soccer_env.agents.perceptron import pack_policy
from soccer_env.train.ppo.curriculum import Curriculum
from soccer_env.train.ppo.networks import SoccerPolicy, blank_policy, export_policy
from soccer_env.train.ppo.settings import TrainSettings, command_of
from tests.agents.staged_policies import decide, random_attention_policy

LEAGUE = find_league("legged-2001")
ENTRIES = layout(LEAGUE, "belief")
NAMES = [entry.name for entry in ENTRIES]


def network(seed: int = 1, **settings: Any) -> SoccerPolicy:
    """Return an actor with attention for beliefs of the legged league."""
    torch.manual_seed(seed)
    shape: dict[str, Any] = {"hidden": (16,), "critic": (16,), **settings}
    return SoccerPolicy(ENTRIES, len(ENTRIES), kind="attention", **shape)


@pytest.mark.parametrize("hidden", ["64,64", "12"])
@pytest.mark.parametrize("mirror", [False, True])
def test_the_policy_before_training_has_the_shape_of_the_one_after(mirror: bool, hidden: str) -> None:
    settings = TrainSettings(kind="attention", mirror=mirror, hidden=hidden)
    blank = blank_policy(settings, LEAGUE)
    sizes = settings.hidden_sizes
    learned = network(hidden=sizes, mirror=mirror)
    made = export_policy(learned, name="t", league=LEAGUE, observe="belief", action_repeat=8, made={})
    assert made.kind == blank.kind == "attention"
    assert len(made.attention[1]) == max(8, sizes[0] // 4)
    rows = np.random.default_rng(1).uniform(-1.0, 1.0, (5, len(NAMES))).astype(np.float32)
    assert pack_policy(made).shape == pack_policy(blank).shape
    assert (decide(blank, rows) == 0.0).all() and (decide(made, rows) != 0.0).any()


def test_a_past_self_takes_the_blank_ones_place() -> None:
    settings = TrainSettings(kind="attention", hidden="32")
    curriculum = Curriculum(("still",), 1, blank_policy(settings, LEAGUE))
    later = random_attention_policy(32, width=8, mirror=True, action_repeat=8)
    curriculum.add_past(later, 100)
    assert (curriculum._past[0].settings == team_from_policy(later).settings).all()


@pytest.mark.parametrize("mirror", [False, True])
def test_attention_learns_to_read_a_player_in_any_slot(mirror: bool) -> None:
    """Ask for the place of the nearest opponent in use, which lies in a slot that changes from row to row."""
    rng = np.random.default_rng(1)
    rows = np.zeros((4000, len(NAMES)), np.float32)
    slot, place = rng.integers(0, 3, 4000), rng.uniform(-1.0, 1.0, 4000)
    for number in range(3):
        rows[slot == number, NAMES.index(f"opponent_{number}_present")] = 1.0
        rows[slot == number, NAMES.index(f"opponent_{number}_x")] = place[slot == number]
    actions = np.zeros((4000, 4), np.float32)
    actions[:, 0] = place
    made = network(mirror=mirror)
    before = [parameter.clone() for parameter in made.attention.encoders.parameters()]
    optimizer = torch.optim.Adam(made.actor_parameters()[:-1], lr=2e-3)
    for _ in range(20):
        for part in torch.randperm(len(rows)).split(128):
            error = (made.mean_actions(torch.as_tensor(rows)[None, part])[0][0] - torch.as_tensor(actions)[part]) ** 2
            optimizer.zero_grad()
            error.mean().backward()
            optimizer.step()
    assert float(error.mean()) < 0.003, "of 0.08 at first"
    after = list(made.attention.encoders.parameters())
    assert all((one != other).any() for one, other in zip(before[2:], after[2:], strict=True)), "opponents' encoder"


def test_the_actors_parameters_are_all_but_the_critics() -> None:
    made = network()
    own = {id(parameter) for parameter in made.actor_parameters()}
    rest = [name for name, parameter in made.named_parameters() if id(parameter) not in own]
    assert rest and all("critic_net" in name for name in rest)
    assert made.actor_parameters()[-1] is made.log_std


def test_slots_are_the_default_the_command_names_the_other_kind_and_pictures_have_no_slots() -> None:
    assert TrainSettings().kind == "slots" and "--kind" not in command_of(TrainSettings())
    assert "--kind attention" in command_of(TrainSettings(kind="attention"))
    with pytest.raises(ValueError, match="kind='attention' needs observe='belief' or 'truth'"):
        TrainSettings(kind="attention", observe="percepts", mirror=False)
