"""Skills as actions: each does what its name says, masks tell which apply, and the memory belongs to the match."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.actions import ActionKind
from soccer_env.replay import Recorder, Replay
from soccer_env.skills.choices import SKILLS
from soccer_env.types import Phase
from tests.scenes.staging import LEAGUES, LEGGED, MIDDLE, place, put_ball, refused, stage, steps_in

NAMES = list(SKILLS)
LONG = {LEGGED: 30.0, MIDDLE: 8.0}  # [s] in which a skill is done


def scene(league: str, **settings: Any) -> Match:
    """Return matches in play in which robots choose skills by true beliefs."""
    return stage(league, **{"actions": "skills", "senses": "ideal", "rules": "none", **settings})


def choose(match: Match, **names: str) -> np.ndarray:
    """Return choices (M, R): those of some agents by the names of skills, the others stand."""
    choices = np.zeros(match.robots.shape, int)
    for agent, name in names.items():
        choices[:, match.agents.index(agent)] = NAMES.index(name)
    return choices


def applies(match: Match, agent: str) -> set[str]:
    """Return the names of the skills that apply for an agent of the first match."""
    mask = match.action_masks()[0, match.agents.index(agent)]
    return {name for name, allowed in zip(match.action_names, mask, strict=True) if allowed}


def play_until(match: Match, choices: np.ndarray, done: Any) -> bool:
    """Play until something is so, or for as long as a skill may take; return whether it came about."""
    for _ in range(steps_in(match, LONG[match.league.name])):
        match.step(choices)
        if done():
            return True
    return False


def attack_from(league: str, **settings: Any) -> tuple[Match, float]:
    """Return a match in which home_1 stands behind the ball before the empty goal, and half the pitch's length."""
    match = scene(league, home=2, **settings)
    half = 0.5 * match.league.pitch.length
    place(match, ball=(0.4 * half, 0.0), robots={1: (0.4 * half - 2.0 * match.league.body.reach, 0.0, 0.0)})
    return match, half


@pytest.mark.parametrize("skill", ["shoot", "shoot left", "shoot right"])
@pytest.mark.parametrize("league", LEAGUES)
def test_most_shots_go_into_the_goal_beside_the_post_that_they_name(league: str, skill: str) -> None:
    match, half = attack_from(league, matches=32, episode="goal")
    y = np.zeros(32)

    def all_scored() -> bool:
        near = (match.balls["x"] > 0.9 * half) & ~match.terminated
        y[near] = match.balls["y"][near]
        return bool(match.terminated.all())

    play_until(match, choose(match, home_1=skill), all_scored)
    goals = match.matches["score"][:, 0] == 1
    assert goals.sum() > 20
    if skill != "shoot":  # kicks of legs stray
        assert y.mean() * (1.0 if skill == "shoot left" else -1.0) > 0.1 * 0.5 * match.league.pitch.goal_width


@pytest.mark.parametrize(("skill", "side"), [("dribble left", 1), ("dribble right", -1)])
@pytest.mark.parametrize("league", LEAGUES)
def test_the_ball_is_carried_to_the_wing_without_a_kick(league: str, skill: str, side: int) -> None:
    match, _ = attack_from(league)
    kicks: list[int] = []
    choices = choose(match, home_1=skill)
    far = 0.2 * match.league.pitch.width
    assert play_until(
        match, choices, lambda: kicks.append(match.robot_events["kick"].max()) or side * match.balls["y"][0] > far
    )
    assert max(kicks) == 0


@pytest.mark.parametrize("skill", ["pass", "pass to first", "pass to second"])
@pytest.mark.parametrize("league", LEAGUES)
def test_a_pass_reaches_the_mate_that_it_names(league: str, skill: str) -> None:
    match = scene(league, home=4)
    half, width = 0.5 * match.league.pitch.length, match.league.pitch.width
    robots = {1: (-2.0 * match.league.body.reach, 0.0, 0.0), 2: (0.25 * half, 0.25 * width, 3.0)}
    if skill != "pass":
        robots[3] = (0.5 * half, -0.25 * width, 3.0)
    place(match, ball=(0.0, 0.0), robots=robots)
    mate = match.robots[0, 3 if skill == "pass to second" else 2]

    def arrived() -> bool:
        return bool(np.hypot(mate["x"] - match.balls["x"][0], mate["y"] - match.balls["y"][0]) < 0.2 * width)

    assert not arrived() and play_until(match, choose(match, home_1=skill), arrived)


@pytest.mark.parametrize("league", LEAGUES)
def test_a_ball_near_the_own_goal_is_cleared(league: str) -> None:
    match = scene(league, home=2)
    half, reach = 0.5 * match.league.pitch.length, match.league.body.reach
    x = -0.5 * half
    place(match, ball=(x, 0.0), robots={1: (x - 2.0 * reach, 0.0, 0.0)})
    assert play_until(match, choose(match, home_1="clear"), lambda: match.balls["x"][0] > x + 0.25 * half)


@pytest.mark.parametrize("skill", ["block", "cover"])
@pytest.mark.parametrize("league", LEAGUES)
def test_a_defender_stands_between_the_ball_and_its_goal(league: str, skill: str) -> None:
    match = scene(league, home=2)
    pitch = match.league.pitch
    place(match, ball=(0.2 * pitch.length, 0.0), robots={1: (0.0, 0.2 * pitch.width, 0.0)})
    robot, ball = match.robots[0, 1], match.balls[0]
    play_until(match, choose(match, home_1=skill), lambda: False)
    assert abs(robot["y"]) < match.league.body.reach and robot["x"] < ball["x"]
    assert (ball["x"] - robot["x"] < 4.0 * match.league.body.reach) == (skill == "block")


