"""The PettingZoo API refuses bad input: an error that names agent and value, and nothing has changed."""

import os
import subprocess
import sys

import numpy as np
import pytest
from gymnasium.utils.env_checker import data_equivalence

from soccer_env import soccer_v0
from tests.scenes.staged_envs import play, still_actions
from tests.scenes.staging import refused

NAN, GOOD = float("nan"), np.zeros(4, np.float32)
BAD_ACTIONS = {
    "not a number": (lambda good: {**good, "away_1": np.array([0, NAN, 0, 0], np.float32)}, r"away_1.*finite.*nan"),
    "infinity": (lambda good: {**good, "home_0": np.array([0, 0, -np.inf, 0])}, r"home_0.*finite.*-inf"),
    "too short": (lambda good: {**good, "home_1": np.zeros(3, np.float32)}, r"home_1.*4 numbers.*\(3,\)"),
    "too long": (lambda good: {**good, "home_1": np.zeros(7, np.float32)}, r"home_1.*4 numbers.*\(7,\)"),
    "a word": (lambda good: {**good, "home_1": "forward"}, r"home_1.*4 numbers"),
    "nothing": (lambda good: {**good, "home_1": None}, r"home_1.*4 numbers"),
    "complex": (lambda good: {**good, "home_1": np.zeros(4, complex)}, r"home_1.*4 numbers.*complex"),
    "truth values": (lambda good: {**good, "home_1": np.zeros(4, bool)}, r"home_1.*4 numbers.*bool"),
    "an agent is missing": (lambda good: {a: x for a, x in good.items() if a != "away_0"}, r"away_0 is missing"),
    "no agents": (lambda good: {}, r"home_0 is missing"),
    "unknown agent": (lambda good: {**good, "home_7": GOOD}, r"unknown agent 'home_7'.*home_0, home_1, away_0, away_1"),
    "no dict": (lambda good: list(good.values()), r"dict.*list"),
}


@pytest.mark.parametrize(("spoil", "complaint"), BAD_ACTIONS.values(), ids=BAD_ACTIONS.keys())
def test_bad_actions_are_refused_and_change_nothing(spoil, complaint):
    env, witness = (soccer_v0.parallel_env(home=2, away=2) for _ in range(2))
    env.reset(seed=1), witness.reset(seed=1)
    for _ in zip(play(env, 5), play(witness, 5), strict=True):
        pass
    with refused(env.unwrapped.match, complaint):
        env.step(spoil(still_actions(env)))
    for (_, mine), (_, theirs) in zip(play(env, 5), play(witness, 5), strict=True):
        assert data_equivalence(mine, theirs, exact=True)


@pytest.mark.parametrize(
    ("action", "complaint"),
    [
        (12, "home_0 must be 0 to 11, got 12"), (-1, "home_0 must be 0 to 11, got -1"),
        (1.0, "home_0 must be one integer"), (True, "home_0 must be one integer"),
        (None, "home_0 must be one integer"), ([1, 2], "home_0 must be one integer"),
        ("kick", "home_0 must be one integer"),
    ],
)  # fmt: skip
def test_bad_discrete_actions_are_refused(action, complaint):
    env = soccer_v0.parallel_env(home=1, away=1, actions="discrete")
    env.reset(seed=1)
    with refused(env.unwrapped.match, complaint):
        env.step({"home_0": action, "away_0": 0})
    env.step({"home_0": np.array([3]), "away_0": np.int64(10)})


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        *(({"seed": bad}, f"seed.*{bad}") for bad in (-1, 1.5, "seven", True)),
        ({"options": {"speed": 3}}, "unknown option 'speed', did you mean 'scene'. known: match_seed"),
        ({"options": 3}, "options must be a dict, got 3"),
        ({"options": {"match_seed": -3}}, "seeds.*-3"),
        ({"options": {"match_seed": 1 << 70}}, "seeds"),
        ({"seed": 1, "options": {"match_seed": 3}}, "both"),
    ],
)
def test_bad_resets_are_refused_and_the_episode_goes_on(arguments, complaint):
    env = soccer_v0.parallel_env(home=1, away=1)
    env.reset(seed=1)
    env.step(still_actions(env))
    with refused(env.unwrapped.match, complaint):
        env.reset(**arguments)
    env.step(still_actions(env))


