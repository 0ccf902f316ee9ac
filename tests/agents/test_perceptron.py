"""The compiled network: it agrees with torch, each row is computed alone, and a mirror policy is its own mirror."""

from typing import Any

import numpy as np
import pytest

from soccer_env.actions import action_mirror
from soccer_env.agents.learned import MEMORY, decide_slice
from soccer_env.agents.perceptron import pack_policy
from soccer_env.agents.policy import Policy
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.observations.reflection import observation_signs
from soccer_env.skills.choices import SKILLS
from soccer_env.types import COMMAND
from tests.agents.staged_policies import decide, random_policy

SIZES = [(8,), (64, 64), (33, 7, 12)]


def observations(policy: Policy, count: int = 64) -> np.ndarray:
    return np.random.default_rng(3).uniform(-1.0, 1.0, (count, len(policy.inputs))).astype(np.float32)


@pytest.mark.parametrize("actions", ["box", "full", "skills"])
@pytest.mark.parametrize("mirror", [False, True])
@pytest.mark.parametrize("activation", ["tanh", "relu"])
@pytest.mark.parametrize("hidden", SIZES, ids=str)
def test_it_agrees_with_torch(hidden: tuple[int, ...], activation: str, mirror: bool, actions: str) -> None:
    torch = pytest.importorskip("torch")
    network, policy = trained(hidden, activation, mirror, actions)
    rows = observations(policy)
    with torch.no_grad():
        expected = network.outputs(torch.as_tensor(rows)[None])[0][0].numpy()
    decided = decide(policy, rows)
    clipped = expected if actions == "skills" else expected.clip(-1.0, 1.0)
    np.testing.assert_allclose(decided, clipped, rtol=0.0, atol=1e-5)
    assert np.std(expected, axis=0).min() > 0.02, "the actions of these rows differ"
    assert (np.abs(expected) > 1.0).any(), "some have to be clipped"


def trained(hidden: tuple[int, ...], activation: str, mirror: bool, actions: str) -> tuple[Any, Policy]:
    """Return a network of torch with weights of some size, and the policy that holds its actor."""
    torch = pytest.importorskip("torch")
    pytest.importorskip("stable_baselines3")
    from soccer_env.train.ppo.networks import SoccerPolicy, export_policy

    entries = random_policy().entries
    torch.manual_seed(1)
    settings: dict[str, Any] = {"hidden": hidden, "activation": activation, "mirror": mirror}
    network = SoccerPolicy(entries, len(entries), actions, **settings)
    with torch.no_grad():
        for parameter in network.actor_parameters():
            parameter.normal_(0.0, 1.5 / parameter.shape[-1] ** 0.5)
    league = find_league("legged-2001")
    made = export_policy(network, name="t", league=league, observe="belief", action_repeat=1, made={})
    return network, made


def commands_of(policy: Policy, seen: np.ndarray, players: list[int], first: int, last: int) -> np.ndarray:
    """Return the commands (M, R) of players of a slice of matches that observe (M, R, n)."""
    commands, memory = np.zeros(seen.shape[:2], COMMAND), np.zeros((len(seen), len(players)), MEMORY)
    constants = constants_of(find_league("legged-2001"))
    decide_slice(seen, memory, commands, np.array(players), constants, pack_policy(policy), first, last)
    return commands


@pytest.mark.parametrize("mirror", [False, True])
def test_an_action_is_the_same_whatever_else_is_in_the_batch(mirror: bool) -> None:
    policy = random_policy(64, 64, mirror=mirror)
    seen = observations(policy, 33 * 3).reshape(33, 3, -1)
    everybody = commands_of(policy, seen, [0, 1, 2], 0, 33)
    alone = commands_of(policy, seen[17:18, 1:2].copy(), [0], 0, 1)
    assert alone[0, 0] == everybody[17, 1] and np.any(alone["forward"])
    some = commands_of(policy, seen, [2, 1], 5, 20)
    assert (some[5:20, 1:] == everybody[5:20, 1:]).all()
    assert (some[:, 0] == np.zeros((), COMMAND)).all() and (some[20:] == np.zeros((), COMMAND)).all()
    seen[17, 0] = 1.0
    seen[16] = -1.0
    assert commands_of(policy, seen, [0, 1, 2], 0, 33)[17, 1] == everybody[17, 1]


@pytest.mark.parametrize("actions", ["box", "full", "skills"])
@pytest.mark.parametrize("observe", ["truth", "belief"])
def test_a_mirror_policy_does_the_mirrored_for_the_mirrored_exactly(observe: str, actions: str) -> None:
    policy = random_policy(64, 64, observe=observe, actions=actions, mirror=True)
    rows, signs = observations(policy), observation_signs(policy.entries).astype(np.float32)
    places, turned = action_mirror(actions)
    decided, mirrored = decide(policy, rows), decide(policy, rows * signs)
    assert (mirrored == (decided * turned)[:, places]).all()
    assert np.abs(mirrored - decided).max() > 0.1, "something is mirrored"
    plain = random_policy(64, 64, observe=observe, actions=actions)
    decided, mirrored = decide(plain, rows), decide(plain, rows * signs)
    assert np.abs(mirrored - (decided * turned)[:, places]).max() > 0.1, "others do not promise that"


def test_skills_change_sides_in_a_mirror_and_those_without_a_side_stay() -> None:
    places, signs = action_mirror("skills")
    names = list(SKILLS)
    turned = dict(zip(names, (names[place] for place in places), strict=True))
    assert turned["shoot left"] == "shoot right" and turned["go back right"] == "go back left"
    assert turned["keep goal"] == "keep goal" and (places[places] == np.arange(len(names))).all()
    assert sum("left" in name for name in names) * 2 == (places != np.arange(len(names))).sum() and (signs == 1.0).all()
