"""Match: settings, starting and ending, teams from outside, and every mistake a caller can make."""

import gc
import tracemalloc
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, Rewards, Scene
from soccer_env.leagues import find_league
from soccer_env.types import MAX_TEAM

LEAGUES = ("legged-2001", "middle-size-2006")


def draw(match: Match, rng: np.random.Generator) -> np.ndarray:
    """Return random actions for every robot."""
    return rng.uniform(-1.0, 1.0, (match.count, len(match.agents), match.settings.actions.size))


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize(("home", "away"), [(1, 1), (1, 11), (3, 5), (11, 11)])
def test_any_team_sizes_play(league: str, home: int, away: int) -> None:
    match = Match(league, home=home, away=away, seed=1)
    rng = np.random.default_rng(0)
    for _ in range(100):
        observations, rewards, _, _ = match.step(draw(match, rng))
    assert observations.shape == (1, home + away, len(match.observation_names))
    assert rewards.shape == (1, home + away)
    assert match.agents[0] == "home_0" and match.agents[-1] == f"away_{away - 1}"


def test_number_0_keeps_goal_when_a_team_has_two() -> None:
    match = Match(home=2, away=1, seed=1)
    assert match.robots["keeper"].tolist() == [[1, 0, 0]]
    assert Match(home=3, away=3, keeper=2, seed=1).robots["keeper"].tolist() == [[0, 0, 1, 0, 0, 1]]


@pytest.mark.parametrize("league", LEAGUES)
def test_padding_is_inactive_and_changes_nothing(league: str) -> None:
    small, padded = Match(league, home=2, away=1, seed=4), Match(league, home=2, away=1, max_players=4, seed=4)
    assert padded.robots["active"].tolist() == [[1, 1, 0, 0, 1, 0, 0, 0]]
    rng = np.random.default_rng(0)
    for _ in range(200):
        actions = rng.uniform(-1.0, 1.0, (1, 3, 4))
        wide = np.zeros((1, 8, 4))
        wide[:, [0, 1, 4]] = actions
        small.step(actions)
        padded.step(wide)
    np.testing.assert_array_equal(small.observations[0], padded.observations[0, [0, 1, 4]])


@pytest.mark.parametrize("mode", ["off", "next_step", "same_step"])
def test_matches_end_by_the_clock_and_start_again_as_told(mode: str) -> None:
    match = Match(home=1, away=1, matches=2, seed=1, minutes=0.1, autoreset=mode)
    ends = []
    for step in range(1, 201):
        _, _, terminated, truncated = match.step(np.zeros((2, 2, 4)))
        assert not truncated.any()
        if terminated.any():
            ends.append(step)
    seconds = 96  # control steps of 0.1 minutes
    expected = {"off": list(range(seconds, 201)), "next_step": [96, 193], "same_step": [96, 192]}
    assert ends == expected[mode]


def test_next_step_pays_nothing_for_the_step_that_restarts() -> None:
    match = Match(home=1, away=1, seed=1, max_cycles=3, autoreset="next_step")
    actions = np.ones((1, 2, 4))
    for _ in range(3):
        _, rewards, _, truncated = match.step(actions)
    assert truncated[0] and rewards.any()
    observations, rewards, terminated, truncated = match.step(actions)
    assert not rewards.any() and not terminated[0] and not truncated[0] and match.matches["step"][0] == 0
    assert match.matches["episode"][0] == 1
    fresh = Match(home=1, away=1, seed=1)
    fresh.reset()
    np.testing.assert_array_equal(observations, fresh.observations)


def test_same_step_keeps_the_last_observation() -> None:
    off = Match(home=1, away=1, seed=1, max_cycles=3)
    same = Match(home=1, away=1, seed=1, max_cycles=3, autoreset="same_step")
    actions = np.ones((1, 2, 4))
    for _ in range(3):
        last, off_rewards, _, _ = off.step(actions)
        _, same_rewards, _, truncated = same.step(actions)
    assert truncated[0] and same.ended.tolist() == [0]
    np.testing.assert_array_equal(same.final["observations"], last)
    np.testing.assert_array_equal(off_rewards, same_rewards)


