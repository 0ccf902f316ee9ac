"""A scene whose success is a function of one's own: it ends episodes, and nonsense is named."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match, OwnTerm, Rewards, Scene, soccer_v0
from soccer_env.replay import Recorder


def walked(match: Any) -> np.ndarray:
    """Succeed 5 cm ahead of where home stood at first, fail as far behind."""
    ahead = match.robots["x"][:, 0] - START
    return np.where(ahead > 0.05, 1, np.where(ahead < -0.05, -1, 0))


def at_start(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Put home's robot behind the centre, far from the ball."""
    robots[0]["x"], robots[0]["y"], robots[0]["heading"] = START, 0.5, 0.0
    ball["x"], ball["y"] = 0.5, -0.5


START = -0.5
WALK = Scene("walk", "walk ahead", place=at_start, success=walked, time_limit=3.0, in_play=True)
SETTINGS: dict[str, Any] = {"scene": WALK, "episode": "drill", "home": 1, "away": 1, "opponents": "still", "seed": 1}


def drill(forward: list[float], **changes: Any) -> tuple[Match, list[list[int]]]:
    """Return matches in which home walks so fast, and after each step how each stands: 1 or -1 ended, 2 out of time."""
    match = Match(**{**SETTINGS, "matches": len(forward), **changes})
    actions = np.zeros((len(forward), 2, 4))
    actions[:, 0, 0] = forward
    history = []
    for _ in range(60):
        match.step(actions)
        history.append(np.where(match.truncated, 2, match.events["drill"] * match.terminated).tolist())
    return match, history


def test_it_ends_successes_failures_and_what_runs_out_of_time() -> None:
    match, history = drill([1.0, -1.0, 0.0])
    for m, wanted in enumerate((1, -1, 2)):
        first = next(step for step, row in enumerate(history) if row[m])
        assert history[first][m] == wanted
        assert first == 47 if wanted == 2 else 5 < first < 40
    assert match.matches["over"].tolist() == [1, 1, 0]
    assert abs(match.robots["x"][0, 0] - START) == pytest.approx(0.05, abs=0.01)


def test_a_match_alone_ends_as_among_many_and_begins_anew() -> None:
    many = Match(**SETTINGS, matches=5, autoreset="same_step")
    one = Match(**{**SETTINGS, "seed": None}, seeds=[many.seeds[3]], autoreset="same_step")
    for _ in range(100):
        many.step(np.ones((5, 2, 4)))
        one.step(np.ones((1, 2, 4)))
    assert one.state_hash(0) == many.state_hash(3)
    assert many.matches["episode"].min() >= 2


def test_shaping_ends_with_potential_0() -> None:
    own = OwnTerm(lambda match: match.robots["x"], kind="potential")
    sums = []
    for speed in (1.0, 0.7):
        match = Match(**SETTINGS, rewards=Rewards.only(progress=1.0, approach=1.0, extra={"own": own}))
        actions, total, discount = np.zeros((1, 2, 4)), np.zeros(len(match.term_names)), 1.0
        actions[:, 0, 0] = speed
        while not match.terminated[0]:
            match.step(actions)
            total += discount * match.terms[0, 0]
            discount *= 0.99
        assert match.rewards[0, 0] == pytest.approx(match.terms[0, 0].sum())
        sums.append(total)
    np.testing.assert_allclose(sums[0], sums[1], atol=1e-9)  # whatever the way, minus the potential of the start
    assert sums[0][-1] == pytest.approx(-START) and sums[0][match.term_names.index("approach")] != 0.0


def test_envs_tell_of_it() -> None:
    env = soccer_v0.parallel_env(**{name: value for name, value in SETTINGS.items() if name != "seed"}, infos="nested")
    env.reset(seed=1)
    while env.agents:
        _, _, terminations, _, infos = env.step({"home_0": np.array([1.0, 0, 0, 0])})
    assert terminations["home_0"] and infos["home_0"]["events"]["drill"] == "success"


@pytest.mark.parametrize(("returned", "message"), [
    (0.5, "success of scene 'mine' must return 1, -1 or 0 for each match, got 0.5 for 0"),
    (np.nan, "success of scene 'mine' must return numbers in [-1, 1], got nan at (0,)"),
    (2, "success of scene 'mine' must return numbers in [-1, 1], got 2.0 at (0,)"),
    (np.zeros(3), "success of scene 'mine' must return numbers of shape (2,), got shape (3,)"),
    (None, "success of scene 'mine' must return"),
])  # fmt: skip
def test_what_it_returns_wrongly_is_named(returned: Any, message: str) -> None:
    mine = Scene("mine", "wrong", success=lambda match: returned)
    match = Match(**{**SETTINGS, "scene": mine}, matches=2)
    with pytest.raises(ValueError) as error:
        match.step(np.zeros((2, 2, 4)))
    assert message in str(error.value)


def test_it_is_not_recorded_and_other_words_are_refused() -> None:
    with pytest.raises(ValueError, match="replays hold no code"):
        Recorder(Match(**SETTINGS))
    assert Recorder(Match(**{**SETTINGS, "episode": "match"})).stop().check() == 0
    with pytest.raises(
        ValueError, match="Scene.success must be one of none, home scores, .*, or a function of the match"
    ):
        Scene("a", "b", success="often")
