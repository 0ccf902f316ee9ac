"""Mutants of the camera on a legged robot's head: what it sees, and the tables from sizes to ranges."""

from tests.mutation.mutant import Mutant

BLOBS, CAMERA = "soccer_env/perception/legged/blobs.py", "soccer_env/perception/legged/camera.py"
JERSEY, TABLES = "soccer_env/perception/legged/jersey.py", "soccer_env/perception/legged/calibration.py"
PICTURE = "soccer_env/perception/legged/picture.py"
TEST_BLOBS, TEST_CAMERA = "tests/perception/legged/test_camera_blobs.py::", "tests/perception/legged/test_camera.py::"
TEST_LOST = "tests/perception/legged/test_lost_blobs.py::"
TEST_JERSEY, TEST_TABLES = (
    "tests/perception/legged/test_camera_jersey.py::",
    "tests/perception/legged/test_calibration.py::",
)

MUTANTS = [
    Mutant(
        "MS04",
        BLOBS,
        "put_largest_first(pieces, count, sketch.spare_piece)",
        "pass",
        TEST_BLOBS + "test_ms04_four_largest_blobs_of_each_colour_largest_first",
    ),
    Mutant(
        "MS04",
        BLOBS,
        "min(count, BLOBS)",
        "min(count, BLOBS - 1)",
        TEST_BLOBS + "test_ms04_four_largest_blobs_of_each_colour_largest_first",
        where="report",
    ),
    Mutant(
        "MS04",
        BLOBS,
        "report(sketch, BALL, percept.ball, state.scale, noise, 0.0, s)",
        "report(sketch, BALL, percept.teammates, state.scale, noise, 0.0, s)",
        TEST_BLOBS + "test_ms04_fewer_blobs_leave_the_rest_empty",
    ),
    Mutant(
        "MS08",
        CAMERA,
        "(pose.gaze_cosine, pose.gaze_sine)",
        "(pose.cosine, pose.sine)",
        TEST_CAMERA + "test_ms08_head_angles_and_pixel_give_the_bearing",
    ),
    Mutant(
        "MS08",
        CAMERA,
        "(pose.level, pose.steep)",
        "(1.0, 0.0)",
        TEST_CAMERA + "test_ms08_head_angles_and_pixel_give_the_bearing",
    ),
    Mutant(
        "MS09",
        TABLES,
        "np.interp(asked, sizes, ranges)",
        "14.0 / asked",
        TEST_TABLES + "test_ms09_the_range_of_a_ball_is_that_of_the_pinhole",
    ),
    Mutant(
        "MS09",
        TABLES,
        "np.interp(asked, sizes, ranges)",
        "14.0 / asked",
        TEST_TABLES + "test_ms09_a_noiseless_ball_is_where_the_table_says",
    ),
    Mutant(
        "MS14",
        BLOBS,
        "blobs[kept].area < sketch.camera.least_area",
        "False",
        TEST_LOST + "test_ms14_regions_below_the_least_area_are_dropped_whatever_their_colour",
    ),
    Mutant(
        "MS14",
        BLOBS,
        "blobs[index].area < sketch.camera.least_area",
        "False",
        TEST_LOST + "test_ms14_regions_below_the_least_area_are_dropped_whatever_their_colour",
    ),
    Mutant(
        "MS14",
        CAMERA,
        "0.25 * s.least_area * (1 << (2 * s.resolution))",
        "0.5",
        TEST_LOST + "test_ms14_the_stickers_of_a_head_are_lost_from_afar",
    ),
    Mutant(
        "MS37",
        JERSEY,
        "apart * (i - 0.5 * (s.trunk_stickers - 1))",
        "0.0",
        TEST_JERSEY + "test_ms37_each_side_of_the_trunk_has_two_stickers_of_one_height",
    ),
    Mutant(
        "MS37",
        BLOBS,
        "uniform(noise, CAMERA_NOISE) < s.player_miss",
        "False",
        TEST_LOST + "test_ms37_a_frame_that_misses_a_player_misses_all_its_stickers_and_nobody_elses",
    ),
    Mutant(
        "MS37",
        BLOBS,
        "miss(sketch, kind, noise, missed)",
        "pass",
        TEST_LOST + "test_ms37_a_single_sticker_that_is_missed_leaves_one_of_its_height",
    ),
    Mutant(
        "MS33",
        TABLES,
        "0.5 * pi",
        "pi",
        TEST_TABLES + "test_ms33_a_noiseless_player_is_where_the_table_of_its_view_says",
    ),
    Mutant(
        "MS37",
        JERSEY,
        "x < -trunk.half_length",
        "True",
        TEST_JERSEY + "test_ms37_several_stickers_are_seen_and_only_those_that_face_the_camera",
    ),
    Mutant(
        "MS37",
        JERSEY,
        "(0.5 * s.jersey * s.sticker_chest_width, 0.5 * s.jersey * s.sticker_chest_height)",
        "(0.5 * s.jersey * s.sticker_flank_width, 0.5 * s.jersey * s.sticker_flank_height)",
        TEST_JERSEY + "test_ms37_a_player_appears_slightly_smaller_head_on",
    ),
    Mutant(
        "MS37",
        JERSEY,
        "abs(y) > head.half_width",
        "abs(y) < 0.0",
        TEST_JERSEY + "test_ms37_without_its_head_stickers_a_player_is_half_as_high",
    ),
    Mutant(
        "MS50",
        JERSEY,
        "body.tilt < -s.head_down",
        "False",
        TEST_JERSEY + "test_ms50_a_lowered_head_hides_a_part_of_the_jersey",
    ),
    Mutant(
        "MS50",
        PICTURE,
        "body.boxes[HEAD].shown == 1 and (not lowered)",
        "body.boxes[HEAD].shown == 1",
        TEST_JERSEY + "test_ms50_from_the_side_a_lowered_head_hides_its_own_stickers_alone",
    ),
]