def test_action_repeat_adds_up_what_single_steps_pay() -> None:
    once = Match("middle-size-2006", home=2, away=2, seed=2)
    four = Match("middle-size-2006", home=2, away=2, seed=2, action_repeat=4)
    rng = np.random.default_rng(0)
    for _ in range(50):
        actions = draw(once, rng)
        paid = sum(once.step(actions, last=step == 3)[1].copy() for step in range(4))
        np.testing.assert_allclose(four.step(actions)[1], paid, atol=1e-12)
    assert once.state_hash() == four.state_hash()


def test_an_episode_of_one_goal_ends_at_the_goal() -> None:
    match = Match("middle-size-2006", home=1, away=1, seed=1, episode="goal")
    match.balls["x"], match.balls["vx"] = 5.9, 4.0
    match.balls["y"] = 0.3
    match.reseat()
    for _ in range(10):
        _, rewards, terminated, _ = match.step(np.zeros((1, 2, 4)))
        if terminated[0]:
            break
    assert terminated[0] and match.matches["score"][0].tolist() == [1, 0]
    assert match.terms[0, 0, 0] == 1.0 and match.terms[0, 1, 0] == -1.0
    before = match.state_hash()
    match.step(np.ones((1, 2, 4)))
    assert not match.rewards.any(), "a match that is over pays nothing"
    assert before == match.state_hash() or not match.events["goal"][0] >= 0


class Walker:
    """A team that goes straight on and counts its steps."""

    name = "walker"
    memory_dtype = np.dtype([("steps", "i8")])

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        memory["steps"] += 1
        commands = view.stand()
        commands[..., 0] = 5.0 * rng.uniform(0.5, 1.0)
        return commands


def test_a_team_in_python_plays_remembers_and_is_clipped() -> None:
    match = Match(home=2, away=1, matches=3, controllers={"home": Walker()}, seed=1)
    for _ in range(20):
        match.step(np.zeros((3, 3, 4)))
    assert match.squads[0].memory["steps"].tolist() == [[20, 20]] * 3
    assert (match.robots["command"]["forward"][:, :2] == 1.0).all()
    assert (match.robots["vx"][:, 0] > 0.05).all()
    match.reset()
    assert not match.squads[0].memory["steps"].any(), "a new episode begins with an empty memory"


def test_a_team_draws_the_same_alone_and_among_many() -> None:
    many = Match(home=1, away=1, matches=4, controllers={"home": Walker(), "away": "random"}, seed=1)
    one = Match(home=1, away=1, controllers={"home": Walker(), "away": "random"}, seeds=[many.seeds[2]])
    for _ in range(50):
        many.step()
        one.step()
    assert one.state_hash(0) == many.state_hash(2)


class Broken:
    """A team that returns whatever it was made with."""

    name = "broken"
    memory_dtype = np.dtype([("unused", "i8")])

    def __init__(self, commands: Any) -> None:
        self.commands = commands

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> Any:
        return self.commands


@pytest.mark.parametrize("commands", [np.zeros((1, 1, 3)), np.full((1, 1, 4), np.nan), np.zeros(4)])
def test_a_team_that_returns_nonsense_is_named(commands: Any) -> None:
    match = Match(home=1, away=1, controllers={"home": Broken(commands), "away": "still"}, seed=1)
    before = match.state_hash()
    with pytest.raises(ValueError, match="broken"):
        match.step()
    assert match.state_hash() == before


