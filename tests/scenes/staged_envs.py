"""Envs for tests of the PettingZoo and Gymnasium APIs, random play on them, and a goal about to be scored."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from gymnasium.vector import AutoresetMode

from soccer_env import soccer_v0
from soccer_env.api.gymnasium_vector import SoccerVectorEnv
from soccer_env.gymnasium_envs import SoloSoccer

GAMES = [("legged-2001", 1, 1), ("legged-2001", 3, 5), ("middle-size-2006", 3, 3), ("middle-size-2006", 11, 11)]
MODES = [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP]
TEAMS = {"opponents": "random", "teammates": "random"}


# Parallel envs


def play(env: Any, steps: int, seed: int = 0, scale: float = 1.0) -> Iterator[tuple[dict[str, np.ndarray], Any]]:
    """Step a parallel env with random actions until it ends; yield actions and what step returned."""
    rng = np.random.default_rng(seed)
    for _ in range(steps):
        if not env.agents:
            return
        actions = {
            agent: (scale * rng.uniform(-1.0, 1.0, env.action_space(agent).shape)).astype(np.float32)
            for agent in env.agents
        }
        yield actions, env.step(actions)


def put_ball(env: Any, x: float, y: float = 0.0, vx: float = 0.0, vy: float = 0.0) -> None:
    """Put the ball somewhere while play is on, field frame."""
    match = env.unwrapped.match
    for name, value in (("x", x), ("y", y), ("vx", vx), ("vy", vy), ("roll_x", vx), ("roll_y", vy)):
        match.balls[name][0] = value
    match.matches["phase"], match.matches["restart_team"] = 0, -1
    match.rebuild()


def still_actions(env: Any) -> dict[str, np.ndarray]:
    """Return the actions of agents that all stand still."""
    return {agent: np.zeros(env.action_space(agent).shape, np.float32) for agent in env.agents}


def env_about_to_score(after: int = 1, **settings: Any) -> soccer_v0.ParallelSoccer:
    """Return an env, begun, in which home scores in a certain control step, and the rest stands still."""
    env = soccer_v0.parallel_env(home=2, away=2, rules="simple", **settings)
    env.reset(seed=1)
    league = env.unwrapped.match.league
    aside = 0.35 * league.pitch.goal_width  # past the goalkeeper
    put_ball(env, league.pitch.length / 2 + league.ball.radius - (after - 0.5) * 2.0 * league.dt, aside, vx=2.0)
    return env


# Envs of one learner


def make_single_env(league: Any = "legged-2001", home: int = 2, away: int = 2, **settings: Any) -> SoloSoccer:
    """Return a single-agent env in which everybody else plays at random."""
    return SoloSoccer(league=league, home=home, away=away, **{**TEAMS, **settings})


def make_vector_env(
    num_envs: Any = 4, league: Any = "legged-2001", home: int = 2, away: int = 2, **settings: Any
) -> SoccerVectorEnv:
    """Return a vector env of the like."""
    return SoccerVectorEnv(num_envs, league=league, home=home, away=away, **{**TEAMS, **settings})
