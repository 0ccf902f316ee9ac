"""The vector Gymnasium API: it is Gymnasium's own vector of single envs, whatever its threads and resets."""

import numpy as np
import pytest
from gymnasium.vector import AutoresetMode, SyncVectorEnv

from soccer_env import Scene
from tests.scenes.staged_envs import MODES, make_single_env, make_vector_env
from tests.scenes.staging import LEAGUES


def roll_the_ball(league, ball, robots, draw):
    """Let the ball roll towards away's goal, and into it if nobody is in the way."""
    ball["x"] = league.pitch.length / 2 - draw.between(0.05, 0.2) * league.pitch.length
    ball["y"] = draw.between(-0.45, 0.45) * league.pitch.goal_width
    ball["vx"] = ball["roll_x"] = draw.between(0.5, 1.0) * league.kicker.fastest


ROLLING = Scene("rolling", "the ball rolls towards away's goal", roll_the_ball, in_play=True)


def same_infos(mine, theirs):
    """Compare infos key by key; Gymnasium puts scores, which are tuples, into arrays of objects."""
    assert mine.keys() == theirs.keys()
    for key, value in theirs.items():
        if key == "score":
            value = np.array([(0, 0) if pair is None else pair for pair in value])
        if isinstance(value, np.ndarray) and key not in ("score", "final_obs"):
            assert mine[key].dtype == value.dtype, key
        if isinstance(value, dict):
            same_infos(mine[key], value)
        elif key == "final_obs":
            assert all((a is None) == (b is None) for a, b in zip(mine[key], value, strict=True))
            assert all(np.array_equal(a, b) for a, b in zip(mine[key], value, strict=True) if a is not None)
        else:
            assert np.array_equal(mine[key], value), key


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize(
    "settings",
    [
        {"infos": "flat", "max_cycles": 13},
        {"infos": "none", "max_cycles": 13},
        {
            "infos": "full", "episode": "goal", "scene": ROLLING, "agent": "away_0", "action_repeat": 3,
            "max_cycles": 20,
        },
        {"infos": "nested", "actions": "discrete", "minutes": 0.02},
    ],
    ids=["time limit", "no infos", "goals", "final whistle of discrete"],
)  # fmt: skip
def test_the_vector_env_is_gymnasiums_own_vector_of_single_envs(league, mode, settings):
    settings = {"opponents": "still", "teammates": "random", "agent": "home_1", **settings}
    many = make_vector_env(4, league, autoreset_mode=mode, **settings)
    each = SyncVectorEnv([lambda: make_single_env(league, **settings)] * 4, autoreset_mode=mode)
    assert many.observation_space == each.observation_space and many.action_space == each.action_space
    assert many.metadata["autoreset_mode"] is each.metadata["autoreset_mode"] is mode
    mine, theirs = many.reset(seed=[3, 4, 5, 6]), each.reset(seed=[3, 4, 5, 6])
    assert np.array_equal(mine[0], theirs[0])
    same_infos(mine[1], theirs[1])
    steps, episodes, goals = 90, 0, 0
    for _ in range(steps):
        actions = many.action_space.sample()
        mine, theirs = many.step(actions), each.step(actions)
        for ours, other in zip(mine[:4], theirs[:4], strict=True):
            assert ours.dtype == other.dtype and np.array_equal(ours, other)
        same_infos(mine[4], theirs[4])
        episodes += int((mine[2] | mine[3]).sum())
        goals += int(mine[2].sum())
    assert episodes >= 4
    if "scene" in settings:
        assert 4 <= goals < episodes
    elif "max_cycles" in settings:
        assert episodes == 4 * (steps // (14 if mode is AutoresetMode.NEXT_STEP else 13))


@pytest.mark.parametrize("mode", MODES)
def test_threads_and_numbers_of_matches_change_nothing(mode):
    envs = [make_vector_env(n, autoreset_mode=mode, threads=t, max_cycles=9) for n, t in ((8, 1), (8, 2), (3, 1))]
    firsts = [env.reset(seed=2)[0] for env in envs]
    assert all(np.array_equal(first[:3], firsts[0][:3]) for first in firsts)
    rng = np.random.default_rng(0)
    for _ in range(30):
        actions = rng.uniform(-1.0, 1.0, (8, 4)).astype(np.float32)
        results = [env.step(actions[: env.num_envs]) for env in envs]
        for result in results:
            assert all(np.array_equal(a[:3], b[:3]) for a, b in zip(result[:4], results[0][:4], strict=True))
    for env in envs:
        env.close()


def test_seeds_of_the_vector_env_lead_to_its_matches():
    envs, solo = make_vector_env(3), make_single_env()
    observations, _ = envs.reset(seed=7)
    assert np.array_equal(observations[0], solo.reset(seed=7)[0])
    match_seeds = envs.match.seeds.copy()
    assert np.array_equal(observations[2], solo.reset(options={"match_seed": match_seeds[2]})[0])
    envs.reset(seed=8)
    assert np.array_equal(observations, envs.reset(options={"match_seeds": match_seeds})[0])
    assert np.array_equal(observations, envs.reset(options={"match_seeds": match_seeds.tolist()})[0])
    assert not np.array_equal(observations, envs.reset()[0])


def test_what_the_vector_env_returns_is_the_callers_to_change():
    envs, witness = make_vector_env(max_cycles=6), make_vector_env(max_cycles=6)
    envs.reset(seed=1), witness.reset(seed=1)
    rng = np.random.default_rng(0)
    for _ in range(15):
        actions = rng.uniform(-1.0, 1.0, (4, 4)).astype(np.float32)
        mine, theirs = envs.step(actions), witness.step(actions)
        for ours, other in zip(mine[:4], theirs[:4], strict=True):
            assert np.array_equal(ours, other)
            other[:] = 1
        same_infos(mine[4], theirs[4])
        for value in theirs[4].values():
            value[:] = 1


def test_every_match_of_the_vector_env_has_its_frame():
    pytest.importorskip("pygame")
    envs = make_vector_env(3, render_mode="rgb_array")
    envs.reset(seed=1)
    frames = envs.render()
    assert len(frames) == 3 and frames[0].dtype == np.uint8 and frames[0].shape[2] == 3
    assert not np.array_equal(frames[0], frames[1])
    silent = make_vector_env(1)
    silent.reset(seed=0)
    with pytest.warns(UserWarning, match="render_mode"):
        assert silent.render() is None