BAD_SETTINGS = [
    ({"league": "small-size"}, "unknown league 'small-size'; known: legged-2001"),
    ({"home": 0}, "home must be 1 to 11, got 0"),
    ({"home": 14}, "home must be 1 to 11, got 14"),
    ({"away": 2.5}, "away must be 1 to 11, got 2.5"),
    ({"home": True}, "home must be 1 to 11, got True"),
    ({"max_players": 2}, "max_players must be 3 to 11, got 2"),
    ({"matches": 0}, "matches must be 1"),
    ({"threads": 0}, "threads must be 1"),
    ({"observe": "smell"}, "observe must be one of truth, percepts, belief, got 'smell'"),
    ({"senses": "eyes"}, "senses must be one of ideal, sensors, got 'eyes'"),
    ({"senses": {"home": "eyes"}}, "senses must be one of ideal, sensors, got 'eyes'"),
    ({"senses": 3}, "senses must be one of ideal, sensors, got 3"),
    ({"pose": "compass"}, "pose must be one of percept, particles, got 'compass'"),
    ({"sensors": {"radar": 1.0}}, "unknown name 'radar' in LeggedSensors; known: resolution, "),
    ({"sensors": {"resolution": "640x480"}}, "resolution must be one of 44x36, 88x72, 176x144, got '640x480'"),
    ({"sensors": {"dither": -0.1}}, "LeggedSensors.dither must be 0 to 1000000, got -0.1"),
    ({"sensors": {"dither": float("nan")}}, "LeggedSensors.dither must be 0 to 1000000, got nan"),
    ({"sensors": {"dither": "much"}}, "LeggedSensors.dither must be a number, got 'much'"),
    ({"sensors": 3}, "sensors must be a mapping of names to values or a LeggedSensors, got 3"),
    ({"memory": {"grouping": -3.0}}, "LeggedMemory.grouping must be 0 to 1000000, got -3.0"),
    ({"memory": {"horizon": 1}}, "LeggedMemory.horizon must be True or False, got 1"),
    ({"memory": {"ball_size": "depth"}}, "ball_size must be one of closer, height, width, got 'depth'"),
    ({"league": "middle-size-2006", "sensors": {"resolution": "88x72"}}, "unknown name 'resolution' in OmniSensors"),
    ({"senses": {"left": "ideal"}}, "keys home and away"),
    ({"actions": "torque"}, "unknown actions 'torque'; known: box, full, discrete"),
    ({"scene": "nowhere"}, "unknown scene 'nowhere'; known: kick-off"),
    ({"episode": "season"}, "episode must be one of match, goal, drill"),
    ({"episode": "drill"}, "needs a scene with a success test"),
    ({"rules": "none"}, "unknown rules 'none'"),
    ({"rewards": "lots"}, "unknown rewards 'lots'; known: default, sparse"),
    ({"placement": "fly"}, "placement must be one of instant, drive"),
    ({"minutes": 0.0}, "minutes must be above zero, got 0.0"),
    ({"minutes": float("nan")}, "minutes must be above zero, got nan"),
    ({"action_repeat": 0}, "action_repeat must be 1 to 1000, got 0"),
    ({"max_cycles": -1}, "max_cycles must be 1"),
    ({"autoreset": "maybe"}, "autoreset must be one of next_step, same_step, off"),
    ({"variation": 0.1}, "variation must be None"),
    ({"keeper": -1}, "keeper must be 0 to 2, got -1"),
    ({"seed": -1}, "seed must be a whole number of 0 or more, got -1"),
    ({"seeds": [1, 2]}, "seeds must be 1 whole numbers"),
    ({"opponents": "brazil"}, "unknown team 'brazil'; known: "),
    ({"opponents": "random@2"}, "strength of team 'random@2' must be a number from 0 to 1"),
    ({"opponents": 7}, "a team needs name, memory_dtype and act"),
    ({"controllers": {"home_9": "still"}}, "unknown agent 'home_9' in controllers; known: home_0"),
    ({"controllers": "still"}, "controllers must map agents or sides to teams"),
]


@pytest.mark.parametrize(("settings", "message"), BAD_SETTINGS, ids=[str(s) for s, _ in BAD_SETTINGS])
def test_bad_settings_are_refused_with_what_is_allowed(settings: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError) as error:
        Match(**settings)
    assert message in str(error.value)


@pytest.mark.parametrize("setting", ["homes", "physics", "render"])
def test_an_unknown_setting_is_refused(setting: str) -> None:
    with pytest.raises(TypeError, match=setting):
        Match(**{setting: 1})


BAD_ACTIONS = [
    (None, "actions are missing for home_0"),
    (np.zeros((1, 2, 3)), "must be numbers of shape (1, 2, 4)"),
    (np.zeros((2, 4)), "must be numbers of shape (1, 2, 4)"),
    (np.zeros((1, 2, 4), complex), "must be numbers"),
    (np.zeros((1, 2, 4), bool), "must be numbers"),
    (np.array([["a"] * 4] * 2)[None], "must be numbers"),
    (np.where(np.arange(8).reshape(1, 2, 4) == 6, np.nan, 0.0), "action of away_0 in match 0 is not finite"),
    (np.where(np.arange(8).reshape(1, 2, 4) == 1, -np.inf, 0.0), "action of home_0 in match 0 is not finite"),
]


