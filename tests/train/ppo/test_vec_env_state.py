"""The VecEnv's state for a central critic, its staggered beginnings and its saves."""

from typing import Any

import numpy as np
import pytest

from soccer_env.teams import Lineup, make_team
from tests.train.evaluate.staged_rows import MIXED, play, rows, same

pytest.importorskip("stable_baselines3")


# The state behind the observation


def named_state(env: Any, row: np.ndarray) -> dict[str, float]:
    """Return the state behind an observation by name."""
    names = env.matches[0].state_names
    assert len(names) == len(row) - env.observed
    return dict(zip(names, row[env.observed :].tolist(), strict=True))


def test_the_state_lies_behind_the_observation_seen_from_home() -> None:
    env, plain = rows(state=True, minutes=0.1), rows(minutes=0.1)
    env.reset(), plain.reset()
    halves = set()
    for step in range(90):
        (seen, *_), (less, *_) = play(env, 1, step)[0], play(plain, 1, step)[0]
        assert (seen[:, : env.observed] == less).all()
        assert (seen[::2, env.observed :] == seen[1::2, env.observed :]).all()
        match, told = env.matches[0], named_state(env, seen[0])
        direction = match.matches["home_direction"][0]
        halves.add(float(direction))
        half = match.league.pitch.length / 2 + match.league.pitch.goal_depth
        assert told["ball_x"] == pytest.approx(direction * match.balls["x"][0] / half, abs=1e-6)
        assert told["home_direction"] == 1.0
        assert told["home_0_x"] == pytest.approx(less[0, env.matches[0].observation_names.index("own_x")], abs=1e-6)
        assert told["home_1_cos"] == pytest.approx(less[1, env.matches[0].observation_names.index("own_cos")], abs=1e-6)
    assert halves == {1.0, -1.0}, "both halves were played"


def test_the_state_of_a_turned_scene_is_the_same() -> None:
    env = rows(state=True)
    env.reset()
    match = env.matches[0]
    before = env._observations()[:, env.observed :]
    for name in ("x", "y", "vx", "vy"):
        match.balls[name] *= -1.0
        match.robots[name] *= -1.0
    match.robots["heading"] += np.pi
    match.matches["home_direction"] *= -1.0
    np.testing.assert_allclose(env._observations()[:, env.observed :], before, atol=1e-6)


def test_the_state_of_an_end_is_the_last_of_the_old_episode() -> None:
    env, longer = rows(state=True, max_cycles=60, minutes=0.1), rows(state=True, minutes=0.1)
    env.reset(), longer.reset()
    (seen, _, dones, infos), (expected, *_) = play(env, 60)[-1], play(longer, 60)[-1]
    assert dones.all() and longer.matches[0].matches["half"].all()
    assert (np.array([info["terminal_observation"] for info in infos]) == expected).all()
    assert named_state(env, seen[0])["clock"] == 0.0 != named_state(env, expected[0])["clock"]


def test_states_of_small_teams_have_room_for_the_largest() -> None:
    env = rows(players=MIXED, state=True, max_cycles=5)
    env.reset()
    seen, _, _, infos = play(env, 5)[-1]
    names = env.matches[1].state_names
    for row in (seen[0], infos[0]["terminal_observation"]):
        told = dict(zip(names, row[env.observed :], strict=True))
        assert [told[f"home_{i}_present"] for i in range(3)] == [1.0, 0.0, 0.0]
        assert [told[f"away_{i}_present"] for i in range(3)] == [1.0, 0.0, 0.0]
    assert (seen[-1, env.observed :] == env.matches[1].state()[-1]).all()


# Beginning at different times, and going on


@pytest.mark.parametrize("repeat", [1, 8])
def test_stagger_spreads_the_clocks_over_the_first_half(repeat: int) -> None:
    env = rows(matches=8, stagger=True, minutes=1.0, action_repeat=repeat, senses="sensors", observe="belief")
    seen, match = env.reset(), env.matches[0]
    clock, gap = match.matches["clock"], match.settings.half_length / 8
    assert (np.abs(np.diff(clock) - gap) <= repeat * match.league.dt).all() and clock[-1] < match.settings.half_length
    left = seen[::2, match.observation_names.index("time_left")]
    np.testing.assert_allclose(left, 1.0 - clock / 60.0, atol=1e-3, err_msg="robots know")
    ends = [np.flatnonzero(dones[::2]).tolist() for _, _, dones, _ in play(env, 970 // repeat)]
    assert [m for end in ends for m in end] == [7, 6, 5, 4, 3, 2, 1, 0]


@pytest.mark.parametrize("players", [((2, 2),), MIXED], ids=["one size", "mixed"])
def test_a_save_goes_on_bit_for_bit(players: Any) -> None:
    def fresh(seed: int) -> Any:
        return rows(
            players=players, observe="belief", senses="sensors", action_repeat=8, max_cycles=9, seed=seed, state=True,
            opponents=Lineup((make_team("still"), make_team("chaser")), np.ones(2), ("a", "b")),  # type: ignore[arg-type]
        )  # fmt: skip

    one, other = fresh(3), fresh(4)
    one.reset(), other.reset()
    play(one, 5)
    saved = one.save()
    seen = other.load(saved)
    assert (seen == one._observations()).all() and other.opponents == one.opponents
    histories = play(one, 30, seed=1), play(other, 30, seed=1)
    assert same(*histories)
    assert one.results and [result.opponent for result in one.results] == [result.opponent for result in other.results]
    for (*_, infos), (*_, others) in zip(*histories, strict=True):
        assert [info.get("episode") for info in infos] == [info.get("episode") for info in others]


def test_a_save_of_other_settings_is_refused() -> None:
    with pytest.raises(ValueError, match="does not fit"):
        rows(minutes=1.0).load(rows().save())
