"""Every reward term is fair, left and right and for both teams, and of the right sign; and terms of a user's own."""

import pickle
import re
from dataclasses import FrozenInstanceError, replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, OwnTerm
from soccer_env.compiled import compiled
from soccer_env.rewards import NAMES, POTENTIALS, TERMS, Rewards
from soccer_env.rewards.paying import measure_potentials, reward_robots
from soccer_env.types import AWAY, HOME, NO_TEAM, Foul
from tests.scenes.staging import each_league, put, put_ball, scatter, stage
from tests.scenes.symmetry import HALF_TURN, MIRROR, Records, assert_close, mirrored, other_team, swapped_rows, turned

SIZE, MATCHES = 3, 60
ALL = Rewards(**dict.fromkeys(NAMES, 1.0))


@compiled
def pay_all(matches, balls, robots, events, robot_events, constants, weights, terms):
    """Pay every term for a step that began with potentials of 0."""
    before, after, rewards = np.zeros(POTENTIALS), np.zeros(POTENTIALS), np.zeros(robots.shape[1])
    for m in range(len(matches)):
        measure_potentials(matches[m], balls[m], robots[m], constants[0], weights[0], after)
        reward_robots(
            matches[m], balls[m], robots[m], events[m], robot_events[m], constants[0], before, after, weights[0],
            terms[m], rewards,
        )  # fmt: skip


def paid(match: Match, records: Records, events: np.ndarray, robot_events: np.ndarray) -> np.ndarray:
    """Return the terms (M, R, names), each of weight 1, potentials as they are."""
    terms = np.zeros((*records.robots.shape, len(NAMES)))
    world = (records.matches, records.balls, records.robots, events, robot_events)
    pay_all(*world, match.settings.constants(), ALL.weights(), terms)
    return terms


def mid_game(name: str) -> Match:
    """Return matches in which everything happens that a term pays for, in both halves, some robots out."""
    match, rng = Match(name, home=SIZE, away=SIZE, matches=MATCHES, seed=3), np.random.default_rng(3)
    scatter(match, rng, 0.95)
    match.matches["home_direction"], match.matches["placing"] = rng.choice([-1.0, 1.0], MATCHES), 0
    robots, half, width = match.robots, 0.5 * match.league.pitch.length, 0.5 * match.league.pitch.goal_width
    end = match.matches["home_direction"][:, None] * np.where(robots["team"] == HOME, -1.0, 1.0)
    keeps = robots["keeper"] == 1  # somewhere before its goal, and the ball before one of the two
    robots["x"][keeps] = (end * (half - rng.uniform(0.0, 0.3, robots.shape) * half))[keeps]
    robots["y"][keeps] = rng.uniform(-1.2, 1.2, robots.shape)[keeps] * width
    x, y = rng.uniform(0.4, 0.95, MATCHES) * rng.choice([-half, half], MATCHES), rng.uniform(-1.5, 1.5, MATCHES) * width
    angle = np.arctan2(0.5 * rng.uniform(-1.0, 1.0, MATCHES) * width - y, np.sign(x) * half - x)  # at that goal
    speed = 0.9 * match.league.ball.top_speed
    put_ball(match, x, y, speed * np.cos(angle), speed * np.sin(angle))
    crowds = (robots["keeper"] == 0) & (np.arange(MATCHES)[:, None] % 3 == 0)
    for axis in "xy":
        near = match.balls[axis][:, None] + 2.5 * match.league.body.reach * rng.uniform(-1.0, 1.0, robots.shape)
        robots[axis][crowds] = near[crowds]
    for field in ("forward", "left", "turn"):
        robots["command"][field] = rng.uniform(-1.0, 1.0, robots.shape)
    robots["active"] = rng.random(robots.shape) < 0.9
    robots["penalty"] = np.where(robots["active"] == 0, 5.0, 0.0)
    match.events["goal"] = rng.choice([NO_TEAM, HOME, AWAY], MATCHES)
    match.robot_events["kick"] = rng.random(robots.shape) < 0.3
    match.robot_events["foul"] = np.where(rng.random(robots.shape) < 0.2, Foul.PUSHING, 0)
    return match


@each_league
def test_every_term_is_the_same_in_the_mirror_and_the_other_teams_after_a_half_turn(name: str) -> None:
    match = mid_game(name)
    records, events, robot_events = Records.of(match), match.events.copy(), match.robot_events.copy()
    one = paid(match, records, events, robot_events)
    image = paid(match, mirrored(records), events, robot_events)
    events["goal"] = other_team(events["goal"])
    turn = paid(match, turned(records), events, swapped_rows(robot_events))
    for column, term in enumerate(NAMES):
        assert len(np.unique(one[..., column].round(9))) > 1, f"{term} never pays here"
        assert_close(image[..., column], one[..., column], MIRROR, f"{term} in the mirror")
        assert_close(turn[..., column], swapped_rows(one)[..., column], HALF_TURN, f"{term} after a half-turn")


