"""Mutants of the potential field of sacks-2001: forces, limits of the way, steps, and the point simulator."""

from tests.mutant import Mutant

FORCES, STEERING = "baselines/sacks_2001/forces.py", "baselines/sacks_2001/steering.py"
SETTINGS, POINTS = "baselines/sacks_2001/settings.py", "baselines/sacks_2001/point_world.py"
TEST = "tests/baselines/test_sacks_field.py::"

MUTANTS = [
    Mutant(
        "MS38",
        FORCES,
        "        return play.goal_gain * dx, play.goal_gain * dy",
        "        return dx, dy",
        TEST + "test_ms38_the_theorys_forces_are_khatibs",
    ),
    Mutant(
        "MS38",
        FORCES,
        "    size = max(gain * (1.0 / x - beyond), 0.0)",
        "    size = gain / x",
        TEST + "test_ms38_the_theorys_forces_are_khatibs",
    ),
    Mutant(
        "MS38",
        FORCES,
        "    beyond = 1.0 / far if play.cut_off == 1 else 0.0",
        "    beyond = 0.0",
        TEST + "test_ms38_beyond_the_greatest_distance_nobody_repels",
    ),
    Mutant(
        "MS39",
        FORCES,
        "    for _ in range(play.exponent - 1):",
        "    for _ in range(2):",
        TEST + "test_ms39_the_exponent_is_that_of_the_settings",
    ),
    Mutant(
        "MS40",
        FORCES,
        "    if play.goal_force == PROPORTIONAL:",
        "    if play.goal_force >= 0:",
        TEST + "test_ms40_the_goal_pulls_equally_from_everywhere",
    ),
    Mutant(
        "MS41",
        FORCES,
        "    if play.cosine_factor == 1:",
        "    if play.cosine_factor == 2:",
        TEST + "test_ms41_nobody_beside_or_behind_repels",
    ),
    Mutant(
        "MS42",
        SETTINGS,
        "    player_gain: float = 0.8 ",
        "    player_gain: float = 0.2 ",
        TEST + "test_ms42_a_player_repels_as_much_as_the_goal_pulls_at_444_mm",
    ),
    Mutant(
        "MS43",
        FORCES,
        "    if play.walls == 0:",
        "    if play.walls >= 0:",
        TEST + "test_ms43_side_walls_push_straight_off_and_less_than_players",
    ),
    Mutant(
        "MS43",
        STEERING,
        "    push_y += wall_force(own.y, 0.5 * k.pitch_width, play)",
        "    push_y += 0.0",
        TEST + "test_ms43_side_walls_push_straight_off_and_less_than_players",
    ),
    Mutant(
        "MS44",
        FORCES,
        "    size = repulsion(away, play.player_gain, play.player_range, play)",
        "    size = repulsion(away - 0.1, play.player_gain, play.player_range, play)",
        TEST + "test_ms44_players_are_points_whatever_way_they_face",
    ),
    Mutant(
        "MS45",
        SETTINGS,
        "    replan: float = 0.5 ",
        "    replan: float = 0.0625 ",
        TEST + "test_ms45_steps_of_3_5_cm_and_a_decision_each_half_second",
    ),
    Mutant(
        "MS45",
        STEERING,
        "    return play.step_length / max(k.gait_steps * k.dt, k.dt)",
        "    return k.drive_forward",
        TEST + "test_ms45_steps_of_3_5_cm_and_a_decision_each_half_second",
    ),
    Mutant(
        "MS46",
        STEERING,
        "    if play.clamp == 0 or abs(off) <= play.goal_limit:",
        "    if play.clamp >= 0:",
        TEST + "test_ms46_the_way_is_never_more_than_70_degrees_off_the_goal",
    ),
    Mutant(
        "MS47",
        STEERING,
        "    if play.keep_side == 1 and side != 0.0 and against:",
        "    if play.keep_side == 2 and side != 0.0 and against:",
        TEST + "test_ms47_pushed_mostly_back_it_stays_on_its_side",
    ),
    Mutant(
        "MS48",
        STEERING,
        "    if play.body_clamp == 0:",
        "    if play.body_clamp >= 0:",
        TEST + "test_ms48_at_most_45_degrees_off_the_body_or_55_past_a_player_ahead",
    ),
    Mutant(
        "MS48",
        STEERING,
        "    limit = play.blocked_limit if is_blocked(belief, tracks, play) else play.body_limit",
        "    limit = play.body_limit",
        TEST + "test_ms48_at_most_45_degrees_off_the_body_or_55_past_a_player_ahead",
    ),
    Mutant(
        "MS49",
        STEERING,
        " and slot != replaced:",
        " and slot >= 0:",
        TEST + "test_ms49_the_rangers_obstacle_stands_in_for_one_player",
    ),
    Mutant(
        "MS49",
        STEERING,
        "    if play.infrared_obstacle == 1 and belief.obstacle.distance > 0.0:",
        "    if play.infrared_obstacle == 2 and belief.obstacle.distance > 0.0:",
        TEST + "test_ms49_the_rangers_obstacle_stands_in_for_one_player",
    ),
    Mutant(
        "MS54",
        POINTS,
        "            choose_way(belief[0], tracks, memory[0], k, play)",
        "            memory[0].way = own.heading",
        TEST + "test_ms54_points_go_as_the_teams_own_forces_say",
    ),
    Mutant(
        "MS54",
        POINTS,
        "            move_players(crowd, own, play.replan)",
        "            pass",
        TEST + "test_ms54_players_move_straight_on_or_come_for_the_dribbler",
    ),
    Mutant(
        "MS54",
        POINTS,
        "put_track(tracks[p], errors[p] * length(dx, dy), ",
        "put_track(tracks[p], length(dx, dy), ",
        TEST + "test_ms54_noise_and_false_blobs_are_what_the_robot_sees_not_what_is_there",
    ),
    Mutant(
        "MS54",
        POINTS,
        "        if body:",
        "        if body and False:",
        TEST + "test_ms54_a_body_that_faces_the_goal_keeps_its_steps_within_the_bodys_limit",
    ),
]
