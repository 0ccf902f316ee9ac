"""Copies by pickle, cloudpickle and deepcopy: a match and its copy have one future, an env's copy begins anew."""

import copy
import logging
import pickle
import subprocess
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AsyncVectorEnv
from pettingzoo.test import parallel_api_test

import soccer_env
from soccer_env import Match, make_team, soccer_v0
from soccer_env.agents.learned import BUNDLED
from soccer_env.agents.policy_file import dump, load
from soccer_env.match import arguments as match_settings
from soccer_env.teams import NAMES, View

ROOT = Path(__file__).parents[1]
SOLO = "soccer_env/Legged2001-2v2-v0"


def pickle_copy(one: Any) -> Any:
    return pickle.loads(pickle.dumps(one))


def cloudpickle_copy(one: Any) -> Any:
    return pickle.loads(pytest.importorskip("cloudpickle").dumps(one))


WAYS = [pickle_copy, cloudpickle_copy, copy.deepcopy, copy.copy]


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize(
    "settings",
    [
        {"senses": "sensors", "pose": "particles", "controllers": {"home": "chaser", "away": "learned"}},
        {"senses": "ideal", "controllers": {"home": "chaser@0.5", "away": "sacks-2001:recovery=False"}},
        {"league": "middle-size-2006", "controllers": {"home": "heinemann-2006", "away": "weigel-2001"}},
        {"scene": "ball-in-corner", "episode": "drill", "minutes": None, "home": 1, "away": 1, "observe": "belief"},
    ],
)
def test_a_match_and_its_copy_have_one_future(way: Callable[[Any], Any], settings: dict[str, Any]) -> None:
    match = Match(**{"matches": 3, "minutes": 0.4, "home": 2, "away": 3, "autoreset": "same_step", **settings}, seed=4)
    actions = np.random.default_rng(1).uniform(-1.0, 1.0, (80, 3, len(match.agents), 4))
    for t in range(40):
        match.step(actions[t])
    other = way(match)
    assert other is not match and other.robots is not match.robots
    assert np.array_equal(match.observations, other.observations)
    for t in range(40, 80):
        for mine, theirs in zip(match.step(actions[t]), other.step(actions[t]), strict=True):
            assert np.array_equal(mine, theirs)
    assert match.state_hash() == other.state_hash()
    assert np.array_equal(match.statistics, other.statistics)


