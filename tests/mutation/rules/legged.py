"""Mutants of the fouls of the legged league, by the test that must notice."""

from tests.mutation.mutant import By, mutants_of

FOLDER = "soccer_env/referee/fouls/legged/"
PUSHING = "tests/referee/fouls/legged/test_pushing.py::test_"
KEEPER_PUSHING = "tests/referee/fouls/legged/test_keeper_pushing.py::test_"
HOLDING = "tests/referee/fouls/legged/test_holding.py::test_"
AREAS = "tests/referee/fouls/legged/test_areas.py::test_"
FALLING = "tests/referee/fouls/legged/test_falling.py::test_"
STUCK = "tests/referee/fouls/legged/test_stuck.py::test_"
ANNULLED = "tests/referee/fouls/test_goals.py::test_"

IN_CONTACT: By = {
    PUSHING + "short_pushes_count_as_one_unless_it_lets_go_for_as_long": [
        ("pushing", "clock + dt if runs else max(clock - dt, 0.0)", "clock + dt if runs else 0.0"),
        ("pushing", "clock + dt if runs else max(clock - dt, 0.0)", "clock + dt if runs else clock"),
    ],
    PUSHING + "mates_may_push_each_other": [
        ("pushing", "robots[r].team == robots[other].team", "False", "note_pushes"),
    ],
    PUSHING + "a_walk_leads_into_another_from_a_quarter_of_the_top_speed_on": [
        ("pushing", "press_of(robot, other) > PRESS * k.drive_forward", "True"),
    ],
    KEEPER_PUSHING + "a_mate_of_the_goalkeeper_may_push_it_and_so_may_an_opponent_out_of_its_area": [
        (
            "goalkeeper pushing",
            "robots[other].keeper == 1 and in_own_area(match, robots[other], k, 1)",
            "robots[other].keeper == 1",
        ),
    ],
    KEEPER_PUSHING + "one_foot_of_a_goalkeeper_counts_and_no_field_player_is_one": [
        (
            "goalkeeper pushing",
            "robots[other].keeper == 1 and in_own_area(match, robots[other], k, 1)",
            "in_own_area(match, robots[other], k, 1)",
        ),
        ("goalkeeper pushing", "in_own_area(match, robots[other], k, 1)", "in_own_area(match, robots[other], k, 2)"),
    ],
    KEEPER_PUSHING + "a_goalkeeper_is_pushed_through_the_ball_too": [
        ("goalkeeper pushing", "robots[r].keeper == 1 and robot_events[r].touch == 1", "False"),
    ],
    KEEPER_PUSHING + "only_a_ball_between_the_two_hands_a_push_on": [
        ("goalkeeper pushing", "x * (robots[keeper].x - ball.x) + y * (robots[keeper].y - ball.y) > 0.0", "True"),
    ],
}
IN_PUSHING: By = {
    PUSHING + "three_seconds_are_legal_and_one_step_more_is_not": [
        ("pushing", "k.rules_pushing_time + 0.5 * k.dt", "k.rules_pushing_time - 0.5 * k.dt"),
    ],
    PUSHING + "the_robot_nearest_to_the_ball_may_push_within_50_cm": [
        (
            "pushing",
            "robot_events[r].pushes > 0 and not is_exempt(match, ball, robots, r, k)",
            "robot_events[r].pushes > 0",
        ),
        ("pushing", "mine > k.rules_pushing_exempt * k.rules_pushing_exempt", "False"),
    ],
    PUSHING + "a_goalkeeper_with_two_feet_in_its_own_area_may_push": [
        ("pushing", "robots[r].keeper == 1 and in_own_area(match, robots[r], k, FEET)", "False"),
    ],
    PUSHING + "the_second_nearest_of_a_team_may_not_while_the_nearest_of_the_other_may": [
        ("pushing", "robots[mate].active == 1 and robots[mate].team == robots[r].team", "robots[mate].active == 1"),
        ("pushing", "plays and square_to_ball(ball, robots[mate]) < mine", "False"),
    ],
}
IN_KEEPER_PUSHING: By = {
    KEEPER_PUSHING + "one_second_is_legal_and_one_step_more_is_not_even_for_the_robot_nearest_to_the_ball": [
        ("goalkeeper pushing", "k.rules_keeper_pushing_time + 0.5 * k.dt", "k.rules_keeper_pushing_time - 0.5 * k.dt"),
    ],
    KEEPER_PUSHING + "a_second_attacker_that_joins_is_removed_immediately_and_the_first_after_its_second": [
        ("goalkeeper pushing", "joins(robots, robot_events, r, k)", "False", "judge_keeper_pushing"),
    ],
    KEEPER_PUSHING + "who_comes_after_a_mate_joins_it_and_of_two_that_come_at_once_neither_does": [
        ("goalkeeper pushing", "robots[mate].keeper_pushing > robots[r].keeper_pushing + 0.5 * k.dt", "True"),
    ],
}
IN_HOLDING: By = {
    HOLDING + "the_full_time_is_legal_and_one_step_more_is_not": [
        ("ball holding", "time_to_hold(match, robot, k) + 0.5 * k.dt", "time_to_hold(match, robot, k) - 0.5 * k.dt"),
    ],
    HOLDING + "the_goalkeeper_has_five_seconds_in_its_area_and_comes_back_at_once": [
        ("ball holding", "robot.keeper == 1 and in_own_area(match, robot, k, 1)", "robot.keeper == 1"),
    ],
    HOLDING + "a_ball_that_an_opponent_touches_is_not_trapped": [
        ("ball holding", "robots[other].team != robots[r].team and robot_events[other].touch == 1", "False"),
    ],
    HOLDING + "a_ball_that_is_walked_ahead_with_or_stood_before_is_never_held": [
        (
            "ball holding",
            "robot.has_ball == 1 and not ahead and moves(robot, k)",
            "robot.has_ball == 1 and moves(robot, k)",
        ),
    ],
    HOLDING + "who_stands_with_it_neither_holds_on_nor_lets_go_and_who_walks_ahead_lets_go": [
        ("ball holding", "robot.has_ball == 1 and not ahead and moves(robot, k)", "robot.has_ball == 1 and not ahead"),
        ("ball holding", "KEPT if robot.has_ball == 1 and not ahead else FREE", "FREE"),
    ],
    HOLDING + "a_ball_that_a_robot_covers_in_a_corner_is_trapped_though_it_walks_ahead": [
        ("ball holding", "is_covered(robot, ball, k)", "False", "way_of_ball"),
    ],
    HOLDING + "a_ball_that_goes_along_though_the_robot_does_not_walk_ahead_is_held_for_three_seconds": [
        ("ball holding", "back or aside or abs(robot.walk.turn) > WALKS * k.drive_turn", "back or aside"),
        (
            "ball holding",
            "back or aside or abs(robot.walk.turn) > WALKS * k.drive_turn",
            "back or abs(robot.walk.turn) > WALKS * k.drive_turn",
        ),
        (
            "ball holding",
            "back or aside or abs(robot.walk.turn) > WALKS * k.drive_turn",
            "aside or abs(robot.walk.turn) > WALKS * k.drive_turn",
        ),
    ],
    HOLDING + "a_robot_that_has_backed_off_by_the_breadth_of_a_paw_covers_nothing": [
        (
            "ball holding",
            "outline_gap_of(robot, k, x, y, cosine, sine) >= k.body_tip_radius",
            "outline_gap_of(robot, k, x, y, cosine, sine) >= 2.0 * k.body_tip_radius",
        ),
    ],
    HOLDING + "carrying_is_a_rule_of_its_own": [
        ("carrying", "carries_too_far(robot, k)", "False", "judge_holding"),
    ],
    HOLDING + "what_it_goes_without_the_ball_is_not_carried": [
        ("carrying", "robot.carry_x, robot.carry_y = robot.x, robot.y", "pass"),
    ],
}
IN_AREAS: By = {
    AREAS + "a_field_player_with_two_feet_in_its_own_area_is_illegal": [
        ("illegal defender", "limit + 0.5 * k.dt", "limit - 0.5 * k.dt"),
        ("illegal defender", "FEET = 2", "FEET = 1"),
        ("illegal defender", "FEET = 2", "FEET = 3"),
        ("illegal defender", "abs(y) <= 0.5 * k.pitch_penalty_width", "True"),
    ],
    AREAS + "goalkeepers_and_attackers_may_be_there_and_both_teams_are_alike": [
        ("illegal defender", "robot.active == 0 or robot.keeper == 1", "robot.active == 0"),
        ("illegal defender", "-direction_of(match, robots[r].team)", "-1.0"),
    ],
    AREAS + "a_second_is_legal_and_short_visits_add_up": [
        ("illegal defender", "max(robot.trespass - k.dt, 0.0)", "0.0"),
    ],
    AREAS + "whom_an_opponent_or_the_referee_put_there_has_time_to_walk_out": [
        ("illegal defender", "robot_events[r].pushed == 1", "False"),
    ],
    AREAS + "it_is_called_though_the_goalkeeper_is_out_but_not_where_there_is_none": [
        ("illegal defender", "has_keeper(robots, robot.team)", "True"),
    ],
    AREAS + "an_attacker_may_not_camp_in_the_opponents_area_while_the_ball_is_elsewhere": [
        ("illegal attacker", "not is_inside(ball.x, ball.y, k, -end)", "True"),
        ("illegal attacker", "in_area(robot, k, -end, FEET)", "in_area(robot, k, end, FEET)"),
        (
            "illegal attacker",
            "k.rules_illegal_defender_time if foul == DEFENDER else k.rules_illegal_attacker_time",
            "k.rules_illegal_defender_time",
        ),
    ],
}
IN_LEAVING: By = {
    AREAS + "who_stands_in_a_goal_for_five_seconds_leaves_the_field_but_for_a_goalkeeper_in_its_own": [
        ("leaving the field", "k.rules_leaving_time + 0.5 * k.dt", "k.rules_leaving_time - 0.5 * k.dt"),
        (
            "leaving the field",
            "robot.keeper == 1 and robot.x * direction_of(match, robot.team) < 0.0",
            "robot.keeper == 1",
        ),
        ("leaving the field", "robot.keeper == 1 and robot.x * direction_of(match, robot.team) < 0.0", "False"),
    ],
    AREAS + "who_comes_back_onto_the_field_in_time_has_not_left_it": [
        ("leaving the field", "robot.beyond = 0.0", "pass"),
    ],
}
IN_FALLING: By = {
    FALLING + "who_lies_for_more_than_five_seconds_is_put_on_the_halfway_line_at_once": [
        ("falling", "k.rules_fallen_time + 0.5 * k.dt", "k.rules_fallen_time - 0.5 * k.dt"),
    ],
    FALLING + "who_stands_beside_a_push_does_not_fall": [
        ("falling", "robot_events[r].pushed == 1", "True"),
    ],
    FALLING + "the_impulse_is_of_opponents_that_push_nearby_as_fast_as_they_walk_towards_it": [
        (
            "falling",
            "robots[other].team != robots[r].team and robot_events[other].pushes > 0 and x * x + y * y < near * near",
            "robots[other].team != robots[r].team",
        ),
        ("falling", "share * k.body_mass * k.drive_thrust * k.dt", "k.body_mass * k.drive_thrust * k.dt"),
    ],
}
IN_STUCK: By = {
    STUCK + "a_ball_that_nobody_touches_for_30_s_gives_a_kick_off_to_those_in_whose_half_it_lies": [
        ("global game stuck", "k.rules_global_stuck_time - 0.5 * k.dt", "k.rules_global_stuck_time + 0.5 * k.dt"),
        ("global game stuck", "HOME if x * match.home_direction < 0.0 else AWAY", "HOME if x < 0.0 else AWAY"),
    ],
    STUCK + "a_dropped_ball_that_nobody_comes_for_does_not_stop_the_clock": [
        ("global game stuck", "match.phase != PLAY and match.phase != DROP_BALL", "match.phase != PLAY"),
    ],
    STUCK + "30_s_at_one_place_are_enough_and_less_is_not": [
        ("local game stuck", "k.rules_local_stuck_time - 0.5 * k.dt", "k.rules_local_stuck_time + 0.5 * k.dt"),
    ],
    STUCK + "play_that_moves_on_by_half_a_metre_is_not_stuck": [
        ("local game stuck", "x * x + y * y > far * far", "x * x > far * far"),
    ],
    STUCK + "seconds_in_which_nobody_is_at_the_ball_do_not_count_and_many_of_them_begin_anew": [
        ("local game stuck", "match.idle_clock < AT_BALL", "True"),
        ("local game stuck", "match.idle_clock > k.rules_stuck_time", "False"),
    ],
    STUCK + "a_goalkeeper_in_the_other_half_is_carried_like_anybody": [
        (
            "local game stuck",
            "robots[r].keeper == 1 and robots[r].x * direction_of(match, robots[r].team) < k.body_reach",
            "robots[r].keeper == 1",
        ),
    ],
    STUCK + "of_a_goalkeeper_in_its_own_half_the_ball_is_taken_to_the_centre_spot_instead": [
        (
            "local game stuck",
            "robots[r].keeper == 1 and robots[r].x * direction_of(match, robots[r].team) < k.body_reach",
            "False",
        ),
    ],
    STUCK + "the_robot_nearest_to_the_ball_is_carried": [
        ("local game stuck", "robots[r].active == 1 and (nearest < 0 or square < least)", "nearest < 0"),
    ],
}
IN_KICK_OFF_SHOT: By = {
    ANNULLED + "the_kicking_team_has_to_touch_the_ball_when_all_of_it_has_left_the_circle": [
        ("kick-off shot", "k.pitch_circle + k.ball_radius", "k.pitch_circle - k.ball_radius"),
        (
            "kick-off shot",
            "robots[r].team == match.kick_off_shot and robot_events[r].touch == 1",
            "robot_events[r].touch == 1",
        ),
    ],
    ANNULLED + "each_kick_off_begins_anew_and_a_scene_in_play_has_none": [
        ("kick-off shot", "match.kick_off_shot = match.restart_team", "pass"),
    ],
}
IN_BOOK: By = {
    HOLDING + "the_goalkeeper_has_five_seconds_in_its_area_and_comes_back_at_once": [
        (
            "penalties",
            "foul in (FALLEN, GAME_STUCK) or (foul == HOLDING and robots[r].keeper == 1)",
            "foul in (FALLEN, GAME_STUCK)",
        ),
    ],
    FALLING + "who_lies_for_more_than_five_seconds_is_put_on_the_halfway_line_at_once": [
        (
            "penalties",
            "foul in (FALLEN, GAME_STUCK) or (foul == HOLDING and robots[r].keeper == 1)",
            "foul == HOLDING and robots[r].keeper == 1",
        ),
    ],
    HOLDING + "a_ball_that_goes_along_though_the_robot_does_not_walk_ahead_is_held_for_three_seconds": [
        ("penalties", "foul == HOLDING and robots[r].keeper == 1", "foul == HOLDING"),
    ],
    AREAS + "who_stands_in_a_goal_for_five_seconds_leaves_the_field_but_for_a_goalkeeper_in_its_own": [
        ("leaving the field", "k.rules_leaving_field == 1", "True"),
    ],
    FALLING + "with_the_switch_off_nobody_falls": [
        ("falling", "k.rules_falling == 1", "True"),
    ],
    STUCK + "of_a_goalkeeper_in_its_own_half_the_ball_is_taken_to_the_centre_spot_instead": [
        ("global game stuck", "call_restart(match, events, DROP_BALL, NO_TEAM, 0.0, 0.0)", "pass"),
    ],
}
PARTS = {
    "contact": IN_CONTACT,
    "pushing": IN_PUSHING,
    "keeper_pushing": IN_KEEPER_PUSHING,
    "holding": IN_HOLDING,
    "areas": IN_AREAS,
    "leaving": IN_LEAVING,
    "falling": IN_FALLING,
    "stuck": IN_STUCK,
    "kick_off_shot": IN_KICK_OFF_SHOT,
    "book": IN_BOOK,
}
MUTANTS = mutants_of(FOLDER, PARTS)
