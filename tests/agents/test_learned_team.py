"""A policy as a team: what it sees is what a learner sees, and what it does is what the learner would have done."""

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.agents.learned import first_decision_step, team_from_policy
from soccer_env.leagues import find_league
from soccer_env.observations import entry_names
from soccer_env.teams import TeamRandom, View
from soccer_env.types import COMMAND
from tests.agents.staged_policies import decide, random_policy
from tests.scenes.staging import play
from tests.scenes.symmetry import Records, mirrored

# What is observed, by which senses, with which settings.
SEEN: list[tuple[str, str, dict[str, Any]]] = [
    ("truth", "ideal", {}), ("belief", "ideal", {}), ("belief", "sensors", {}),
    ("belief", "sensors", {"pose": "particles"}), ("percepts", "sensors", {}),
]  # fmt: skip


def commanded(match: Match) -> np.ndarray:
    command = match.robots["command"]
    return np.stack([command[name] for name in COMMAND.names or ()], axis=-1)


def same_play(one: Match, other: Match) -> bool:
    """Tell whether the records of two matches are the same bit for bit."""
    names = ("matches", "balls", "robots")
    return all(getattr(one, name).tobytes() == getattr(other, name).tobytes() for name in names)


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
@pytest.mark.parametrize(("observe", "senses", "settings"), SEEN)
def test_it_observes_bit_for_bit_what_a_learner_there_does(observe: str, senses: str, settings: Any, league: str):
    settings = {"home": 2, "away": 2, "matches": 2, "senses": senses, "seed": 4, **settings}
    team = team_from_policy(random_policy(observe=observe, league=league))
    inside = Match(league, controllers={"home": team, "away": "chaser"}, **settings)
    outside = Match(league, opponents="chaser", observe=observe, actions="full", **settings)
    for _ in range(60):
        due = outside.observations[:, :2].copy()
        inside.step()
        assert (inside.squads[0].observations[:, :2] == due).all()
        assert np.abs(due).max() <= 1.0 and due.any()
        outside.step(commanded(inside))
    assert same_play(inside, outside)


def test_with_a_policy_at_home_and_one_away_each_observes_from_its_own_side() -> None:
    truth, belief = team_from_policy(random_policy(observe="truth")), team_from_policy(random_policy())
    match = Match(home=2, away=2, controllers={"home": truth, "away": belief}, seed=4, senses={"home": "ideal"})
    outside = Match(home=2, away=2, observe="belief", actions="full", seed=4, senses={"home": "ideal"})
    for _ in range(30):
        due = outside.observations[:, 2:].copy()
        match.step()
        assert (match.squads[1].observations[:, 2:] == due).all()
        outside.step(commanded(match))
    seen = dict(zip(random_policy(observe="truth").inputs, match.squads[0].observations[0, 0], strict=True))
    assert seen["own_x"] < 0.0, "the own half is at -x"


def test_robots_stand_until_the_first_decision_and_keep_each_for_the_repeat() -> None:
    team = team_from_policy(random_policy(action_repeat=8))
    match = Match(home=2, away=1, controllers={"home": team, "away": "still"}, seed=1)
    asked = []
    for _ in range(30):
        match.step()
        asked.append(commanded(match)[0, :2])
    asked_for = [(0, 8), (2, 8), (2, 1), (2, 4), (9, 8)]
    assert [first_decision_step(*one) for one in asked_for] == [0, 6, 0, 2, 7], "a delay before a repeat ends"
    first = first_decision_step(match.league.delay_steps, 8)
    assert first == 6, "the walk is latched every 8 control steps and a command needs 2 to arrive"
    assert not np.any(asked[:first] - np.array([0, 0, 0, 0, -1, 0, 0])), "the head tracks the ball by itself"
    for step in range(first, 30):
        changed = bool((asked[step][:, :4] != asked[step - 1][:, :4]).any())
        assert changed == ((step - first) % 8 == 0)


@pytest.mark.parametrize("size", [1, 2, 3, 5])
def test_any_team_size_plays_and_each_robot_by_its_own_observation(size: int) -> None:
    policy = random_policy(16)
    teams = {"home": team_from_policy(policy), "away": "chaser"}
    match = Match(home=size, away=size, controllers=teams, matches=2, seed=1)
    start = match.robots["x"].copy()
    for _ in range(50):
        match.step()
        rows = match.squads[0].observations[:, :size].reshape(2 * size, -1)
        assert (commanded(match)[:, :size, :4].reshape(-1, 4) == decide(policy, rows)).all()
    assert (match.robots["x"] != start)[:, :size].all()


@pytest.mark.parametrize("mirror", [False, True])
def test_a_policy_of_fewer_inputs_plays_as_its_network_says_to_these(mirror: bool) -> None:
    """As policies of the time before the clocks: they read the entries by name, bit for bit."""
    names = entry_names(find_league("legged-2001"), "belief")
    old = [name for name in names if name not in ("own_pushing", "own_holding", "own_penalty", "ball_still")]
    columns = [names.index(name) for name in old]
    policy = random_policy(16, mirror=mirror, inputs=tuple(old))
    match = Match(home=2, away=1, controllers={"home": team_from_policy(policy), "away": "chaser"}, seed=1)
    for _ in range(40):
        match.step()
        seen = match.squads[0].observations[0, :2]
        assert seen.shape[1] == len(names) == len(old) + 4
        assert (commanded(match)[0, :2, :4] == decide(policy, seen[:, columns])).all()


