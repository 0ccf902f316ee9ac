"""The legged drills: everybody stands as they say, success is what they say, and nothing else is."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match, make_team
from soccer_env.match.staging import put
from soccer_env.scenes import SCENES, Scene
from soccer_env.scenes.drills_alone import DRILLS_ALONE
from soccer_env.scenes.drills_legged import DRILLS_LEGGED
from soccer_env.scenes.judging import LOST, LOST_TIME, PAST
from soccer_env.types import AWAY
from tests.scenes.staging import LEGGED, deepest_overlaps, place, play, put_ball, stand
from tests.scenes.symmetry import Records, mirrored, mirrored_actions

MATCHES = 40
PAWS = 0.15  # [m] from a robot's centre to a ball between its paws
each_drill = pytest.mark.parametrize("scene", [scene.name for scene in (*DRILLS_LEGGED, *DRILLS_ALONE)])


def drill(scene: str, matches: int = MATCHES, home: int = 1, away: int | None = None, **settings: Any) -> Match:
    """Return a drill with as many opponents as it needs."""
    away = max(len(SCENES[scene].opponents), 1) if away is None else away
    asked = {"seed": 5, "episode": "drill", **settings}
    return Match(LEGGED, home=home, away=away, matches=matches, scene=scene, **asked)


def outcome(match: Match) -> list[int]:
    """Return the result of one control step in which everybody stands."""
    match.rebuild()
    match.step(stand(match))
    return match.events["drill"].tolist()


def empty(scene: str, matches: int = 1) -> Match:
    """Return a drill 1 v 1 whose robots stand far apart on the middle line, the ball between home's paws."""
    match = drill(scene, matches=matches, away=max(len(SCENES[scene].opponents), 1))
    for r in range(1, match.robots.shape[1]):
        put(match, r, 1.2, 0.7 - 0.4 * r, 0.0)
    put(match, 0, -0.5, 0.0, 0.0)
    put_ball(match, -0.5 + PAWS, 0.0)
    match.robots["has_ball"] = 0
    match.robots["has_ball"][:, 0] = 1
    return match


@each_drill
@pytest.mark.parametrize(("home", "away"), [(1, None), (3, 3)])
def test_everybody_stands_free_on_the_pitch_and_the_drill_is_open(scene: str, home: int, away: int | None) -> None:
    match = drill(scene, home=home, away=away)
    pitch = match.league.pitch
    assert max(deepest_overlaps(match).values()) < 0.001
    assert (abs(match.robots["x"]) < pitch.length / 2 - 0.07).all()
    assert (abs(match.robots["y"]) < pitch.width / 2 - 0.07).all() and outcome(match) == [0] * MATCHES


@each_drill
def test_placement_follows_from_the_seed_and_differs_between_seeds(scene: str) -> None:
    first, same, other = (drill(scene, seed=seed) for seed in (5, 5, 6))
    assert (first.robots == same.robots).all() and (first.balls == same.balls).all()
    assert (first.balls["x"] != other.balls["x"]).all()


@pytest.mark.parametrize("scene", ["ball-behind-robot", "facing-wall"])
def test_to_have_the_ball_between_the_paws_is_to_get_it(scene: str) -> None:
    match = empty(scene)
    assert outcome(match) == [1] and match.terminated[0]
    match = empty(scene)
    match.robots["has_ball"][:, 0], match.robots["has_ball"][:, 1] = 0, 1
    put(match, 0, -0.8, 0.0)
    assert outcome(match) == [0]


def test_a_ball_that_both_have_is_nobodys_and_the_first_to_have_it_alone_wins() -> None:
    match = drill("head-on-push")
    assert (match.robots["has_ball"] == 1).all() and outcome(match) == [0] * MATCHES
    assert outcome(empty("head-on-push")) == [1]
    match = empty("head-on-push")
    put(match, 0, 1.0, -0.6, 0.0)
    put(match, 1, -0.5 + 2 * PAWS, 0.0, np.pi)
    match.robots["has_ball"][:, :] = [0, 1]
    assert outcome(match) == [-1]


@pytest.mark.parametrize(("direction", "attacks", "result"), [(1, 1, 1), (-1, 1, -1), (1, -1, -1), (-1, -1, 1)])
def test_a_ball_that_both_push_far_goes_to_the_side_that_it_went_to(direction: int, attacks: int, result: int) -> None:
    match = drill("head-on-push", matches=1)
    match.matches["restart_x"] = match.balls["x"] - 0.35 * direction
    match.matches["home_direction"] = attacks
    assert outcome(match) == [result]


