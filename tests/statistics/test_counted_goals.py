"""Goals of every kind, just under and just over each limit, and what came before them."""

import numpy as np
import pytest

from soccer_env.types import AWAY, HOME, Phase
from tests.scenes.fouls import NOSES
from tests.statistics.counted_steps import (
    CLEAN_DRIBBLE,
    CLEAN_KICK,
    DEFLECTED_KICK,
    HALF,
    KEEPER,
    KICKER,
    MATE,
    OWN_GOAL,
    PUSHED_IN,
    SCRUM,
    SECOND,
    THEIR_KEEPER,
    THEIR_PLAYER,
    Steps,
    only,
    shoot,
)


def face(steps: Steps, row: int, other: int) -> None:
    """Let two robots touch, paw to paw, away from the ball."""
    steps.put(row, 0.0, -0.9)
    steps.put(other, NOSES - 0.003, -0.9)
    steps.set(other, heading=np.pi)


# Kinds of goals


@pytest.mark.parametrize(("later", "kind"), [(5 * SECOND, CLEAN_KICK), (5 * SECOND + 1, CLEAN_DRIBBLE)])
def test_a_ball_is_on_its_way_for_five_seconds(later, kind) -> None:
    steps = Steps()
    shoot(steps)
    steps.count(steps=later - 1)
    steps.count(goal=HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("later", "kind"), [(SECOND, DEFLECTED_KICK), (SECOND + 1, OWN_GOAL)])
def test_a_touch_by_another_makes_it_deflected_for_a_second_and_then_it_is_the_others(later, kind) -> None:
    steps = Steps()
    shoot(steps)
    steps.count(touch=THEIR_PLAYER)
    steps.count(steps=later - 1)
    steps.score(HOME, scorer=THEIR_PLAYER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("later", "kind"), [(HALF, CLEAN_KICK), (HALF + 1, CLEAN_DRIBBLE)])
def test_the_kicker_that_touches_the_ball_half_a_second_later_plays_it_anew(later, kind) -> None:
    steps = Steps()
    shoot(steps)
    steps.count(steps=later - 1)
    steps.count(touch=KICKER)
    steps.count(goal=HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("vx", "shots"), [(1.0, 1), (0.1, 1), (-1.0, 1)])
def test_a_clean_kick_that_is_in_is_one_shot_on_target_whatever_was_thought_of_it(vx, shots) -> None:
    steps = Steps()
    shoot(steps, vx=vx)
    steps.score(HOME)
    assert [steps.of(what)[HOME] for what in ("shots", "on_target")] == [shots, 1]
    shoot(steps, y=0.35)  # a shot already, beside the post
    steps.score(HOME)
    assert [steps.of(what)[HOME] for what in ("shots", "on_target")] == [2, 2]
    assert steps.kinds(HOME)[CLEAN_KICK] == 2


@pytest.mark.parametrize(("scorer", "team", "kind"), [(KICKER, AWAY, OWN_GOAL), (KICKER, HOME, CLEAN_DRIBBLE)])
def test_a_goal_that_an_opponent_touched_last_is_an_own_goal(scorer, team, kind) -> None:
    steps = Steps()
    steps.count(touch=scorer)
    steps.score(team, scorer=scorer)
    assert steps.kinds(team) == only(kind) and sum(steps.kinds(1 - team)) == 0


def test_a_kick_into_the_own_goal_is_an_own_goal() -> None:
    steps = Steps()
    shoot(steps, x=-1.0, vx=-1.0)
    steps.count(goal=AWAY, scorer=KICKER)
    assert steps.kinds(AWAY) == only(OWN_GOAL)


def test_who_touches_the_ball_for_the_first_time_in_the_step_of_the_goal_has_scored_it() -> None:
    steps = Steps()
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(CLEAN_DRIBBLE)


