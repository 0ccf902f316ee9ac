"""Shots, saves and passes, just under and just over each limit, and what of them a restart forgets."""

import pytest

from soccer_env.types import HOME, Phase
from tests.scenes.staging import LEGGED, MIDDLE
from tests.statistics.counted_steps import (
    CLEAN_KICK,
    DEFLECTED_KICK,
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


def test_a_kick_in_the_step_of_a_restart_is_no_shot() -> None:
    steps = Steps()
    steps.ball(1.0, 0.0, 1.0)
    steps.count(kick=KICKER, restart=Phase.THROW_IN, restart_team=HOME)
    assert [steps.of("kicks"), steps.of("shots")] == [[1, 0], [0, 0]]


@pytest.mark.parametrize(("speed", "shots"), [(FAST, 1), (SLOW, 0)])
@pytest.mark.parametrize("free", [3, 4, 5])
def test_a_push_is_a_shot_when_the_ball_comes_free_as_fast_as_by_a_kick(speed, shots, free) -> None:
    steps = Steps()
    steps.ball(1.2, 0.0, speed)
    steps.match.balls["roll_x"] = speed
    steps.count(touch=KICKER)
    steps.count(steps=free)
    assert steps.of("shots") == [shots if free >= 4 else 0, 0]


@pytest.mark.parametrize(("y", "touches", "saves"), [
    (0.0, [THEIR_KEEPER], 1), (0.0, [THEIR_PLAYER], 0), (0.0, [THEIR_PLAYER, THEIR_KEEPER], 0), (0.0, [KEEPER], 0),
    (0.4, [THEIR_KEEPER], 0), (0.0, [THEIR_KEEPER, THEIR_PLAYER], 1), (0.0, [], 0),
])  # fmt: skip
def test_a_shot_on_target_is_saved_if_the_goalkeeper_touches_it_first(y, touches, saves) -> None:
    steps = Steps()
    shoot(steps, y=y)
    for row in touches:
        steps.count(touch=row)
    steps.count(steps=6 * SECOND)
    assert steps.of("saves") == [0, saves]


def test_a_shot_that_the_goalkeeper_touches_and_that_goes_in_is_not_saved() -> None:
    steps = Steps()
    shoot(steps)
    steps.count(touch=THEIR_KEEPER)
    steps.score(HOME)
    steps.count(steps=6 * SECOND)
    assert steps.of("saves") == [0, 0] and steps.kinds(HOME) == only(DEFLECTED_KICK)


def test_a_restart_or_another_kick_ends_a_save_that_was_made() -> None:
    for kick in (-1, MATE):
        steps = Steps()
        shoot(steps)
        steps.count(touch=THEIR_KEEPER)
        if kick < 0:
            steps.count(restart=Phase.CORNER_KICK, restart_team=HOME)
        else:
            steps.count(kick=kick)
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


def test_a_shot_that_another_touches_is_no_pass_and_no_robot_passes_to_itself() -> None:
    for kicker, toucher in ((True, MATE), (False, KICKER)):
        steps = Steps()
        if kicker:
            shoot(steps, x=0.9)
        else:
            steps.count(touch=KICKER)
        steps.count(steps=SECOND)
        steps.ball(1.4, 0.0)
        steps.count(touch=toucher)
        assert steps.of("passes_tried") == [0, 0]


def test_a_restart_forgets_who_played_the_ball() -> None:
    steps = Steps()
    shoot(steps)
    steps.count(restart=Phase.THROW_IN, restart_team=HOME)
    steps.score(HOME, scorer=KICKER)
    assert steps.kinds(HOME)[CLEAN_KICK] == 0
    again = Steps()
    again.count(touch=KICKER)
    again.count(restart=Phase.THROW_IN, restart_team=HOME)
    again.ball(0.5, 0.0)
    again.count(steps=SECOND)
    again.count(touch=MATE)
    assert again.of("passes_tried") == [0, 0]
