"""Opponents by name in infos, and other ones at a reset, in every API."""

from typing import Any

import gymnasium
import numpy as np
import pytest

from soccer_env import Lineup, Match, soccer_v0, team_of_function
from soccer_env.replay import Recorder

NESTED: dict[str, Any] = {"infos": "nested"}
SHORT: dict[str, Any] = {"home": 1, "away": 1, "max_cycles": 3, **NESTED}


def rested(observations: np.ndarray) -> np.ndarray:
    return np.zeros((*observations.shape[:2], 4))


def play(env: Any) -> list[str]:
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
        assert [infos["home_0"]["opponent"], *play(env)] == [name] * 4
        names.add(name)
        _, infos = env.reset()
    assert names == set(chooser.names)


def test_a_reset_changes_the_opponents_and_goes_on_with_the_seeds_episodes() -> None:
    env, plain = soccer_v0.parallel_env(**SHORT, opponents="still"), soccer_v0.parallel_env(**SHORT, opponents="chaser")
    env.reset(seed=5), plain.reset(seed=5)
    play(env), play(plain)
    _, infos = env.reset(options={"opponents": "chaser"})
    plain.reset()
    assert infos["home_0"]["opponent"] == "chaser"
    play(env), play(plain)
    assert env.match.state_hash() == plain.match.state_hash()
    assert env.match.matches["episode"][0] == 1
    env.reset(seed=6, options={"opponents": Lineup(["still", "random"])})
    assert set(play(env)) <= {"still", "random"}
    env.reset()
    assert set(play(env)) <= {"still", "random"}, "they stay"


def test_functions_and_policies_come_and_go() -> None:
    env = soccer_v0.parallel_env(home=1, away=2, max_cycles=3, opponents="chaser", infos="nested")
    for opponents, name in ((team_of_function(rested), "rested"), ("learned", "learned"), ("still", "still")):
        env.reset(seed=1, options={"opponents": opponents})
        assert play(env)[-1] == name and env.match.squads[-1].players.tolist() == [1, 2]


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
    match, before = env.match, env.match.state_hash()
    with pytest.raises(ValueError, match=message.replace("?", r"\?")):
        env.reset(options=options)
    assert env.match is match and match.state_hash() == before
    assert play(env) == ["still"] * 3


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
