"""Learning from a teacher: what is recorded of its decisions, and that an actor can be fitted to them."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.agents.learned import first_decision_step
from soccer_env.leagues import find_league
from soccer_env.observations import layout
from tests.scenes.staging import play

pytest.importorskip("stable_baselines3")

import torch

from soccer_env.train.ppo.networks import SoccerPolicy
from soccer_env.train.ppo.teaching import imitation
from soccer_env.train.ppo.teaching.imitation import NO_KICK, fit, record

Rows = tuple[np.ndarray, np.ndarray]  # observations, actions
SETTINGS: dict[str, Any] = {"observe": "belief", "senses": "sensors", "matches": 4, "seed": 2}
ENTRIES = layout(find_league("legged-2001"), "belief")
NAMES = [entry.name for entry in ENTRIES]


@pytest.fixture(scope="module")
def recorded() -> Rows:
    return record("chaser", "still", (2, 1), 40, 8, **SETTINGS)


def commands(repeat: int, decisions: int) -> np.ndarray:
    """Return what 2 chasers command (decisions, repeat, M, 2, 4) from the first decision on."""
    match = Match(home=2, away=1, controllers={"home": "chaser", "away": "still"}, autoreset="same_step", **SETTINGS)
    play(match, steps=first_decision_step(match.league.delay_steps, repeat))
    found = []
    for _ in range(repeat * decisions):
        match.step()
        command = match.robots["command"][:, :2]
        found.append(np.stack([command[name] for name in ("forward", "left", "turn", "kick")], axis=-1))
    return np.array(found).reshape(decisions, repeat, *found[0].shape)


def network(mirror: bool = False, seed: int = 1) -> SoccerPolicy:
    torch.manual_seed(seed)
    return SoccerPolicy(ENTRIES, len(ENTRIES), hidden=(16,), critic=(16,), mirror=mirror)


def test_a_row_is_kept_of_each_robot_at_each_decision_the_same_each_time(recorded: Rows) -> None:
    observations, actions = recorded
    assert observations.shape == (40 * 4 * 2, len(NAMES)) and actions.shape == (40 * 4 * 2, 4)
    assert observations.dtype == actions.dtype == np.float32
    assert np.abs(observations).max() <= 1.0 and np.abs(actions).max() <= 1.0
    again = record("chaser", "still", (2, 1), 40, 8, **SETTINGS)
    assert all((one == other).all() for one, other in zip(recorded, again, strict=True))


@pytest.mark.parametrize("repeat", [1, 8])
def test_the_label_is_the_walk_at_the_decision_and_the_strongest_kick_until_the_next(repeat: int) -> None:
    _, actions = record("chaser", "still", (2, 1), 30, repeat, **SETTINGS)
    given = commands(repeat, 30)
    labels = actions.reshape(30, 4, 2, 4)
    np.testing.assert_array_equal(labels[..., :3], given[:, 0, ..., :3].astype(np.float32))
    kick = given[..., 3].max(axis=1)
    np.testing.assert_array_equal(labels[..., 3], np.where(kick > 0.0, kick, NO_KICK).astype(np.float32))
    assert (np.std(labels[..., :3], axis=(0, 1, 2)) > 0.0)[[0, 2]].all(), "the teacher walks and turns"


def test_a_kick_between_two_decisions_is_not_lost() -> None:
    settings = {**SETTINGS, "matches": 8, "senses": "ideal"}
    _, actions = record("chaser", "still", (2, 1), 60, 8, **settings)
    kicks = actions[:, 3]
    assert (kicks == np.float32(NO_KICK)).any() and (kicks > 0.0).any()
    assert ((kicks == np.float32(NO_KICK)) | (kicks > 0.0)).all()


def test_what_does_not_lie_in_a_command_is_the_learners_observation(recorded: Rows) -> None:
    match = Match(home=2, away=1, controllers={"home": "chaser", "away": "still"}, **SETTINGS)
    play(match, steps=first_decision_step(match.league.delay_steps, 8))
    columns = [index for index, name in enumerate(NAMES) if not name.startswith("last_")]
    first = recorded[0][:8].reshape(4, 2, -1)
    np.testing.assert_array_equal(first[..., columns], match.observations[:, :2][..., columns])


def test_what_tells_the_next_command_is_shuffled_over_the_rows(recorded: Rows) -> None:
    before = recorded[0]
    after = before.copy()
    imitation.permute_own_commands(after, ENTRIES, 1)
    own = np.array([name.startswith("last_") for name in NAMES])
    assert np.array_equal(after[:, ~own], before[:, ~own])
    assert not np.array_equal(after[:, own], before[:, own])
    for column in np.flatnonzero(own):
        assert np.array_equal(np.sort(after[:, column]), np.sort(before[:, column]))


def fitted(recorded: Rows, seed: int = 1, **settings: Any) -> tuple[list[float], SoccerPolicy]:
    """Return the errors of 20 epochs and the network."""
    made = network(**settings)
    return fit(made, *recorded, 20, seed, batch=64), made


@pytest.mark.parametrize("mirror", [False, True])
def test_fitting_lowers_the_error(recorded: Rows, mirror: bool) -> None:
    errors, made = fitted(recorded, mirror=mirror)
    assert len(errors) == 20 and errors[-1] < 0.8 * errors[0]
    with torch.no_grad():
        left = made.mean_actions(torch.as_tensor(recorded[0])[None])[0][0].numpy() - recorded[1]
    assert (left**2).mean() == pytest.approx(errors[-1], rel=0.1), "the errors are those of the actor"


def test_fitting_is_deterministic_its_seed_counts_and_it_tells_how_far_it_is(recorded: Rows) -> None:
    (errors, one), (again, other), (third, _) = fitted(recorded), fitted(recorded), fitted(recorded, seed=2)
    assert errors == again != third
    assert all((a == b).all() for a, b in zip(one.actor_parameters(), other.actor_parameters(), strict=True))
    shares: list[float] = []
    fit(network(), *recorded, 4, 1, advance=shares.append)
    assert shares == [0.25] * 4


def test_fitting_leaves_the_critic_and_the_noise_alone(recorded: Rows) -> None:
    before, (_, after) = network(), fitted(recorded)
    assert (before.log_std == after.log_std).all()
    pairs = zip(before.critic_net.parameters(), after.critic_net.parameters(), strict=True)
    assert all((one == other).all() for one, other in pairs)


def test_players_that_no_teaching_showed_move_nothing(recorded: Rows) -> None:
    """The first weights of a slot that stays empty would be noise in a larger team."""
    seen, asked = recorded[0].copy(), recorded[1]
    empty = [i for i, name in enumerate(NAMES) if name.startswith(("teammate_1", "opponent_2"))]
    seen[:, empty] = 0.0
    _, taught = fitted((seen, asked))
    weights, slots = (
        taught.policy_net[0].weight.detach().numpy(),
        [i for i, e in enumerate(ENTRIES) if e.slot is not None],
    )
    assert empty and not weights[:, empty].any() and not network().policy_net[0].weight[:, slots].any()
    shown = seen.any(axis=0)
    assert weights[:, shown].any(axis=0).all(), "what was shown counts"
