"""Who may not stay in the areas before the goals, and for how long; cards."""

import pytest

from soccer_env.referee.fouls.middle_size.book import OUT, YELLOW, book_foul
from soccer_env.types import AWAY, HOME, Foul, Phase
from tests.scenes.referee import Referee
from tests.scenes.staging import play, record_each_step, robot_actions

each_team = pytest.mark.parametrize("team", [HOME, AWAY])
GOAL_AREA, PENALTY_AREA = Foul.GOAL_AREA, Foul.PENALTY_AREA


@each_team
@pytest.mark.parametrize(("index", "x", "y", "foul"), [
    (1, -5.51, 0.0, GOAL_AREA),  # a field player in its own goal area, 0.5 x 3 m
    (1, -5.49, 0.0, 0), (1, -5.6, 1.49, GOAL_AREA), (1, -5.6, 1.51, 0),
    (0, -5.8, 0.0, 0),  # its goalkeeper
    (1, 5.51, 0.0, GOAL_AREA),  # an attacker
    (1, 5.49, 0.0, 0),
    (0, 5.6, 0.0, GOAL_AREA),  # a goalkeeper that attacks
])  # fmt: skip
def test_only_the_goalkeeper_stays_in_a_goal_area(index, x, y, foul, team):
    referee = Referee(team=team)
    referee.put(index, x, y)
    assert not any(referee.wait(9.98)) and referee.look() == foul
    if foul:
        assert referee.record["phase"] == Phase.FREE_KICK and referee.record["restart_team"] == 1 - team
        assert abs(referee.record["restart_x"]) == 5.5


@pytest.mark.parametrize("x", [-5.4, -3.0])  # before it, and far from all areas
def test_who_leaves_the_goal_area_begins_anew(x):
    referee = Referee()
    for _ in range(2):
        referee.put(1, -5.6, 0.0)
        assert not any(referee.wait(9.0))
        referee.put(1, x, 0.0)
        assert referee.look() == 0


@each_team
@pytest.mark.parametrize(("second", "foul"), [((-4.51, 2.49), PENALTY_AREA), ((-4.49, 2.0), 0), ((-4.6, 2.51), 0)])
def test_one_field_player_is_in_its_own_penalty_area_beside_the_goalkeeper(second, foul, team):
    referee = Referee(team=team)
    referee.put(0, -5.8, 0.0)
    referee.put(1, -5.0, 0.0)
    referee.put(2, *second)
    assert not any(referee.wait(9.98)) and referee.look() == foul


@pytest.mark.parametrize(("ball", "guilty"), [(-1.0, 2), (2.0, 1)])
def test_the_one_nearest_to_the_ball_may_stay_and_the_other_is_guilty(ball, guilty):
    referee = Referee()
    referee.put(1, -5.0, 0.0)
    referee.put(2, -5.0, 1.0)
    referee.ball["x"], referee.ball["y"] = -4.0, ball
    referee.wait(10.0)
    assert referee.deeds["foul"].tolist() == [PENALTY_AREA if row == guilty else 0 for row in range(6)]


@pytest.mark.parametrize(("first", "second", "ball"), [
    ((1, -5.0, 0.0), (0, -4.6, 0.0), (-4.6, 1.0)), ((1, -5.0, 0.0), (4, 5.0, 0.0), (5.0, 1.0)),
    ((1, 5.0, 0.0), (2, 5.0, 1.0), (0.0, 0.0)),
])  # fmt: skip
def test_a_goalkeeper_and_an_opponent_in_its_own_area_crowd_nobody_and_opponents_may_stay_there(first, second, ball):
    referee = Referee()
    referee.put(*first)
    referee.put(*second)
    referee.ball["x"], referee.ball["y"] = ball
    assert not any(referee.wait(11.0))


def test_clocks_stand_still_at_restarts():
    referee = Referee()
    referee.put(1, 5.6, 0.0)
    referee.restart(Phase.THROW_IN, 0.0, 4.0)
    assert not any(referee.wait(11.0))


@pytest.mark.parametrize("rule", ["goal_area", "penalty_area"])
def test_each_can_be_switched_off(rule):
    referee = Referee(**{rule: False})
    referee.put(1, -5.6, 0.0)
    referee.put(2, -5.0, 1.0)
    referee.ball["x"] = -6.0
    fouls = set(referee.wait(10.5)) - {0}
    assert fouls == ({PENALTY_AREA} if rule == "goal_area" else {GOAL_AREA})


def cards(referee, hard):
    """Return the cards and what `book_foul` says, for fouls of robot 1 one after the other."""
    shown = []
    for one in hard:
        referee.deeds["card"] = 0
        out = book_foul(referee.robots, referee.deeds, referee.rows[1], one, referee.k)
        shown.append((int(referee.deeds["card"][referee.rows[1]]), bool(out)))
    return shown


@pytest.mark.parametrize("team", [HOME, AWAY])
def test_every_third_foul_is_a_yellow_card_and_the_sixth_the_end(team):
    referee = Referee(team=team)
    assert cards(referee, [False] * 6) == [(0, False)] * 2 + [(YELLOW, False)] + [(0, False)] * 2 + [(OUT, True)]
    robot = referee.robots[referee.rows[1]]
    assert robot["active"] == 0 and robot["banned"] == 1 and robot["penalty"] == 0.0


def test_a_hard_foul_is_a_yellow_card_at_once_who_is_sent_off_stays_away_and_cards_can_be_switched_off():
    referee = Referee()
    assert cards(referee, [True, True]) == [(YELLOW, False), (OUT, True)]
    referee.match.rebuild()
    play(referee.match, actions=robot_actions(referee.match, referee.rows[1], 1.0), steps=150)
    assert referee.robots["active"].tolist() == [1, 0, 1, 1, 1, 1]
    assert cards(Referee(timed_cards=True), [True] * 4) == [(YELLOW, False), (OUT, True)] * 2
    referee = Referee(cards=False)
    assert cards(referee, [True] * 4) == [(0, False)] * 4 and referee.robots["fouls"].max() == 0


def test_the_timed_variant_lets_it_come_back_after_its_time():
    referee = Referee(timed_cards=True, card_time=1.0)
    cards(referee, [True, True])
    assert referee.robots["banned"].max() == 0 and referee.robots["penalty"][1] == 1.0
    referee.match.rebuild()
    assert record_each_step(referee.match, lambda: referee.robots["active"][1], steps=60).tolist().index(1) == 49
    assert abs(referee.robots["x"][1]) < 0.5 and abs(referee.robots["y"][1]) > 3.0
