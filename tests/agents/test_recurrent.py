"""The memory of a policy: it is torch's GRU, its state is that of one robot, and is saved with the match."""

import json
import pickle
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from safetensors.numpy import load, save

from soccer_env import Match
from soccer_env.actions import action_mirror
from soccer_env.agents.learned import STATES, remember_slice, team_from_policy
from soccer_env.agents.perceptron import pack_policy
from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import dump, parse
from soccer_env.agents.recurrent import MAX_MEMORY, TENSORS
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.observations.reflection import observation_signs
from soccer_env.types import COMMAND
from tests.agents.staged_policies import decide, random_policy, random_recurrent_policy, team_from_disk

UNITS = 8


def episode(policy: Policy, steps: int = 30, seed: int = 3) -> np.ndarray:
    """Return observations (steps, inputs) of a robot that plays."""
    rows = np.random.default_rng(seed).uniform(-1.0, 1.0, (steps, len(policy.inputs))).astype(np.float32)
    rows[:, policy.inputs.index("active")] = 1.0
    return rows


@pytest.mark.parametrize("units", [1, UNITS, 64, MAX_MEMORY])
def test_the_state_is_that_of_torchs_gru_cell(units: int) -> None:
    """A last layer that copies four numbers of the state shows it."""
    torch = pytest.importorskip("torch")
    policy = random_recurrent_policy(units=units)
    last, shown = np.zeros((4, len(policy.inputs) + units), np.float32), min(units, 4)
    last[np.arange(shown), len(policy.inputs) + units - 1 - np.arange(shown)] = 1.0
    policy = replace(policy, weights=(last,), biases=(np.zeros(4, np.float32),))
    cell, rows = torch.nn.GRUCell(len(policy.inputs), units), episode(policy)
    with torch.no_grad():
        for name, array in zip(("weight_ih", "bias_ih", "weight_hh", "bias_hh"), policy.memory, strict=True):
            getattr(cell, name).copy_(torch.tensor(array))
        state, states = torch.zeros(1, units), []
        for row in torch.as_tensor(rows):
            state = cell(row[None], state)
            states.append(state[0, -4:].flip(0).numpy())
    decided = decide(policy, rows)
    np.testing.assert_allclose(decided[:, :shown], np.array(states), rtol=0.0, atol=2e-6)
    assert np.std(decided[:, 0]) > 0.1 and (np.abs(decided) <= 1.0).all()


def test_what_was_seen_before_counts_and_what_follows_does_not() -> None:
    policy = random_recurrent_policy(16, units=UNITS)
    rows = episode(policy)
    other = rows.copy()
    other[10] = episode(policy, seed=4)[10]
    decided, changed = decide(policy, rows), decide(policy, other)
    assert (decided[:10] == changed[:10]).all() and (decided[11] != changed[11]).any()
    plain = (decide(policy, rows[11:12]) == decided[11:12]).all()
    assert not plain, "the same observation at the start of an episode asks for something else"


def test_an_action_is_the_same_whatever_else_is_in_the_batch() -> None:
    policy = random_recurrent_policy(16, units=UNITS, mirror=True)
    seen = episode(policy, 5 * 17 * 3).reshape(5, 17, 3, -1)
    everybody = played(policy, seen, [0, 1, 2], 0, 17)
    alone = played(policy, seen[:, 11:12, 1:2].copy(), [0], 0, 1)
    assert (alone[:, 0, 0] == everybody[:, 11, 1]).all() and np.any(alone["forward"])
    some = played(policy, seen, [2, 1], 5, 12)
    assert (some[:, 5:12, 1:] == everybody[:, 5:12, 1:]).all()


def played(policy: Policy, seen: np.ndarray, players: list[int], first: int, last: int) -> np.ndarray:
    """Return the commands (steps, M, R) of players of a slice of matches that observe (steps, M, R, n)."""
    commands, memory = np.zeros(seen.shape[:3], COMMAND), np.zeros((seen.shape[1], len(players)), STATES)
    numbers, constants = pack_policy(policy, at_once=True), constants_of(find_league("legged-2001"))
    for step in range(len(seen)):
        remember_slice(seen[step], memory, commands[step], np.array(players), constants, numbers, first, last)
    return commands


def test_a_mirror_policy_does_the_mirrored_for_mirrored_episodes_exactly() -> None:
    policy = random_recurrent_policy(16, units=UNITS, mirror=True)
    rows, signs = episode(policy), observation_signs(policy.entries).astype(np.float32)
    decided = decide(policy, rows)
    assert (decide(policy, rows * signs) == decided * action_mirror("box")[1]).all()
    assert np.abs(decided[:, 1]).max() > 0.1, "something is mirrored"


def test_a_robot_that_is_sent_off_begins_anew() -> None:
    policy = random_recurrent_policy(16, units=UNITS)
    rows = episode(policy)
    rows[9:11, policy.inputs.index("active")] = -1.0
    decided = decide(policy, rows)
    assert (decided[10:] == decide(policy, rows[10:])).all() and (decided[9:] != decide(policy, rows)[8:-1]).any()


LIVELY: dict[str, Any] = {"action_repeat": 3, "mirror": True}


def match_of(policy: Policy, matches: int = 3, seeds: Any = (5, 6, 7), **settings: Any) -> Match:
    match = Match(home=2, away=2, matches=matches, controllers={"home": team_from_policy(policy), "away": "chaser"},
                  minutes=0.1, autoreset="same_step", **settings)  # fmt: skip
    match.reset(seeds=np.array(seeds))
    return match


