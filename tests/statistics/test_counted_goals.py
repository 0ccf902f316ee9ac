"""Goals of every kind, what came before them, shots, saves and passes, just under and just over each limit."""

import numpy as np
import pytest

from soccer_env.statistics.records import GoalKind
from soccer_env.types import AWAY, HOME, Phase
from tests.scenes.fouls import NOSES
from tests.scenes.staging import LEGGED, MIDDLE
from tests.statistics.counted_steps import (
    HALF,
    KEEPER,
    KICKER,
    MATE,
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


@pytest.mark.parametrize(
    ("later", "kind"), [(5 * SECOND, GoalKind.CLEAN_KICK), (5 * SECOND + 1, GoalKind.CLEAN_DRIBBLE)]
)
def test_a_ball_is_on_its_way_for_five_seconds(steps, later, kind) -> None:
    shoot(steps)
    steps.count(steps=later - 1)
    steps.count(goal=HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("later", "kind"), [(SECOND, GoalKind.DEFLECTED_KICK), (SECOND + 1, GoalKind.OWN_GOAL)])
def test_a_touch_by_another_makes_it_deflected_for_a_second_and_then_it_is_the_others(steps, later, kind) -> None:
    shoot(steps)
    steps.count(touch=THEIR_PLAYER)
    steps.count(steps=later - 1)
    steps.score(HOME, scorer=THEIR_PLAYER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("later", "kind"), [(HALF, GoalKind.CLEAN_KICK), (HALF + 1, GoalKind.CLEAN_DRIBBLE)])
def test_the_kicker_that_touches_the_ball_half_a_second_later_plays_it_anew(steps, later, kind) -> None:
    shoot(steps)
    steps.count(steps=later - 1)
    steps.count(touch=KICKER)
    steps.count(goal=HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("vx", "shots"), [(1.0, 1), (0.1, 1), (-1.0, 1)])
def test_a_clean_kick_that_is_in_is_one_shot_on_target_whatever_was_thought_of_it(steps, vx, shots) -> None:
    shoot(steps, vx=vx)
    steps.score(HOME)
    assert [steps.of(what)[HOME] for what in ("shots", "on_target")] == [shots, 1]
    shoot(steps, y=0.35)  # a shot already, beside the post
    steps.score(HOME)
    assert [steps.of(what)[HOME] for what in ("shots", "on_target")] == [2, 2]
    assert steps.kinds(HOME)[GoalKind.CLEAN_KICK] == 2


@pytest.mark.parametrize(("team", "kind"), [(AWAY, GoalKind.OWN_GOAL), (HOME, GoalKind.CLEAN_DRIBBLE)])
@pytest.mark.parametrize("before", [0, 1])
def test_a_goal_that_an_opponent_touched_last_is_an_own_goal_also_in_its_step(steps, team, kind, before):
    for _ in range(before):
        steps.count(touch=KICKER)
    steps.score(team, scorer=KICKER)
    assert steps.kinds(team) == only(kind) and sum(steps.kinds(1 - team)) == 0


def in_a_scrum() -> Steps:
    """Return a match in which three robots are about the ball."""
    steps = Steps()
    for row, y in ((KICKER, 0.0), (MATE, 0.2), (THEIR_PLAYER, -0.2)):
        steps.put(row, -0.1, y)
    return steps


@pytest.mark.parametrize(
    ("held", "since", "kind"), [(15, 0, GoalKind.SCRUM), (16, 0, GoalKind.CLEAN_DRIBBLE), (20, 9, GoalKind.SCRUM)]
)
def test_in_a_scrum_only_who_has_kept_the_ball_for_a_second_and_still_has_it_dribbles(held, since, kind) -> None:
    steps = in_a_scrum()
    steps.set(KICKER, has_ball=1)
    steps.count(steps=held, touch=KICKER)
    steps.set(KICKER, has_ball=0)
    steps.count(steps=since)
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("ago", "kind"), [(HALF, GoalKind.SCRUM), (HALF + 1, GoalKind.CLEAN_DRIBBLE)])
def test_a_scrum_of_half_a_second_ago_still_is_one(ago, kind) -> None:
    steps = in_a_scrum()
    steps.count(touch=KICKER)
    for row in (MATE, THEIR_PLAYER):
        steps.put(row, 0.1 * row, 0.9)
    steps.count(steps=ago - 1)
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("other", "ago", "kind"), [
    (THEIR_PLAYER, 48, GoalKind.PUSHED_IN), (THEIR_PLAYER, 49, GoalKind.CLEAN_DRIBBLE),
    (MATE, 1, GoalKind.CLEAN_DRIBBLE),
])  # fmt: skip
def test_a_dribble_in_touch_with_an_opponent_within_three_seconds_is_a_push_and_not_in_the_legs_of_a_mate(
    other, ago, kind, steps
) -> None:
    face(steps, KICKER, other)
    steps.set(KICKER, locked=0.1)
    steps.count(touch=KICKER)
    steps.set(KICKER, locked=0.05)  # it runs back, which is no contact
    steps.count(steps=ago - 1)
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME) == only(kind)


@pytest.mark.parametrize(("ago", "counted"), [(96, 1), (97, 0)])
def test_goals_within_six_seconds_of_a_separation_say_so(steps, ago, counted) -> None:
    steps.count(separated=1)
    steps.count(steps=ago - 1)
    steps.score(AWAY)
    assert steps.of("after_separation") == [0, counted]


@pytest.mark.parametrize(("ago", "counted"), [(160, 1), (161, 0)])
def test_goals_within_ten_seconds_of_a_restart_say_which(steps, ago, counted) -> None:
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
def test_goals_within_ten_seconds_of_a_goalkeeper_in_contact_with_opponents_for_one_say_so(locked, ago, counted, mate):
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


