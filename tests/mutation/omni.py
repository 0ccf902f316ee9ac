"""Mutants of the middle-size robots: base, kicker, mirror camera, light, tracking, radio."""

from tests.mutation.mutant import Mutant

LEAGUE = "soccer_env/leagues/middle_size_2006.py"
AROUND, PICTURE = "soccer_env/perception/omni/around.py", "soccer_env/perception/omni/sense.py"
SIGHTINGS, LINES = "soccer_env/perception/omni/sightings.py", "soccer_env/perception/omni/line_picture.py"
LIGHTING, KALMAN = "soccer_env/perception/omni/lighting.py", "soccer_env/belief/omni/kalman.py"
BALL, PLAYERS = "soccer_env/belief/omni/ball.py", "soccer_env/belief/omni/players.py"
REPORTS, TALK = "soccer_env/belief/omni/reports.py", "soccer_env/belief/omni/radio.py"
TEST_LEAGUE, TEST_LIGHT = "tests/repository/test_mechanisms.py::", "tests/perception/omni/test_lighting.py::"
TEST_MIRROR = "tests/perception/omni/test_mirror_curve.py::"
TEST_OMNI, TEST_TRACKING = "tests/perception/omni/test_omni.py::", "tests/belief/omni/test_tracking.py::"
TEST_BALL, TEST_PLAYERS = "tests/belief/omni/test_ball.py::", "tests/belief/omni/test_players.py::"
TEST_REPORTS, TEST_TALK = "tests/belief/omni/test_reports.py::", "tests/belief/test_talk.py::"

