"""Attention over other players: their order and empty slots do not matter, who is attended to does."""

from dataclasses import replace
from itertools import permutations
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.attention import Layout, attention_width, layout_of
from soccer_env.agents.policy import Policy
from soccer_env.leagues import LEAGUES, find_league
from soccer_env.observations import Entry, entries_named, entry_names
from soccer_env.observations import layout as entries_of
from tests.agents.staged_policies import decide, random_attention_policy, random_policy

FIXED, KINDS = ("ball_x", "ball_y"), ("teammate", "opponent")
SLOTS = tuple(f"teammate_{slot}_{part}" for slot in (0, 1) for part in ("present", "x"))
SLOTS += tuple(f"opponent_{slot}_{part}" for slot in (0, 1, 2) for part in ("present", "x", "y"))


def observations(policy: Policy, count: int = 64, present: float | None = 0.5) -> np.ndarray:
    """Return observations (count, inputs) in [-1, 1], each slot in use with that probability (None: nobody)."""
    rng = np.random.default_rng(3)
    rows = rng.uniform(-1.0, 1.0, (count, len(policy.inputs))).astype(np.float32)
    places = [index for index, name in enumerate(policy.inputs) if name.endswith("_present")]
    rows[:, places] = 0.0 if present is None else rng.random((count, len(places))) < present
    return rows


def places_of(policy: Policy, kind: str) -> np.ndarray:
    """Return where the entries of a kind's slots lie (slots, entries)."""
    layout, index = layout_of(policy.entries), ("teammate", "opponent").index(kind)
    own = [place for place, name in enumerate(policy.inputs) if name.startswith(kind)]
    return np.array(own).reshape(layout.slots[index], -1)


def by_hand(policy: Policy, row: np.ndarray) -> np.ndarray:
    """Return the action for one observation, as the equations of the module say it."""
    bend = {"tanh": np.tanh, "relu": lambda x: np.maximum(x, 0.0)}[policy.activation]
    layout = layout_of(policy.entries)
    x = [row[: layout.fixed].astype(float)]
    for kind, first in (("teammate", 0), ("opponent", 3)):
        weight, bias, query = policy.attention[first : first + 3]
        encoded = [bend(weight @ slot + bias) for slot in row[places_of(policy, kind)].astype(float) if slot[0] > 0.0]
        shares = np.exp([(query @ x[0]) @ e for e in encoded])
        x.append(sum((share * e for share, e in zip(shares / shares.sum(), encoded)), np.zeros(len(bias))))
    y = np.concatenate(x)
    for number, (weight, bias) in enumerate(zip(policy.weights, policy.biases)):
        y = weight @ y + bias
        y = bend(y) if number < len(policy.weights) - 1 else y
    return y.clip(-1.0, 1.0)


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
@pytest.mark.parametrize("observe", ["truth", "belief"])
@pytest.mark.parametrize("activation", ["tanh", "relu"])
def test_it_computes_its_equations(activation: str, observe: str, league: str) -> None:
    policy = random_attention_policy(32, 16, width=12, activation=activation, observe=observe, league=league)
    for present in (0.0, 0.5, 1.0):
        rows = observations(policy, present=present)
        np.testing.assert_allclose(decide(policy, rows), [by_hand(policy, row) for row in rows], rtol=0.0, atol=1e-6)


@pytest.mark.parametrize("kind", ["teammate", "opponent"])
@pytest.mark.parametrize("mirror", [False, True])
def test_the_order_of_the_slots_does_not_matter(mirror: bool, kind: str) -> None:
    policy, plain = random_attention_policy(64, 64, width=16, mirror=mirror), random_policy(64, 64, mirror=mirror)
    rows = observations(policy, present=0.7)
    decided, places = decide(policy, rows), places_of(policy, kind)
    for order in permutations(range(len(places))):
        moved = rows.copy()
        moved[:, places] = rows[:, places[list(order)]]
        np.testing.assert_allclose(decide(policy, moved), decided, rtol=0.0, atol=1e-6)
    assert np.abs(decide(plain, moved) - decide(plain, rows)).max() > 0.1, "to fixed slots it does"


@pytest.mark.parametrize("mirror", [False, True])
def test_what_lies_in_an_empty_slot_has_no_influence(mirror: bool) -> None:
    policy = random_attention_policy(64, mirror=mirror)
    rows = observations(policy)
    cleared = rows.copy()
    for kind in ("teammate", "opponent"):
        for slot in places_of(policy, kind):
            absent = rows[:, slot[0]] == 0.0
            cleared[np.ix_(absent, slot)] = 0.0
    assert (cleared != rows).any()
    assert (decide(policy, cleared) == decide(policy, rows)).all()