def test_a_saved_match_resumes_with_its_states_and_a_copy_and_a_branch_have_their_own() -> None:
    match = match_of(random_recurrent_policy(16, units=UNITS, **LIVELY))
    for _ in range(20):
        match.step()
    states = match.squads[0].memory["states"]
    assert (states[..., :UNITS] != 0.0).any() and (states[..., UNITS:] == 0.0).all()
    assert (states[:, :, 0] != states[:, :, 1]).any(), "the mirror image has a state of its own"
    other, copy = match_of(random_recurrent_policy(16, units=UNITS, **LIVELY)), pickle.loads(pickle.dumps(match))
    other.load(match.save())
    assert other.squads[0].memory.tobytes() == match.squads[0].memory.tobytes()
    assert other.state_hash() == match.state_hash()
    for _ in range(25):
        for one in (match, other, copy):
            one.step()
    assert other.state_hash() == match.state_hash() == copy.state_hash()
    before = match.state_hash()
    match.squads[0].memory["states"][1, 0, 0, 0] += 0.125
    assert match.state_hash() != before, "the state is hashed"


def test_a_match_in_a_batch_is_the_match_alone() -> None:
    policy = random_recurrent_policy(16, units=UNITS, **LIVELY)
    batch, alone = match_of(policy), match_of(policy, 1, (6,))
    for _ in range(40):
        batch.step()
        alone.step()
        assert batch.robots[1].tobytes() == alone.robots[0].tobytes()
    assert batch.squads[0].memory[1].tobytes() == alone.squads[0].memory[0].tobytes()


def test_states_are_0_when_an_episode_begins() -> None:
    match = match_of(random_recurrent_policy(16, units=UNITS, **LIVELY))
    over = np.zeros(3, bool)
    while not over.any():
        _, _, terminated, truncated = match.step()
        over = terminated | truncated
    assert (match.squads[0].memory["states"][over] == 0.0).all()


def test_a_save_with_a_state_out_of_range_is_refused() -> None:
    match = match_of(random_recurrent_policy(16, units=UNITS))
    match.step()
    match.squads[0].memory["states"][0, 0, 0, 0] = 1.5
    with pytest.raises(ValueError, match="states"):
        match_of(random_recurrent_policy(16, units=UNITS)).load(match.save())


def test_a_file_returns_the_policy_and_only_one_with_a_memory_is_of_version_7(tmp_path: Path) -> None:
    policy = random_recurrent_policy(16, units=UNITS)
    read = parse(data := dump(policy), "file")
    assert dump(read) == data and b'\\"version\\":7' in data and b'\\"version\\":3' in dump(random_policy())
    assert all((one == other).all() for one, other in zip(read.memory, policy.memory, strict=True))
    assert "memory of 8" in repr(read)
    assert (decide(read, episode(policy)) == decide(policy, episode(policy))).all()
    team = team_from_disk(policy, tmp_path)
    assert (pickle.loads(pickle.dumps(team)).settings == team.settings).all()


def tensors(**changes: Any) -> tuple[np.ndarray, ...]:
    """Return the tensors of a memory, with changes by the last part of their names."""
    names = [name.removeprefix("memory.") for name in TENSORS]
    made = dict(zip(names, random_recurrent_policy(16, units=UNITS).memory, strict=True))
    return tuple((made | changes).values())


REFUSED: dict[str, tuple[Any, str]] = {
    "no tuple": (None, "memory must be an empty tuple or one of memory.input_weight, .*, got NoneType"),
    "too few": (tensors()[:3], "memory must be an empty tuple or one of .*, got 3 arrays"),
    "doubles": (tensors(input_bias=np.zeros(24)), "memory.input_bias must be an array of float32, got float64"),
    "too many units": (tensors(input_bias=np.zeros(387, np.float32)), r"shape \(3 times 1 to 128,\), got \(387,\)"),
    "no multiple of three": (tensors(input_bias=np.zeros(25, np.float32)), r"memory.input_bias must have the shape"),
    "other units": (tensors(state_bias=np.zeros(21, np.float32)), r"state_bias must have the shape \(24,\), got"),
    "other inputs": (tensors(input_weight=np.zeros((24, 5), np.float32)), r"input_weight must have the shape \(24, 1"),
    "NaN": (tensors(state_bias=np.full(24, np.nan, np.float32)), "memory.state_bias must be finite"),
    "overflow": (tensors(state_bias=np.full(24, 2e37, np.float32)), r"memory must stay below 1e\+37"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_a_memory_that_does_not_fit_is_refused(case: str) -> None:
    memory, said = REFUSED[case]
    policy = random_recurrent_policy(16, units=UNITS)
    with pytest.raises(ValueError, match=said):
        replace(policy, memory=memory)


def test_a_file_with_half_a_memory_is_refused() -> None:
    data = dump(random_recurrent_policy(16, units=UNITS))
    length = int.from_bytes(data[:8], "little")
    metadata, parts = json.loads(data[8 : 8 + length])["__metadata__"], load(data)
    del parts["memory.state_bias"]
    with pytest.raises(ValueError, match="lacks the tensor 'memory.state_bias'"):
        parse(save(parts, metadata=metadata), "file")
    older = {key: text.replace('"version":7', '"version":6') for key, text in metadata.items()}
    with pytest.raises(ValueError, match="lacks the tensor 'layer2.bias'"):
        parse(save(load(data), metadata=older), "file")
