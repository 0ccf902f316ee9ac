"""Mutants of the fouls of the middle size, by the test that must notice."""

from tests.mutation.mutant import By, mutants_of

FOLDER = "soccer_env/referee/fouls/middle_size/"
TAKING = "tests/referee/fouls/middle_size/test_taking.py::test_"
FREE_KICKS = "tests/referee/fouls/middle_size/test_free_kicks.py::test_"
CHARGING = "tests/referee/fouls/middle_size/test_charging.py::test_"
HANDLING = "tests/referee/fouls/middle_size/test_handling.py::test_"
AREAS = "tests/referee/fouls/middle_size/test_areas.py::test_"
CARDS = "tests/referee/fouls/middle_size/test_cards.py::test_"

IN_TAKING: By = {
    TAKING + "a_second_touch_by_the_taker_is_a_free_kick_for_the_others_where_it_stands": [
        ("second touch", "k.rules_touch_break - 0.5 * k.dt", "k.rules_touch_break + 0.5 * k.dt"),
        ("second touch", "again or x * x + y * y > far * far", "x * x + y * y > far * far"),
        ("second touch", "match.taker_clock += k.dt", "pass"),
    ],
    TAKING + "in_one_touch_the_ball_may_be_pushed_half_a_metre": [
        ("second touch", "again or x * x + y * y > far * far", "again"),
    ],
    TAKING + "once_a_mate_or_an_opponent_has_touched_it_the_taker_may_again": [
        ("second touch", "r != match.taker and touches(robot_events[r])", "False"),
    ],
    TAKING + "no_goal_falls_straight_from_a_restart": [
        ("indirect restarts", "0 if allows_goal(k, match.phase) else 1", "0"),
        ("indirect restarts", "k.rules_direct_corner_kick == 1", "True"),
        ("indirect restarts", "k.rules_direct_throw_in == 1", "True"),
    ],
    TAKING + "a_kick_is_a_touch_though_the_ball_is_gone_at_once": [
        ("indirect restarts", "robot_event.touch == 1 or robot_event.kick == 1", "robot_event.touch == 1"),
    ],
}
IN_DISTANCES: By = {
    FREE_KICKS + "an_opponent_that_stays_too_near_for_a_second_is_put_back": [
        ("distance", "k.rules_distance_time - 0.5 * k.dt", "k.rules_distance_time + 0.5 * k.dt"),
        (
            "distance",
            "distance_from_ball(match, robot, k) - k.rules_distance_slack",
            "distance_from_ball(match, robot, k)",
        ),
    ],
    FREE_KICKS + "the_goalkeeper_may_stay_in_its_goal_area_and_mates_where_they_like": [
        ("distance", "robot.team == match.restart_team or robot.active == 0", "robot.active == 0"),
        ("distance", "not near or (robot.keeper == 1 and in_goal_area(match, robot, robot.team, k))", "not near"),
        (
            "distance",
            "not near or (robot.keeper == 1 and in_goal_area(match, robot, robot.team, k))",
            "not near or robot.keeper == 1",
        ),
    ],
    FREE_KICKS + "who_steps_away_has_a_second_again": [
        ("distance", "robot.near_clock = 0.0", "pass"),
    ],
    FREE_KICKS + "an_opponent_that_touches_the_ball_too_early_has_it_taken_again": [
        ("distance", "touches(robot_events[r])", "False"),
    ],
}
IN_CHARGING: By = {
    CHARGING + "driving_into_an_opponent_for_two_seconds_is_a_foul": [
        ("charging", "k.rules_charging_time - 0.5 * k.dt", "k.rules_charging_time + 0.5 * k.dt"),
        (
            "charging",
            "into < k.rules_charging_speed or not touches(touching, r, other)",
            "not touches(touching, r, other)",
        ),
        ("charging", "own > k.rules_charging_exempt", "False"),
        ("charging", "max(other_vx * x + other_vy * y, 0.0)", "other_vx * x + other_vy * y"),
    ],
    CHARGING + "who_is_in_contact_already_strikes_no_hard_blow_by_driving_faster": [
        ("charging", "fresh and speed >= k.rules_charging_hard", "speed >= k.rules_charging_hard"),
    ],
    CHARGING + "a_hard_blow_is_a_foul_at_once_and_who_drives_away_softens_it": [
        ("charging", "fresh and speed >= k.rules_charging_hard", "False"),
        ("charging", "max(other_vx * x + other_vy * y, 0.0)", "0.0"),
    ],
    CHARGING + "who_touches_only_others_charges_nobody_however_near": [
        (
            "charging",
            "into < k.rules_charging_speed or not touches(touching, r, other)",
            "into < k.rules_charging_speed",
        ),
    ],
    CHARGING + "mates_may_push_each_other": [
        ("charging", "robots[other].team == robots[r].team or robots[other].active == 0", "robots[other].active == 0"),
    ],
    CHARGING + "the_robot_nearest_to_the_ball_may_fight_for_it": [
        ("charging", "speed == 0.0 or fights_for_ball(ball, robots, r, k)", "speed == 0.0"),
        ("charging", "same and length(robots[mate].x - ball.x, robots[mate].y - ball.y) < own", "False"),
    ],
    CHARGING + "driving_into_the_goalkeeper_in_its_goal_area_is_a_foul_at_once_even_for_the_ball": [
        (
            "keeper charge",
            "robots[other].keeper == 1 and in_goal_area(match, robots[other], robots[other].team, k)",
            "robots[other].keeper == 1",
        ),
        ("keeper charge", "found = CHARGES_KEEPER", "pass"),
    ],
    CHARGING + "both_can_be_switched_off": [
        ("keeper charge", "keeper and k.rules_keeper_charge == 1", "keeper"),
    ],
}
IN_HANDLING: By = {
    HANDLING + "more_than_a_third_for_longer_than_a_stop_takes_is_a_foul": [
        ("ball handling", "k.rules_handling_time - 0.5 * k.dt", "k.rules_handling_time + 0.5 * k.dt"),
    ],
    HANDLING + "dribbling_is_limited_to_three_metres_only_if_asked": [
        ("ball handling", "max(-speed, 0.0)", "abs(speed)"),
        (
            "dribble limit",
            "robot.dribbled > k.rules_dribble_distance",
            "robot.dribbled > 2.0 * k.rules_dribble_distance",
        ),
    ],
    HANDLING + "going_back_with_the_ball_for_more_than_half_a_metre_is_a_foul": [
        ("ball handling", "late or robot.backed > k.rules_handling_back", "late"),
    ],
    HANDLING + "who_lets_the_ball_out_begins_anew": [
        (
            "ball handling",
            "robot.handling + k.dt if deep else 0.0",
            "robot.handling + k.dt if deep else robot.handling",
        ),
    ],
    HANDLING + "a_ball_beside_the_guide_or_behind_the_robot_lies_outside": [
        ("ball handling", "abs(left) > k.body_tip_y or ahead < k.body_disc_x", "ahead < k.body_disc_x"),
    ],
    HANDLING + "a_robot_that_loses_the_ball_begins_anew": [
        ("ball handling", "robots[r].handling = robots[r].backed = robots[r].dribbled = 0.0", "pass"),
    ],
}
IN_AREAS: By = {
    AREAS + "only_the_goalkeeper_stays_in_a_goal_area": [
        ("goal area", "k.rules_area_time - 0.5 * k.dt", "k.rules_area_time + 0.5 * k.dt"),
        (
            "goal area",
            "trespasses and not (robot.keeper == 1 and in_goal_area(match, robot, robot.team, k))",
            "trespasses and not robot.keeper == 1",
        ),
        (
            "goal area",
            "trespasses and not (robot.keeper == 1 and in_goal_area(match, robot, robot.team, k))",
            "trespasses",
        ),
        (
            "goal area",
            "in_goal_area(match, robot, HOME, k) or in_goal_area(match, robot, AWAY, k)",
            "in_goal_area(match, robot, HOME, k)",
        ),
    ],
    AREAS + "who_leaves_the_goal_area_begins_anew": [
        (
            "goal area",
            "robot.area_clock + k.dt if trespasses else 0.0",
            "robot.area_clock + k.dt if trespasses else robot.area_clock",
        ),
        ("goal area", "robot.area_clock = robot.crowd_clock = 0.0", "pass"),
    ],
    AREAS + "one_field_player_is_in_its_own_penalty_area_beside_the_goalkeeper": [
        (
            "penalty area",
            "robots[r].keeper == 1 or not in_penalty_area(match, robots[r], robots[r].team, k)",
            "not in_penalty_area(match, robots[r], robots[r].team, k)",
        ),
        ("penalty area", "nearer and in_penalty_area(match, robots[mate], robots[mate].team, k)", "nearer"),
    ],
    AREAS + "a_goalkeeper_and_an_opponent_in_its_own_area_crowd_nobody_though_nearer_to_the_ball": [
        (
            "penalty area",
            "mate == r or robots[mate].team != robots[r].team or robots[mate].active == 0 or robots[mate].keeper == 1",
            "mate == r or robots[mate].team != robots[r].team or robots[mate].active == 0",
        ),
        (
            "penalty area",
            "mate == r or robots[mate].team != robots[r].team or robots[mate].active == 0 or robots[mate].keeper == 1",
            "mate == r or robots[mate].active == 0 or robots[mate].keeper == 1",
        ),
    ],
    AREAS + "the_one_nearest_to_the_ball_may_stay_and_the_other_is_guilty": [
        (
            "penalty area",
            "nearer and in_penalty_area(match, robots[mate], robots[mate].team, k)",
            "in_penalty_area(match, robots[mate], robots[mate].team, k)",
        ),
    ],
}
IN_FREE_KICKS: By = {
    FREE_KICKS + "opponents_are_a_metre_away_and_the_taker_behind_the_ball_once_it_is_given": [
        ("free kick", "other_team(culprit_team)", "culprit_team"),
    ],
    FREE_KICKS + "it_is_taken_where_the_foul_was_on_the_pitch_and_out_of_the_goal_areas": [
        ("free kick", "line if x > 0.0 else -line", "line"),
        ("free kick", "abs(x) > line and abs(y) < 0.5 * k.pitch_goal_area_width", "abs(x) > line"),
        ("free kick", "clip(y, -edge_y, edge_y)", "y"),
    ],
}
IN_CARDS: By = {
    CARDS + "every_third_foul_is_a_yellow_card_and_the_sixth_the_end": [
        ("cards", "robots[r].fouls % k.rules_card_fouls != 0.0", "robots[r].fouls < k.rules_card_fouls"),
        ("cards", "robots[r].yellow % 2 == 1", "True"),
        ("cards", "robot_events[r].card = YELLOW", "pass"),
    ],
    CARDS + "a_hard_foul_is_a_yellow_card_at_once": [
        (
            "cards",
            "not hard and robots[r].fouls % k.rules_card_fouls != 0.0",
            "robots[r].fouls % k.rules_card_fouls != 0.0",
        ),
    ],
    CARDS + "who_came_back_begins_with_a_yellow_card_again": [
        ("cards", "robots[r].yellow % 2 == 1", "robots[r].yellow == 1"),
    ],
    CARDS + "the_timed_variant_lets_it_come_back_after_its_time": [
        ("cards", "k.rules_card_time if k.rules_timed_cards == 1 else inf", "inf"),
    ],
}
IN_BOOK: By = {
    TAKING + "a_second_touch_in_a_shoot_out_ends_the_kick": [
        ("shoot-out", "match.shoot_out == 0", "True"),
    ],
    TAKING + "a_foul_lets_everybodys_clocks_begin_anew": [
        ("free kick", "forget(robots)", "pass"),
    ],
    CHARGING + "a_goal_in_the_same_step_is_annulled": [
        ("goals that count", "1 if goal_scored(ball, k) else 0", "0"),
    ],
    FREE_KICKS + "an_opponent_that_stays_too_near_for_a_second_is_put_back": [
        ("cards", "book(robots, robot_events, row, False, k)", "pass"),
        ("distance", "put_back(match, robots, row, k)", "pass"),
    ],
    FREE_KICKS + "an_opponent_that_touches_the_ball_too_early_has_it_taken_again": [
        ("distance", "call_restart(match, events, match.phase, match.restart_team, x, y)", "pass"),
    ],
}
PARTS = {
    "taking": IN_TAKING,
    "distances": IN_DISTANCES,
    "charging": IN_CHARGING,
    "handling": IN_HANDLING,
    "areas": IN_AREAS,
    "free_kicks": IN_FREE_KICKS,
    "cards": IN_CARDS,
    "book": IN_BOOK,
}
MUTANTS = mutants_of(FOLDER, PARTS)