def test_with_one_player_of_a_kind_the_query_does_not_matter() -> None:
    policy = random_attention_policy(32)
    rows = observations(policy, present=None)
    rows[:, [places_of(policy, kind)[1, 0] for kind in ("teammate", "opponent")]] = 1.0
    others = [array if index % 3 < 2 else -3.0 * array for index, array in enumerate(policy.attention)]
    other = replace(policy, attention=tuple(others))
    np.testing.assert_allclose(decide(other, rows), decide(policy, rows), rtol=0.0, atol=1e-12)
    rows = observations(policy, present=1.0)
    assert np.abs(decide(other, rows) - decide(policy, rows)).max() > 0.1, "among several it does"


def test_two_players_alike_count_as_one_and_a_team_mate_is_no_opponent() -> None:
    policy = random_attention_policy(32, observe="truth")
    one = observations(policy, present=None)
    first, second = places_of(policy, "teammate")
    one[:, first[0]] = 1.0
    two = one.copy()
    two[:, second] = one[:, first]
    np.testing.assert_allclose(decide(policy, two), decide(policy, one), rtol=0.0, atol=1e-12)
    swapped = one.copy()
    swapped[:, places_of(policy, "opponent")[0]] = one[:, first]
    swapped[:, first] = 0.0
    assert np.abs(decide(policy, swapped) - decide(policy, one)).max() > 0.1


def test_a_strong_query_picks_one_player_and_never_overflows() -> None:
    policy = random_attention_policy(16, activation="relu")
    weight, bias, query = policy.attention[:3]
    strong = replace(policy, attention=(weight, bias, query * np.float32(1e30), *policy.attention[3:]))
    rows = observations(strong, present=1.0)
    decided = decide(strong, rows)
    assert np.isfinite(decided).all()
    first, second = places_of(strong, "teammate")
    alone = [rows.copy(), rows.copy()]
    alone[0][:, second] = alone[1][:, first] = 0.0
    nearest = [np.abs(decide(strong, some) - decided).max(axis=1) for some in alone]
    assert np.minimum(*nearest).max() < 1e-9


def test_torch_learns_from_observations_in_which_nobody_is_seen() -> None:
    torch = pytest.importorskip("torch")
    pytest.importorskip("stable_baselines3")
    from soccer_env.train.ppo.networks import Attention

    policy = random_attention_policy()
    layer = Attention(layout_of(policy.entries), 8, "tanh")
    rows = torch.as_tensor(observations(policy, present=None))
    pooled = layer(rows)
    assert (pooled[:, -16:] == 0.0).all()
    pooled.sum().backward()
    assert all(torch.isfinite(part.grad).all() for part in layer.parameters())


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("observe", ["truth", "belief"])
def test_every_league_has_its_slots_behind_the_rest(league: str, observe: str) -> None:
    preset = find_league(league)
    names, layout = entry_names(preset, observe), layout_of(entries_of(preset, observe))
    assert layout.slots == (preset.slots.teammates, preset.slots.opponents)
    assert names[layout.fixed] == "teammate_0_present" and not names[layout.fixed - 1].startswith("teammate")
    assert layout.fixed + sum(a * b for a, b in zip(layout.slots, layout.entries)) == len(names)


def test_slots_of_both_kinds_may_differ_and_the_width_goes_with_the_first_hidden_layer() -> None:
    assert layout_of(entries_named("truth", FIXED + SLOTS)) == Layout(2, (2, 3), (2, 3))
    assert Layout(2, (2, 3), (2, 3)).shapes(8) == ((8, 2), (8,), (8, 2), (8, 3), (8,), (8, 2))
    assert Layout(2, (2, 3), (2, 3)).features(8) == 18
    assert [attention_width(sizes) for sizes in ((64, 64), (128,), (4, 400))] == [16, 32, 8]


MATES, OPPONENTS = SLOTS[:4], SLOTS[4:]
SECOND_MATE_FIRST = MATES[2:] + MATES[:2]


@pytest.mark.parametrize(
    "names",
    [
        FIXED, SLOTS, SLOTS + FIXED, FIXED + MATES, FIXED + OPPONENTS, FIXED + OPPONENTS + MATES,
        FIXED + SECOND_MATE_FIRST + OPPONENTS, FIXED + SLOTS[:-1], FIXED + SLOTS[:2] + SLOTS[3:], FIXED + SLOTS[1:],
        FIXED + SLOTS + ("opponent_3_present",), FIXED + tuple(name.replace("_1_", "_2_") for name in SLOTS),
        FIXED + tuple(name.replace("_0_", "_00_") for name in SLOTS),
        FIXED + tuple(name.replace("present", "seen") for name in SLOTS),
        tuple(entry_names(find_league("legged-2001"), "percepts")),
    ],
)  # fmt: skip
def test_other_layouts_are_refused(names: tuple[str, ...]) -> None:
    with pytest.raises(ValueError, match="needs inputs that end in slots for other players"):
        layout_of(entries_named("truth", names))


