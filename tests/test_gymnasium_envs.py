"""The Gymnasium faces: their contract, and that they are the parallel env seen by one agent."""

import gymnasium
import numpy as np
import pettingzoo
import pytest
from gymnasium.utils.env_checker import check_env, data_equivalence
from gymnasium.vector import AutoresetMode, SyncVectorEnv

from soccer_env import Scene, soccer_v0
from soccer_env.gymnasium_envs import SoloSoccer, register
from soccer_env.gymnasium_vector import SoccerVectorEnv

LEAGUES = ("legged-2001", "middle-size-2006")
GAMES = [("legged-2001", 1, 1), ("legged-2001", 3, 5), ("middle-size-2006", 3, 3), ("middle-size-2006", 11, 11)]
MODES = [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP]
TEAMS = {"opponents": "random", "teammates": "random"}
NAN = float("nan")


def make(league="legged-2001", home=2, away=2, **settings):
    return SoloSoccer(league=league, home=home, away=away, **{**TEAMS, **settings})


def make_many(num_envs=4, league="legged-2001", home=2, away=2, **settings):
    return SoccerVectorEnv(num_envs, league=league, home=home, away=away, **{**TEAMS, **settings})


# The contract


@pytest.mark.parametrize(("league", "home", "away"), GAMES)
def test_gymnasium_accepts_it(league, home, away):
    pytest.importorskip("pygame")
    name = {"legged-2001": "Legged2001", "middle-size-2006": "MiddleSize2006"}[league]
    env = gymnasium.make(f"soccer_env/{name}-1v1-v0", home=home, away=away, render_mode="rgb_array", **TEAMS)
    check_env(env.unwrapped)


@pytest.mark.parametrize(("league", "home", "away"), GAMES)
@pytest.mark.parametrize("actions", ["box", "full", "discrete"])
def test_stable_baselines_accepts_it(league, home, away, actions):
    checker = pytest.importorskip("stable_baselines3.common.env_checker")
    checker.check_env(make(league, home, away, actions=actions))


def test_every_id_can_be_made():
    ids = [name for name in gymnasium.registry if name.startswith("soccer_env/")]
    assert "soccer_env/Legged2001-1v1-v0" in ids and "soccer_env/MiddleSize2006-6v6-v0" in ids and len(ids) == 12
    for name in ids:
        env = gymnasium.make(name, **TEAMS)
        settings = env.unwrapped.match.settings
        league = {"legged-2001": "Legged2001", "middle-size-2006": "MiddleSize2006"}[settings.league.name]
        assert name == f"soccer_env/{league}-{settings.home}v{settings.away}-v0"
        assert env.unwrapped.agent == f"home_{settings.home - 1}"
    register()  # again, and nobody is warned


def test_make_vec_uses_the_batched_core():
    envs = gymnasium.make_vec("soccer_env/MiddleSize2006-1v1-v0", num_envs=64, opponents="still")
    assert isinstance(envs, SoccerVectorEnv) and envs.num_envs == envs.match.count == 64
    assert envs.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP
    observations, _ = envs.reset(seed=1)
    assert observations in envs.observation_space and observations.shape[0] == 64
    observations, rewards, terminated, truncated, _ = envs.step(envs.action_space.sample())
    assert observations in envs.observation_space
    assert rewards.shape == terminated.shape == truncated.shape == (64,)
    envs.close()
    envs.close()


@pytest.mark.skipif(not hasattr(pettingzoo, "make"), reason="this PettingZoo has no registry")
def test_pettingzoo_knows_it_by_name():
    parallel = pettingzoo.make("parallel", "soccer_env/soccer-v0", home=1, away=2)
    assert parallel.possible_agents == ["home_0", "away_0", "away_1"]
    assert pettingzoo.make("aec", "soccer_env/soccer-v0", max_cycles=3).unwrapped.match.settings.max_cycles == 3