@pytest.mark.parametrize(("held", "since", "kind"), [(15, 0, SCRUM), (16, 0, CLEAN_DRIBBLE), (20, 9, SCRUM)])
def test_in_a_scrum_only_who_has_kept_the_ball_for_a_second_and_still_has_it_dribbles(held, since, kind) -> None:
    steps = Steps()
    for row, y in ((KICKER, 0.0), (MATE, 0.2), (THEIR_PLAYER, -0.2)):
        steps.put(row, -0.1, y)
    steps.set(KICKER, has_ball=1)
    steps.count(steps=held, touch=KICKER)
    steps.set(KICKER, has_ball=0)
    steps.count(steps=since)
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("ago", "kind"), [(HALF, SCRUM), (HALF + 1, CLEAN_DRIBBLE)])
def test_a_scrum_of_half_a_second_ago_still_is_one(ago, kind) -> None:
    steps = Steps()
    for row, y in ((KICKER, 0.0), (MATE, 0.2), (THEIR_PLAYER, -0.2)):
        steps.put(row, -0.1, y)
    steps.count(touch=KICKER)
    for row in (MATE, THEIR_PLAYER):
        steps.put(row, 0.1 * row, 0.9)
    steps.count(steps=ago - 1)
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("other", "ago", "kind"), [
    (THEIR_PLAYER, 48, PUSHED_IN), (THEIR_PLAYER, 49, CLEAN_DRIBBLE), (MATE, 1, CLEAN_DRIBBLE),
])  # fmt: skip
def test_a_dribble_in_touch_with_an_opponent_within_three_seconds_is_a_push_and_not_in_the_legs_of_a_mate(
    other, ago, kind
) -> None:
    steps = Steps()
    face(steps, KICKER, other)
    steps.set(KICKER, locked=0.1)
    steps.count(touch=KICKER)
    steps.set(KICKER, locked=0.05)  # it runs back, which is no contact
    steps.count(steps=ago - 1)
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


# What came before


@pytest.mark.parametrize(("ago", "counted"), [(96, 1), (97, 0)])
def test_goals_within_six_seconds_of_a_separation_say_so(ago, counted) -> None:
    steps = Steps()
    steps.count(separated=1)
    steps.count(steps=ago - 1)
    steps.score(AWAY)
    assert steps.of("after_separation") == [0, counted]


@pytest.mark.parametrize(("ago", "counted"), [(160, 1), (161, 0)])
def test_goals_within_ten_seconds_of_a_restart_say_which(ago, counted) -> None:
    steps = Steps()
    for phase in (Phase.GOAL_KICK, Phase.CORNER_KICK):
        steps.match.matches["phase"] = phase
        steps.count(steps=5)
        steps.match.matches["phase"] = Phase.PLAY
        steps.count(in_play=1)
    steps.match.matches["phase"] = Phase.OVER  # the end is no restart
    steps.count(steps=ago - 1)
    steps.score(HOME)
    expected = [[counted if phase == Phase.CORNER_KICK else 0 for phase in Phase], [0] * len(Phase)]
    assert steps.of("after_restart") == expected


@pytest.mark.parametrize(("locked", "ago", "counted", "mate"), [
    (1.0, 160, 1, False), (1.0, 161, 0, False), (0.94, 1, 0, False), (1.0, 1, 0, True),
])  # fmt: skip
def test_goals_within_ten_seconds_of_a_goalkeeper_in_contact_with_opponents_for_one_say_so(
    locked, ago, counted, mate
) -> None:
    for keeper, player, team in ((THEIR_KEEPER, MATE, HOME), (KEEPER, THEIR_PLAYER, AWAY)):
        steps = Steps()
        face(steps, keeper, keeper + 1 if mate else player)
        steps.set(keeper, locked=locked)
        steps.count()
        steps.set(keeper, locked=0.0)
        steps.count(steps=ago - 1)
        steps.score(team)
        assert steps.of("after_pushed_keeper")[team] == counted
        assert steps.of("after_pushed_keeper")[1 - team] == 0


def test_a_goal_is_a_solo_if_one_robot_of_the_scorers_alone_touched_the_ball_since_the_restart() -> None:
    steps = Steps()
    steps.count(touch=MATE)
    steps.count(restart=Phase.THROW_IN, restart_team=HOME)
    steps.count(touch=THEIR_PLAYER)
    steps.count(touch=KICKER)
    steps.score(HOME, scorer=KICKER)
    assert steps.of("solo") == [1, 0]
    steps.count(touch=MATE)
    steps.score(HOME, scorer=KICKER)
    assert steps.of("solo") == [1, 0]