# Signs, in scenes of one team of which left and right, or the two ends, are not alike: better, then worse

BEFORE_LEFT_POST = (-0.6, 0.2)  # shares of half the length and width, team frame: here lies the ball


def scene(side: int, direction: float, ball: Any, keeper: Any, mates: Any = (), **given: Any) -> tuple[Match, int]:
    """Return a match with a team's keeper (robot 0) and mates at places of the team frame, and the team's first row."""
    match = stage("legged-2001", home=SIZE, away=SIZE)
    match.matches["home_direction"] = direction
    forward, first = direction * (1.0 if side == HOME else -1.0), side * SIZE
    scale = 0.5 * np.array([match.league.pitch.length, match.league.pitch.width])
    for r, place in enumerate((keeper, *mates)):
        put(match, first + r, *(forward * scale * place))
    velocity = forward * np.array(given.get("velocity", (0.0, 0.0)))
    put_ball(match, *(forward * scale * ball), *velocity)
    return match, first


def value(term: str, match: Match, r: int) -> float:
    """Return what robot r is paid of a term of weight 1, by this moment's records alone."""
    return float(paid(match, Records.of(match), match.events, match.robot_events)[0, r, NAMES.index(term)])


FAR, AT_BALL = (0.5, -0.8), (-0.55, 0.2)
SCENES = {  # term: better, worse scenes of the team
    "progress": ({"ball": (0.3, 0.4)}, {"ball": (-0.3, 0.4)}),
    "approach": ({"mates": [(-0.5, 0.2)]}, {"mates": [(-0.5, -0.2)]}),
    "cover": ({"mates": [AT_BALL, (-0.72, 0.1)]}, {"mates": [AT_BALL, (-0.72, -0.1)]}),
    "crowding": ({"mates": [AT_BALL, (-0.6, -0.2)]}, {"mates": [AT_BALL, (-0.6, 0.3)]}),
    "guard": ({"keeper": (-0.9, 0.1)}, {"keeper": (-0.9, -0.1)}),
    "shot": ({"ball": (0.6, 0.5), "velocity": (1.0, -0.8)}, {"ball": (0.6, 0.5), "velocity": (1.0, 0.8)}),
}


@pytest.mark.parametrize("direction", [1.0, -1.0])
@pytest.mark.parametrize("side", [HOME, AWAY])
@pytest.mark.parametrize("term", SCENES)
def test_who_stands_on_the_right_side_is_paid_more(term: str, side: int, direction: float) -> None:
    usual = {"ball": BEFORE_LEFT_POST, "keeper": (-0.95, 0.0), "mates": [FAR, FAR]}
    found = []
    for case in SCENES[term]:
        match, first = scene(side, direction, **{**usual, **case})
        match.robot_events["kick"][0, first] = 1
        found.append(value(term, match, first))
    assert found[0] > found[1]


def test_goals_fouls_efforts_and_penalties_pay_and_cost_who_they_should() -> None:
    match, _ = scene(HOME, 1.0, BEFORE_LEFT_POST, (-0.9, 0.0))
    match.events["goal"], match.robot_events["foul"][0, 1], match.robots["penalty"][0, 4] = AWAY, Foul.HOLDING, 9.0
    match.robots["command"]["turn"][0, 5] = -1.0
    told = {name: [value(name, match, r) for r in range(2 * SIZE)] for name in ("goal", "foul", "strength", "effort")}
    assert told["goal"] == [-1.0] * SIZE + [1.0] * SIZE and told["foul"] == [0.0, -1.0, 0.0, 0.0, 0.0, 0.0]
    assert told["strength"] == pytest.approx([0.0] * SIZE + [-ALL.gamma / SIZE] * SIZE)
    assert told["effort"] == pytest.approx([0.0] * 5 + [-match.league.dt / 3.0])
    assert set(told) | set(SCENES) == {term.name for term in TERMS}, "a term of which no scene says the sign"


NOTHING = Rewards.only()


def one(match: Match) -> np.ndarray:
    return np.ones(match.robots.shape)


