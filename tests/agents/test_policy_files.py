"""Policies and their files: what goes in comes out, and everything else is refused with its reason."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from soccer_env.agents import policy as limits
from soccer_env.agents.policy import Policy, training_fields
from soccer_env.agents.policy_file import MAX_FILE, MAX_HEADER, VERSION, dump, load, parse
from soccer_env.leagues import Slots, find_league
from soccer_env.observations import entry_names
from tests.agents.staged_files import FIELDS, assert_content_refused, with_fields
from tests.agents.staged_policies import random_recurrent_policy

MADE = {"command": "soccer train --seed 1", "note": 'two\nlines, "quoted", ß'}


def policy(*widths: int, inputs: tuple[str, ...] = ("ball_x", "ball_y"), **changes: Any) -> Policy:
    outputs = 7 if changes.get("actions") == "full" else 4
    sizes = [len(inputs), *(widths or (3,)), outputs]
    rng = np.random.default_rng(1)
    fields = {
        **FIELDS, "inputs": inputs, "action_repeat": 2, "made": MADE,
        "weights": tuple(rng.normal(size=(b, a)).astype(np.float32) for a, b in zip(sizes, sizes[1:])),
        "biases": tuple(rng.normal(size=b).astype(np.float32) for b in sizes[1:]),
    }  # fmt: skip
    return Policy(**{**fields, **changes})


def ones(*shape: int) -> np.ndarray:
    return np.ones(shape, np.float32)


@pytest.mark.parametrize("units", [0, 8])
def test_a_file_gives_back_the_policy(tmp_path: Path, units: int) -> None:
    settings: dict[str, Any] = {"actions": "full", "mirror": True}
    whole = policy(5, 3, **settings) if units == 0 else random_recurrent_policy(16, 8, units=units, **settings)
    (tmp_path / "a.safetensors").write_bytes(dump(whole))
    read = load(tmp_path / "a.safetensors")
    for field in FIELDS.keys() - {"weights", "biases"}:
        assert getattr(read, field) == getattr(whole, field)
    assert len(read.memory) == (4 if units else 0)
    for name in ("weights", "biases", "memory"):
        for own, other in zip(getattr(whole, name), getattr(read, name), strict=True):
            assert own.tobytes() == other.tobytes() and own.shape == other.shape


@settings(max_examples=40)
@given(
    widths=st.lists(st.integers(1, 9), max_size=7),
    made=st.dictionaries(st.from_regex(limits.NAME, fullmatch=True), st.text(st.characters(categories="LPS"))),
    repeat=st.integers(1, 1000),
    mirror=st.booleans(),
)
def test_the_same_policy_gives_the_same_bytes(widths: list[int], made: dict, repeat: int, mirror: bool) -> None:
    content = dump(policy(*widths, made=made, action_repeat=repeat, mirror=mirror))
    assert dump(parse(content, "here")) == content
    backwards = dict(reversed(made.items()))
    assert dump(policy(*widths, made=backwards, action_repeat=repeat, mirror=mirror)) == content


def test_the_largest_policy_fits_into_a_file() -> None:
    inputs = tuple(f"{'n' * 59}_{number:04d}" for number in range(limits.MAX_INPUTS - 1000))
    made = {f"{'k' * 60}{number:02d}": '"\U0001f600\n\\' * 500 for number in range(limits.MAX_MADE)}
    large = policy(1000, 700, inputs=inputs, made=made)
    assert sum(array.size for array in large.weights + large.biases) > 0.97 * limits.MAX_NUMBERS
    content = dump(large)
    assert len(content) < MAX_FILE
    assert dump(parse(content, "here")) == content
    assert int.from_bytes(content[:8], "little") < MAX_HEADER


def test_the_longest_header_is_below_its_limit() -> None:
    inputs = tuple(f"{'n' * 59}_{number:04d}" for number in range(limits.MAX_INPUTS))
    made = {f"{'k' * 61}{number:02d}": '"' * 2000 for number in range(limits.MAX_MADE)}
    content = dump(policy(2, inputs=inputs, made=made))
    assert MAX_HEADER // 2 < int.from_bytes(content[:8], "little") < MAX_HEADER


def test_arrays_are_copied_and_cannot_be_written_to() -> None:
    weight = ones(4, 2)
    made = dict(MADE)
    whole = policy(weights=(weight,), biases=(ones(4),), made=made)
    weight[0, 0] = np.nan
    made["note"] = "changed"
    assert whole.weights[0][0, 0] == 1.0
    assert whole.made == MADE
    with pytest.raises(ValueError, match="read-only"):
        whole.weights[0][0, 0] = 2.0


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        *(({"name": name}, "name must be 1 to 64 characters") for name in ("", "a|b", "two\nlines", "x" * 65)),
        ({"name": 3}, "name must be 1 to 64 characters .* got 3"),
        ({"league": ""}, "league must be"),
        ({"family": "Middle size"}, "family must be 1 to 64 lower-case letters, digits and -, got 'Middle size'"),
        ({"control_rate": 0}, "control_rate must be 1 to 1000, got 0"),
        ({"observe": "all"}, "observe must be one of truth, percepts, belief, got 'all'"),
        ({"actions": "words"}, "actions must be one of box, full, discrete, multi, skills"),
        ({"actions": "discrete"}, r"layer1 must have a weight \(12, 3\) and a bias \(12,\), got \(4, 3\)"),
        ({"actions": "discrete", "squash": True}, "mirror and squash must be False where actions are 'discrete'"),
        ({"at_once": 1}, "at_once must be True or False, got 1"),
        ({"normalise": {"mean": []}}, "normalise must be empty or a table of mean, deviation, limit"),
        ({"activation": "gelu"}, "activation must be one of tanh, relu"),
        ({"mirror": 1}, "mirror must be True or False, got 1"),
        *(({"action_repeat": bad}, f"action_repeat must be 1 to 1000, got {bad}") for bad in (0, 1001, True, 2.0)),
        ({"inputs": ["ball_x", "ball_y"]}, "inputs must be a tuple"),
        ({"inputs": ()}, "inputs must be a tuple of 1 to 4096 names, got 0"),
        ({"inputs": tuple(f"i{n}" for n in range(4097))}, "1 to 4096 names, got 4097"),
        ({"inputs": ("ball_x", "ball_x")}, "input 1 must have a name of its own"),
        ({"inputs": ("ball_x", "ball y")}, "input 1 must be 1 to 64 characters"),
        ({"inputs": ("ball_x",)}, r"layer0 must have a weight \(3, 1\)"),
        ({"made": "me"}, "made must be a mapping"),
        ({"made": {f"k{n}": "" for n in range(65)}}, "made must be a mapping of at most 64 texts, got 65"),
        ({"made": {"seed": 1}}, r"made\['seed'\] must be a text of at most 2000 characters, got 1"),
        ({"made": {"log": "x" * 2001}}, r"made\['log'\] must be .* got 2001 characters"),
        ({"made": {"log": "\x1b[31m"}}, r"made\['log'\] must be plain text"),
        ({"made": {"a\nb": ""}}, "a key of made must be"),
        ({"weights": []}, "must be tuples of the same length"),
        ({"weights": (ones(4, 2),) * 9, "biases": (ones(4),) * 9}, "1 to 8 layers, got 9"),
        ({"weights": (ones(4, 2).astype(float),), "biases": (ones(4),)}, "layer0.weight must .* got float64"),
        ({"weights": (ones(4, 2),), "biases": ([1.0] * 4,)}, "layer0.bias must be an array of float32, got list"),
        ({"weights": (ones(4, 3),), "biases": (ones(4),)}, r"layer0 must have a weight \(4, 2\)"),
        ({"weights": (ones(3, 2), ones(4, 3)), "biases": (ones(1, 3), ones(4))}, "layer0.bias must have the shape"),
        ({"weights": (ones(1025, 2), ones(4, 1025)), "biases": (ones(1025), ones(4))}, "layer0.bias must have the "),
        ({"weights": (ones(4, 2) * np.nan,), "biases": (ones(4),)}, "layer0 must be finite"),
        ({"weights": (ones(4, 2) * 3e37,), "biases": (ones(4),)}, "layer0 must stay below 1e[+]37"),
        ({"activation": "relu", "weights": (ones(3, 2) * 1e20, ones(4, 3) * 1e20)}, "layer1 must stay below"),
    ],
)
def test_what_does_not_agree_is_refused(changes: dict[str, Any], reason: str) -> None:
    with pytest.raises(ValueError, match=reason) as refusal:
        replace(policy(), **changes)
    assert len(str(refusal.value)) < 300 and str(refusal.value).isprintable()


def test_too_many_weights_are_refused_and_tanh_bounds_what_follows_it() -> None:
    with pytest.raises(ValueError, match="at most 3900000 weights and biases"):
        policy(*(1000,) * 6)
    replace(policy(), weights=(ones(3, 2) * 1e20, ones(4, 3) * 1e20))


def test_a_league_is_known_by_what_it_is_and_not_by_its_name() -> None:
    league = find_league("legged-2001")
    trained = policy(inputs=tuple(entry_names(league, "truth")), **training_fields(league))
    trained.check_plays(replace(league, name="icy"))
    trained.check_plays(replace(league, name="of-my-own", ball=replace(league.ball, rolling=0.05)))
    with pytest.raises(ValueError, match="'legged-2001' of control rate 16, 'legged-2001' is of control rate 20"):
        trained.check_plays(replace(league, control_rate=20))
    with pytest.raises(ValueError, match="reads the entry 'opponent_2_present', which 'truth' of 'legged-2001' lacks"):
        trained.check_plays(replace(league, slots=Slots(teammates=2, opponents=2)))
    with pytest.raises(ValueError, match="of family legged, 'legged-2001' is of family cats"):
        trained.check_plays(replace(league, family="cats"))


@pytest.mark.parametrize("version", [1, 2])
def test_a_file_of_a_version_before_the_first_release_is_refused(version: int) -> None:
    refused = f"is of format version {version}; .* reads versions 3 to {VERSION}"
    assert_content_refused(with_fields(version=version), refused)


def test_inputs_are_found_by_name_and_a_missing_entry_is_named() -> None:
    league = find_league("legged-2001")
    names = entry_names(league, "truth")
    swapped = (names[1], names[0], *names[2:])
    assert policy(inputs=swapped).columns(league) == [1, 0, *range(2, len(names))]
    assert policy(inputs=(names[5],), weights=(ones(4, 1),), biases=(ones(4),)).columns(league) == [5]
    said = "policy '.*' reads the entry 'more', which 'truth' of 'legged-2001' lacks"
    with pytest.raises(ValueError, match=said):
        policy(inputs=(*names, "more")).check_plays(league)
    with pytest.raises(ValueError, match="reads the entry 'gone', which 'belief' of 'middle-size-2006' lacks"):
        belief = entry_names(find_league("middle-size-2006"), "belief")
        policy(
            inputs=(*belief, "gone"), observe="belief", **training_fields(find_league("middle-size-2006"))
        ).check_plays(find_league("middle-size-2006"))
