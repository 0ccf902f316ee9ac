"""Infos: flat ones are numbers under keys that never change, which agree with the records; who plays; statistics."""

import pickle

import numpy as np
import pytest
from gymnasium.utils.env_checker import data_equivalence

from soccer_env import Rewards, soccer_v0
from soccer_env.api.infos import EVENT_NAMES, OWN_NAMES
from soccer_env.api.report import PHASES
from soccer_env.statistics.figures import flatten_statistics
from soccer_env.types import AWAY, HOME, Foul
from tests.scenes.staged_envs import env_about_to_score, make_single_env, make_vector_env, play, still_actions
from tests.scenes.staging import LEAGUES, each_league


@pytest.mark.parametrize("infos", ["flat", "full"])
@pytest.mark.parametrize("league", LEAGUES)
def test_every_info_of_an_episode_has_the_same_keys_with_numbers_of_the_same_kinds(league, infos):
    rewards = Rewards(extra={"one": lambda match: np.ones(match.rewards.shape)})
    env = env_about_to_score(3, league=league, rewards=rewards, max_cycles=8, infos=infos)
    kinds = {key: type(value) for key, value in env.reset(seed=1)[1]["home_0"].items()}
    assert set(kinds.values()) <= {bool, int, float} and "reward_one" in kinds
    assert kinds["active"] is bool and {"score_for", "score_against", "phase"} <= {k for k in kinds if kinds[k] is int}
    while env.agents:
        for info in env.step(still_actions(env))[4].values():
            assert {key: type(value) for key, value in info.items()} == kinds


@each_league
def test_they_say_what_the_nested_ones_say(name):
    settings = {"league": name, "home": 3, "away": 2, "opponents": "chaser", "max_cycles": 300, "action_repeat": 3}
    flat_ones, nested = (soccer_v0.parallel_env(infos=infos, **settings) for infos in ("flat", "nested"))
    flat_ones.reset(seed=3), nested.reset(seed=3)
    happened = set()
    for (_, mine), (_, theirs) in zip(play(flat_ones, 300), play(nested, 300), strict=True):
        match = nested.unwrapped.match
        for row, agent in enumerate(nested.possible_agents):
            info, words = mine[4][agent], theirs[4][agent]
            assert info["active"] == words["active"] and PHASES[info["phase"]] == words["phase"]
            assert (info["score_for"], info["score_against"]) == words["score"]
            assert {term: info[f"reward_{term}"] for term in match.term_names} == words["rewards"]
            assert all(info[f"event_{event}"] == match.events[event][0] for event in EVENT_NAMES)
            assert all(info[f"own_{event}"] == match.robot_events[event][0, row] for event in OWN_NAMES)
            happened |= {event for event in OWN_NAMES if info[f"own_{event}"]}
    assert {"collision", "touch"} & happened


@each_league
def test_full_ones_hold_the_statistics_of_the_episode_so_far(name):
    env = soccer_v0.parallel_env(league=name, home=1, away=1, senses="ideal", max_cycles=6, infos="full")
    env.reset(seed=3)
    for cycle, (_, (*_, infos)) in enumerate(play(env, 6), start=1):
        assert infos["home_0"]["statistics_played"] == pytest.approx(cycle * env.match.league.dt)
        for agent, team in (("home_0", HOME), ("away_0", AWAY)):
            found = {key: value for key, value in infos[agent].items() if key.startswith("statistics_")}
            told = flatten_statistics(env.match.statistics[0], team)
            assert found == {f"statistics_{name}": value for name, value in told.items()}


def test_a_foul_of_ones_own_and_one_of_the_match_have_names_of_their_own():
    env = soccer_v0.parallel_env(home=1, away=1, infos="flat")
    env.reset(seed=0)
    env.match.robot_events["foul"][0, 0], env.match.events["foul"][0] = Foul.PUSHING, Foul.HOLDING
    infos = env._infos()
    assert infos["home_0"]["own_foul"] == Foul.PUSHING and infos["away_0"]["own_foul"] == Foul.NONE
    assert infos["home_0"]["event_foul"] == infos["away_0"]["event_foul"] == Foul.HOLDING


@pytest.mark.parametrize("maker", [soccer_v0.parallel_env, make_single_env, make_vector_env])
def test_true_and_false_are_flat_and_none_and_a_wrong_kind_is_refused(maker):
    for given, same in ((True, "flat"), (False, "none")):
        asked, words = maker(home=1, away=1, infos=given), maker(home=1, away=1, infos=same)
        assert data_equivalence(asked.reset(seed=1)[1], words.reset(seed=1)[1])
    with pytest.raises(ValueError, match="infos must be .*one of flat, full, nested, none, got 'words'"):
        maker(home=1, away=1, infos="words")
    with pytest.raises(ValueError, match="infos must be .*got None"):
        maker(home=1, away=1, infos=None)


CYCLES = 12


@each_league
def test_the_last_infos_of_an_episode_hold_its_statistics(name):
    env = soccer_v0.parallel_env(league=name, home=1, away=1, senses="ideal", max_cycles=CYCLES, infos="nested")
    for episode in range(2):
        env.reset(seed=3 if episode == 0 else None)
        for cycle in range(1, CYCLES + 1):
            *_, infos = env.step({agent: np.array([1.0, 0.0, 0.0, 0.0]) for agent in env.agents})
            assert all(("statistics" in info) == (cycle == CYCLES) for info in infos.values())
        home, away = infos["home_0"]["statistics"], infos["away_0"]["statistics"]
        assert home["played"] == pytest.approx(CYCLES * env.match.league.dt)
        assert all(isinstance(value, (int, float)) for value in home.values())
        assert home == flatten_statistics(env.match.statistics[0], HOME)
        assert away == flatten_statistics(env.match.statistics[0], AWAY)


def test_infos_that_are_left_out_are_empty_and_each_kind_is_copied() -> None:
    env = soccer_v0.parallel_env(home=1, away=1, max_cycles=2, infos=False)
    found = [env.reset(seed=3)[1], *(infos for _, (*_, infos) in play(env, 2))]
    assert found == [{"home_0": {}, "away_0": {}}] * 3
    for kind in ("flat", "full", "nested", "none"):
        assert pickle.loads(pickle.dumps(soccer_v0.parallel_env(home=1, away=1, infos=kind))).info_kind == kind