def test_rewards_can_be_compared_copied_and_written_down() -> None:
    rewards = Rewards(goal=2.0, extra={"x": one})
    assert rewards == Rewards(goal=2.0, extra={"x": OwnTerm(one)}) != Rewards(extra={"x": one})
    assert replace(rewards, gamma=0.5) == Rewards(goal=2.0, gamma=0.5, extra={"x": one})
    assert pickle.loads(pickle.dumps(rewards)) == rewards
    with pytest.raises(FrozenInstanceError):
        rewards.goal = 1.0
    described = Match(home=1, away=1, seed=1, rewards=rewards).settings.describe()["rewards"]
    assert described["goal"] == 2.0 and described["extra"]["x"]["kind"] == "event"
    assert described["extra"]["x"]["function"].endswith(".one")


@pytest.mark.parametrize(("bad", "message"), [
    ((3,), "OwnTerm.function must be"),
    ((one, "bonus"), "OwnTerm.kind must be one of potential, event, cost, got 'bonus'"),
    ((one, "cost", np.nan), "OwnTerm.weight must be -1000000000 to 1000000000, got nan"),
    ((one, "event", -1e300), "OwnTerm.weight must be -1000000000 to 1000000000, got -1e+300"),
])  # fmt: skip
def test_bad_terms_of_ones_own_are_refused(bad: tuple[Any, ...], message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        OwnTerm(*bad)


def ball_x(match: Match) -> np.ndarray:
    """Return the ball's place (M, R), of either team alike: never 0 in play."""
    return np.repeat(match.balls["x"][:, None] + 5.0, len(match.agents), axis=1)


@pytest.mark.parametrize("repeat", [1, 4])
def test_a_potential_of_ones_own_telescopes_over_an_episode_and_is_0_at_its_end(repeat: int) -> None:
    gamma, weight = 0.9, 2.0
    rewards = replace(NOTHING, gamma=gamma, extra={"mine": OwnTerm(ball_x, "potential", weight)})
    match = Match(home=2, away=2, matches=3, seed=2, minutes=0.05, action_repeat=repeat, rewards=rewards)
    start, total, discount = ball_x(match), np.zeros((3, 4)), 1.0
    rng = np.random.default_rng(0)
    while not match.terminated.all():
        before = ball_x(match)
        _, paid, _, _ = match.step(rng.uniform(-1.0, 1.0, (3, 4, 4)))
        after = np.where(match.terminated[:, None], 0.0, ball_x(match))
        np.testing.assert_allclose(paid, weight * (gamma * after - before), atol=1e-12)
        total += discount * paid
        discount *= gamma
    np.testing.assert_allclose(total, -weight * start, atol=1e-9)
    _, paid, _, _ = match.step(np.zeros((3, 4, 4)))
    assert not paid.any(), "a match that is over pays nothing"


@pytest.mark.parametrize("mode", ["same_step", "next_step"])
@pytest.mark.parametrize("ending", [{"max_cycles": 7}, {"minutes": 0.01}])
def test_a_potential_of_ones_own_does_not_leak_over_an_autoreset(mode: str, ending: dict[str, Any]) -> None:
    rewards = replace(NOTHING, extra={"mine": OwnTerm(ball_x, "potential")})
    match = Match(home=1, away=1, matches=2, seed=3, autoreset=mode, rewards=rewards, **ending)
    rng, begun = np.random.default_rng(0), np.zeros(2, np.int64)
    for _ in range(60):
        match.balls["vx"] = rng.uniform(-1.0, 1.0, 2)
        match.rebuild()
        before, episode = ball_x(match), match.matches["episode"].copy()
        _, paid, terminated, _ = match.step(rng.uniform(-1.0, 1.0, (2, 2, 4)))
        same = match.matches["episode"] == episode
        after = np.where(terminated[:, None], 0.0, ball_x(match))
        np.testing.assert_allclose(paid[same], (0.99 * after - before)[same], atol=1e-12)
        if mode == "next_step":
            assert not paid[~same].any()
        elif "minutes" in ending and not same.all():
            np.testing.assert_allclose(paid[~same], -before[~same], atol=1e-12)
        begun += ~same
    assert (begun >= 3).all()


def test_a_potential_is_that_of_the_records_when_the_step_begins() -> None:
    """Whoever writes into the records between two steps, or loads a save, is neither paid nor charged for it."""
    rewards = replace(NOTHING, gamma=1.0, extra={"mine": OwnTerm(ball_x, "potential")})
    match = Match(home=1, away=1, seed=3, rewards=rewards)
    saved = match.save()
    match.step(np.zeros((1, 2, 4)))
    match.balls["x"] = 0.7
    match.rebuild()
    assert abs(match.step(np.zeros((1, 2, 4)))[1]).max() < 0.1
    match.load(saved)
    assert abs(match.step(np.zeros((1, 2, 4)))[1]).max() < 0.1