def test_a_goal_is_a_solo_if_one_robot_of_the_scorers_alone_touched_the_ball_since_the_restart(steps: Steps) -> None:
    steps.count(touch=MATE)
    steps.count(restart=Phase.THROW_IN, restart_team=HOME)
    steps.count(touch=THEIR_PLAYER)
    steps.count(touch=KICKER)
    steps.score(HOME, scorer=KICKER)
    assert steps.of("solo") == [1, 0]
    steps.count(touch=MATE)
    steps.score(HOME, scorer=KICKER)
    assert steps.of("solo") == [1, 0]


FAST, SLOW = 0.82, 0.78  # [m/s] around the weakest kick of the legged league
each_direction = pytest.mark.parametrize("direction", [1.0, -1.0])


@each_direction
@pytest.mark.parametrize(("y", "vx", "shots", "on_target"), [
    (0.29, 1.0, 1, 1), (-0.29, 1.0, 1, 1), (0.31, 1.0, 1, 0), (-0.44, 1.0, 1, 0), (0.46, 1.0, 0, 0), (0.0, -1.0, 0, 0),
    (0.0, 0.85, 0, 0), (0.0, 0.9, 1, 1),
])  # fmt: skip
def test_a_kick_that_would_roll_to_the_goal_is_a_shot(direction, y, vx, shots, on_target) -> None:
    """A ball that is kicked slides first: 0.51 m at 0.85 m/s, 0.57 m at 0.9 m/s, of the 0.54 m to the line."""
    steps = Steps(direction=direction)
    shoot(steps, y=y, vx=vx)
    assert [steps.of(name) for name in ("shots", "on_target")] == [[shots, 0], [on_target, 0]]


def test_a_kick_in_the_step_of_a_restart_is_no_shot(steps: Steps) -> None:
    steps.ball(1.0, 0.0, 1.0)
    steps.count(kick=KICKER, restart=Phase.THROW_IN, restart_team=HOME)
    assert [steps.of("kicks"), steps.of("shots")] == [[1, 0], [0, 0]]


@pytest.mark.parametrize(("speed", "shots"), [(FAST, 1), (SLOW, 0)])
@pytest.mark.parametrize("free", [3, 4, 5])
def test_a_push_is_a_shot_when_the_ball_comes_free_as_fast_as_by_a_kick(steps, speed, shots, free) -> None:
    steps.ball(1.2, 0.0, speed)
    steps.match.balls["roll_x"] = speed
    steps.count(touch=KICKER)
    steps.count(steps=free)
    assert steps.of("shots") == [shots if free >= 4 else 0, 0]


def test_a_shot_that_the_goalkeeper_touches_and_that_goes_in_is_not_saved(steps: Steps) -> None:
    shoot(steps)
    steps.count(touch=THEIR_KEEPER)
    steps.score(HOME)
    steps.count(steps=6 * SECOND)
    assert steps.of("saves") == [0, 0] and steps.kinds(HOME) == only(GoalKind.DEFLECTED_KICK)


@pytest.mark.parametrize("end", [{"kick": MATE}, {"restart": Phase.CORNER_KICK, "restart_team": HOME}])
def test_a_restart_or_another_kick_ends_a_save_that_was_made(steps, end) -> None:
    shoot(steps)
    steps.count(touch=THEIR_KEEPER)
    steps.count(**end)
    assert steps.of("saves") == [0, 1]


@pytest.mark.parametrize(("name", "quarter", "least"), [(LEGGED, 4, 0.3), (MIDDLE, 13, 1.0)])
@pytest.mark.parametrize(("steps_free", "further", "tried"), [(0, 0.01, 1), (-1, 0.01, 0), (0, -0.01, 0)])
def test_a_ball_that_is_free_for_a_quarter_second_and_goes_far_enough_is_a_pass(
    name, quarter, least, steps_free, further, tried
) -> None:
    for row, found in ((MATE, ([tried, 0], [tried, 0], [0, 0])), (THEIR_PLAYER, ([tried, 0], [0, 0], [0, tried]))):
        steps = Steps(name)
        steps.ball(-0.4, 0.2)
        steps.count(touch=KICKER)
        steps.ball(0.6 * (least + further) - 0.4, 0.8 * (least + further) + 0.2)
        steps.count(steps=quarter - 1 + steps_free)
        steps.count(touch=row)
        assert tuple(steps.of(what) for what in ("passes_tried", "passes", "interceptions")) == found


@pytest.mark.parametrize(("shot", "toucher"), [(True, MATE), (False, KICKER)])
def test_a_shot_that_another_touches_is_no_pass_and_no_robot_passes_to_itself(steps, shot, toucher) -> None:
    if shot:
        shoot(steps, x=0.9)
    steps.count(steps=SECOND, touch=-1 if shot else KICKER)
    steps.ball(1.4, 0.0)
    steps.count(touch=toucher)
    assert steps.of("passes_tried") == [0, 0]


def test_a_restart_forgets_who_played_the_ball(steps: Steps) -> None:
    shoot(steps)
    steps.count(restart=Phase.THROW_IN, restart_team=HOME)
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME)[GoalKind.CLEAN_KICK] == 0
    again = Steps()
    again.count(touch=KICKER)
    again.count(restart=Phase.THROW_IN, restart_team=HOME)
    again.ball(0.5, 0.0)
    again.count(steps=SECOND)
    again.count(touch=MATE)
    assert again.of("passes_tried") == [0, 0]
