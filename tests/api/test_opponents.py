"""Opponents by name in infos, by number in flat ones, and other ones at a reset, in every API."""

from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest

from soccer_env import Lineup, Match, soccer_v0
from soccer_env.replay import Recorder
from soccer_env.train.ppo.vec_env import SoccerVecEnv
from tests.agents.staged_policies import random_policy, team_from_disk
from tests.scenes.staged_envs import still_actions
from tests.scenes.staging import refused

NESTED: dict[str, Any] = {"infos": "nested"}
SHORT: dict[str, Any] = {"home": 1, "away": 1, "max_cycles": 3, **NESTED}


def named_in(env: Any) -> list[str]:
    """Return the opponent's name after a reset's infos and after each step of an episode."""
    found = []
    while env.agents:
        *_, infos = env.step({agent: np.zeros(4) for agent in env.agents})
        found.append(infos["home_0"]["opponent"])
    return found


def test_infos_name_the_opponent_of_the_episode() -> None:
    chooser = Lineup(["still", "chaser@0.5"])
    env = soccer_v0.parallel_env(**SHORT, opponents=chooser)
    names = set()
    _, infos = env.reset(seed=3)
    for episode in range(8):
        name = chooser.names[chooser.choose(int(env.match.seeds[0]), episode)]
        assert [infos["home_0"]["opponent"], *named_in(env)] == [name] * 4
        names.add(name)
        _, infos = env.reset()
    assert names == set(chooser.names)


def test_a_reset_changes_the_opponents_and_goes_on_with_the_seeds_episodes() -> None:
    env, plain = soccer_v0.parallel_env(**SHORT, opponents="still"), soccer_v0.parallel_env(**SHORT, opponents="chaser")
    env.reset(seed=5), plain.reset(seed=5)
    named_in(env), named_in(plain)
    _, infos = env.reset(options={"opponents": "chaser"})
    plain.reset()
    assert infos["home_0"]["opponent"] == "chaser"
    named_in(env), named_in(plain)
    assert env.match.state_hash() == plain.match.state_hash()
    assert env.match.matches["episode"][0] == 1
    env.reset(seed=6, options={"opponents": Lineup(["still", "random"])})
    assert set(named_in(env)) <= {"still", "random"}
    env.reset()
    assert set(named_in(env)) <= {"still", "random"}, "they stay"


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"opponents": "chasr"}, "unknown team 'chasr', did you mean 'chaser'?"),
        ({"opponents": None}, "the option opponents must be a team"),
        ({"opponents": "heinemann-2006"}, "heinemann-2006"),
        ({"opponents": "still", "match_seed": -3}, "seed"),
        ({"opponent": "still"}, "unknown option 'opponent', did you mean 'opponents'?"),
    ],
)
def test_after_a_refusal_the_running_episode_goes_on(options: dict[str, Any], message: str) -> None:
    env = soccer_v0.parallel_env(**SHORT, opponents="still")
    env.reset(seed=1)
    match = env.match
    with refused(match, message.replace("?", r"\?")):
        env.reset(options=options)
    assert env.match is match
    assert named_in(env) == ["still"] * 3


def test_a_match_that_is_written_down_keeps_its_opponents_and_so_do_two_sides_that_learn() -> None:
    with pytest.raises(ValueError, match="got 'still' for learners of away and home"):
        soccer_v0.parallel_env(**SHORT).reset(options={"opponents": "still"})
    env = soccer_v0.parallel_env(**SHORT, opponents="still")
    env.reset(seed=1)
    recorder = Recorder(env.match)
    with pytest.raises(ValueError, match="stop it first"):
        env.reset(options={"opponents": "chaser"})
    recorder.stop()
    env.reset(options={"opponents": "chaser"})


def test_a_reset_changes_the_team_sizes_within_max_players() -> None:
    settings: dict[str, Any] = {"max_players": 3, "max_cycles": 3, "opponents": "chaser", "infos": "nested"}
    env = soccer_v0.parallel_env(home=1, away=1, **settings)
    plain = soccer_v0.parallel_env(home=2, away=3, **settings)
    env.reset(seed=5), plain.reset(seed=5)
    while env.agents:
        env.step(still_actions(env)), plain.step(still_actions(plain))
    observations, infos = env.reset(options={"home": 2, "away": 3})
    plain.reset()
    assert [agent for agent in env.agents if infos[agent]["active"]] == ["home_0", "home_1"]
    assert observations.keys() == set(env.possible_agents) == {"home_0", "home_1", "home_2"}
    env.step(still_actions(env)), plain.step(still_actions(plain))
    assert env.match.state_hash() == plain.match.state_hash()
    match, wrong = env.match, {"max_players must be 4 to 11, got 3": {"home": 4}, "unknown scene 'x'": {"scene": "x"}}
    for told, options in (wrong | {"away": {"away": "2"}}).items():
        with refused(match, told):
            env.reset(options=options)
        assert env.match is match
    env.reset(options={"scene": "empty-goal"})
    assert env.match.settings.scene.name == "empty-goal" and env.match.settings.home == 2
    tight = soccer_v0.parallel_env(home=1, away=1, max_cycles=3)
    tight.reset(seed=1)
    with pytest.raises(ValueError, match="within max_players"):
        tight.reset(options={"home": 2})