def test_a_hostile_layout_is_refused_at_once() -> None:
    mate, opponents = Entry("mate", group="teammate", slot=0, present=True), {"group": "opponent", "present": True}
    slots = [Entry(f"slot_{number}", slot=number, **opponents) for number in range(2048)]
    more = [Entry(f"more_{number}", slot=0, **opponents) for number in range(2046)]
    with pytest.raises(ValueError, match="needs inputs that end in slots"):
        layout_of([Entry("a"), mate, *slots, *more])


def test_an_observation_of_ones_own_has_slots_by_its_entries_whatever_their_names() -> None:
    here, far = Entry("here", present=True), Entry("how_far")
    own = [Entry("a"), Entry("b")]
    slots = [(kind, i, part) for kind in KINDS for i in (0, 1) for part in (here, far)]
    own += [replace(part, name=f"{part.name}{i}", group=kind, slot=i) for kind, i, part in slots]
    assert layout_of(own) == Layout(2, (2, 2), (2, 2))
    for wrong in (own[::-1], [replace(entry, present=False) for entry in own], [Entry(entry.name) for entry in own]):
        with pytest.raises(ValueError, match="each beginning with its `present` entry"):
            layout_of(wrong)


def ones(*shape: int) -> np.ndarray:
    return np.ones(shape, np.float32)


WHOLE = random_attention_policy(inputs=FIXED + SLOTS, weights=(ones(16, 15), ones(4, 16)), width=5)


@pytest.mark.parametrize(
    ("index", "array", "reason"),
    [
        (None, (), "attention of kind 'attention' must be a tuple of teammate.weight, .* opponent.query, got 0 arrays"),
        (None, WHOLE.attention[:5], "got 5 arrays"),
        (None, list(WHOLE.attention), "got list"),
        (0, ones(5, 3), r"teammate.weight must have the shape \(5, 2\), got \(5, 3\)"),
        (1, ones(4), r"teammate.weight must have the shape \(4, 2\)"),
        (1, ones(0), r"teammate.bias must have the shape \(1 to 1024,\), got \(0,\)"),
        (1, ones(1025), r"teammate.bias must have the shape \(1 to 1024,\)"),
        (1, ones(5, 1), r"teammate.bias must have the shape \(1 to 1024,\)"),
        (1, np.float32(1.0), "teammate.bias must be an array of float32, got float32"),
        (2, ones(5, 15), r"teammate.query must have the shape \(5, 2\)"),
        (3, ones(5, 2), r"opponent.weight must have the shape \(5, 3\)"),
        (4, ones(6), r"opponent.bias must have the shape \(5,\)"),
        (5, ones(5, 2).astype(float), "opponent.query must be an array of float32, got float64"),
        (5, ones(5, 2) * np.inf, "opponent.query must be finite"),
        (0, ones(5, 2) * np.nan, "teammate.weight must be finite"),
        (4, ones(5) * np.float32(1e38), r"opponent.weight must stay below 1e[+]37, its units could reach 1e[+]38"),
        (2, ones(5, 2) * np.float32(1e37), "teammate.query must stay below 1e[+]37, its units could reach"),
    ],
)
def test_what_does_not_agree_is_refused(index: int | None, array: Any, reason: str) -> None:
    attention = array if index is None else (*WHOLE.attention[:index], array, *WHOLE.attention[index + 1 :])
    with pytest.raises(ValueError, match=reason) as refusal:
        replace(WHOLE, attention=attention)
    assert len(str(refusal.value)) < 300 and str(refusal.value).isprintable()


def test_the_first_layer_takes_what_is_pooled_in() -> None:
    with pytest.raises(ValueError, match=r"layer0 must have a weight \(16, 12\)"):
        replace(WHOLE, weights=(ones(16, 15), ones(4, 16)))
    large = replace(WHOLE, activation="relu", attention=tuple(array * np.float32(1e15) for array in WHOLE.attention))
    with pytest.raises(ValueError, match="layer0 must stay below"):
        replace(large, weights=(ones(16, 12) * np.float32(1e25), ones(4, 16)))
    replace(large, activation="tanh", weights=(ones(16, 12) * np.float32(1e25), ones(4, 16)))
    with pytest.raises(ValueError, match="read-only"):
        WHOLE.attention[0][0, 0] = 2.0


def test_attention_counts_among_the_numbers_of_a_policy() -> None:
    names = tuple(f"i{number}" for number in range(2000)) + SLOTS
    layout = layout_of(entries_named("truth", names))
    attention = tuple(np.zeros(shape, np.float32) for shape in layout.shapes(970))
    weights = (np.zeros((4, layout.features(970)), np.float32),)
    with pytest.raises(ValueError, match="at most 3900000 weights and biases"):
        Policy(
            "large", "legged-2001", "legged", 16, "truth", names, "box", 1, "attention", "tanh", False,
            weights, (ones(4),), {}, attention,
        )  # fmt: skip
