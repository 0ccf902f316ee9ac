"""Mutants of the stuck counters, the recovery and the referee who pulls robots apart: see mutants.py."""

from tests.mutation.mutant import Mutant

STUCK = "baselines/sacks_2001/stuck.py"
RECOVERY = "baselines/sacks_2001/recovery.py"
PLANNER = "baselines/sacks_2001/planner.py"
SEPARATION = "soccer_env/referee/separation.py"
TEST_STUCK = "tests/baselines/sacks_2001/test_stuck.py::"
TEST_RECOVERY = "tests/baselines/sacks_2001/test_recovery.py::"
TEST_SEPARATION = "tests/referee/test_separation.py::"

MUTANTS = [
    Mutant(
        "MS19",
        STUCK,
        "memory.stuck += 1",
        "memory.stuck += 0",
        TEST_STUCK + "test_ms19_a_ball_that_does_not_come_nearer_is_counted_until_the_robot_is_stuck",
    ),
    Mutant(
        "MS19",
        STUCK,
        "max(memory.stuck - 1, 0)",
        "memory.stuck - 1",
        TEST_STUCK + "test_ms19_a_ball_that_clearly_comes_nearer_is_taken_off_and_the_count_is_never_below_zero",
    ),
    Mutant(
        "MS19",
        STUCK,
        "ball.radial < -play.clearly",
        "ball.radial < -play.near_zero",
        TEST_STUCK + "test_ms19_between_the_bands_the_count_rests",
    ),
    Mutant(
        "MS19",
        STUCK,
        "ball.radial < -play.clearly",
        "ball.radial < -play.clearly - 0.05 * ball.filtered_distance * ball.filtered_distance",
        TEST_STUCK + "test_ms19_however_wrong_velocities_are_the_count_falls_for_who_walks_and_rises_for_who_stands",
    ),
    Mutant(
        "MS20",
        STUCK,
        "play.two_counters == 0",
        "play.two_counters <= 1",
        TEST_STUCK + "test_ms20_near_the_ball_both_counters_must_agree",
    ),
    Mutant(
        "MS20",
        STUCK,
        "max(memory.near - elapsed, 0.0)",
        "0.0",
        TEST_STUCK + "test_ms20_the_second_counter_is_time_within_35_cm_of_the_camera_and_time_beyond_is_taken_off",
    ),
    Mutant(
        "MS20",
        STUCK,
        "distance * cos(bearing) - k.head_camera_ahead",
        "distance * cos(bearing)",
        TEST_STUCK + "test_ms20_the_second_counter_is_time_within_35_cm_of_the_camera_and_time_beyond_is_taken_off",
    ),
    Mutant(
        "MS20",
        STUCK,
        "from_camera(ball.filtered_distance, ball.filtered_bearing, k) < play.near",
        "from_camera(ball.distance, ball.bearing, k) < play.near",
        TEST_STUCK + "test_ms20_one_reading_beyond_35_cm_neither_ends_the_time_nor_makes_a_robot_think_itself_stuck",
    ),
    Mutant(
        "MS21",
        STUCK,
        "clip(gap / max(play.near, ROUNDING), play.near_step, 1.0)",
        "play.near_step if gap < play.near else 1.0",
        TEST_STUCK + "test_ms21_within_35_cm_steps_shrink_with_the_distance_until_the_ball_hardly_comes_nearer",
    ),
    Mutant(
        "MS21",
        PLANNER,
        "if memory.had_ball < play.possession_time:\n    share = 1.0",
        "pass",
        TEST_STUCK + "test_ms21_who_has_just_had_the_ball_walks_on_at_full_pace",
    ),
    Mutant(
        "MS22",
        PLANNER,
        "choose_role(belief, memory, play, elapsed)",
        "choose_role(belief, memory, play, elapsed)\nwatch_approach(ball, memory, k, play, elapsed)",
        TEST_STUCK + "test_ms22_only_who_tries_to_get_to_the_ball_counts",
    ),
    Mutant(
        "MS22",
        PLANNER,
        "if memory.clock >= REALLY_HAS:\n    forget_approach(memory)\nmemory.tries = 0",
        "if memory.clock >= REALLY_HAS:\n    memory.tries = 0",
        TEST_STUCK + "test_ms22_who_went_on_to_something_else_begins_to_count_anew",
    ),
    Mutant(
        "MS22",
        PLANNER,
        "forget_approach(memory)\nreturn waits",
        "return waits",
        TEST_STUCK + "test_ms22_who_went_on_to_something_else_begins_to_count_anew",
    ),
    Mutant(
        "MS23",
        RECOVERY,
        "play.back_steps * k.gait_steps * k.dt",
        "0.0",
        TEST_RECOVERY + "test_ms23_a_stuck_robot_takes_ten_steps_back_then_one_aside_then_goes_to_the_ball",
    ),
    Mutant(
        "MS23",
        RECOVERY,
        "memory.tries += 1",
        "memory.tries = 1",
        TEST_RECOVERY + "test_ms23_it_does_so_again_if_it_is_stuck_again_and_counts_the_tries",
    ),
    Mutant(
        "MS23",
        PLANNER,
        "play.recovery == 1 and is_stuck(belief.ball, memory, k, play)",
        "is_stuck(belief.ball, memory, k, play)",
        TEST_RECOVERY + "test_ms23_without_recovery_it_pushes_on_for_ever",
    ),
    Mutant(
        "MS24",
        RECOVERY,
        "side_to_step(belief, tracks, k, play)",
        "1.0",
        TEST_RECOVERY + "test_ms24_the_step_aside_brings_the_ball_between_the_robot_and_the_goal",
    ),
    Mutant(
        "MS25",
        RECOVERY,
        "abs(bearing) > play.rotate_beyond",
        "abs(bearing) > 10.0",
        TEST_RECOVERY + "test_ms25_a_ball_more_than_30_degrees_aside_is_turned_to_instead",
    ),
    Mutant(
        "MS25",
        RECOVERY,
        "abs(bearing) < FACING",
        "abs(bearing) < 0.0",
        TEST_RECOVERY + "test_ms25_one_that_faces_the_ball_goes_to_it",
    ),
    Mutant(
        "MS55",
        SEPARATION,
        "robot.locked += k.dt",
        "robot.locked = 0.0",
        TEST_SEPARATION + "test_ms55_robots_that_push_against_each_other_are_pulled_apart_after_the_set_time",
    ),
    Mutant(
        "MS55",
        SEPARATION,
        "k.rules_contact_time - 0.5 * k.dt",
        "15.0",
        TEST_SEPARATION + "test_ms55_with_an_infinite_time_they_are_left_alone",
    ),
]
