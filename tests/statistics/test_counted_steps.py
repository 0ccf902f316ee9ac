"""What is counted in a single step, just under and just over each limit: time, possession, touches, standing, calls."""

import numpy as np
import pytest

from soccer_env.statistics.records import BINS, BINS_PER_OCTAVE, SHORTEST
from soccer_env.types import AWAY, HOME, NO_TEAM, Foul, Phase
from tests.scenes.staging import LEAGUES, LEGGED, MIDDLE
from tests.statistics.counted_steps import Steps

DT = 1.0 / 16.0  # [s] a step of the legged league
NEAR = {LEGGED: 0.2955, MIDDLE: 0.497}  # [m] from the ball's centre: reach, ball and 10 cm
AFAR = {LEGGED: (0.5, 0.9), MIDDLE: (2.0, 3.0)}  # [m] where robots of the next test wait
each_direction = pytest.mark.parametrize("direction", [1.0, -1.0])


@pytest.mark.parametrize(
    ("phase", "placing", "in_play"), [(Phase.PLAY, 0, 1.0), (Phase.PLAY, 1, 0.0), (Phase.THROW_IN, 0, 0.0)]
)
def test_time_counts_always_and_in_play_while_no_restart_is_placed_or_waited_for(steps, phase, placing, in_play):
    steps.match.matches["phase"], steps.match.matches["placing"] = phase, placing
    steps.set(1, has_ball=1)
    steps.count(seconds=1.0)
    assert steps.of("played") == 1.0
    assert steps.of("in_play") == steps.of("still") == steps.of("possession")[HOME] == in_play


@pytest.mark.parametrize(("vx", "vy", "still"), [(0.0139, 0.0139, 1.0), (0.0145, -0.0145, 0.0), (-0.0199, 0.0, 1.0)])
def test_a_ball_slower_than_2_cm_a_second_lies_still(steps, vx, vy, still) -> None:
    steps.ball(0.0, 0.0, vx, vy)
    steps.count(seconds=1.0)
    assert steps.of("still") == still


@pytest.mark.parametrize(("x", "y", "board", "corner"), [
    (0.0, 0.81, 1.0, 0.0), (0.0, -0.81, 1.0, 0.0), (0.0, 0.79, 0.0, 0.0), (1.31, 0.0, 1.0, 0.0),
    (-1.31, 0.0, 1.0, 0.0), (1.29, 0.0, 0.0, 0.0), (1.26, 0.76, 0.0, 1.0), (-1.31, -0.81, 1.0, 1.0),
    (1.31, 0.74, 1.0, 0.0), (1.24, 0.81, 1.0, 0.0),
])  # fmt: skip
def test_a_ball_within_20_cm_of_a_line_is_at_the_boards_and_within_25_of_two_in_a_corner(steps, x, y, board, corner):
    steps.ball(x, y)
    steps.count(seconds=1.0)
    assert [steps.of("at_boards"), steps.of("in_corner")] == [board, corner]


@pytest.mark.parametrize("name", LEAGUES)
@pytest.mark.parametrize(("third", "active", "scrum"), [(-0.002, 1, 1.0), (0.002, 1, 0.0), (-0.002, 0, 0.0)])
def test_three_robots_that_play_near_the_ball_are_a_scrum(name, third, active, scrum) -> None:
    steps = Steps(name)
    for row in range(6):
        steps.put(row, -AFAR[name][0] + 0.1 * row, AFAR[name][1])
    near = NEAR[name]
    steps.put(1, near - 0.002, 0.0)
    steps.put(4, 0.0, near - 0.002)
    steps.put(2, -0.6 * (near + third), -0.8 * (near + third))
    steps.set(2, active=active)
    steps.count(seconds=1.0)
    assert steps.of("scrum") == pytest.approx(scrum)


@pytest.mark.parametrize(
    ("rows", "found"), [((1,), [1, 0, 0]), ((4, 5), [0, 1, 0]), ((0, 3), [0, 0, 1]), ((), [0, 0, 0])]
)
def test_possession_is_a_teams_that_has_the_ball_alone(steps, rows, found) -> None:
    for row in rows:
        steps.set(row, has_ball=1)
    steps.count(seconds=1.0)
    for row in rows:
        steps.set(row, has_ball=0)
    steps.count(seconds=1.0)
    assert [*steps.of("possession"), steps.of("both")] == found


