"""Mutants of what the referee calls in both leagues, by the test that must notice."""

from tests.mutation.mutant import By, mutants_of

FOLDER = "soccer_env/referee/"
ANNULLED = "tests/referee/fouls/test_goals.py::test_"
KEEPER_PUSHING = "tests/referee/fouls/legged/test_keeper_pushing.py::test_"
HOLDING = "tests/referee/fouls/legged/test_holding.py::test_"
PENALTIES = "tests/referee/fouls/test_penalties.py::test_"
OUT_OF_PLAY = "tests/referee/test_out_of_play.py::test_"
STUCK_BALL = "tests/referee/test_stuck_ball.py::test_"
DROPPED_BALL = "tests/referee/test_dropped_ball.py::test_"
GOALS = "tests/referee/test_goals.py::test_"
TAKING = "tests/referee/fouls/middle_size/test_taking.py::test_"
FREE_KICKS = "tests/referee/fouls/middle_size/test_free_kicks.py::test_"
SHOOT_OUT = "tests/referee/test_shoot_out.py::test_"
AREAS = "tests/referee/fouls/middle_size/test_areas.py::test_"

IN_FOULS_GOALS: By = {
    ANNULLED + "a_push_by_those_who_concede_does_not_matter": [
        ("goals that count", "robot.team != scorer or robot.active == 0", "robot.active == 0"),
    ],
    ANNULLED + "who_held_the_ball_and_has_let_go_annuls_no_goal": [
        (
            "goals that count",
            "k.rules_holding == 1 and robot.has_ball == 1 and robot.holding >= k.rules_annulled_push - 0.5 * k.dt",
            "k.rules_holding == 1 and robot.holding >= k.rules_annulled_push - 0.5 * k.dt",
        ),
    ],
    ANNULLED + "a_goal_while_the_scorers_push_the_goalkeeper_does_not_count_after_half_a_second": [
        (
            "goals that count",
            "robot.keeper_pushing >= k.rules_annulled_push - 0.5 * k.dt",
            "robot.keeper_pushing >= k.rules_annulled_push + 0.5 * k.dt",
        ),
    ],
    ANNULLED + "a_whistled_attack_cannot_score_for_three_seconds": [
        (
            "goals that count",
            "match.whistled_clock > k.rules_annulled_time - 0.5 * k.dt",
            "match.whistled_clock > k.rules_annulled_time + 0.5 * k.dt",
        ),
        ("goals that count", "match.whistled == scorer", "False"),
    ],
    KEEPER_PUSHING + "one_second_is_legal_and_one_step_more_is_not_even_for_the_robot_nearest_to_the_ball": [
        (
            "goals that count",
            "robot_events[r].foul == KEEPER_PUSHING or robot_events[r].foul == HOLDING",
            "robot_events[r].foul == HOLDING",
        ),
    ],
    HOLDING + "a_ball_that_goes_along_though_the_robot_does_not_walk_ahead_is_held_for_three_seconds": [
        (
            "goals that count",
            "robot_events[r].foul == KEEPER_PUSHING or robot_events[r].foul == HOLDING",
            "robot_events[r].foul == KEEPER_PUSHING",
        ),
    ],
    KEEPER_PUSHING + "from_the_whistle_on_goals_do_not_count_for_the_full_time_though_there_was_one_before": [
        ("goals that count", "match.whistled_clock = 0.0", "pass"),
    ],
}
IN_FOULS_PENALTIES: By = {
    PENALTIES + "it_comes_back_away_from_the_ball_and_if_that_lies_in_the_middle_on_its_left": [
        ("penalties", "robots[r].penalty < 0.5 * k.dt", "robots[r].penalty < 1.5 * k.dt"),
        ("penalties", "-1.0 if ball.y > 0.0 else (1.0 if ball.y < 0.0 else ahead * match.handedness)", "1.0"),
        (
            "penalties",
            "-1.0 if ball.y > 0.0 else (1.0 if ball.y < 0.0 else ahead * match.handedness)",
            "-1.0 if ball.y > 0.0 else (1.0 if ball.y < 0.0 else 1.0)",
        ),
        ("penalties", "-side * 0.5 * pi", "side * 0.5 * pi"),
    ],
    PENALTIES + "without_pardon_the_clock_runs_on_through_a_kick_off": [
        ("penalties", "k.rules_pardon == 0 or events.restart != KICK_OFF", "events.restart != KICK_OFF"),
    ],
    PENALTIES + "half_time_ends_penalties_too_and_a_dropped_ball_does_not": [
        ("penalties", "k.rules_pardon == 0 or events.restart != KICK_OFF", "k.rules_pardon == 0"),
    ],
    PENALTIES + "with_no_room_on_that_side_it_comes_back_on_the_other_clear_of_the_ball": [
        ("penalties", "aside < 0.0", "False"),
        ("penalties", "length(ball.x - x, ball.y - y) < k.body_reach + k.ball_radius + MARGIN", "False"),
    ],
    PENALTIES + "where_somebody_stands_it_comes_back_beside_towards_its_own_goal": [
        ("penalties", "-ahead * step * STEP_ASIDE", "ahead * step * STEP_ASIDE"),
        (
            "penalties",
            "other != r and robots[other].active == 1 and far < 2.0 * k.body_reach + MARGIN",
            "other != r and far < 0.0",
        ),
    ],
    PENALTIES + "legs_that_were_caught_come_free": [
        ("penalties", "robots[other].caught_by = 0", "pass"),
    ],
    PENALTIES + "removal_time_zero_puts_it_back_at_once": [
        ("penalties", "seconds <= 0.0", "False"),
    ],
}
IN_CALLS: By = {
    OUT_OF_PLAY + "the_whole_ball_must_be_over_the_touchline": [
        ("out of play", "abs(ball.y) > 0.5 * k.pitch_width + k.ball_radius", "abs(ball.y) > 0.5 * k.pitch_width"),
    ],
    OUT_OF_PLAY + "the_whole_ball_must_be_over_the_goal_line": [
        (
            "out of play",
            "abs(ball.x) > 0.5 * k.pitch_length + k.ball_radius",
            "abs(ball.x) > 0.5 * k.pitch_length",
            "out_of_play",
        ),
    ],
    OUT_OF_PLAY + "over_the_touchline_it_is_a_throw_in_by_the_other_team_where_it_went_out": [
        ("throw-in", "other_team(last) if last != NO_TEAM else defender", "defender"),
    ],
    OUT_OF_PLAY + "a_ball_that_nobody_touched_goes_to_the_defenders": [
        ("throw-in", "other_team(last) if last != NO_TEAM else defender", "other_team(last)"),
    ],
    OUT_OF_PLAY + "near_a_corner_a_throw_in_is_taken_no_nearer_to_the_goal_line_than_a_corner_kick": [
        (
            "throw-in",
            "min(max(ball.x, -half_length + k.rules_corner_offset), half_length - k.rules_corner_offset)",
            "ball.x",
        ),
    ],
    OUT_OF_PLAY + "over_the_goal_line_it_is_a_corner_off_a_defender_and_a_goal_kick_off_an_attacker": [
        ("corner kick", "last == defender", "last != defender"),
        ("corner kick", "side_x * match.home_direction > 0.0", "side_x > 0.0"),
        ("goal kick", "side_y * k.rules_goal_kick_y", "k.rules_goal_kick_y"),
        ("corner kick", "side_y * y", "y"),
    ],
    STUCK_BALL + "a_restart_that_nobody_takes_is_no_stuck_ball": [
        ("dropped ball", "match.phase != PLAY or x * x + y * y > near * near", "x * x + y * y > near * near"),
    ],
    STUCK_BALL + "within_the_radius_it_has_stayed_and_beyond_it_it_begins_anew": [
        ("dropped ball", "x * x + y * y > near * near", "x * x > near * near"),
        ("dropped ball", "k.rules_stuck_time - 0.5 * k.dt", "k.rules_stuck_time + 0.5 * k.dt"),
    ],
    DROPPED_BALL + "without_the_rule_no_ball_is_dropped": [
        ("dropped ball", "k.rules_dropped_ball == 1 and ball_stuck(match, ball, k)", "ball_stuck(match, ball, k)"),
    ],
    GOALS + "the_whole_ball_must_cross_the_line_to_the_millimetre": [
        (
            "goals",
            "abs(ball.x) > 0.5 * k.pitch_length + k.ball_radius",
            "abs(ball.x) > 0.5 * k.pitch_length",
            "goal_scored",
        ),
    ],
    GOALS + "in_the_second_half_the_teams_have_changed_ends_and_goals_count_for_them": [
        ("goals", "(ball.x > 0.0) == (match.home_direction > 0.0)", "ball.x > 0.0"),
    ],
    GOALS + "the_scorer_is_the_robot_that_touched_the_ball_last": [
        ("goals", "events.scorer = match.last_touch_robot", "pass"),
    ],
    GOALS + "after_a_goal_the_team_that_conceded_it_kicks_off_from_the_centre": [
        (
            "goals",
            "call_restart(match, events, KICK_OFF, other_team(scorer), 0.0, 0.0)",
            "call_restart(match, events, KICK_OFF, scorer, 0.0, 0.0)",
            "give_goal",
        ),
    ],
    ANNULLED + "the_ball_of_an_annulled_goal_is_dropped_on_the_halfway_line_on_its_side": [
        ("goals that count", "ASIDE if ball.y > 0.0 else -ASIDE", "ASIDE"),
    ],
    ANNULLED + "a_kick_off_shot_gives_the_defenders_a_kick_off": [
        ("kick-off shot", "is_kick_off_shot(match, k, scorer)", "False"),
    ],
    TAKING + "an_own_goal_straight_from_a_restart_is_a_corner_kick": [
        ("indirect restarts", "is_own_goal(match, robots, scorer)", "False"),
    ],
    TAKING + "no_goal_falls_straight_from_a_restart": [
        ("indirect restarts", "is_own_goal(match, robots, scorer)", "True"),
    ],
    FREE_KICKS + "after_ten_seconds_everybody_may_play_the_ball": [
        ("restarts", "k.rules_restart_time - 0.5 * k.dt", "k.rules_restart_time + 0.5 * k.dt"),
    ],
}
IN_DROPPING: By = {
    DROPPED_BALL + "beside_the_area_it_stays_beside_it": [
        ("dropped ball", "abs(ball.x) > line and abs(ball.y) < 0.5 * width", "abs(ball.x) > line"),
    ],
    DROPPED_BALL + "before_a_goal_it_is_dropped_on_the_line_of_the_area_where_it_was": [
        ("dropped ball", "depth <= 0.0", "False"),
    ],
    DROPPED_BALL + "from_a_board_it_is_taken_straight_out_by_030_m_at_most_and_from_a_corner_out_of_both": [
        ("dropped ball", "min(k.rules_drop_way / way, 1.0)", "1.0"),
        ("dropped ball", "2.0 * k.body_reach + k.ball_radius", "2.0 * k.body_reach"),
        ("dropped ball", "ball.y - side_y * share * y", "ball.y - share * y"),
    ],
}
IN_SHOOT_OUT: By = {
    SHOOT_OUT + "a_match_that_is_won_ends_and_so_does_a_draw_without_the_rule": [
        ("shoot-out", "k.rules_shoot_out == 1 and match.score[HOME] == match.score[AWAY]", "k.rules_shoot_out == 1"),
        (
            "shoot-out",
            "k.rules_shoot_out == 1 and match.score[HOME] == match.score[AWAY]",
            "match.score[HOME] == match.score[AWAY]",
        ),
    ],
    SHOOT_OUT + "goals_of_it_count_apart_and_teams_take_turns": [
        ("shoot-out", "match.shoot_out % 2 == 1", "True"),
    ],
    SHOOT_OUT + "a_goal_counts_until_its_time_is_up": [
        ("shoot-out", "k.rules_shoot_out_time - 0.5 * k.dt", "k.rules_shoot_out_time + 0.5 * k.dt"),
        (
            "shoot-out",
            "in_goal and not late and ball.x * direction_of(match, team) > 0.0",
            "in_goal and ball.x * direction_of(match, team) > 0.0",
        ),
    ],
    SHOOT_OUT + "the_own_goal_is_a_miss": [
        ("shoot-out", "in_goal and not late and ball.x * direction_of(match, team) > 0.0", "in_goal and not late"),
    ],
    SHOOT_OUT + "a_kick_that_nobody_takes_is_missed_after_ten_seconds": [
        (
            "shoot-out",
            "match.phase == PLAY and ball.vx * ball.vx + ball.vy * ball.vy < AT_REST * AT_REST",
            "ball.vx * ball.vx + ball.vy * ball.vy < AT_REST * AT_REST",
        ),
    ],
    SHOOT_OUT + "a_ball_that_comes_to_rest_is_missed": [
        (
            "shoot-out",
            "ball.vx * ball.vx + ball.vy * ball.vy < AT_REST * AT_REST",
            "ball.vx * ball.vx < AT_REST * AT_REST",
        ),
        ("shoot-out", "AT_REST = 0.05", "AT_REST = 0.06"),
    ],
    SHOOT_OUT + "when_it_is_decided": [
        ("shoot-out", "lead > left_second or -lead > left_first", "lead > left_second"),
        ("shoot-out", "(taken + 1) // 2", "taken // 2"),
        (
            "shoot-out",
            "taken % 2 == 0 and (lead != 0 or taken >= 2.0 * k.rules_shoot_out_most)",
            "lead != 0 or taken >= 2.0 * k.rules_shoot_out_most",
        ),
        ("shoot-out", "taken >= 2.0 * k.rules_shoot_out_most", "False"),
    ],
}
IN_AREAS: By = {
    AREAS + "only_the_goalkeeper_stays_in_a_goal_area": [
        ("goal area", "inside and abs(robot.y) < 0.5 * width", "inside"),
    ],
    AREAS + "opponents_may_stay_in_a_penalty_area": [
        ("penalty area", "-direction_of(match, team) * robot.x", "abs(robot.x)"),
    ],
}
PARTS = {
    "fouls/goals": IN_FOULS_GOALS,
    "fouls/penalties": IN_FOULS_PENALTIES,
    "calls": IN_CALLS,
    "dropping": IN_DROPPING,
    "shoot_out": IN_SHOOT_OUT,
    "areas": IN_AREAS,
}
MUTANTS = mutants_of(FOLDER, PARTS)