def test_the_default_opponent_is_a_team_of_the_league():
    pytest.importorskip("soccer_env.baselines.chaser")
    for name in ("soccer_env/Legged2001-2v2-v0", "soccer_env/MiddleSize2006-2v2-v0"):
        env = gymnasium.make(name)
        env.reset(seed=1)
        for _ in range(20):
            env.step(env.action_space.sample())
        assert [squad.team.name for squad in env.unwrapped.match.squads] == ["chaser", "chaser"]


# Agreement


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("agent", ["home_1", "home_0", "away_1"])
def test_the_single_env_is_the_parallel_env_of_its_agent(league, agent):
    solo = make(league, agent=agent, max_cycles=60)
    others = {name: "random" for name in ("home_0", "home_1", "away_0", "away_1") if name != agent}
    parallel = soccer_v0.parallel_env(league=league, home=2, away=2, controllers=others, max_cycles=60)
    assert solo.observation_space == parallel.observation_space(agent)
    assert solo.action_space == parallel.action_space(agent)
    for episode in range(2):
        seed = 5 if episode == 0 else None
        mine, theirs = solo.reset(seed=seed), parallel.reset(seed=seed)
        assert data_equivalence(mine, tuple(part[agent] for part in theirs), exact=True)
        ended = False
        while not ended:
            action = solo.action_space.sample()
            mine, theirs = solo.step(action), parallel.step({agent: action})
            assert data_equivalence(mine, tuple(part[agent] for part in theirs), exact=True)
            assert solo.match.state_hash() == parallel.unwrapped.match.state_hash()
            ended = mine[2] or mine[3]
    assert parallel.agents == []


def roll_the_ball(league, ball, robots, draw):
    """Let the ball roll towards away's goal, and into it if nobody is in the way."""
    ball["x"] = league.pitch.length / 2 - draw.between(0.05, 0.2) * league.pitch.length
    ball["y"] = draw.between(-0.45, 0.45) * league.pitch.goal_width
    ball["vx"] = ball["roll_x"] = draw.between(0.5, 1.0) * league.kicker.fastest


ROLLING = Scene("rolling", "the ball rolls towards away's goal", roll_the_ball, in_play=True)