@pytest.mark.parametrize(("row", "team"), [(1, HOME), (5, AWAY)])
@pytest.mark.parametrize(("gap", "spells"), [(8, [34]), (9, [16, 10])])
def test_a_spell_goes_on_after_half_a_second_without_the_ball_and_not_after_longer(steps, row, team, gap, spells):
    for has_ball, length in ((1, 16), (0, gap), (1, 10), (0, 9)):
        steps.set(row, has_ball=has_ball)
        steps.count(steps=length)
    assert steps.of("spells")[team] == len(spells) and steps.of("spells")[1 - team] == 0
    assert steps.of("spell_time")[team] == pytest.approx(sum(spells) * DT)
    assert steps.of("longest_spell")[team] == pytest.approx(max(spells) * DT)
    places = [int(BINS_PER_OCTAVE * np.log2(length * DT / SHORTEST)) for length in spells]
    assert steps.of("spell_lengths")[team] == np.bincount(places, minlength=BINS).tolist()


def test_a_spell_ends_with_the_play_and_a_longer_one_stays_the_longest(steps: Steps) -> None:
    steps.set(1, has_ball=1)
    steps.count(seconds=2.0)
    steps.match.matches["phase"] = Phase.GOAL_KICK
    steps.count()
    assert [steps.of("spells")[HOME], steps.of("longest_spell")[HOME]] == [1, 2.0]
    steps.count(seconds=3.0)
    steps.match.matches["phase"] = Phase.PLAY
    steps.count(seconds=1.0)
    steps.set(1, active=0)  # taken out
    steps.count()
    assert [steps.of("spells")[HOME], steps.of("longest_spell")[HOME], steps.of("spell_time")[HOME]] == [2, 2.0, 3.0]


@pytest.mark.parametrize(("row", "team"), [(1, HOME), (4, AWAY)])
@pytest.mark.parametrize(("gap", "touches"), [(16, 1), (17, 2)])
def test_a_touch_counts_anew_after_more_than_a_second_without_one(steps, row, team, gap, touches) -> None:
    steps.count(seconds=3.0, touch=row)
    steps.count(steps=gap)
    steps.count(touch=row)
    assert steps.of("touches")[team] == touches and steps.of("touches")[1 - team] == 0
    steps.count(touch=(row + 1) % 6)  # another robot's is its own
    assert sum(steps.of("touches")) == touches + 1


def test_a_touch_before_the_ball_is_in_play_is_none_but_a_kick_counts(steps: Steps) -> None:
    steps.match.matches["phase"] = Phase.THROW_IN
    steps.count(kick=4)
    assert [steps.of("touches"), steps.of("kicks")] == [[0, 0], [0, 1]]


@pytest.mark.parametrize(("name", "slow"), [(LEGGED, 0.01), (MIDDLE, 0.05)])
def test_mates_are_field_players_that_are_not_nearest_to_the_ball_and_idle_those_that_stand(name, slow) -> None:
    steps = Steps(name, players=4)
    for row, (x, speed) in enumerate([(-1.3, 0.0), (-0.4, 0.0), (-0.8, 0.9 * slow), (-0.9, 1.1 * slow)]):
        steps.put(row, x, 0.5, speed)
    for row in range(4, 8):  # the keeper is the nearest of away: all three others are mates
        steps.put(row, 0.3 + 0.2 * row if row > 4 else 0.2, -0.5, 2.0 * slow)
    steps.count(seconds=1.0)
    assert steps.of("mates") == pytest.approx([2.0, 3.0]) and steps.of("idle") == pytest.approx([1.0, 0.0])
    steps.put(1, -1.2, 0.5, 0.0)  # now it is one of the mates, and one that moves, farther off, is the nearest
    steps.put(2, -0.5, 0.5, 2.0 * slow)
    steps.count(seconds=1.0)
    assert steps.of("mates") == pytest.approx([4.0, 6.0]) and steps.of("idle") == pytest.approx([2.0, 0.0])


