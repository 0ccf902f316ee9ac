"""Monte Carlo search in a drill: dribble past a robot that stands in the way, and beat `chaser` at it.

    python -m soccer_env.train.examples.monte_carlo

At every gait step the search tries 128 plans of six walks in branches of the match, each with its own random numbers,
and carries out the first walk of the best plan. Nothing is learned. In the 16 drills of the seeds 0 to 15 search
succeeds in 12, `chaser` in 1; both together take about a minute of a core.
"""

from typing import Any

import numpy as np

from soccer_env import Match

DRILL: dict[str, Any] = {"scene": "dribble-past-one", "episode": "drill", "home": 1, "away": 1, "senses": "ideal"}
PLANS, WALKS, STEPS = 128, 6, 8  # plans tried, walks of each, control steps of a walk: one gait step


def best_plan(match: Match, planner: Match, rng: np.random.Generator, last: np.ndarray) -> np.ndarray:
    """Return the best of random plans (WALKS, 4) for the first robot of a match; one is the rest of the last plan."""
    plans = rng.uniform(-1.0, 1.0, (planner.count, WALKS, 4))
    plans[..., 3] = -1.0  # no kicks
    plans[0, :-1] = last[1:]
    match.branch(0, into=planner, noise=int(rng.integers(1 << 32)))
    actions, value = np.zeros((planner.count, 2, 4)), np.zeros(planner.count)
    for t in range(WALKS * STEPS):
        actions[:, 0] = plans[:, t // STEPS]
        _, rewards, _, _ = planner.step(actions)
        value += rewards[:, 0] + 3.0 * planner.events["drill"]  # 1: success, -1: failure
    return np.asarray(plans[np.argmax(value)])


def play(seed: int, home: str | None = None, plans: int = PLANS) -> bool:
    """Play the drill by search, or by a team; return whether it succeeded."""
    match = Match(seed=seed, controllers={"home": home, "away": "still"}, **DRILL)
    planner = match.branch([0] * plans)
    rng, plan, actions = np.random.default_rng(seed), np.zeros((WALKS, 4)), np.zeros((1, 2, 4))
    while not (match.terminated[0] or match.truncated[0]):
        if home is None and match.matches["step"][0] % STEPS == 0:
            plan = best_plan(match, planner, rng, plan)
        actions[0, 0] = plan[0]
        match.step(actions)
    return bool(match.events["drill"][0] == 1)


if __name__ == "__main__":
    for home in (None, "chaser"):
        print(home or "search", sum(play(seed, home) for seed in range(16)), "of 16")
