"""Team-mates that report by radio are where they say, and a ball that one sees is known to all."""

from math import inf

import numpy as np
import pytest

from tests.belief.omni.staged_omni import Radio, turned

DT = 0.02  # [s]
LATE = 3  # frames that a report is on its way


def test_mh05_team_mates_are_where_they_say() -> None:
    radio = Radio()
    radio.stand(1, 1.0, 1.0, -2.0, forward=1.5, left=-0.5)
    radio.step(LATE)
    assert radio.present(0) == []
    radio.step()
    assert sorted(radio.present(0)) == [1, 2] and sorted(radio.present(2)) == [0, 1]
    gone_on = LATE * DT * turned(1.5, -0.5, -2.0)
    assert radio.place_of(0, 1) == pytest.approx(np.array([1.0, 1.0]) + gone_on)
    assert radio.place_of(1, 2) == pytest.approx([0.5, -2.0])
    track = radio.tracks[0][radio.tracks["number"][0] == 1][0]
    assert track["heading"] == pytest.approx(-2.3)
    assert (track["vx"], track["vy"]) == pytest.approx(tuple(turned(1.5, -0.5, -2.3)))
    assert track["distance"] == pytest.approx(np.hypot(track["x"], track["y"]))
    assert track["bearing"] == pytest.approx(np.arctan2(track["y"], track["x"]))
    assert track["age"] == pytest.approx(0.06) and 90.0 < track["confidence"] < 95.0
    assert radio.tracks["keeper"][1][radio.tracks["number"][1] == 0].tolist() == [1]
    assert track["keeper"] == 0 and track["teammate"] == 1


def test_opponents_do_not_listen() -> None:
    radio = Radio(home=2, away=3)
    radio.step(LATE + 1)
    assert [sorted(radio.present(r)) for r in range(5)] == [[1], [0], [1, 2], [0, 2], [0, 1]]


def test_what_the_own_camera_sees_keeps_its_place_and_gets_the_number_until_it_saw_it_long_ago() -> None:
    for age, place in ((0.0, [1.3, 1.2]), (0.9, [1.0, 1.0])):
        radio = Radio()
        radio.film(0, 0, *turned(3.3, 0.7, -0.3), age=age)  # robot 1, as robot 0 sees it: 36 cm beside what it says
        radio.step(LATE + 1)
        assert sorted(radio.present(0)) == [1, 2] and radio.place_of(0, 1) == pytest.approx(place)
        track = radio.tracks[0, 0]
        assert track["number"] == 1 and track["heading"] == pytest.approx(-2.3)
        assert age > 0.0 or track["confidence"] == 100.0


def test_two_that_are_seen_get_their_own_numbers_and_a_stranger_beyond_the_gate_is_another_player() -> None:
    radio = Radio()
    radio.stand(1, 1.0, 0.4, 0.0)
    radio.stand(2, 1.0, -0.4, 0.0)
    radio.film(0, 0, *turned(3.0, -0.4 - 0.5 + 0.1, -0.3))  # robot 2
    radio.film(0, 1, *turned(3.0, 0.4 - 0.5 + 0.1, -0.3))  # robot 1
    radio.step(LATE + 1)
    assert radio.tracks["number"][0, :2].tolist() == [2, 1]
    radio = Radio(home=2)
    radio.film(0, 0, *turned(3.0 + 1.4, 0.5, -0.3))  # 3 m away: 1 m, and 0.1 rad for the own heading
    radio.step(LATE + 1)
    assert radio.present(0) == [-1, 1]


def test_what_is_told_takes_no_slot_from_what_is_seen_and_of_too_many_the_nearest_are_kept() -> None:
    radio = Radio(home=6)
    for slot in range(4):  # all slots are full of players far away from what is told
        radio.film(0, slot, *turned(7.0, 2.0 * slot - 4.0, -0.3))
    radio.step(LATE + 1)
    seen = radio.tracks[0, :4]
    assert (seen["confidence"] == 100.0).all() and (seen["number"] == -1).all()
    radio = Radio(home=11)
    away = np.array([0.0, 9.0, 3.0, 8.0, 1.0, 7.0, 2.0, 6.0, 4.0, 5.0, 10.0])
    for r in range(11):
        radio.stand(r, -5.0 + away[r], 0.0, 0.0)
    radio.step(LATE + 1)
    slots = radio.league.slots.teammates
    nearest = sorted(np.argsort(away)[1 : slots + 1].tolist())
    assert sorted(radio.present(0)) == nearest


def test_a_team_mate_that_was_told_moves_with_each_report_and_is_not_moved_on_without_compensation() -> None:
    radio = Radio(home=2)
    for x in (1.0, 1.8, 4.0):  # the last one is a jump beyond the gate
        radio.stand(1, x, 1.0, 0.0)
        radio.step(10)
        assert radio.present(0) == [1] and radio.place_of(0, 1) == pytest.approx([x, 1.0])
    radio = Radio()
    radio.settings["delay_compensation"] = 0
    radio.stand(1, 1.0, 1.0, -2.0, forward=2.0)
    radio.step(LATE + 1)
    assert radio.place_of(0, 1) == pytest.approx([1.0, 1.0])