@pytest.mark.parametrize("agent", ["home_1", "away_0"])
def test_the_gymnasium_env_takes_others_on_either_side(agent: str) -> None:
    settings = {"agent": agent, "opponents": "still", "teammates": "random", "infos": "nested"}
    env: Any = gymnasium.make("soccer_env/Legged2001-2v2-v0", **settings)
    env.reset(seed=2)
    _, info = env.reset(options={"opponents": "chaser@0.5"})
    assert info["opponent"] == "chaser@0.5"
    assert env.unwrapped.match is env.unwrapped._parallel.match
    *_, info = env.step(np.zeros(4))
    teams = {squad.team.name: squad.players.tolist() for squad in env.unwrapped.match.squads}
    mates = [0] if agent == "home_1" else [3]
    assert teams == {"random": mates, "chaser": [2, 3] if agent == "home_1" else [0, 1]}


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_the_vector_env_names_the_opponents_of_all_matches(mode: str) -> None:
    chooser = Lineup(["still", "chaser"])
    envs: Any = gymnasium.make_vec(
        "soccer_env/Legged2001-1v1-v0", num_envs=6, opponents="random", max_cycles=2, autoreset_mode=mode,
        infos="nested",
    )  # fmt: skip
    _, infos = envs.reset(seed=1)
    assert infos["opponent"].tolist() == ["random"] * 6
    _, infos = envs.reset(options={"opponents": chooser})
    match: Match = envs.unwrapped.match

    def expected(episode: int) -> list[str]:
        return [chooser.names[chooser.choose(int(seed), episode)] for seed in match.seeds]

    assert infos["opponent"].tolist() == expected(1)
    for _ in range(2):
        *_, infos = envs.step(np.zeros((6, 4)))
    ended = infos["final_info"] if mode == "SameStep" else infos
    assert [*ended["opponent"]] == expected(1)
    if mode == "NextStep":
        *_, infos = envs.step(np.zeros((6, 4)))
    assert infos["opponent"].tolist() == expected(2)


FLAT: dict[str, Any] = {"home": 1, "away": 1, "max_cycles": 3}
ID = "soccer_env/Legged2001-1v1-v0"


def test_others_that_a_reset_brings_come_behind_so_that_numbers_keep_their_meaning() -> None:
    env = soccer_v0.parallel_env(**FLAT, opponents="still")
    env.reset(seed=1)
    seen = []
    for opponents in ("random", Lineup(["chaser", "still"], weights=[1, 0]), "still"):
        _, infos = env.reset(options={"opponents": opponents})
        seen.append(infos["home_0"]["opponent"])
    assert env.opponent_names == ["learner", "still", "random", "chaser"] and seen == [2, 3, 1]


def test_who_meets_a_learner_is_told_so_and_each_side_has_its_own_opponent() -> None:
    env = soccer_v0.parallel_env(home=2, away=1, teammates="random")
    _, infos = env.reset(seed=1)
    assert {agent: info["opponent"] for agent, info in infos.items()} == {"home_1": 0, "away_0": 0}
    solo = gymnasium.make(ID, agent="away_0", opponents="still").unwrapped
    assert solo.opponent_names[solo.reset(seed=1)[1]["opponent"]] == "still"  # type: ignore[attr-defined]


def test_a_team_that_joins_the_lineup_is_named_without_infos_too() -> None:
    pool = Lineup(["still"])
    env = gymnasium.make_vec(ID, num_envs=2, opponents=pool, max_cycles=2, infos="none").unwrapped
    env.reset(seed=1)
    pool.add("random")
    for _ in range(4):
        env.step(np.zeros((2, 4)))
    assert env.opponent_names == ["learner", "still", "random"]  # type: ignore[attr-defined]


def test_rows_of_stable_baselines_hear_the_name_when_an_episode_ends() -> None:
    chooser = Lineup(["still", "random"])
    env = SoccerVecEnv(players=[(1, 1)], matches=6, opponents=chooser, max_cycles=2, seed=1)
    env.reset()
    before = env.playing()
    for _ in range(2):
        env.step_async(np.zeros((6, 4)))
        *_, infos = env.step_wait()
    assert [info["opponent"] for info in infos] == before and set(before) == set(chooser.names)
    assert [result.opponent for result in env.take_results()] == before


def test_policies_of_one_name_in_a_lineup_are_told_apart_by_their_files(tmp_path: Path) -> None:
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        team_from_disk(random_policy(), tmp_path / folder)
    files = [str(tmp_path / folder / "lively.safetensors") for folder in ("a", "b")]
    assert Lineup([*files, "still"]).names == (*files, "still")
