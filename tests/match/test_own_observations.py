"""Observations of one's own: any bounds, images, dicts, other ones for each team; in Match and in every API."""

import re
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.spaces import Box, Dict, Discrete
from gymnasium.utils.env_checker import check_env
from pettingzoo.test import parallel_api_test

from soccer_env import Match, soccer_v0
from tests.scenes.staging import stand

SOLO = "soccer_env/Legged2001-2v2-v0"


class Metres:
    """Where the ball lies, in metres, and how long play has been on, in seconds: far from [-1, 1]."""

    names = ("x", "y", "clock")
    low, high = (-10.0, -10.0, 0.0), (10.0, 10.0, np.inf)

    def __call__(self, match: Match) -> np.ndarray:
        told = np.stack([match.balls["x"], match.balls["y"], match.matches["clock"]], axis=-1)
        return np.repeat(told[:, None], len(match.agents), axis=1)


class Picture:
    """A picture of 4 x 5 pixels, with the score beside it."""

    space = Dict({"pixels": Box(0, 255, (4, 5), np.uint8), "game": Dict({"score": Box(0.0, np.inf, (2,), np.float64)})})

    def __call__(self, match: Match) -> dict[str, Any]:
        count, robots = match.robots.shape
        pixels = np.zeros((count, robots, 4, 5), int)
        pixels[..., 0, 0] = match.matches["step"][:, None]
        pixels[..., 1, 0] = np.arange(robots)
        return {"pixels": pixels, "game": {"score": np.repeat(match.matches["score"][:, None], robots, axis=1)}}


def test_bounds_of_ones_own_are_those_of_the_space() -> None:
    env = soccer_v0.parallel_env(home=1, away=1, observe=Metres(), max_cycles=30)
    space = env.observation_space("home_0")
    assert space.low.tolist() == [-10.0, -10.0, 0.0] and space.high[2] == np.inf and space.dtype == np.float32
    parallel_api_test(env, num_cycles=50)
    env.reset(seed=1)
    for _ in range(24):
        observations = env.step({agent: np.zeros(4) for agent in env.agents})[0]
    assert observations["away_0"][2] == 1.5 and env.get_env_info()["obs_shape"] == 3


def test_dicts_and_pictures_pass_through_every_api() -> None:
    env = soccer_v0.parallel_env(home=2, away=1, opponents="still", observe=Picture(), max_cycles=9)
    parallel_api_test(env, num_cycles=30)
    observations, _ = env.reset(seed=1)
    env.step({agent: np.zeros(4) for agent in env.agents})
    assert observations["home_1"]["pixels"].dtype == np.uint8 and observations["home_1"]["pixels"][1, 0] == 1
    assert not observations["home_1"]["pixels"][0, 0], "observations are the caller's own, and are not written again"
    assert env.get_env_info()["obs_shape"] == 22
    check_env(gymnasium.make(SOLO, observe=Picture(), max_cycles=9).unwrapped, skip_render_check=True)


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_a_vector_env_batches_them(mode: str) -> None:
    envs = gymnasium.make_vec(SOLO, num_envs=3, observe=Picture(), max_cycles=4, autoreset_mode=mode)
    observations, _ = envs.reset(seed=1)
    assert envs.observation_space.contains(observations) and observations["pixels"].shape == (3, 4, 5)
    for _ in range(4):
        observations, _, _, truncated, infos = envs.step(np.zeros((3, 4), np.float32))
    assert truncated.all() and observations["pixels"][0, 0, 0] == (0 if mode == "SameStep" else 4)
    if mode == "SameStep":
        assert infos["final_obs"][2]["pixels"][0, 0] == 4