@pytest.mark.parametrize(("actions", "message"), BAD_ACTIONS)
def test_bad_actions_are_refused_and_change_nothing(actions: Any, message: str) -> None:
    match = Match(home=1, away=1, seed=1)
    match.step(np.ones((1, 2, 4)))
    before = match.state_hash()
    with pytest.raises(ValueError) as error:
        match.step(actions)
    assert message in str(error.value)
    assert match.state_hash() == before


@pytest.mark.parametrize("index", [-1, 12])
def test_bad_discrete_actions_name_the_agent(index: int) -> None:
    match = Match(home=1, away=1, actions="discrete", seed=1)
    with pytest.raises(ValueError, match="action of away_0"):
        match.step(np.array([[0, index]]))
    with pytest.raises(ValueError, match="must be one integer"):
        match.step(np.array([[0.0, 1.5]]))


def test_finite_actions_outside_the_box_are_clipped() -> None:
    wild, tame = Match(seed=1), Match(seed=1)
    wild.step(np.full((1, 6, 4), 1e300))
    tame.step(np.ones((1, 6, 4)))
    assert wild.state_hash() == tame.state_hash()


def test_rows_that_teams_play_may_hold_anything() -> None:
    match = Match(home=1, away=1, opponents="random", seed=1)
    actions = np.zeros((1, 2, 4))
    actions[:, 1] = np.nan
    match.step(actions)
    assert np.isfinite(match.robots["x"]).all()


def test_one_terms_of_ones_own_is_added() -> None:
    rewards = Rewards(goal=0.0, progress=0.0, approach=0.0, effort=0.0, extra={"x": lambda match: match.robots["x"]})
    match = Match(home=2, away=2, rewards=rewards, seed=1)
    _, paid, _, _ = match.step(np.zeros((1, 4, 4)))
    np.testing.assert_array_equal(paid, match.robots["x"])


def test_an_observation_of_ones_own_is_used_everywhere() -> None:
    class Clock:
        names = ("clock",)

        def __call__(self, match: Match) -> np.ndarray:
            return np.repeat(match.matches["clock"][:, None, None], len(match.agents), axis=1)

    match = Match(home=1, away=1, matches=2, observe=Clock(), seed=1, max_cycles=2, autoreset="same_step")
    assert match.observations.shape == (2, 2, 1)
    match.step(np.zeros((2, 2, 4)))
    assert np.allclose(match.observations, 1 / 16)
    match.step(np.zeros((2, 2, 4)))
    assert np.allclose(match.final["observations"], 2 / 16) and not match.observations.any()


def test_a_scene_of_ones_own_places_what_it_likes() -> None:
    def place(league: Any, ball: Any, robots: Any, draw: Any) -> None:
        ball["x"] = draw.between(0.2, 0.4)

    match = Match(home=1, away=1, matches=8, scene=Scene("ahead", "the ball lies ahead", place), seed=1)
    assert ((match.balls["x"] > 0.2) & (match.balls["x"] < 0.4)).all()
    assert len(set(match.balls["x"])) == 8


def test_a_league_of_ones_own_is_checked_and_played() -> None:
    legged = find_league("legged-2001")
    fast = replace(legged, name="fast", drive=replace(legged.drive, forward=0.3, slip=0.0))
    match = Match(fast, home=1, away=1, seed=1)
    speeds = []
    for _ in range(40):
        match.step(np.array([[[1.0, 0, 0, 0], [0, 0, 0, 0]]]))
        speeds.append(np.hypot(match.robots["vx"], match.robots["vy"]).max())
    assert max(speeds) == pytest.approx(0.3, rel=0.01)
    with pytest.raises(ValueError, match=r"Drive\.forward must be positive, got -1"):
        replace(legged.drive, forward=-1.0)


