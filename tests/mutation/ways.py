"""Mutants of the planner of the middle-size teams: field, steps, search, time and demonstration."""

from tests.mutation.mutant import Mutant

POTENTIAL = "baselines/weigel_2001/planner/potential.py"
STEPPING = "baselines/weigel_2001/planner/stepping.py"
WALKING = "baselines/weigel_2001/planner/walking.py"
PLANNING = "baselines/weigel_2001/planner/planning.py"
SETTINGS = "baselines/weigel_2001/planner/settings.py"
TRAVELLING = "baselines/weigel_2001/planner/travelling.py"
DRAWING = "baselines/weigel_2001/planner/drawing.py"
PLANNER = "baselines/weigel_2001/planner/planner.py"
TEST_POTENTIAL = "tests/baselines/weigel_2001/test_planner_potential.py::"
TEST_STEPPING = "tests/baselines/weigel_2001/test_planner_stepping.py::"
TEST_PLANNING = "tests/baselines/weigel_2001/test_planner_planning.py::"
TEST_SEARCHING = "tests/baselines/weigel_2001/test_planner_searching.py::"
TEST_TRAVELLING = "tests/baselines/weigel_2001/test_planner_travelling.py::"
TEST_PLANNER = "tests/baselines/weigel_2001/test_planner.py::"

MUTANTS = [
    Mutant(
        "MH09",
        POTENTIAL,
        "settings.form == VECTOR",
        "settings.form == VECTOR + 9",
        TEST_POTENTIAL + "test_mh09_the_vector_field_is_the_size_of_the_sum_of_all_forces",
    ),
    Mutant(
        "MH09",
        POTENTIAL,
        "size_at(sqrt(away) - within, settings.gain, settings.reach, settings)",
        "0.0",
        TEST_POTENTIAL + "test_mh09_the_scalar_field_is_the_distance_and_the_size_of_each_force",
    ),
    Mutant(
        "MH09",
        POTENTIAL,
        "size * (2.0 - gap / settings.floor)",
        "size",
        TEST_POTENTIAL + "test_mh09_below_the_floor_the_force_goes_on_growing_evenly",
    ),
    Mutant(
        "MH10",
        POTENTIAL,
        "(above - below) / a",
        "(above - below) / (2.0 * a)",
        TEST_POTENTIAL + "test_mh10_the_gradient_is_the_difference_between_neighbours_over_a_cell",
    ),
    Mutant(
        "MH11",
        STEPPING,
        "rest_y - dv",
        "0.0",
        TEST_STEPPING + "test_mh11_carried_steps_keep_to_the_line_within_half_a_cell",
    ),
    Mutant(
        "MH11",
        STEPPING,
        "along > HALF_OF_45 * across",
        "along > 0.0",
        TEST_STEPPING + "test_mh11_a_quantised_step_goes_to_the_nearest_of_eight_neighbours",
    ),
    Mutant(
        "MH12",
        WALKING,
        "settings.search == 1",
        "settings.search == 2",
        TEST_SEARCHING + "test_mh12_a_search_leads_out_of_a_cup_of_robots_and_without_it_nobody_gets_out",
    ),
    Mutant(
        "MH12",
        WALKING,
        "scratch.marks[index_of(u, v, scratch)] == 0",
        "scratch.marks[index_of(u, v, scratch)] < 9999",
        TEST_SEARCHING + "test_mh12_a_way_never_comes_to_a_cell_twice",
    ),
    Mutant(
        "MH13",
        WALKING,
        "settings.backward == 1",
        "settings.backward == 2",
        TEST_PLANNING + "test_mh13_backwards_the_way_is_planned_from_the_target_towards_the_robot",
    ),
    Mutant(
        "MH14",
        TRAVELLING,
        "CYCLE = 0.02",
        "CYCLE = 0.1",
        TEST_TRAVELLING + "test_mh14_a_cycle_is_20_ms_of_driving_at_full_speed_along_a_new_plan",
    ),
    Mutant(
        "MH15",
        STEPPING,
        "step_length(du, dv, settings) / settings.speed",
        "settings.cell / settings.speed",
        TEST_STEPPING + "test_mh15_a_step_takes_38_or_54_milliseconds",
    ),
    Mutant(
        "MH15",
        WALKING,
        "-1.0 if backward else 1.0",
        "1.0",
        TEST_PLANNING + "test_mh15_time_is_counted_back_from_t_by_a_step_for_each_cell",
    ),
    Mutant(
        "MH15",
        STEPPING,
        "settings.time_variant == 0",
        "settings.time_variant >= 0",
        TEST_PLANNING + "test_mh15_the_way_avoids_where_an_obstacle_will_be_and_not_where_it_is",
    ),
    Mutant(
        "MH16",
        PLANNING,
        "0.0 if settings.literal == 1 else settings.damping",
        "0.0",
        TEST_PLANNING + "test_mh16_t_begins_at_its_least_and_goes_half_way_to_the_time_of_the_last_way",
    ),
    Mutant(
        "MH16",
        PLANNING,
        "0.0 if settings.literal == 1 else settings.damping",
        "settings.damping",
        TEST_PLANNING + "test_mh16_by_the_papers_words_t_is_the_time_of_the_last_way_of_cells",
    ),
    Mutant(
        "MH16",
        PLANNING,
        "worth < best",
        "worth > best",
        TEST_PLANNING + "test_mh16_if_no_time_agrees_the_best_the_first_or_the_last_plan_is_kept",
    ),
    Mutant(
        "MH16",
        SETTINGS,
        "threshold: float = 0.1",
        "threshold: float = 0.03",
        TEST_PLANNING + "test_mh16_in_the_papers_scene_one_iteration_tells_the_time_to_a_tenth_of_a_second",
    ),
    Mutant(
        "MH17",
        STEPPING,
        "if settings.time_variant == 0:\n    return 0.0",
        "pass",
        TEST_PLANNING + "test_mh17_weigels_planner_knows_no_velocities",
    ),
    Mutant(
        "MH17",
        PLANNING,
        "speeds > 0.0",
        "True",
        TEST_PLANNING + "test_mh17_with_all_velocities_zero_the_time_variant_plan_is_the_baselines",
    ),
    Mutant(
        "MH18",
        TRAVELLING,
        "obstacles[j].y + i * CYCLE * obstacles[j].vy",
        "obstacles[j].y",
        TEST_TRAVELLING
        + "test_mh18_weigels_planner_nearly_meets_the_obstacle_and_drives_away_and_the_time_variant_one_does_not",
    ),
    Mutant(
        "MH18",
        DRAWING,
        "travel.path[: cycle + 1]",
        "travel.path",
        TEST_PLANNER + "test_mh18_plans_and_travels_are_drawn",
    ),
    Mutant(
        "MH25",
        PLANNER,
        "FASTEST = 100.0",
        "FASTEST = 4.0",
        TEST_TRAVELLING + "test_mh25_an_obstacle_at_5_metres_a_second_is_planned_for_where_it_will_be",
    ),
]
