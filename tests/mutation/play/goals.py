"""Mutants of what the statistics count of balls on their way and of goals, by the test that must notice."""

from tests.mutation.mutant import By, mutants_of

STATISTICS = "soccer_env/statistics/"
GOALS = "tests/statistics/test_counted_goals.py::test_"
SHOTS = "tests/statistics/test_counted_shots.py::test_"

IN_FLIGHTS: By = {
    SHOTS + "a_push_is_a_shot_when_the_ball_comes_free_as_fast_as_by_a_kick": [
        ("shots", "max(k.drive_forward, k.kicker_slowest)", "k.drive_forward"),
        ("shots", "step - trail.touched == steps_in(FREE, k)", "step - trail.touched >= 0", "is_pushed"),
        (
            "shots",
            "step - trail.touched == steps_in(FREE, k)",
            "step - trail.touched == steps_in(FREE, k) + 2",
            "is_pushed",
        ),
    ],
    SHOTS + "a_kick_in_the_step_of_a_restart_is_no_shot": [
        ("shots", "events.restart == 0", "True", "begin_flight"),
    ],
    SHOTS + "a_kick_that_would_roll_to_the_goal_is_a_shot": [
        ("shots", "tally.shots[team] += 1", "tally.shots[1 - team] += 1"),
        ("shots", "tally.on_target[team] += 1", "tally.on_target[1 - team] += 1"),
        ("shots", "trail.aim == ON_TARGET", "trail.aim != ELSEWHERE", "begin_flight"),
        ("shots", "trail.aim != ELSEWHERE", "trail.aim == ON_TARGET", "begin_flight"),
        ("shots", "BESIDE = 0.25", "BESIDE = 0.2"),
        ("shots", "BESIDE = 0.25", "BESIDE = 0.3"),
        ("shots", "0.5 * k.pitch_goal_width", "0.45 * k.pitch_goal_width"),
        ("shots", "way > reach * ahead / length(ball.vx, ball.vy)", "False"),
        ("shots", "ball.vx - share * (ball.vx - ball.roll_x)", "ball.vx"),
        ("shots", "direction_of(match, team)", "1.0", "begin_flight"),
    ],
    GOALS + "a_ball_is_on_its_way_for_five_seconds": [
        ("goals by kind", "LONGEST = 5.0", "LONGEST = 4.9"),
        ("goals by kind", "LONGEST = 5.0", "LONGEST = 5.1"),
    ],
    GOALS + "a_touch_by_another_makes_it_deflected_for_a_second_and_then_it_is_the_others": [
        ("goals by kind", "DEFLECTED = 1.0", "DEFLECTED = 0.9"),
        ("goals by kind", "DEFLECTED = 1.0", "DEFLECTED = 1.1"),
    ],
    GOALS + "the_kicker_that_touches_the_ball_half_a_second_later_plays_it_anew": [
        ("goals by kind", "SWING = 0.5", "SWING = 0.4"),
        ("goals by kind", "SWING = 0.5", "SWING = 0.6"),
    ],
    SHOTS + "a_shot_on_target_is_saved_if_the_goalkeeper_touches_it_first": [
        ("saves", "trail.aim == ON_TARGET", "trail.aim != ELSEWHERE", "touch"),
        ("saves", "robot.keeper == 1 and robot.team != trail.flight_team", "robot.keeper == 1"),
        ("saves", "robot.keeper == 1 and robot.team != trail.flight_team", "robot.team != trail.flight_team"),
        ("saves", "trail.deflected == LONG_AGO", "True", "touch"),
        ("saves", "tally.saves[1 - trail.flight_team] += 1", "tally.saves[trail.flight_team] += 1"),
    ],
    SHOTS + "a_restart_or_another_kick_ends_a_save_that_was_made": [
        ("saves", "end_flight(tally, trail)", "pass", "begin_flight"),
    ],
    SHOTS + "a_ball_that_is_free_for_a_quarter_second_and_goes_far_enough_is_a_pass": [
        ("passes", "PASS_LEGS if k.drive_kind == GAIT else PASS_WHEELS", "PASS_LEGS"),
        ("passes", "PASS_LEGS if k.drive_kind == GAIT else PASS_WHEELS", "PASS_WHEELS"),
        ("passes", "step - trail.touched < steps_in(FREE, k)", "step - trail.touched <= steps_in(FREE, k)"),
        ("passes", "step - trail.touched < steps_in(FREE, k)", "step - trail.touched < steps_in(FREE, k) - 1"),
        ("passes", "x * x + y * y <= least * least", "x * x <= least * least"),
        ("passes", "tally.passes_tried[trail.player_team] += 1", "tally.passes_tried[team] += 1"),
        ("passes", "team == trail.player_team", "team != trail.player_team", "receive"),
        ("interceptions", "tally.interceptions[team] += 1", "tally.interceptions[1 - team] += 1"),
        ("passes", "trail.played_x, trail.played_y = x, y", "pass"),
    ],
    SHOTS + "a_shot_that_another_touches_is_no_pass_and_no_robot_passes_to_itself": [
        (
            "passes",
            "shot or step - trail.touched < steps_in(FREE, k) or x * x + y * y <= least * least",
            "step - trail.touched < steps_in(FREE, k) or x * x + y * y <= least * least",
        ),
        ("passes", "trail.player >= 0 and trail.player != row", "trail.player >= 0", "touch"),
    ],
    GOALS + "a_goal_is_a_solo_if_one_robot_of_the_scorers_alone_touched_the_ball_since_the_restart": [
        (
            "goals of one robot",
            "trail.since_restart[robot.team] |= 1 << row",
            "trail.since_restart[robot.team] = 1 << row",
        ),
    ],
}
IN_GOALS: By = {
    GOALS + "a_ball_is_on_its_way_for_five_seconds": [
        ("goals by kind", "tally.goals[team, kind] += 1", "tally.goals[1 - team, kind] += 1"),
    ],
    GOALS + "a_touch_by_another_makes_it_deflected_for_a_second_and_then_it_is_the_others": [
        ("goals by kind", "trail.deflected == LONG_AGO", "True"),
    ],
    GOALS + "a_kick_into_the_own_goal_is_an_own_goal": [
        ("goals by kind", "trail.flight >= 0 and trail.flight_team == team", "trail.flight >= 0"),
    ],
    GOALS + "a_goal_that_an_opponent_touched_last_is_an_own_goal": [
        ("own goals", "trail.player_team != team", "False"),
    ],
    GOALS + "in_a_scrum_only_who_has_kept_the_ball_for_a_second_and_still_has_it_dribbles": [
        ("goals by kind", "step - player.held_last > steps_in(JUST, k)", "False"),
        ("goals by kind", "kept < steps_in(KEPT, k)", "True", "kind_of"),
        ("goals by kind", "kept < steps_in(KEPT, k)", "kept <= steps_in(KEPT, k)", "kind_of"),
        ("goals by kind", "step - trail.crowded <= steps_in(JUST, k)", "False"),
    ],
    GOALS + "a_scrum_of_half_a_second_ago_still_is_one": [
        ("goals by kind", "step - trail.crowded <= steps_in(JUST, k)", "step - trail.crowded < steps_in(JUST, k)"),
        ("goals by kind", "step - trail.crowded <= steps_in(JUST, k)", "step - trail.crowded <= steps_in(JUST, k) + 1"),
    ],
    GOALS + "a_dribble_in_touch_with_an_opponent_within_three_seconds_is_a_push_and_not_in_the_legs_of_a_mate": [
        ("goals by kind", "CONTACT = 3.0", "CONTACT = 2.9"),
        ("goals by kind", "CONTACT = 3.0", "CONTACT = 3.1"),
    ],
    GOALS + "a_clean_kick_that_is_in_is_one_shot_on_target_whatever_was_thought_of_it": [
        ("shots", "tally.shots[team] += trail.aim == ELSEWHERE", "tally.shots[team] += 1"),
        ("shots", "tally.on_target[team] += 1", "pass", "count_goal"),
        ("shots", "kind == CLEAN_KICK and trail.aim != ON_TARGET", "kind == CLEAN_KICK"),
    ],
    SHOTS + "a_shot_that_the_goalkeeper_touches_and_that_goes_in_is_not_saved": [
        ("saves", "trail.saved = 0", "pass"),
    ],
    GOALS + "goals_within_six_seconds_of_a_separation_say_so": [
        (
            "goals after a separation",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 10.0",
            "SEPARATION, RESTART, PUSHED_KEEPER = 5.9, 10.0, 10.0",
        ),
        (
            "goals after a separation",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 10.0",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.1, 10.0, 10.0",
        ),
    ],
    GOALS + "goals_within_ten_seconds_of_a_restart_say_which": [
        (
            "goals after a restart",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 10.0",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 9.9, 10.0",
        ),
        (
            "goals after a restart",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 10.0",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.1, 10.0",
        ),
    ],
    GOALS + "goals_within_ten_seconds_of_a_goalkeeper_in_contact_with_opponents_for_one_say_so": [
        (
            "goals after a pushed goalkeeper",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 10.0",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 9.9",
        ),
        (
            "goals after a pushed goalkeeper",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 10.0",
            "SEPARATION, RESTART, PUSHED_KEEPER = 6.0, 10.0, 10.1",
        ),
        ("goals after a pushed goalkeeper", "trail.keeper_pushed[1 - team]", "trail.keeper_pushed[team]"),
    ],
    GOALS + "a_goal_is_a_solo_if_one_robot_of_the_scorers_alone_touched_the_ball_since_the_restart": [
        ("goals of one robot", "bits_of(trail.since_restart[team]) == 1", "True"),
        (
            "goals of one robot",
            "bits_of(trail.since_restart[team]) == 1",
            "bits_of(trail.since_restart[1 - team]) == 1",
        ),
    ],
}
PARTS = {"flights": IN_FLIGHTS, "goals": IN_GOALS}
MUTANTS = mutants_of(STATISTICS, PARTS)