def test_state_has_room_for_max_players_and_says_who_is_there() -> None:
    from soccer_env import truth_state

    match = Match("middle-size-2006", home=1, away=2, max_players=3, seed=1, matches=2)
    state, names = match.state(), truth_state.names(match)
    assert state.shape == (2, len(names)) and state.dtype == np.float32
    present = [bool(state[0, names.index(f"{side}_{i}_present")]) for side in ("home", "away") for i in range(3)]
    assert present == [True, False, False, True, True, False]
    assert np.abs(state).max() <= 1.0


def test_memory_stays_flat_over_thousands_of_resets() -> None:
    match = Match(home=1, away=1, seed=1)
    for _ in range(200):
        match.reset()
    gc.collect()
    tracemalloc.start()
    for _ in range(2000):
        match.reset()
    gc.collect()
    grown = tracemalloc.get_traced_memory()[0]
    tracemalloc.stop()
    assert grown < 200_000  # [bytes]


def test_a_league_has_room_for_eleven() -> None:
    assert MAX_TEAM == 11


@pytest.mark.parametrize(
    ("returned", "message"),
    [
        (np.zeros(3), "reward term 'mine' must return numbers of shape (1, 2), got shape (3,)"),
        (np.nan, "reward term 'mine' must return finite numbers, got nan at (0, 0)"),
        (None, "reward term 'mine' must return"),
    ],
)
def test_a_reward_term_that_returns_nonsense_is_named(returned: Any, message: str) -> None:
    match = Match(home=1, away=1, seed=1, rewards=Rewards(extra={"mine": lambda match: returned}))
    with pytest.raises(ValueError) as error:
        match.step(np.zeros((1, 2, 4)))
    assert message in str(error.value)


@pytest.mark.parametrize("value", [np.nan, 5.0])
def test_an_observation_outside_the_box_is_refused(value: float) -> None:
    class Wild:
        names = ("wild",)

        def __call__(self, match: Match) -> float:
            return value

    with pytest.raises(ValueError, match=r"observe must return numbers in \[-1, 1\]"):
        Match(home=1, away=1, seed=1, observe=Wild())


def test_a_class_is_no_team() -> None:
    with pytest.raises(ValueError, match=r"give Walker\(\), not the class"):
        Match(home=1, away=1, opponents=Walker, seed=1)


def test_a_compiled_team_is_clipped_and_checked() -> None:
    from soccer_env.baselines.still import MEMORY, SETTINGS
    from soccer_env.compiled import compiled
    from soccer_env.teams import CompiledTeam

    @compiled
    def ask(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last):  # type: ignore[no-untyped-def]
        for m in range(first, last):
            for r in players:
                commands[m, r].turn = settings[0].strength

    for asked, expected in ((7.0, 1.0), (-3.0, -1.0)):
        team = CompiledTeam("wild", ask, MEMORY, np.array([(asked,)], SETTINGS))
        match = Match(home=1, away=1, seed=1, controllers={"home": team, "away": "still"})
        match.step()
        assert match.robots["command"]["turn"][0, 0] == expected
    match = Match(home=1, away=1, seed=1, opponents=CompiledTeam("lost", ask, MEMORY, np.array([(np.nan,)], SETTINGS)))
    with pytest.raises(ValueError, match="team 'lost' gave robot 1 of match 0 a command that is not finite"):
        match.step(np.zeros((1, 2, 4)))
    assert np.isfinite(match.robots["x"]).all()


def test_a_seed_and_seeds_together_are_refused() -> None:
    with pytest.raises(ValueError, match="give seed or seeds, not both"):
        Match(seed=1, seeds=[2])


def test_a_ball_that_is_held_is_not_touched_and_steering_costs_nothing() -> None:
    match = Match("middle-size-2006", home=2, away=2, seed=1, placement="drive", minutes=1, rewards=Rewards(effort=1.0),
                  controllers={"home": "chaser", "away": "chaser"})  # fmt: skip
    placed = 0
    while not match.terminated[0]:
        match.step()
        if match.matches["placing"][0]:
            placed += 1
            assert not match.robot_events["touch"].any() or match.events["restart"][0]
            assert not match.terms[..., 3].any()
    assert placed > 0