def test_a_match_plays_alone_as_among_64_and_on_two_threads_as_on_one() -> None:
    team = team_from_policy(random_policy(16, action_repeat=4))
    hashes = []
    for threads in (1, 2):
        many = Match(controllers={"home": team, "away": "chaser"}, home=2, away=1, matches=64, threads=threads, seed=3)
        play(many, steps=40)
        hashes.append(many.state_hash())
        many.close()
    assert hashes[0] == hashes[1]
    one = Match(controllers={"home": team, "away": "chaser"}, home=2, away=1, seeds=[many.seeds[41]])
    play(one, steps=40)
    assert one.state_hash(0) == many.state_hash(41)


@pytest.mark.parametrize(("repeat", "actions"), [(1, "box"), (4, "full"), (8, "box")])
@pytest.mark.parametrize(("observe", "senses", "settings"), SEEN)
def test_it_plays_exactly_as_a_learner_that_was_asked_in_training(
    observe: str, senses: str, settings: dict[str, Any], repeat: int, actions: str
) -> None:
    pytest.importorskip("stable_baselines3")
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

    settings = {"matches": 2, "senses": senses, "seed": 4, "minutes": 0.05, **settings}
    policy = random_policy(16, observe=observe, action_repeat=repeat, actions=actions)
    learner = SoccerVecEnv(players=((2, 2),), action_repeat=repeat, actions=actions, observe=observe, **settings)
    sides = {"home": team_from_policy(policy), "away": "chaser"}
    player = Match(home=2, away=2, controllers=sides, autoreset="same_step", **settings)
    seen = learner.reset()
    play(player, steps=first_decision_step(player.league.delay_steps, repeat))
    assert same_play(learner.matches[0], player)
    ends = 0
    for _ in range(120 // repeat):
        seen, _, dones, _ = learner.step(decide(policy, seen))
        play(player, steps=repeat)
        ends += dones.any()
        assert same_play(learner.matches[0], player)
    assert ends == 2, "it goes on so in later episodes"


def test_plain_python_plays_what_the_compiled_code_plays() -> None:
    program = """
from soccer_env import Match
from soccer_env.agents.learned import team_from_policy
from tests.agents.staged_policies import random_policy, random_recurrent_policy
makers = (random_policy, random_recurrent_policy)
for make, activation in ((make, activation) for make in makers for activation in ("tanh", "relu")):
    team = team_from_policy(make(16, 8, activation=activation, mirror=True, action_repeat=4))
    match = Match(home=1, away=1, controllers={"home": team, "away": team}, senses="ideal", seed=1)
    for _ in range(24):
        match.step()
    print(match.state_hash())
"""
    printed = []
    for disabled in ("0", "1"):
        environment = {**os.environ, "NUMBA_DISABLE_JIT": disabled, "PYTHONPATH": str(Path(__file__).parents[2])}
        command = [sys.executable, "-c", program]
        run = subprocess.run(command, capture_output=True, text=True, env=environment, check=True)
        printed.append(run.stdout.split())
    assert printed[0] == printed[1] and len(set(printed[0])) == 4


@pytest.mark.parametrize("observe", ["truth", "belief"])
def test_a_mirror_policy_plays_a_mirrored_scene_mirrored(observe: str) -> None:
    team = team_from_policy(random_policy(32, 32, observe=observe, mirror=True))
    one, other = (Match(home=2, away=2, controllers={"home": team, "away": team}, senses="ideal", seed=2) for _ in "ab")
    play(one, steps=30)
    mirrored(Records.of(one)).put_into(other)
    for squad, twin in zip(one.squads, other.squads, strict=True):
        twin.memory[:] = squad.memory
    one.step()
    other.step()
    signs = np.array([1, -1, -1, 1, 1, 1, 1])
    np.testing.assert_allclose(commanded(other), commanded(one) * signs, rtol=0.0, atol=1e-5)
    assert np.abs(commanded(one)[..., 1:3]).max() > 0.02


@pytest.mark.parametrize(
    ("observe", "needed", "got"), [("truth", "ideal", "sensors"), ("percepts", "sensors", "ideal")]
)
def test_senses_that_cannot_give_what_it_observes_are_refused(observe: str, needed: str, got: str) -> None:
    team = team_from_policy(random_policy(observe=observe))
    with pytest.raises(ValueError) as error:
        Match(home=1, away=1, opponents=team, senses={"away": got, "home": needed}, seed=1)
    said = f"team 'lively' observes {observe}: it needs senses={needed!r}, got {got!r} "
    assert str(error.value).startswith(f"{said}(a command takes --senses {needed};")
    Match(home=1, away=1, opponents=team, senses={"away": needed, "home": got}, seed=1)


def test_a_body_and_its_league_are_needed_to_act_and_saves_are_of_one_policy() -> None:
    match, team = Match(home=1, away=1, seed=1, senses="ideal"), team_from_policy(random_policy())
    view = View(match.league, match.beliefs, match.tracks)
    memory, rng = np.zeros((1, 2), team.memory_dtype), TeamRandom(match.robots["noise"].copy(), np.arange(2))
    with pytest.raises(ValueError, match="team 'lively' plays inside a match only: give it as controllers, opponents"):
        team.act(view, memory, rng)
    with pytest.raises(ValueError, match="policy 'lively' was trained in .* family legged, 'middle-size-2006' is of"):
        Match("middle-size-2006", opponents=team, seed=1)
    teams = [team_from_policy(random_policy(16, seed=seed)) for seed in (1, 2)]
    one, other = (Match(home=1, away=1, opponents=team, seed=1) for team in teams)
    with pytest.raises(ValueError, match="teams differ"):
        other.load(one.save())