def same_infos(mine, theirs):
    """Compare infos key by key; Gymnasium puts scores, which are tuples, into arrays of objects."""
    assert mine.keys() == theirs.keys()
    for key, value in theirs.items():
        if key == "score":
            value = np.array([(0, 0) if pair is None else pair for pair in value])
        if isinstance(value, dict):
            same_infos(mine[key], value)
        elif key == "final_obs":
            assert all((a is None) == (b is None) for a, b in zip(mine[key], value, strict=True))
            assert all(np.array_equal(a, b) for a, b in zip(mine[key], value, strict=True) if a is not None)
        else:
            assert np.array_equal(mine[key], value), key


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize(
    "settings",
    [
        {"max_cycles": 13},
        {"episode": "goal", "scene": ROLLING, "agent": "away_0", "action_repeat": 3, "max_cycles": 20},
        {"actions": "discrete", "minutes": 0.02},
    ],
    ids=["time limit", "goals", "final whistle of discrete"],
)
def test_the_vector_env_is_gymnasiums_own_vector_of_single_envs(league, mode, settings):
    settings = {"opponents": "still", "teammates": "random", "agent": "home_1", **settings}
    many = make_many(4, league, autoreset_mode=mode, **settings)
    each = SyncVectorEnv([lambda: make(league, **settings)] * 4, autoreset_mode=mode)
    assert many.observation_space == each.observation_space and many.action_space == each.action_space
    mine, theirs = many.reset(seed=[3, 4, 5, 6]), each.reset(seed=[3, 4, 5, 6])
    assert np.array_equal(mine[0], theirs[0])
    same_infos(mine[1], theirs[1])
    rng, steps = np.random.default_rng(0), 200
    episodes, goals = 0, 0
    for _ in range(steps):
        if "actions" in settings:
            actions = many.action_space.sample()
        else:
            actions = rng.uniform(-1.0, 1.0, (4, 4)).astype(np.float32)
        mine, theirs = many.step(actions), each.step(actions)
        for ours, other in zip(mine[:4], theirs[:4], strict=True):
            assert ours.dtype == other.dtype and np.array_equal(ours, other)
        same_infos(mine[4], theirs[4])
        episodes += int((mine[2] | mine[3]).sum())
        goals += int(mine[2].sum())
    assert episodes >= 8
    if "scene" in settings:
        assert 8 <= goals < episodes
    elif "max_cycles" in settings:
        assert episodes == 4 * (steps // (14 if mode is AutoresetMode.NEXT_STEP else 13))


@pytest.mark.parametrize("mode", MODES)
def test_threads_and_numbers_of_matches_change_nothing(mode):
    envs = [make_many(n, autoreset_mode=mode, threads=t, max_cycles=9) for n, t in ((8, 1), (8, 2), (3, 1))]
    firsts = [env.reset(seed=2)[0] for env in envs]
    assert all(np.array_equal(first[:3], firsts[0][:3]) for first in firsts)
    rng = np.random.default_rng(0)
    for _ in range(30):
        actions = rng.uniform(-1.0, 1.0, (8, 4)).astype(np.float32)
        results = [env.step(actions[: env.num_envs]) for env in envs]
        for result in results:
            assert all(np.array_equal(a[:3], b[:3]) for a, b in zip(result[:4], results[0][:4], strict=True))
    for env in envs:
        env.close()


def test_seeds_of_the_vector_env_lead_to_its_matches():
    envs, solo = make_many(3), make()
    observations, _ = envs.reset(seed=7)
    assert np.array_equal(observations[0], solo.reset(seed=7)[0])
    match_seeds = envs.match.seeds.copy()
    assert np.array_equal(observations[2], solo.reset(options={"match_seed": match_seeds[2]})[0])
    envs.reset(seed=8)
    assert np.array_equal(observations, envs.reset(options={"match_seeds": match_seeds})[0])
    assert np.array_equal(observations, envs.reset(options={"match_seeds": match_seeds.tolist()})[0])
    assert not np.array_equal(observations, envs.reset()[0])


def test_the_last_observation_and_info_of_an_episode_are_kept_in_same_step_mode():
    envs = make_many(2, autoreset_mode="SameStep", max_cycles=5)
    envs.reset(seed=[1, 2])
    solo = make(max_cycles=5)
    solo.reset(seed=2)
    for _ in range(5):
        observations, rewards, _, truncated, infos = envs.step(np.full((2, 4), 0.5, np.float32))
        last, reward, _, _, info = solo.step(np.full(4, 0.5, np.float32))
    assert truncated.all() and infos["_final_obs"].all() and infos["_final_info"].all()
    assert np.array_equal(infos["final_obs"][1], last) and rewards[1] == reward
    assert {name: values[1] for name, values in infos["final_info"]["rewards"].items() if name[0] != "_"} == (
        info["rewards"]
    )
    assert all((values == 0.0).all() for name, values in infos["rewards"].items() if name[0] != "_")
    assert not np.array_equal(observations[1], last)
    assert np.array_equal(observations[1], solo.reset()[0])


def test_what_the_vector_env_returns_is_the_callers_to_change():
    envs, witness = make_many(max_cycles=6), make_many(max_cycles=6)
    envs.reset(seed=1), witness.reset(seed=1)
    rng = np.random.default_rng(0)
    for _ in range(15):
        actions = rng.uniform(-1.0, 1.0, (4, 4)).astype(np.float32)
        mine, theirs = envs.step(actions), witness.step(actions)
        for ours, other in zip(mine[:4], theirs[:4], strict=True):
            assert np.array_equal(ours, other)
            other[:] = 1
        same_infos(mine[4], {**theirs[4], "score": [tuple(pair) for pair in theirs[4]["score"]]})
        for value in (theirs[4]["score"], theirs[4]["active"], theirs[4]["phase"], *theirs[4]["rewards"].values()):
            value[:] = 1


@pytest.mark.parametrize("mode", MODES)
def test_gymnasiums_vector_wrappers_work(mode):
    envs = gymnasium.wrappers.vector.RecordEpisodeStatistics(make_many(3, autoreset_mode=mode, max_cycles=7))
    envs.reset(seed=1)
    lengths = []
    for _ in range(30):
        *_, infos = envs.step(envs.action_space.sample())
        if "episode" in infos:
            lengths += infos["episode"]["l"][infos["_episode"]].tolist()
    assert lengths and set(lengths) == {7}


# Who plays


def test_the_learner_and_the_teams_can_be_chosen():
    assert make(home=3, away=3).agent == "home_2"
    assert make(home=1, away=1, max_players=3).agent == "home_0"  # not a robot of the padding
    env = make(home=2, away=3, agent="away_1", controllers={"away_0": "still"})
    names = {name: squad.team.name for squad in env.match.squads for name in np.array(env.match.agents)[squad.players]}
    assert names == {"home_0": "random", "home_1": "random", "away_0": "still", "away_2": "random"}
    assert make(home=1, away=1, teammates=None).agent == "home_0"


@pytest.mark.parametrize("maker", [make, make_many])
@pytest.mark.parametrize(
    ("settings", "complaint"),
    [
        ({"agent": "home_2"}, "unknown agent 'home_2'; known: home_0, home_1, away_0, away_1"),
        ({"agent": 1}, "unknown agent 1; known"),
        ({"opponents": None}, "home_1 is the one learner.*away_0"),
        ({"teammates": None}, "home_1 is the one learner.*home_0"),
        ({"controllers": {"home_1": "still"}}, "controllers must map .* other than home_1"),
        ({"controllers": "still"}, "controllers must map"),
        ({"controllers": {"home_5": "still"}}, "unknown agent 'home_5' in controllers"),
        ({"opponents": "giants"}, "unknown team 'giants'"),
        ({"league": "football"}, "unknown league 'football'"),
        ({"home": 12}, "home must be 1 to 11, got 12"),
        ({"render_mode": "ascii"}, "render_mode must be one of rgb_array"),
    ],
)
def test_bad_settings_are_refused(maker, settings, complaint):
    with pytest.raises(ValueError, match=complaint):
        maker(**settings)


@pytest.mark.parametrize(
    ("settings", "complaint"),
    [
        ({"num_envs": 0}, "matches must be .*1"),
        ({"num_envs": 2.5}, "matches must be .*2.5"),
        ({"threads": 0}, "threads must be 1 to 256, got 0"),
        ({"autoreset_mode": "Disabled"}, "autoreset_mode must be one of NextStep, SameStep, got 'Disabled'"),
        ({"render_mode": "human"}, "render_mode must be one of rgb_array, got 'human'"),
    ],
)
def test_bad_settings_of_the_vector_env_are_refused(settings, complaint):
    with pytest.raises(ValueError, match=complaint):
        make_many(**settings)


# Bad input


@pytest.mark.parametrize(
    ("action", "complaint"),
    [
        (np.array([0, NAN, 0, 0]), "home_1.*nan"),
        (np.zeros(3), r"home_1 must be 4 numbers.*\(3,\)"),
        (np.zeros((2, 4)), r"home_1 must be 4 numbers.*\(2, 4\)"),
        (None, "home_1 must be 4 numbers"),
        ("forward", "home_1 must be 4 numbers"),
        (3, "home_1 must be 4 numbers"),
    ],
)
def test_bad_actions_are_refused_and_change_nothing(action, complaint):
    env = make()
    env.reset(seed=1)
    env.step(np.zeros(4))
    before = env.match.state_hash()
    with pytest.raises(ValueError, match=complaint):
        env.step(action)
    assert env.match.state_hash() == before
    env.step(np.zeros(4))


GOOD = np.zeros((4, 4), np.float32)


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize(
    ("actions", "complaint"),
    [
        (np.where(np.arange(16).reshape(4, 4) == 9, np.inf, GOOD), "home_1 in match 2.*inf"),
        (GOOD[:3], r"home_1 must be numbers of shape \(4, 4\), got float32 of shape \(3, 4\)"),
        (GOOD[0], r"shape \(4, 4\), got float32 of shape \(4,\)"),
        (GOOD.astype(complex), "got complex"),
        (GOOD.astype(bool), "got bool"),
        (GOOD.astype(str), "got <U"),
        ([[0.0], [1.0, 2.0]], "must be numbers of shape"),
        (None, "got object"),
        ({"home_1": GOOD}, "got object"),
    ],
)
def test_bad_actions_of_the_vector_env_are_refused_and_change_nothing(mode, actions, complaint):
    envs, witness = make_many(autoreset_mode=mode), make_many(autoreset_mode=mode)
    envs.reset(seed=1), witness.reset(seed=1)
    envs.step(GOOD), witness.step(GOOD)
    before = envs.match.state_hash()
    with pytest.raises(ValueError, match=complaint):
        envs.step(actions)
    assert envs.match.state_hash() == before
    assert np.array_equal(envs.step(GOOD)[0], witness.step(GOOD)[0])


@pytest.mark.parametrize(
    ("actions", "complaint"),
    [([0, 12, 0, 0], "home_1 in match 1 must be 0 to 11, got 12"), ([0.0, 1.0, 2.0, 3.0], "integers of shape")],
)
def test_bad_discrete_actions_of_the_vector_env_are_refused(actions, complaint):
    envs = make_many(actions="discrete")
    envs.reset(seed=1)
    before = envs.match.state_hash()
    with pytest.raises(ValueError, match=complaint):
        envs.step(actions)
    assert envs.match.state_hash() == before
    envs.step([0, 11, 3, 4])


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        ({"seed": -1}, "seed.*-1"),
        ({"seed": 1.5}, "seed.*1.5"),
        ({"seed": [1, 2]}, "seeds must be 4 whole numbers"),
        ({"seed": [1, 2, 3, None]}, "each seed must be a whole number of 0 or more, got None"),
        ({"seed": [1, 2, 3, -4]}, "got -4"),
        ({"options": {"reset_mask": np.ones(4, bool)}}, "unknown option 'reset_mask'; known: match_seeds"),
        ({"options": {"match_seeds": [1, 2]}}, "seeds must be 4 whole numbers"),
        ({"seed": 1, "options": {"match_seeds": [1, 2, 3, 4]}}, "both"),
    ],
)
def test_bad_resets_of_the_vector_env_are_refused(arguments, complaint):
    envs = make_many()
    envs.reset(seed=1)
    before = envs.match.state_hash()
    with pytest.raises(ValueError, match=complaint):
        envs.reset(**arguments)
    assert envs.match.state_hash() == before


