"""Distance covered, time stuck and heat maps, just under and just over each limit."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.statistics.maps import BALL
from soccer_env.statistics.players import MAKES, STUCK, WANTS
from soccer_env.statistics.records import CELLS_LONG, CELLS_WIDE, LOOK
from soccer_env.types import HOME, Phase
from tests.statistics.counted_steps import KICKER, SECOND, Steps

each_direction = pytest.mark.parametrize("direction", [1.0, -1.0])
TOP = find_league("legged-2001").drive.forward  # [m/s]
LONG, PAUSE = 24, 8  # steps: 1.5 s and half a second, of 16 a second


def walk(steps: Steps, count: int, pace: float = 0.01) -> None:
    """Let home's player go on by a pace [m] before each of some steps."""
    for _ in range(count):
        steps.match.robots["x"][0, KICKER] += 0.6 * pace
        steps.match.robots["y"][0, KICKER] += 0.8 * pace
        steps.count()


def aim(steps: Steps, wanted: float, made: float) -> None:
    """Let home's player aim at a speed and make another [m/s]; all others want nothing."""
    for name in ("forward", "left"):
        steps.match.robots["target"][name] = 0.0
    steps.match.robots["target"]["forward"][0, KICKER] = wanted
    steps.set(KICKER, vx=0.0, vy=made)


def test_distance_is_the_way_from_step_to_step() -> None:
    steps = Steps()
    steps.set(KICKER, placed=0)
    steps.count()
    walk(steps, 10)
    assert steps.of("distance") == pytest.approx([0.1, 0.0])


def test_nobody_covers_a_distance_as_he_is_put_somewhere_or_while_the_ball_is_out_of_play() -> None:
    steps = Steps()
    steps.count()
    steps.set(KICKER, placed=1)
    walk(steps, 1, 0.5)
    steps.set(KICKER, placed=0)
    steps.match.matches["phase"] = Phase.THROW_IN
    walk(steps, 3, 0.5)
    steps.match.matches["phase"] = Phase.PLAY
    walk(steps, 1, 0.5)
    assert steps.of("distance") == [0.0, 0.0]
    walk(steps, 1, 0.5)
    assert steps.of("distance") == pytest.approx([0.5, 0.0])


def test_a_robot_that_is_sent_off_covers_nothing_and_is_not_present() -> None:
    steps = Steps()
    steps.count()
    steps.set(KICKER, active=0)
    walk(steps, SECOND)
    steps.set(KICKER, active=1)
    walk(steps, 1)
    assert steps.of("distance") == [0.0, 0.0]
    assert steps.of("present") == pytest.approx([2 * 18 / SECOND + 2 / SECOND, 3 * 18 / SECOND])


@pytest.mark.parametrize(("count", "seconds"), [(LONG - 1, 0.0), (LONG, STUCK), (LONG + 5, STUCK + 5 / SECOND)])
def test_who_is_stopped_for_long_is_stuck_from_the_first_moment(count: int, seconds: float) -> None:
    steps = Steps()
    aim(steps, TOP, 0.0)
    steps.count(steps=count)
    assert steps.of("stuck") == pytest.approx([seconds, 0.0])


@pytest.mark.parametrize(("pause", "seconds"), [(PAUSE, (20 + PAUSE + 10) / SECOND), (PAUSE + 1, 0.0)])
def test_a_short_break_does_not_end_it(pause: int, seconds: float) -> None:
    steps = Steps()
    aim(steps, TOP, 0.0)
    steps.count(steps=20)
    aim(steps, TOP, TOP)
    steps.count(steps=pause)
    aim(steps, TOP, 0.0)
    steps.count(steps=10)
    assert steps.of("stuck") == pytest.approx([seconds, 0.0])


@pytest.mark.parametrize(
    ("wanted", "made", "stuck"),
    [
        (WANTS * TOP * 1.01, 0.0, True), (WANTS * TOP * 0.99, 0.0, False),
        (TOP, MAKES * TOP * 0.99, True), (TOP, MAKES * TOP * 1.01, False),
    ],
)  # fmt: skip
def test_who_wants_little_or_gets_on_is_not_stuck(wanted: float, made: float, stuck: bool) -> None:
    steps = Steps()
    aim(steps, wanted, made)
    steps.count(steps=2 * LONG)
    assert (steps.of("stuck")[HOME] > 0.0) == stuck


@pytest.mark.parametrize("field", ["kick_clock", "fallen"])
def test_who_winds_up_a_kick_or_lies_on_the_ground_is_not_stuck(field: str) -> None:
    steps = Steps()
    aim(steps, TOP, 0.0)
    steps.set(KICKER, **{field: 1.0})
    steps.count(steps=2 * LONG)
    assert steps.of("stuck") == [0.0, 0.0]


@each_direction
@pytest.mark.parametrize(
    ("x", "y", "column", "row"),
    [
        (-1.49, -0.99, 0, 0), (1.49, 0.99, CELLS_LONG - 1, CELLS_WIDE - 1),
        (0.01, 0.01, CELLS_LONG // 2, CELLS_WIDE // 2),
        (-0.01, -0.01, CELLS_LONG // 2 - 1, CELLS_WIDE // 2 - 1), (1.6, -1.2, CELLS_LONG - 1, 0),
    ],
)  # fmt: skip
def test_the_heat_map_is_that_of_a_team_that_attacks_to_the_right(direction, x, y, column, row) -> None:
    """A ball that is beyond a line counts in the cell at the line."""
    steps = Steps(direction=direction)
    steps.ball(x, direction * y)
    steps.count(steps=3 * LOOK)
    heat = steps.tally["maps"]["heat"][0]
    assert heat[BALL].sum() == heat[BALL, row, column] == 3
    assert heat[:BALL].sum(axis=(1, 2)).tolist() == [9, 9]


def test_the_heat_map_rests_while_the_ball_is_out_of_play() -> None:
    steps = Steps()
    steps.match.matches["phase"] = Phase.CORNER_KICK
    steps.count(steps=3 * LOOK)
    assert not steps.tally["maps"]["heat"].any()


def test_the_mean_place_of_a_player_is_that_in_play() -> None:
    steps = Steps(direction=-1.0)
    steps.put(KICKER, 1.0, 0.25)
    steps.count(steps=SECOND)
    steps.put(KICKER, 0.0, 0.25)
    steps.count(steps=SECOND)
    maps = steps.tally["maps"][0]
    x, y, seconds = maps["places"][KICKER]
    assert seconds == 2.0
    assert np.array([x, y]) / seconds == pytest.approx([0.5, -0.25])