def test_layouts_differ_by_team() -> None:
    observe = {"home": "belief", "away": Metres()}
    match = Match(home=2, away=1, matches=3, seed=1, observe=observe, autoreset="same_step", max_cycles=5)
    beliefs = Match(home=2, away=1, matches=3, seed=1, observe="belief", autoreset="same_step", max_cycles=5)
    for _ in range(5):
        seen, _, _, _ = match.step(stand(match))
        told, _, _, _ = beliefs.step(stand(beliefs))
    assert seen["home"].shape == (3, 2, len(match.observation_names["home"])) and seen["away"].shape == (3, 1, 3)
    assert np.array_equal(seen["home"], told[:, :2])
    assert np.array_equal(match.final["observations"]["home"], beliefs.final["observations"][:, :2])
    assert match.final["observations"]["away"][:, 0, 2].tolist() == [5 / 16] * 3
    env = soccer_v0.parallel_env(home=2, away=1, observe=observe, max_cycles=20)
    parallel_api_test(env, num_cycles=30)
    assert env.observation_space("home_1").shape != env.observation_space("away_0").shape == (3,)


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_a_team_whose_learners_see_percepts_senses_alone_and_the_other_may_be_left_out(league: str) -> None:
    match = Match(league, home=2, away=2, seed=1, observe={"home": "percepts"})
    assert match.batch.senses is not None and match.batch.senses.sides == (0,)
    plain, truth = (Match(league, home=2, away=2, seed=1, observe=observe) for observe in ("percepts", "truth"))
    assert np.array_equal(match.observations["home"], plain.observations[:, :2])
    assert np.array_equal(match.observations["away"], truth.observations[:, 2:])
    assert Match(home=1, away=1, observe={"home": "truth"}).settings.observe == "truth"


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        (np.zeros((2, 3, 2)), "of shape (2, 3, 3), got shape (2, 3, 2); by match and by home_0"),
        (np.full((2, 3, 3), np.nan), "in [-10, 10], got nan at (0, 0, 0): home_0 of match 0"),
        (-np.ones((2, 3, 3)), "in [0, inf], got -1.0 at (0, 0, 2): home_0 of match 0"),
        (11.0, "in [-10, 10], got 11.0 at (0, 0, 0)"),
        ("text", "of shape (2, 3, 3), got 'text'"),
        (None, "of shape (2, 3, 3), got None"),
    ],
)
def test_nonsense_is_named_and_leaves_the_match_as_it_was(returned: Any, message: str) -> None:
    own = Metres()
    match = Match(home=2, away=1, matches=2, seed=1, observe=own, opponents="random", action_repeat=3)
    for _ in range(10):
        match.step(stand(match) + 0.5)
    saved, seen, rewards = match.state_hash(), match.observations.copy(), match.rewards.copy()
    type(own).__call__, kept = (lambda self, match: returned), type(own).__call__
    try:
        for act in (lambda: match.step(stand(match)), match.reset, lambda: match.reset(seed=4)):
            with pytest.raises(ValueError) as error:
                act()
            assert str(error.value).startswith("observe must return numbers ") and message in str(error.value)
            assert match.state_hash() == saved
            assert np.array_equal(match.observations, seen) and np.array_equal(match.rewards, rewards)
    finally:
        type(own).__call__ = kept  # type: ignore[method-assign]
    other = Match(home=2, away=1, matches=2, seed=9, observe=own, opponents="random", action_repeat=3)
    other.load(match.save())
    for one in (match, other):
        one.step(stand(one))
    assert match.state_hash() == other.state_hash(), "it goes on as if nothing had been"


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        ({"pixels": 0}, "observe must return a dict with the keys game, pixels, got the keys pixels"),
        ({"pixels": 0, "game": 3}, "observe['game'] must return a dict with the keys score, got 3"),
        ({"pixels": 300, "game": {"score": 0}}, "observe['pixels'] must return numbers in [0, 255], got 300 at (0, "),
        (np.zeros((1, 2, 3)), "observe must return a dict with the keys game, pixels, got array("),
    ],
)
def test_a_dict_that_is_not_that_of_the_space_is_refused(returned: Any, message: str) -> None:
    class Broken(Picture):
        def __call__(self, match: Match) -> Any:
            return returned

    with pytest.raises(ValueError, match=re.escape(message)):
        Match(home=1, away=1, seed=1, observe=Broken())


class Plain:
    """An observation with whatever attributes it is given."""

    def __init__(self, **given: Any) -> None:
        self.__dict__.update(given)

    def __call__(self, match: Match) -> float:
        return 0.0


@pytest.mark.parametrize(
    ("observe", "message"),
    [
        ({"hom": "truth"}, "unknown side of observe 'hom', did you mean 'home'?"),
        ({"home": {"home": "truth", "away": "belief"}}, "observe must be a name, an object with `names`"),
        ({"home": "truht"}, "observe must be one of truth, percepts, belief, an object with `names`"),
        ({"home": 3}, "observe must be a name, an object with `names`"),
        (Plain(), "observe must be a name, an object with `names`"),
        (Plain(space=Discrete(3)), "space of observe must be a gymnasium Box, or a Dict of them, got Discrete(3)"),
        (Plain(space=Dict({"a": Discrete(3)})), "space of observe['a'] must be a gymnasium Box"),
        (Plain(names=("a", "b"), low=(0.0,)), "low of observe must be a number or 2 of them, got [0.0]"),
        (Plain(names=("a",), low=2.0), "low of observe must be below high, got 2.0 and 1.0"),
    ],
)
def test_what_is_no_observation_is_refused(observe: Any, message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        Match(home=1, away=1, seed=1, observe=observe)