def test_calls_in_the_wrong_order_say_that_reset_is_due():
    solo, envs = make(max_cycles=1, render_mode="rgb_array"), make_many(render_mode="rgb_array")
    for call in (lambda: solo.step(GOOD[0]), lambda: envs.step(GOOD), solo.render, envs.render):
        with pytest.raises(RuntimeError, match="before reset"):
            call()
    solo.reset(seed=0)
    solo.step(GOOD[0])
    with pytest.raises(RuntimeError, match="after the end"):
        solo.step(GOOD[0])


# Pictures


def test_every_match_of_the_vector_env_has_its_frame():
    pytest.importorskip("pygame")
    envs = make_many(3, render_mode="rgb_array")
    envs.reset(seed=1)
    frames = envs.render()
    assert len(frames) == 3 and frames[0].dtype == np.uint8 and frames[0].shape[2] == 3
    assert not np.array_equal(frames[0], frames[1])
    silent = make_many(1)
    silent.reset(seed=0)
    with pytest.warns(UserWarning, match="render_mode"):
        assert silent.render() is None


# Training libraries


@pytest.mark.parametrize("league", LEAGUES)
def test_one_policy_fits_every_team_size(league):
    sb3 = pytest.importorskip("stable_baselines3")
    model = sb3.PPO("MlpPolicy", make(league, 1, 1), n_steps=8, batch_size=8, n_epochs=1, device="cpu")
    model.learn(8)
    for home, away in ((3, 5), (11, 11)):
        env = make(league, home, away)
        model.set_env(env)
        model.learn(8)
        action, _ = model.predict(env.reset(seed=0)[0])
        assert action.shape == (4,)
