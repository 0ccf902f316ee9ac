"""Mutants of what a legged robot believes of other players: slots, grouping, matching, ranges, obstacle."""

from tests.mutation.mutant import Mutant

PLAYERS = "soccer_env/belief/legged/players.py"
OBSTACLE = "soccer_env/belief/legged/obstacle.py"
GROUPING, MATCHING = "soccer_env/belief/legged/grouping.py", "soccer_env/belief/legged/matching.py"
TEST_PLAYERS, TEST_MEMORY = "tests/belief/legged/test_players.py::", "tests/belief/legged/test_players_memory.py::"
TEST_OBSTACLE = "tests/belief/legged/test_obstacle.py::"
TEST_GROUPING, TEST_MATCHING = "tests/belief/legged/test_grouping.py::", "tests/belief/legged/test_matching.py::"

MUTANTS = [
    Mutant(
        "MS03",
        PLAYERS,
        "max(SURE - w.fading * track.age, 0.0)",
        "SURE",
        TEST_MEMORY + "test_ms03_trust_in_a_player_fades_while_it_is_not_seen",
    ),
    Mutant(
        "MS28",
        PLAYERS,
        "SLOTS['nearest']",
        "SLOTS['all']",
        TEST_PLAYERS + "test_ms28_all_players_of_both_teams_are_remembered",
    ),
    Mutant(
        "MS28",
        PLAYERS,
        "SLOTS['nearest']",
        "-1",
        TEST_PLAYERS + "test_ms28_the_old_memory_knows_the_nearest_of_the_moment",
    ),
    Mutant(
        "MS29",
        GROUPING,
        "grouping * size_of(blobs[j])",
        "0.0",
        TEST_GROUPING + "test_ms29_blobs_nearer_than_three_sizes_of_the_larger_are_one_player",
    ),
    Mutant(
        "MS29",
        GROUPING,
        "0.5 * (width + height)",
        "1.0 * width * height",
        TEST_GROUPING + "test_ms29_size_is_the_mean_of_width_and_height",
    ),
    Mutant(
        "MS30",
        MATCHING,
        "uncertainty_of(track, w) * near",
        "near",
        TEST_MATCHING + "test_ms30_likelihood_is_uncertainty_by_distance_cubed_by_angle",
    ),
    Mutant(
        "MS30",
        MATCHING,
        "tracks[slot].present == 1 and tracks[slot].age == 0.0",
        "tracks[slot].present == 2",
        TEST_MATCHING + "test_ms30_no_slot_is_taken_twice_in_one_view",
    ),
    Mutant(
        "MS31",
        MATCHING,
        "falloff(max(distance, LEAST_DISTANCE), w.distance_power)",
        "falloff(max(distance, LEAST_DISTANCE), 1.0)",
        TEST_MATCHING + "test_ms31_with_the_first_power_an_uncertain_player_far_away_is_replaced",
    ),
    Mutant(
        "MS31",
        MATCHING,
        "uncertainty_of(track, w) * near * falloff(max(angle, LEAST_ANGLE), w.angle_power)",
        "uncertainty_of(track, w) * near",
        TEST_MATCHING + "test_ms31_the_angle_counts_more_than_the_range",
    ),
    Mutant(
        "MS32",
        MATCHING,
        "min(w.uncertainty_least + w.uncertainty_growth * track.age, w.uncertainty_most)",
        "w.uncertainty_least",
        TEST_MATCHING + "test_ms32_uncertainty_grows_from_a_half_to_a_hundred",
    ),
    Mutant(
        "MS33",
        PLAYERS,
        "w.player_view == SIDE",
        "w.player_view != SIDE",
        TEST_PLAYERS + "test_ms33_ranges_come_from_the_height_table_of_a_view",
    ),
    Mutant(
        "MS34",
        GROUPING,
        "w.player_blob == COMBINED",
        "w.player_blob >= 0",
        TEST_GROUPING + "test_ms34_the_largest_blob_alone_stands_for_a_player",
    ),
    Mutant(
        "MS34",
        GROUPING,
        "w.player_blob == COMBINED",
        "w.player_blob >= 0",
        TEST_PLAYERS + "test_ms34_the_range_does_not_jump_when_head_stickers_vanish",
    ),
    Mutant(
        "MS35",
        PLAYERS,
        "w.player_infrared == 1",
        "w.player_infrared == 2",
        TEST_PLAYERS + "test_ms35_a_player_in_the_beam_is_as_far_as_the_infrared_says",
    ),
    Mutant(
        "MS35",
        PLAYERS,
        "right - aside <= 0.0 <= left + aside and low - above <= 0.0 <= high + above",
        "True",
        TEST_PLAYERS + "test_ms35_the_infrared_tells_of_nobody_beside_the_beam",
    ),
    Mutant(
        "MS35",
        "soccer_env/belief/legged/surface.py",
        "length(x - k.head_camera_ahead, y) - half_a_body(k)",
        "length(x, y)",
        "tests/belief/legged/test_surface.py::test_ms35_the_reading_is_the_distance_to_the_surface",
    ),
    Mutant(
        "MS36",
        PLAYERS,
        "put_at(tracks[slot], x, y)",
        "pass",
        TEST_MEMORY + "test_ms36_players_in_memory_are_moved_by_own_steps",
    ),
    Mutant(
        "MS49",
        OBSTACLE,
        "w.obstacle == 1",
        "w.obstacle == 2",
        TEST_OBSTACLE + "test_ms49_a_reading_much_closer_than_every_player_is_an_obstacle",
    ),
    Mutant(
        "MS49",
        OBSTACLE,
        "w.obstacle == 1",
        "w.obstacle == 2",
        TEST_OBSTACLE + "test_ms49_a_player_with_its_head_down_that_seems_far_away_is_an_obstacle",
    ),
    Mutant(
        "MS49",
        OBSTACLE,
        "w.obstacle_share * nearest_player(percept, tracks, k, s)",
        "inf",
        TEST_OBSTACLE + "test_ms49_the_reading_must_be_significantly_closer_than_every_player",
    ),
    Mutant(
        "MS49",
        OBSTACLE,
        "max(away - half_a_body(k), 0.0)",
        "away",
        TEST_OBSTACLE + "test_ms49_the_reading_must_be_significantly_closer_than_every_player",
    ),
    Mutant(
        "MS49",
        OBSTACLE,
        "height + percept.infrared * sin(tilt) > lowest",
        "True",
        TEST_OBSTACLE + "test_ms49_ball_boards_and_carpet_are_no_obstacles",
    ),
]