@pytest.mark.parametrize("direction", [1, -1])
def test_a_dribbler_past_the_last_player_with_the_ball_has_done_it(direction: int) -> None:
    for beyond, result in ((0.01, 1), (-0.02, 0)):
        match = empty("dribble-past-one")
        match.matches["home_direction"] = direction
        put(match, 1, -0.5 + PAWS - PAST - beyond, 0.7)
        if direction < 0:  # the scene turned by half
            x = match.robots["x"].copy()
            put(match, 0, -x[:, 0], 0.0, np.pi)
            put(match, 1, -x[:, 1], 0.7)
            put_ball(match, -match.balls["x"], 0.0)
        assert outcome(match) == [result]


def test_goals_end_a_dribble_and_so_does_a_touch_but_a_ball_past_the_last_player_that_the_dribbler_has_not() -> None:
    match, touching, goals = empty("dribble-past-one"), empty("dribble-past-one"), empty("dribble-past-one", matches=2)
    put(match, 1, -0.9, 0.7)
    put_ball(match, -0.5 + PAWS + 0.1, 0.0)
    match.robots["has_ball"] = 0
    put(touching, 1, -0.5 - match.league.body.tip_x - 0.126, 0.0)
    put_ball(goals, [1.6, -1.6], 0.0)
    assert [outcome(one) for one in (match, touching, goals)] == [[0], [-1], [1, -1]]


def test_a_ball_lost_for_two_seconds_is_a_failure_and_one_that_is_caught_up_with_is_not() -> None:
    match = empty("dribble-past-one")
    place(match, ball=(-0.5 + LOST + 0.02, 0.0))
    steps = round(LOST_TIME * match.league.control_rate)
    for _ in range(steps):
        match.step(stand(match))
        assert match.events["drill"][0] == 0
    saved = match.save()
    match.step(stand(match))
    assert match.events["drill"][0] == -1
    match.load(saved)
    put_ball(match, -0.5 + LOST - 0.02, 0.0)
    assert outcome(match) == [0] and match.matches["drill_clock"][0] == 0.0


@each_drill
def test_a_mirrored_drill_is_judged_the_same(scene: str) -> None:
    match, other = drill(scene, seed=8), drill(scene, seed=8)
    mirrored(Records.of(match)).put_into(other)
    match.rebuild()
    rng = np.random.default_rng(1)
    results = np.zeros((2, MATCHES), int)
    for step in range(80):
        if step % 16 == 0:
            actions = rng.uniform(-1.0, 1.0, (*match.robots.shape, 4))
            actions[..., 0] = abs(actions[..., 0])
        match.step(actions)
        other.step(mirrored_actions(actions))
        results += match.events["drill"], other.events["drill"]
    assert (results[0] == results[1]).all()


def test_opponents_are_a_suggestion_the_scene_names_teams_and_nobody_is_pulled_apart_and_no_ball_dropped() -> None:
    match = drill("head-on-push", matches=4, controllers={"home": "walker", "away": "walker"})
    for _ in range(16 * 40):
        match.step()
        assert not match.events["stuck"].any() and not match.events["separated"].any()
    for team in {team for scene in SCENES.values() for team in scene.opponents}:
        make_team(team)
    with pytest.raises(ValueError, match=r"Scene\.success"):
        Scene("mine", "", success="home wins")


@pytest.mark.parametrize(("settings", "words"), [
    ({"scene": "gap-500", "away": 1}, "away must be 2 to 3 in scene 'gap-500', got 1"),
    ({"scene": "gap-500", "home": 4}, "home must be 1 to 3"), ({"scene": "gap-600"}, "unknown scene 'gap-600'"),
    ({"scene": "gap-500", "league": "middle-size-2006"}, "is for legged leagues, 'middle-size-2006' is"),
])  # fmt: skip
def test_a_drill_says_what_is_wrong(settings: dict[str, Any], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        Match(**{"league": LEGGED, "seed": 1, **settings})


@pytest.mark.parametrize("strength", [0.25, 0.5, 0.75, 1.0])
def test_walkers_walk_straight_ahead_as_fast_as_their_strength_says(strength: float) -> None:
    match = drill("dribble-past-mover-far", controllers={"home": "still", "away": f"walker@{strength}"})
    start = match.robots[:, AWAY].copy()
    play(match, steps=64)
    gone = np.hypot(*(match.robots[name][:, AWAY] - start[name] for name in ("x", "y")))
    assert 0.12 * strength * 3.0 < np.median(gone) < 0.12 * strength * 4.2