@each_direction
@pytest.mark.parametrize(("row", "team"), [(0, HOME), (3, AWAY)])
@pytest.mark.parametrize(("ahead", "aside", "away", "in_goal"), [
    (0.74, 0.0, 0, 0), (0.76, 0.0, 1, 0), (0.55, 0.52, 1, 0), (0.0, 0.74, 0, 0), (-0.01, 0.1, 0, 1), (0.01, 0.1, 0, 0),
])  # fmt: skip
def test_a_goalkeeper_is_away_a_quarter_of_the_pitch_from_its_goal_and_in_it_behind_its_line(
    direction, row, team, ahead, aside, away, in_goal
) -> None:
    steps = Steps(direction=direction)
    side = 1.0 if team == HOME else -1.0
    steps.put(3 - row, side * 1.3, 0.0)  # the other one is in its place
    steps.put(row, side * (ahead - 1.5), aside)
    steps.count(seconds=1.0)
    mine = slice(None, None, 1 if team == HOME else -1)
    assert steps.of("keeper_away")[mine] == [away, 0] and steps.of("keeper_in_goal")[mine] == [in_goal, 0]


@pytest.mark.parametrize(("fields", "out"), [({"penalty": 30.0}, 1.0), ({"banned": 1}, 1.0), ({}, 0.0)])
def test_penalties_count_as_time_out_of_their_team_and_empty_places_do_not(steps, fields, out) -> None:
    steps.set(4, active=0, **fields)
    steps.count(seconds=1.0)
    assert steps.of("out") == [0.0, out]


@pytest.mark.parametrize("team", [HOME, AWAY])
@pytest.mark.parametrize("phase", [Phase.KICK_OFF, Phase.THROW_IN, Phase.CORNER_KICK, Phase.FREE_KICK])
def test_a_restart_counts_for_the_team_that_takes_it(steps, team, phase) -> None:
    steps.count(steps=3, restart=phase, restart_team=team)
    expected = np.zeros((2, len(Phase)), int)
    expected[team, phase] = 3
    assert steps.of("restarts") == expected.tolist() and steps.of("drops") == 0


def test_dropped_balls_and_separations_are_counted_and_how_far_they_carried_whom(steps: Steps) -> None:
    robots = steps.match.robots[0]
    steps.bodies[1:, 0], steps.bodies[1:, 1] = robots["x"], robots["y"]
    steps.bodies[2, 1] -= 0.3
    steps.count(restart=Phase.DROP_BALL, restart_team=NO_TEAM)
    assert [steps.of("drops"), steps.of("separations"), steps.of("carried")] == [1, 0, pytest.approx(0.3)]
    steps.bodies[2, 1] += 0.2
    steps.count(separated=1)
    assert [steps.of("drops"), steps.of("separations"), steps.of("carried")] == [1, 1, pytest.approx(0.3)]
    steps.bodies[5, 0] += 0.7
    steps.count(separated=1, returned=4)  # it came back from a penalty, which is no carrying
    steps.count(restart=Phase.THROW_IN, restart_team=HOME)  # nor is to be put to one's place
    assert steps.of("carried") == pytest.approx(0.3)
    steps.count(separated=1)
    assert steps.of("carried") == pytest.approx(0.7)
    assert np.sum(steps.of("restarts")) == 1


def test_each_robot_that_is_whistled_counts_and_a_foul_of_a_team_once(steps: Steps) -> None:
    steps.count(foul=Foul.PUSHING, foul_team=HOME, fouls={1: Foul.PUSHING, 4: Foul.PUSHING, 5: Foul.HOLDING})
    expected = np.zeros((2, len(Foul)), int)
    expected[HOME, Foul.PUSHING] = expected[AWAY, Foul.PUSHING] = expected[AWAY, Foul.HOLDING] = 1
    assert steps.of("fouls") == expected.tolist()
    steps.count(foul=Foul.GAME_STUCK, foul_team=AWAY)
    expected[AWAY, Foul.GAME_STUCK] = 1
    assert steps.of("fouls") == expected.tolist()
    steps.count()
    assert steps.of("fouls") == expected.tolist()


@each_direction
@pytest.mark.parametrize(("x", "team"), [(1.6, HOME), (-1.6, AWAY)])
def test_an_annulled_goal_counts_for_the_team_that_attacks_there(direction, x, team) -> None:
    steps = Steps(direction=direction)
    steps.ball(x, 0.0)
    steps.count(annulled=1)
    assert steps.of("annulled") == [1 - team, team]
    assert np.sum(steps.of("fouls")) == np.sum(steps.of("goals")) == 0