@pytest.mark.slow
@pytest.mark.parametrize(("league", "home", "seconds"), [("legged-2001", 3, 6.0), ("middle-size-2006", 4, 4.0)])
def test_in_scrums_too(league: str, home: int, seconds: float) -> None:
    """Robots that press each other have contacts, of which Chipmunk remembers the impulses; a save knows none."""
    teams = {"home": "chaser", "away": "chaser"}
    match = Match(league, home=home, away=home, matches=100, controllers=teams, senses="ideal", seed=3, minutes=5.0)
    rate = int(match.league.control_rate)
    for _ in range(int(seconds * rate)):
        match.step()
    copies = 0
    while copies < 200:  # of matches in which robots touch each other at that moment
        copies += int(match.robot_events["collision"].any(axis=1).sum())
        other = pickle_copy(match)
        for _ in range(rate // 2):
            match.step()
            other.step()
        assert match.state_hash() == other.state_hash()
        for _ in range(rate // 4):
            match.step()


def test_that_the_original_is_rebuilt_is_logged(caplog: pytest.LogCaptureFixture) -> None:
    with caplog.at_level(logging.INFO, logger="soccer_env"):
        pickle_copy(Match(controllers={"home": "still", "away": "still"}))
    assert "its physics is rebuilt" in caplog.text


@pytest.mark.parametrize("make", [soccer_v0.parallel_env, soccer_v0.env, soccer_v0.raw_env])
@pytest.mark.parametrize("way", WAYS[:3])
def test_a_copy_of_a_pettingzoo_env_is_reset_before_it_plays(way: Callable[[Any], Any], make: Any) -> None:
    env = make(home=2, away=1, opponents="chaser", actions="discrete", max_cycles=7, infos=False)
    env.reset(seed=1)
    other = way(env)
    assert other.possible_agents == env.possible_agents == ["home_0", "home_1"]
    env.reset(seed=5)
    other.reset(seed=5)
    assert np.array_equal(env.state(), other.state()) and other.state() is not env.state()
    assert other.action_space("home_0") == env.action_space("home_0")


def test_copies_draw_seeds_of_their_own_and_pass_the_api_test() -> None:
    env = soccer_v0.parallel_env(home=1, away=1, opponents="random", max_cycles=20)
    one, two = pickle_copy(env), pickle_copy(env)
    first, second = one.reset()[0]["home_0"], two.reset()[0]["home_0"]
    states = [e.unwrapped.match.seeds.tolist() for e in (env, one, two)]
    assert states[1] != states[2] and first.shape == second.shape
    parallel_api_test(one, num_cycles=30)


def test_gymnasium_envs_are_copied_by_their_settings() -> None:
    env = gymnasium.make(SOLO, opponents="still", teammates="chaser@0.5", max_cycles=9)
    vector = gymnasium.make_vec(SOLO, num_envs=3, opponents="still", autoreset_mode="SameStep")
    for one in (env, vector):
        other: Any = pickle_copy(one)
        assert np.array_equal(one.reset(seed=3)[0], other.reset(seed=3)[0])
        assert other.observation_space == one.observation_space
    assert pickle_copy(vector).num_envs == 3


def test_workers_that_are_spawned_play() -> None:
    envs = AsyncVectorEnv([lambda: gymnasium.make(f"soccer_env:{SOLO}", max_cycles=5)] * 2, context="spawn")
    observations, _ = envs.reset(seed=1)
    envs.step(envs.action_space.sample())
    assert observations.shape[0] == 2
    envs.close()


LOADS = """
import pickle, sys
match = pickle.load(open(sys.argv[1], "rb"))
for _ in range(30):
    match.step()
print(match.state_hash())
"""


@dataclass(frozen=True)
class Slow:
    name: str = "slow"
    memory_dtype: np.dtype = field(default_factory=lambda: np.dtype([("steps", "i8")]))

    def act(self, view: View, memory: np.ndarray, rng: Any) -> np.ndarray:
        memory["steps"] += 1
        commands = view.stand()
        commands[..., 0] = 0.2
        return commands


@pytest.mark.parametrize("team", ["chaser", "learned", Slow()])
def test_another_process_goes_on_with_a_match_whose_teams_are_objects(tmp_path: Path, team: Any) -> None:
    away = make_team(team) if isinstance(team, str) else team
    match = Match(controllers={"home": make_team("sacks-2001"), "away": away}, seed=2, senses="ideal", minutes=0.2)
    for _ in range(30):
        match.step()
    (tmp_path / "match.pickle").write_bytes(pickle.dumps(match))
    for _ in range(30):
        match.step()
    words = [sys.executable, "-c", LOADS, str(tmp_path / "match.pickle")]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.stdout.strip() == match.state_hash(), done.stderr


@pytest.mark.parametrize("name", NAMES)
def test_a_shipped_team_keeps_its_kernel(name: str) -> None:
    team = make_team(name)
    found = pickle_copy(team)
    assert found.kernel is team.kernel and found.settings.tobytes() == team.settings.tobytes()
    assert len(pickle.dumps(team)) < 200_000


def test_a_policy_is_copied_whole() -> None:
    policy = load(BUNDLED)
    assert dump(pickle_copy(policy)) == dump(policy)


def test_what_another_version_pickled_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    made = soccer_v0.parallel_env(home=1, away=1).__reduce__()
    assert made[1][0] == soccer_env.__version__
    monkeypatch.setattr(match_settings, "version", lambda: "9.9")
    old = made[1][0], made[1][1], {**made[1][2], "wind": 3}
    with pytest.raises(ValueError, match=f"pickled by soccer_env {soccer_env.__version__}, and this is 9.9: .*wind"):
        made[0](*old)
    match = Match(controllers={"home": "still", "away": "still"})
    make, (_, kind, settings, saved) = match.__reduce__()
    with pytest.raises(ValueError, match="pickled by soccer_env 0.0.1, and this is 9.9: this is not a save"):
        make("0.0.1", kind, settings, saved[:-1])
