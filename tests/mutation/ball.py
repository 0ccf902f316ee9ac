"""Mutants of what a legged robot believes of the ball: its place, its way through memory, its velocity."""

from tests.mutation.mutant import Mutant

BALL, BLOB, VELOCITY = (
    "soccer_env/belief/legged/ball.py",
    "soccer_env/belief/legged/ball_blob.py",
    "soccer_env/belief/legged/velocity.py",
)
TEST_BALL, TEST_BLOB = "tests/belief/legged/test_ball.py::", "tests/belief/legged/test_ball_blob.py::"
TEST_VELOCITY = "tests/belief/legged/test_velocity.py::"

MUTANTS = [
    Mutant(
        "MS02",
        BALL,
        "(length(x, y), atan2(y, x))",
        "(x, y)",
        TEST_BALL + "test_ms02_the_ball_is_kept_in_polar_coordinates_of_the_robot",
    ),
    Mutant(
        "MS03",
        BALL,
        "max(SURE - w.fading * (frame - memory.seen) * k.dt, 0.0)",
        "SURE",
        TEST_BALL + "test_ms03_confidence_is_100_when_seen_and_fades_when_not",
    ),
    Mutant(
        "MS08",
        BLOB,
        "direction_of_pixel(u, v, pan, tilt, s)",
        "direction_of_pixel(0.0 * u, v, pan, tilt, s)",
        TEST_BLOB + "test_ms08_the_bearing_is_head_angle_plus_place_in_the_picture",
    ),
    Mutant(
        "MS08",
        BLOB,
        "(ahead + away * cos(bearing), left + away * sin(bearing))",
        "(away * cos(bearing), away * sin(bearing))",
        TEST_BLOB + "test_ms08_bearing_and_distance_count_from_the_body_not_from_the_camera",
    ),
    Mutant(
        "MS09",
        BLOB,
        "ranges[min(max(size, 0), ranges.shape[0] - 1)]",
        "14.0 / max(size, 1)",
        TEST_BLOB + "test_ms09_the_range_is_read_from_the_table_of_sizes",
    ),
    Mutant(
        "MS10",
        BLOB,
        "w.under_head == 1",
        "w.under_head == 2",
        TEST_BLOB + "test_ms10_almost_under_the_head_the_range_is_height_by_angle",
    ),
    Mutant(
        "MS11",
        BLOB,
        "min(by_height, by_width)",
        "by_height",
        TEST_BLOB + "test_ms11_a_ball_cut_in_one_dimension_keeps_its_range",
    ),
    Mutant(
        "MS11",
        BLOB,
        "min(by_height, by_width)",
        "by_width",
        TEST_BLOB + "test_ms11_a_ball_cut_in_one_dimension_keeps_its_range",
    ),
    Mutant(
        "MS12",
        BLOB,
        "w.infrared_override == 1",
        "w.infrared_override == 2",
        TEST_BLOB + "test_ms12_the_infrared_ranger_wins_over_the_size_of_a_hidden_ball",
    ),
    Mutant(
        "MS12",
        BLOB,
        "w.infrared_share * by_size",
        "by_size",
        TEST_BLOB + "test_ms12_a_reading_above_two_thirds_changes_nothing",
    ),
    Mutant(
        "MS12",
        BLOB,
        "percept.infrared <= 0.0 or not beam_is_on(blob, s, w)",
        "percept.infrared <= 0.0",
        TEST_BLOB + "test_ms12_the_beam_must_be_on_the_ball",
    ),
    Mutant(
        "MS13",
        BLOB,
        "elevation > w.horizon_angle",
        "False",
        TEST_BLOB + "test_ms13_what_lies_much_above_the_horizontal_is_no_ball",
    ),
    Mutant(
        "MS14",
        BLOB,
        "w.double_area == 1",
        "w.double_area == 2",
        TEST_BLOB + "test_ms14_after_a_near_sighting_a_small_patch_is_no_ball",
    ),
    Mutant(
        "MS14",
        BALL,
        "length(np.float64(memory.x), np.float64(memory.y)) < w.area_near",
        "True",
        TEST_BLOB + "test_ms14_after_a_far_sighting_or_a_long_time_it_is",
    ),
    Mutant(
        "MS15",
        BALL,
        "w.odometry == ROTATION",
        "w.odometry == FULL",
        TEST_BALL + "test_ms15_a_still_ball_is_where_it_was_after_a_walk_out_of_sight",
    ),
    Mutant(
        "MS15",
        BALL,
        "w.odometry_while_dribbling == 0",
        "w.odometry_while_dribbling == 2",
        TEST_BALL + "test_ms15_a_dribbled_ball_comes_along",
    ),
    Mutant(
        "MS16",
        BALL,
        "min(memory.count + 1, w.averaged)",
        "1",
        TEST_BALL + "test_ms16_the_filtered_place_is_the_mean_of_the_last_four_in_cartesian_coordinates",
    ),
    Mutant(
        "MS17",
        VELOCITY,
        "period == memory.period",
        "period < 0",
        TEST_VELOCITY + "test_ms17_a_velocity_every_third_of_a_second",
    ),
    Mutant(
        "MS17",
        VELOCITY,
        "w.velocity_gate == 0",
        "w.velocity_gate < 2",
        TEST_VELOCITY + "test_ms17_after_more_than_a_second_and_a_half_the_place_is_only_stored",
    ),
    Mutant(
        "MS17",
        VELOCITY,
        "interval + ROUNDING",
        "99.0",
        TEST_VELOCITY + "test_ms17_a_ball_that_was_not_seen_for_a_third_of_a_second_gives_no_reading",
    ),
    Mutant(
        "MS18",
        VELOCITY,
        "ball.distance if w.radial_from == RAW else ball.filtered_distance",
        "ball.distance",
        TEST_VELOCITY + "test_ms18_the_radial_velocity_is_of_the_filtered_place_the_angular_of_the_raw",
    ),
    Mutant(
        "MS18",
        VELOCITY,
        "ball.bearing if w.angular_from == RAW else ball.filtered_bearing",
        "ball.filtered_bearing",
        TEST_VELOCITY + "test_ms18_the_radial_velocity_is_of_the_filtered_place_the_angular_of_the_raw",
    ),
]
