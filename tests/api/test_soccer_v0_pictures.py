"""The pictures of the PettingZoo API: frames and windows show the match and leave it alone."""

import numpy as np
import pytest

from soccer_env import soccer_v0
from tests.scenes.staged_envs import play
from tests.scenes.staging import LEAGUES


@pytest.mark.parametrize("league", LEAGUES)
def test_frames_show_the_match_and_leave_it_alone(league):
    pytest.importorskip("pygame")
    env, witness = (soccer_v0.parallel_env(league=league, render_mode=mode) for mode in ("rgb_array", None))
    env.reset(seed=1), witness.reset(seed=1)
    frames = []
    for _ in zip(play(env, 10), play(witness, 10), strict=True):
        frames.append(env.render())
    assert frames[0].dtype == np.uint8 and frames[0].ndim == 3 and frames[0].shape[2] == 3
    assert not np.array_equal(frames[0], frames[-1])
    assert env.unwrapped.match.state_hash() == witness.unwrapped.match.state_hash()
    env.close()
    env.close()
    assert np.array_equal(env.render(), frames[-1])


def test_a_window_is_shown_at_every_step_and_closes_twice():
    pytest.importorskip("pygame")
    env = soccer_v0.parallel_env(league="middle-size-2006", home=1, away=1, render_mode="human", opponents="still")
    env.close()
    env.reset(seed=0)
    window = env.screen._window
    assert window.is_open and window.fps == 50
    for _ in play(env, 3):
        assert env.render() is None
    env.close()
    env.close()
    assert not window.is_open


def test_rendering_without_a_mode_warns():
    env = soccer_v0.parallel_env(home=1, away=1)
    env.reset(seed=0)
    with pytest.warns(UserWarning, match="render_mode"):
        assert env.render() is None
