"""Statistics of play in nested infos: at the end of an episode alone, from the side of the agent's team."""

import numpy as np
import pytest

from soccer_env import soccer_v0
from soccer_env.api.gymnasium_vector import SoccerVectorEnv
from soccer_env.statistics.figures import flat
from soccer_env.types import AWAY, HOME
from tests.scenes.staging import each_league

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
        assert home == flat(env.match.statistics[0], HOME)
        assert away == flat(env.match.statistics[0], AWAY)


def test_infos_that_are_left_out_hold_no_statistics() -> None:
    env = soccer_v0.parallel_env(home=1, away=1, senses="ideal", max_cycles=2, infos=False)
    env.reset(seed=3)
    for _ in range(2):
        *_, infos = env.step({agent: np.zeros(4) for agent in env.agents})
    assert infos == {"home_0": {}, "away_0": {}}


@pytest.mark.parametrize("agent", ["home_0", "away_0"])
def test_the_vector_env_gives_them_of_the_matches_that_ended(agent):
    given = {
        "home": 1,
        "away": 1,
        "senses": "ideal",
        "teammates": None,
        "agent": agent,
        "max_cycles": CYCLES,
        "infos": "nested",
    }
    opponents = {"opponents": "chaser"} if agent == "home_0" else {"opponents": None, "controllers": {"home": "chaser"}}
    for mode in ("NextStep", "SameStep"):
        env = SoccerVectorEnv(2, autoreset_mode=mode, **given, **opponents)
        env.reset(seed=1)
        for cycle in range(1, CYCLES + 1):
            *_, infos = env.step(np.zeros((2, 4)))
            assert "statistics" not in infos or cycle == CYCLES
        last = infos["statistics"] if mode == "NextStep" else infos["final_info"]["statistics"]
        record = env.match.statistics if mode == "NextStep" else env.match.final["statistics"]
        assert last["played"] == pytest.approx(CYCLES * env.match.league.dt)
        side = HOME if agent == "home_0" else AWAY
        assert last["possession_for"] == pytest.approx(record["possession"][:, side])
        assert last["_played"].all()
        env.close()