@pytest.mark.parametrize(
    ("settings", "complaint"),
    [
        ({"league": "legged-2002"}, "unknown league 'legged-2002', did you mean 'legged-2001'\\? known: legged-2001"),
        ({"scene": "kickoff"}, "unknown scene 'kickoff', did you mean 'kick-off' or .*\\? known: kick-off"),
        ({"rewards": {"goal": 1.0}}, "unknown rewards.*or a Rewards object"),
        ({"max_cycles": 0}, "max_cycles must be 1"),
        ({"render_mode": "ansi"}, "render_mode must be one of rgb_array, human, got 'ansi'"),
        ({"controllers": {"home_9": "still"}}, "unknown agent 'home_9' in controllers"),
        ({"controllers": ["still"]}, "controllers must map"),
        ({"controllers": {"home": "still", "away": "still"}}, "no agent is left"),
    ],
)
@pytest.mark.parametrize("maker", [soccer_v0.parallel_env, soccer_v0.env], ids=["parallel", "turns"])
def test_bad_settings_are_refused(maker, settings, complaint):
    """Of the env's own, and those that a match refuses: tests/match/test_match_settings.py has the rest of these."""
    with pytest.raises(ValueError, match=complaint):
        maker(**settings)


def test_positions_and_unknown_settings_are_refused():
    with pytest.raises(TypeError):
        soccer_v0.parallel_env("legged-2001")
    for maker in (soccer_v0.parallel_env, soccer_v0.env, soccer_v0.raw_env):
        with pytest.raises(TypeError, match="legue"):
            maker(legue="legged-2001")


def test_calls_in_the_wrong_order_say_that_reset_is_due():
    env = soccer_v0.parallel_env(home=1, away=1, max_cycles=1, render_mode="rgb_array")
    good = {"home_0": GOOD, "away_0": GOOD}
    for call, complaint in ((lambda: env.step(good), "step before reset"), (env.render, "render before reset")):
        with refused(env.unwrapped.match, complaint, RuntimeError):
            call()
    env.reset(seed=0)
    env.step(still_actions(env))
    for actions in ({}, good):
        with refused(env.unwrapped.match, "step after the end of the episode", RuntimeError):
            env.step(actions)


def test_a_bad_action_of_one_who_takes_turns_is_refused_at_once():
    env = soccer_v0.env(home=2, away=1, max_cycles=2)
    env.reset(seed=0)
    for action in (None, np.array([0, 0, NAN, 0]), np.zeros(3)):
        with refused(env.unwrapped.match, "home_0"):
            env.step(action)
    assert env.agent_selection == "home_0"
    for _ in range(6):
        env.step(GOOD)
    assert all(env.truncations.values())
    with pytest.raises(ValueError, match=f"{env.agent_selection} has ended.*None"):
        env.step(GOOD)
    for _ in range(3):
        env.step(None)
    assert env.agents == []


def test_bad_input_is_refused_without_assertions_too():
    program = """
import numpy as np
from soccer_env import soccer_v0
env = soccer_v0.parallel_env(home=1, away=1)
still, nan = np.zeros(4), np.full(4, np.nan)
for act in (
    lambda: env.step({}),
    lambda: env.reset(seed=1) and env.step({"home_0": nan, "away_0": still}),
    lambda: env.step({"home_0": still}),
    lambda: env.reset(seed=-1),
    lambda: soccer_v0.env(home=99),
):
    try:
        act()
        print("accepted")
    except (ValueError, RuntimeError) as error:
        print(type(error).__name__)
env.step({"home_0": np.zeros(4), "away_0": np.zeros(4)})
print(env.unwrapped.match.matches["step"][0])
"""
    done = subprocess.run([sys.executable, "-O", "-c", program], capture_output=True, text=True, env={**os.environ})
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["RuntimeError", "ValueError", "ValueError", "ValueError", "ValueError", "1"]
