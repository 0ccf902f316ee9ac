"""The Gymnasium APIs refuse bad settings, actions, resets and calls, and nothing has changed."""

import numpy as np
import pytest

from tests.scenes.staged_envs import MODES, make_single_env, make_vector_env
from tests.scenes.staging import refused

NAN = float("nan")
GOOD = np.zeros((4, 4), np.float32)


BOTH, VECTOR = (make_single_env, make_vector_env), (make_vector_env,)
BAD_SETTINGS = [
    (BOTH, {"agent": "home_2"}, "unknown agent 'home_2', did you mean .*known: home_0, home_1, away_0, away_1"),
    (BOTH, {"agent": 1}, "agent must be a text, got 1"),
    (BOTH, {"opponents": None}, "home_1 is the one learner.*away_0"),
    (BOTH, {"teammates": None}, "home_1 is the one learner.*home_0"),
    (BOTH, {"controllers": {"home_1": "still"}}, "controllers must map .* other than home_1"),
    (BOTH, {"controllers": "still"}, "controllers must map"),
    (BOTH, {"controllers": {"home_5": "still"}}, "unknown agent 'home_5' in controllers"),
    (BOTH, {"opponents": "giants"}, "unknown team 'giants'"),
    (BOTH, {"league": "football"}, "unknown league 'football'"),
    (BOTH, {"home": 12}, "home must be 1 to 11, got 12"),
    (BOTH, {"render_mode": "ascii"}, "render_mode must be one of rgb_array"),
    (VECTOR, {"num_envs": 0}, "num_envs must be 1 to "),
    (VECTOR, {"num_envs": 2.5}, "num_envs must be a whole number, 1 to .*2.5"),
    (VECTOR, {"threads": 0}, "threads must be 1 to 256, got 0"),
    (VECTOR, {"autoreset_mode": "Disabled"}, "autoreset_mode must be one of NextStep, SameStep, got 'Disabled'"),
    (VECTOR, {"render_mode": "human"}, "render_mode must be one of rgb_array, got 'human'"),
]


@pytest.mark.parametrize(("makers", "settings", "complaint"), BAD_SETTINGS)
def test_bad_settings_are_refused(makers, settings, complaint):
    for maker in makers:
        with pytest.raises(ValueError, match=complaint):
            maker(**settings)


@pytest.mark.parametrize(
    ("action", "complaint"),
    [
        (np.array([0, NAN, 0, 0]), "home_1.*nan"),
        (np.zeros(3), r"home_1 must be 4 numbers.*\(3,\)"),
        (np.zeros((2, 4)), r"home_1 must be 4 numbers.*\(2, 4\)"),
        (None, "home_1 must be 4 numbers"),
        ("forward", "home_1 must be 4 numbers"),
        (3, "home_1 must be 4 numbers"),
    ],
)
def test_bad_actions_are_refused_and_change_nothing(action, complaint):
    env = make_single_env()
    env.reset(seed=1)
    env.step(np.zeros(4))
    with refused(env.match, complaint):
        env.step(action)
    env.step(np.zeros(4))


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize(
    ("kind", "actions", "complaint"),
    [
        ("box", np.where(np.arange(16).reshape(4, 4) == 9, np.inf, GOOD), "home_1 in match 2.*inf"),
        ("box", GOOD[:3], r"home_1 must be numbers of shape \(4, 4\), got float32 of shape \(3, 4\)"),
        ("box", GOOD[0], r"shape \(4, 4\), got float32 of shape \(4,\)"),
        ("box", GOOD.astype(complex), "got complex"),
        ("box", GOOD.astype(bool), "got bool"),
        ("box", GOOD.astype(str), "got <U"),
        ("box", [[0.0], [1.0, 2.0]], "must be numbers of shape"),
        ("box", None, "got object"),
        ("box", {"home_1": GOOD}, "got object"),
        ("discrete", [0, 12, 0, 0], "home_1 in match 1 must be 0 to 11, got 12"),
        ("discrete", [0.0, 1.0, 2.0, 3.0], "integers of shape"),
    ],
)
def test_bad_actions_of_the_vector_env_are_refused_and_change_nothing(mode, kind, actions, complaint):
    envs, witness = (make_vector_env(autoreset_mode=mode, actions=kind) for _ in range(2))
    good = GOOD if kind == "box" else [0, 11, 3, 4]
    envs.reset(seed=1), witness.reset(seed=1)
    envs.step(good), witness.step(good)
    with refused(envs.match, complaint):
        envs.step(actions)
    assert np.array_equal(envs.step(good)[0], witness.step(good)[0])


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ({"seed": -1}, "seed.*-1"),
        ({"seed": 1.5}, "seed.*1.5"),
        ({"seed": [1, 2]}, "seeds must be 4 whole numbers"),
        ({"seed": [1, 2, 3, None]}, "each seed must be a whole number of 0 or more, got None"),
        ({"seed": [1, 2, 3, -4]}, "got -4"),
        ({"options": {"reset_mask": np.ones(4, bool)}}, "unknown option 'reset_mask'; known: match_seeds"),
        ({"options": {"match_seeds": [1, 2]}}, "seeds must be 4 whole numbers"),
        ({"seed": 1, "options": {"match_seeds": [1, 2, 3, 4]}}, "both"),
    ],
)
def test_bad_resets_of_the_vector_env_are_refused(arguments, complaint):
    envs = make_vector_env()
    envs.reset(seed=1)
    with refused(envs.match, complaint):
        envs.reset(**arguments)


def test_calls_in_the_wrong_order_say_that_reset_is_due():
    solo, envs = make_single_env(max_cycles=1, render_mode="rgb_array"), make_vector_env(render_mode="rgb_array")
    for call in (lambda: solo.step(GOOD[0]), lambda: envs.step(GOOD), solo.render, envs.render):
        with pytest.raises(RuntimeError, match="before reset"):
            call()
    solo.reset(seed=0)
    solo.step(GOOD[0])
    with pytest.raises(RuntimeError, match="after the end"):
        solo.step(GOOD[0])