def test_one_who_does_not_know_where_it_is_is_not_placed_and_one_who_is_sent_off_falls_silent() -> None:
    radio = Radio()
    radio.beliefs["own"]["confidence"][1] = 0.0
    radio.track_ball(1, 2.0, 2.0)
    radio.step(LATE + 1)
    assert radio.present(0) == [2] and radio.beliefs["ball"]["confidence"][0] == 0.0
    radio = Radio(home=2)
    radio.percepts["body"]["active"][1] = 0
    radio.step(20)
    assert radio.present(0) == [] and radio.present(1) == [0]


def test_mh05_a_ball_that_one_sees_is_known_to_all() -> None:
    radio = Radio()
    radio.settings["delay_compensation"] = 0
    radio.track_ball(1, 2.0, 0.5, 1.0, -0.5)
    radio.step(LATE)
    assert radio.beliefs["ball"]["confidence"][0] == 0.0
    radio.step()
    for r in (0, 2):
        ball, own = radio.beliefs["ball"][r], radio.beliefs["own"][r]
        assert radio.ball_of(r) == pytest.approx([2.0, 0.5])
        assert turned(ball["vx"], ball["vy"], own["heading"]) == pytest.approx([1.0, -0.5])
        assert ball["distance"] == ball["filtered_distance"] == pytest.approx(np.hypot(ball["x"], ball["y"]))
        assert ball["bearing"] == ball["filtered_bearing"] == pytest.approx(np.arctan2(ball["y"], ball["x"]))
        assert 90.0 < ball["confidence"] < 95.0 and ball["age"] == pytest.approx(0.06)
    assert radio.beliefs["ball"]["confidence"][1] == 100.0


@pytest.mark.parametrize("walk", [(0.0, 0.0, 0.0), (1.0, -0.5, 0.7), (-2.0, 0.3, -1.1)])
def test_a_told_ball_comes_and_turns_as_the_moving_robot_would_see_it(walk: tuple[float, float, float]) -> None:
    """By their definition: the rates of distance and bearing, from where both are a moment later."""
    forward, left, turn = walk
    radio, moment = Radio(radio_delay=0.0), 1e-6
    radio.track_ball(1, 2.0, 0.5, 0.6, -0.4)
    radio.stand(0, -2.0, 0.5, 0.3, forward, left)
    radio.beliefs["own"]["turn"][0] = turn
    radio.step(2)
    ball = radio.beliefs["ball"][0]
    now = complex(ball["x"], ball["y"])
    later = now + moment * complex(ball["vx"] - forward, ball["vy"] - left)
    assert ball["radial"] == pytest.approx((abs(later) - abs(now)) / moment, abs=1e-6)
    assert ball["angular"] == pytest.approx(np.angle(later / now) / moment - turn, abs=1e-6)


def test_a_ball_rolls_on_while_the_report_is_on_its_way() -> None:
    radio = Radio()
    radio.track_ball(1, 2.0, 0.5, 3.0, 0.0)
    radio.step(LATE + 1)
    slowing = radio.league.ball.rolling
    assert radio.ball_of(0) == pytest.approx([2.0 + 3.0 * 0.06 - 0.5 * slowing * 0.06**2, 0.5])
    radio = Radio(radio_period=3.0, radio_delay=2.0)
    radio.track_ball(1, 2.0, 0.5, 0.4, 0.0)
    radio.step(101)
    assert radio.ball_of(0) == pytest.approx([2.0 + 0.4**2 / (2.0 * slowing), 0.5])  # it lies still by then
    assert abs(radio.beliefs["ball"]["vx"][0]) < 1e-12


@pytest.mark.parametrize(("age", "told", "own"), [
    (0.1, 0.0, True), (0.48, 0.0, True), (0.52, 0.0, False), (3.0, 0.0, False), (1.0, 2.0, True),
])  # fmt: skip
def test_the_own_ball_counts_until_it_has_not_been_seen_for_a_while_and_before_an_older_one(age, told, own) -> None:
    radio = Radio()
    radio.track_ball(1, 2.0, 0.5, age=told)
    radio.step(LATE)
    radio.track_ball(0, -1.0, -1.0, age=age)
    radio.step()
    assert radio.ball_of(0) == pytest.approx([-1.0, -1.0] if own else [2.0, 0.5])


@pytest.mark.parametrize("age", [0.3, 0.0])
def test_the_most_confident_team_mate_is_believed_then_the_nearest_to_the_ball(age: float) -> None:
    radio = Radio()
    radio.track_ball(1, 2.0, 0.5, age=age)  # less sure, or as sure and farther from it
    radio.track_ball(2, 1.0, -1.5)
    radio.step(LATE + 1)
    assert radio.ball_of(0) == pytest.approx([1.0, -1.5])


def test_a_robot_that_shares_nothing_knows_what_it_sees_alone_and_no_ball_anywhere_is_no_ball() -> None:
    radio = Radio()
    radio.settings["shared"] = 0
    radio.track_ball(1, 2.0, 0.5)
    radio.step(20)
    assert radio.present(0) == [] and radio.beliefs["ball"]["confidence"][0] == 0.0
    radio = Radio()
    radio.step(20)
    assert (radio.beliefs["ball"]["age"] == inf).all() and (radio.beliefs["ball"]["confidence"] == 0.0).all()
