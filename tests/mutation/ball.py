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
        "    ball.distance, ball.bearing = length(x, y), atan2(y, x)",
        "    ball.distance, ball.bearing = x, y",
        TEST_BALL + "test_ms02_the_ball_is_kept_in_polar_coordinates_of_the_robot",
    ),
    Mutant(
        "MS03",
        BALL,
        "    return max(SURE - w.fading * (frame - memory.seen) * k.dt, 0.0)",
        "    return SURE",
        TEST_BALL + "test_ms03_confidence_is_100_when_seen_and_fades_when_not",
    ),
    Mutant(
        "MS08",
        BLOB,
        "    bearing, elevation = direction_of_pixel(u, v, pan, tilt, s)\n",
        "    bearing, elevation = direction_of_pixel(0.0 * u, v, pan, tilt, s)\n",
        TEST_BLOB + "test_ms08_the_bearing_is_head_angle_plus_place_in_the_picture",
    ),
    Mutant(
        "MS08",
        BLOB,
        "    return ahead + away * cos(bearing), left + away * sin(bearing)",
        "    return away * cos(bearing), away * sin(bearing)",
        TEST_BLOB + "test_ms08_bearing_and_distance_count_from_the_body_not_from_the_camera",
    ),
    Mutant(
        "MS09",
        BLOB,
        "    return ranges[min(max(size, 0), ranges.shape[0] - 1)]",
        "    return 14.0 / max(size, 1)",
        TEST_BLOB + "test_ms09_the_range_is_read_from_the_table_of_sizes",
    ),
    Mutant(
        "MS10",
        BLOB,
        "    if w.under_head == 1 and",
        "    if w.under_head == 2 and",
        TEST_BLOB + "test_ms10_almost_under_the_head_the_range_is_height_by_angle",
    ),
    Mutant(
        "MS11",
        BLOB,
        "    return min(by_height, by_width)",
        "    return by_height",
        TEST_BLOB + "test_ms11_a_ball_cut_in_one_dimension_keeps_its_range",
    ),
    Mutant(
        "MS11",
        BLOB,
        "    return min(by_height, by_width)",
        "    return by_width",
        TEST_BLOB + "test_ms11_a_ball_cut_in_one_dimension_keeps_its_range",
    ),
    Mutant(
        "MS12",
        BLOB,
        "    overrides = w.infrared_override == 1",
        "    overrides = w.infrared_override == 2",
        TEST_BLOB + "test_ms12_the_infrared_ranger_wins_over_the_size_of_a_hidden_ball",
    ),
    Mutant(
        "MS12",
        BLOB,
        "by_infrared < w.infrared_share * by_size",
        "by_infrared < by_size",
        TEST_BLOB + "test_ms12_a_reading_above_two_thirds_changes_nothing",
    ),
    Mutant("MS12", BLOB, "or not beam_is_on(blob, s, w)", "", TEST_BLOB + "test_ms12_the_beam_must_be_on_the_ball"),
    Mutant(
        "MS13",
        BLOB,
        "    return elevation > w.horizon_angle",
        "    return False",
        TEST_BLOB + "test_ms13_what_lies_much_above_the_horizontal_is_no_ball",
    ),
    Mutant(
        "MS14",
        BLOB,
        "was_near and w.double_area == 1",
        "was_near and w.double_area == 2",
        TEST_BLOB + "test_ms14_after_a_near_sighting_a_small_patch_is_no_ball",
    ),
    Mutant(
        "MS14",
        BALL,
        "    return length(np.float64(memory.x), np.float64(memory.y)) < w.area_near",
        "    return True",
        TEST_BLOB + "test_ms14_after_a_far_sighting_or_a_long_time_it_is",
    ),
    Mutant(
        "MS15",
        BALL,
        "    if w.odometry == ROTATION:",
        "    if w.odometry == FULL:",
        TEST_BALL + "test_ms15_a_still_ball_is_where_it_was_after_a_walk_out_of_sight",
    ),
    Mutant(
        "MS15",
        BALL,
        "    if w.odometry_while_dribbling == 0 and",
        "    if w.odometry_while_dribbling == 2 and",
        TEST_BALL + "test_ms15_a_dribbled_ball_comes_along",
    ),
    Mutant(
        "MS16",
        BALL,
        "    count = min(memory.count + 1, w.averaged)",
        "    count = 1",
        TEST_BALL + "test_ms16_the_filtered_place_is_the_mean_of_the_last_four_in_cartesian_coordinates",
    ),
    Mutant(
        "MS17",
        VELOCITY,
        "    if period == memory.period:",
        "    if period < 0:",
        TEST_VELOCITY + "test_ms17_a_velocity_every_third_of_a_second",
    ),
    Mutant(
        "MS17",
        VELOCITY,
        "or w.velocity_gate == 0",
        "or w.velocity_gate < 2",
        TEST_VELOCITY + "test_ms17_after_more_than_a_second_and_a_half_the_place_is_only_stored",
    ),
    Mutant(
        "MS17",
        VELOCITY,
        "(frame - memory.seen) * dt <= interval + ROUNDING",
        "(frame - memory.seen) * dt <= 99.0",
        TEST_VELOCITY + "test_ms17_a_ball_that_was_not_seen_for_a_third_of_a_second_gives_no_reading",
    ),
    Mutant(
        "MS18",
        VELOCITY,
        "    distance = ball.distance if w.radial_from == RAW else ball.filtered_distance",
        "    distance = ball.distance",
        TEST_VELOCITY + "test_ms18_the_radial_velocity_is_of_the_filtered_place_the_angular_of_the_raw",
    ),
    Mutant(
        "MS18",
        VELOCITY,
        "    bearing = ball.bearing if w.angular_from == RAW else ball.filtered_bearing",
        "    bearing = ball.filtered_bearing",
        TEST_VELOCITY + "test_ms18_the_radial_velocity_is_of_the_filtered_place_the_angular_of_the_raw",
    ),
]