@pytest.mark.parametrize("league", LEAGUES)
def test_a_goalkeeper_guards_and_only_a_goalkeeper_may(league: str) -> None:
    match = scene(league, home=2)
    pitch = match.league.pitch
    place(match, ball=(0.0, 0.2 * pitch.width), robots={0: (-0.25 * pitch.length, 0.0, 0.0), 1: (0.0, 0.0, 0.0)})
    assert "keep goal" in applies(match, "home_0") and "keep goal" not in applies(match, "home_1")
    play_until(match, choose(match, home_0="keep goal"), lambda: False)
    assert match.robots["x"][0, 0] < -0.4 * pitch.length and 0.0 < match.robots["y"][0, 0] < 0.5 * pitch.goal_width


@pytest.mark.parametrize("league", LEAGUES)
def test_masks_say_what_applies(league: str) -> None:
    match, half = attack_from(league, rules="league")
    everywhere = {"stand", "search", *(name for name in NAMES if name.startswith("go "))}
    ball = {"approach", "dribble to goal", "dribble left", "dribble right", "shoot", "shoot left", "shoot right"}
    alone = {"block", "cover", "keep goal"}
    assert applies(match, "home_1") == everywhere | ball | alone, "no mate, not in the own half"
    assert applies(match, "home_0") == {"stand"}, "sent off"
    put_ball(match, -0.4 * half, 0.0)
    assert applies(match, "home_1") == everywhere | ball - {"shoot left", "shoot right"} | alone | {"clear"}
    place(match, robots={0: (-0.8 * half, 0.1, 0.0)})
    assert {"pass", "pass to first"} <= applies(match, "home_1") and "pass to second" not in applies(match, "home_1")
    kicks = {"shoot", "pass"} & applies(match, "home_0")
    assert (kicks != set()) == match.league.kicker.keeper_kicks
    match.matches["phase"], match.matches["restart_team"] = int(Phase.KICK_OFF), 1
    assert applies(match, "home_1") == everywhere | {"block", "cover"}, "the opponents take a restart"


@pytest.mark.parametrize("league", LEAGUES)
def test_a_masked_choice_is_the_search(league: str) -> None:
    one, other = (attack_from(league)[0] for _ in range(2))
    assert "pass" not in applies(one, "home_1")
    for _ in range(40):
        one.step(choose(one, home_1="pass"))
        other.step(choose(other, home_1="search"))
    assert one.state_hash() == other.state_hash()


def test_a_wrong_choice_is_named() -> None:
    match = scene(MIDDLE, home=2)
    with refused(match, r"action of home_1 in match 0 must be 0 to 25, got 26"):
        match.step(np.array([[0, 26, 0]]))
    with refused(match, r"actions must be integers of shape \(1, 3\)"):
        match.step(np.zeros((1, 3, 4)))
    with pytest.raises(ValueError, match="got 26"):
        ActionKind("skills").given(26, "home_0")


# A match with skills is data like any other


def random_play(match: Match, steps: int, seed: int = 1) -> str:
    """Play random skills that apply, each for half a second; return the state's hash."""
    rng = np.random.default_rng(seed)
    for _ in range(steps):
        chances = match.action_masks() * rng.uniform(0.1, 1.0, (*match.robots.shape, len(NAMES)))
        match.step(chances.argmax(axis=-1))
    return match.state_hash()


@pytest.mark.parametrize("league", LEAGUES)
def test_both_backends_and_threads_and_one_match_alone_play_alike(league: str) -> None:
    settings: dict[str, Any] = {"home": 2, "away": 2, "opponents": "chaser", "actions": "skills", "action_repeat": 25}
    one, other = (Match(league, matches=4, seed=5, backend=backend, **settings) for backend in ("c", "batch"))
    assert random_play(one, 8) == random_play(other, 8)
    threaded = Match(league, matches=4, seed=5, threads=2, **settings)
    assert random_play(threaded, 8) == one.state_hash()


@pytest.mark.parametrize("league", LEAGUES)
def test_saves_branches_and_replays_hold_the_memory(league: str, tmp_path: Any) -> None:
    match = Match(league, home=2, away=2, seed=5, opponents="chaser", actions="skills", action_repeat=25)
    recorder = Recorder(match)
    random_play(match, 6)
    assert match.skills is not None and match.skills.memory["patience"][0, 1] > 0.0
    branch, saved = match.branch([0, 0]), match.save()
    loaded = Match(league, home=2, away=2, seed=9, opponents="chaser", actions="skills", action_repeat=25)
    loaded.load(saved)
    assert loaded.state_hash() == match.state_hash() == branch.state_hash(1)
    futures = {random_play(loaded, 4, seed=2), random_play(match, 4, seed=2)}
    assert len(futures) == 1
    replay = Replay.read(recorder.stop().write(tmp_path / "skills.replay"))
    assert replay.check() == len(replay) > 0
    boxes = Match(league, home=2, away=2, seed=9, opponents="chaser")
    with pytest.raises(ValueError, match="actions 'skills' there, 'commands' here"):
        boxes.load(saved)