MUTANTS = [
    Mutant(
        "MH01",
        "soccer_env/physics/drive.py",
        "share * aside",
        "0.5 * share * aside",
        TEST_LEAGUE + "test_mh01_the_omnidirectional_base_reaches_its_top_speed_in_every_direction",
        where="change_walk",
    ),
    Mutant(
        "MH02",
        "soccer_env/optics/mirror_camera.py",
        "scale * distance / (height + bend * sqrt(distance * distance + height * height))",
        "scale * distance / (height + bend * distance)",
        TEST_MIRROR + "test_mh02_every_ray_is_reflected_into_the_pixel_that_the_curve_names",
    ),
    Mutant(
        "MH02",
        "soccer_env/optics/mirror_camera.py",
        "2.0 * s.mirror_eccentricity / (1.0 + s.mirror_eccentricity * s.mirror_eccentricity)",
        "1.0",
        TEST_MIRROR + "test_mh02_every_ray_is_reflected_into_the_pixel_that_the_curve_names",
    ),
    Mutant(
        "MH02",
        "soccer_env/optics/mirror_camera.py",
        "0.5 * s.image * (height + bend * sqrt(edge * edge + height * height)) / edge",
        "0.5 * s.image",
        TEST_MIRROR + "test_mh02_the_mirror_shows_ten_metres_in_290_pixels",
    ),
    Mutant(
        "MH02",
        "soccer_env/belief/omni/tracking.py",
        "(pixels * along, pixels * across)",
        "(pixels * across, pixels * across)",
        TEST_TRACKING + "test_mh02_readings_are_trusted_as_the_mirrors_curve_allows",
    ),
    Mutant(
        "MH02",
        SIGHTINGS,
        "s.pixel_noise * sqrt(-2.0 * log(1.0 - uniform(noise, CAMERA)))",
        "0.0 * sqrt(-2.0 * log(1.0 - uniform(noise, CAMERA)))",
        TEST_OMNI + "test_mh02_bearings_are_good_to_a_pixel_and_ranges_fail_with_the_mirrors_curve",
    ),
    Mutant(
        "MH02",
        AROUND,
        "(0.0, 0.0)",
        "(0.0, 1.0)",
        TEST_OMNI + "test_mh02_a_hidden_ball_is_never_seen",
    ),
    Mutant(
        "MH02",
        AROUND,
        "0.5 * (low + high)",
        "0.0",
        TEST_OMNI + "test_mh02_of_a_ball_half_hidden_the_other_half_is_seen",
    ),
    Mutant(
        "MH02",
        PICTURE,
        "slot.body.active == 1 and slot.body.frame + late == match.step",
        "False",
        TEST_OMNI + "test_mh02_a_picture_arrives_some_frames_after_its_exposure",
    ),
    Mutant(
        "MH02",
        LINES,
        "first_line(robot.x, robot.y, dx, dy, map, k.pitch_circle, s.hidden_radius, map.free[i])",
        "first_line(robot.x, robot.y, dx, dy, map, 0.0, s.hidden_radius, map.free[i])",
        "tests/perception/omni/test_omni_lines.py::test_mh02_the_first_line_in_each_direction_is_seen_to_a_pixel",
    ),
    Mutant(
        "MH03",
        LEAGUE,
        "control_rate=50",
        "control_rate=25",
        TEST_LEAGUE + "test_mh03_the_control_cycle_takes_20_ms",
    ),
    Mutant(
        "MH04",
        "soccer_env/physics/kicker.py",
        "speed * ahead",
        "0.5 * speed * ahead",
        TEST_LEAGUE + "test_mh04_the_kicker_shoots_as_hard_as_it_is_told",
    ),
    Mutant(
        "MH04",
        "soccer_env/physics/kicker.py",
        "robot.keeper == 0 or k.keeper_kicks == 1",
        "True",
        TEST_LEAGUE + "test_mh04_the_kicker_shoots_as_hard_as_it_is_told",
    ),
    Mutant(
        "MH05",
        TALK,
        "uniform(noise[r], RADIO) < s.radio_loss",
        "False",
        TEST_TALK + "test_the_share_of_messages_that_is_lost_is_the_one_that_is_set",
    ),
    Mutant(
        "MH05",
        TALK,
        "w.shared == 0",
        "w.shared != 2",
        TEST_TALK + "test_mh05_a_radio_message_is_heard_a_few_frames_later_with_its_distance",
    ),
    Mutant(
        "MH05",
        REPORTS,
        "(frame - report.frame) * k.dt if w.delay_compensation == 1 else 0.0",
        "0.0",
        TEST_REPORTS + "test_mh05_team_mates_are_where_they_say",
    ),
    Mutant(
        "MH05",
        REPORTS,
        "best >= 0",
        "best >= 99",
        TEST_REPORTS + "test_mh05_a_ball_that_one_sees_is_known_to_all",
    ),
    Mutant(
        "MH06",
        KALMAN,
        "vv + q",
        "vv",
        TEST_TRACKING + "test_mh06_the_filter_is_the_textbooks_kalman_filter",
    ),
    Mutant(
        "MH06",
        KALMAN,
        "(K_x + age * K_v, K_v)",
        "(1.0, 0.0)",
        TEST_TRACKING + "test_mh06_the_line_fit_is_that_of_least_squares",
    ),
    Mutant(
        "MH06",
        "soccer_env/belief/omni/tracking.py",
        "G_along * along * uy + G_across * across * ux",
        "0.0",
        TEST_BALL + "test_mh06_a_ball_that_rolls_by_is_tracked_with_its_velocity",
    ),
    Mutant(
        "MH06",
        BALL,
        "filter.surprises < w.surprise_count",
        "filter.surprises < 100",
        TEST_BALL + "test_mh06_a_ball_that_is_somewhere_else_is_believed_there_after_some_readings",
    ),
    Mutant(
        "MH06",
        PLAYERS,
        "tracks[slot].present == 1 and filters[slot].seen == 0 and (readings[i].off[slot] < least)",
        "tracks[slot].present == 1 and filters[slot].seen == 0 and (best < 0) and (readings[i].off[slot] < gate)",
        TEST_PLAYERS + "test_mh06_the_nearest_pair_of_reading_and_track_comes_first",
    ),
    Mutant(
        "MH06",
        PLAYERS,
        "nearest_pair(percept, tracks, filters, readings, count, teammate, first, last, w.gate)",
        "nearest_pair(percept, tracks, filters, readings, count, teammate, first, last, 0.0)",
        TEST_PLAYERS + "test_mh06_two_that_pass_each_other_keep_their_tracks",
    ),
    Mutant(
        "MH06",
        PLAYERS,
        "correct(track, filter, x, y, late, max(track.age - age, k.dt), s, w)",
        "start(track, filter, x, y, PLAYER_SPEED, s)",
        TEST_PLAYERS + "test_mh06_a_player_that_moves_is_tracked_with_its_velocity",
    ),
    Mutant(
        "MH07",
        LIGHTING,
        "2.0 * pi * (match.clock / s.light_period + start)",
        "2.0 * pi * match.clock / s.light_period",
        TEST_LIGHT + "test_mh07_light_swings_as_told_and_differs_from_match_to_match",
    ),
    Mutant(
        "MH07",
        LIGHTING,
        "off * clip(dt / max(s.table_time, dt), 0.0, 1.0)",
        "0.0",
        TEST_LIGHT + "test_mh07_the_adaptive_table_follows_the_light_and_the_fixed_one_does_not",
    ),
    Mutant(
        "MH07",
        LIGHTING,
        "s.colour_table != ADAPTIVE or not placed or abs(off) > CLASS_SPREAD * s.table_width",
        "s.colour_table != ADAPTIVE or not placed",
        TEST_LIGHT + "test_mh07_light_that_jumps_leaves_the_table_behind",
    ),
    Mutant(
        "MH07",
        PICTURE,
        "pose != NO_POSE or lines >= LEAST_LINES",
        "True",
        TEST_LIGHT + "test_mh07_who_cannot_know_its_place_learns_no_colours",
    ),
    Mutant(
        "MH07",
        PICTURE,
        "match.step == 0 or pose == POSE_TOLD",
        "match.step == 0",
        TEST_LIGHT + "test_mh07_who_is_told_its_place_trains_a_table_anew",
    ),
    Mutant(
        "MH07",
        LIGHTING,
        "exp(-min(log(2.0) * difference * difference, DARKEST))",
        "1.0",
        TEST_LIGHT + "test_mh07_a_table_that_is_off_by_its_width_misses_half",
    ),
    Mutant(
        "MH23",
        LEAGUE,
        "length=12.0",
        "length=10.0",
        TEST_LEAGUE + "test_mh23_the_middle_size_preset_has_room_for_six_robots",
    ),
    Mutant(
        "MH24",
        SIGHTINGS,
        "kept if s.ball_coloured == 1 else UNCOLOURED",
        "kept",
        TEST_OMNI + "test_mh24_a_ball_without_colour_is_found_less_often_and_mistaken_more_often",
    ),
]
