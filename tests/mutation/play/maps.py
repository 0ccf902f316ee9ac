"""Mutants of what the statistics count of robots that move and of where things happen, by the test that must notice."""

from tests.mutation.mutant import By, mutants_of

MOVING = "tests/statistics/test_moving.py::test_"
MAPS = "tests/statistics/test_maps.py::test_"

IN_MOVING: By = {
    MOVING + "distance_is_the_way_from_step_to_step": [
        ("distance covered", "length(robot.x - player.x, robot.y - player.y)", "length(robot.x - player.x, 0.0)"),
    ],
    MOVING + "nobody_covers_a_distance_as_he_is_put_somewhere_or_while_the_ball_is_out_of_play": [
        ("distance covered", "player.seen == match.step - 1 and robot.placed == 0", "player.seen == match.step - 1"),
        ("distance covered", "player.seen == match.step - 1 and robot.placed == 0", "robot.placed == 0"),
    ],
    MOVING + "who_is_stopped_for_long_is_stuck_from_the_first_moment": [
        ("stuck", "tally.stuck[team] += (steps - player.stuck_steps) * k.dt", "tally.stuck[team] += k.dt"),
        ("stuck", "STUCK = 1.5", "STUCK = 1.6"),
    ],
    MOVING + "a_short_break_does_not_end_it": [
        ("stuck", "BREAK = 0.5", "BREAK = 0.6"),
        ("stuck", "BREAK = 0.5", "BREAK = 0.4"),
    ],
    MOVING + "who_wants_little_or_gets_on_is_not_stuck": [
        ("stuck", "wanted > least * least", "True"),
        ("stuck", "made < MAKES * MAKES * wanted", "True"),
    ],
    MOVING + "who_winds_up_a_kick_or_lies_on_the_ground_is_not_stuck": [
        ("stuck", "robot.kick_clock <= 0.0", "True"),
        ("stuck", "robot.fallen <= 0.0", "True"),
    ],
    MOVING + "the_mean_place_of_a_player_is_that_in_play": [
        ("mean places", "maps.places[r, 0] += LOOK * k.dt * direction * robot.x", "pass"),
    ],
}
IN_MAPS: By = {
    MOVING + "the_heat_map_is_that_of_a_team_that_attacks_to_the_right": [
        ("heat map", "(direction * thing.x / k.pitch_length + 0.5) * CELLS_LONG",
         "(thing.x / k.pitch_length + 0.5) * CELLS_LONG"),
        ("heat map", "(direction * thing.y / k.pitch_width + 0.5) * CELLS_WIDE",
         "(thing.y / k.pitch_width + 0.5) * CELLS_WIDE"),
    ],
    MAPS + "a_shot_is_noted_where_the_ball_was_played": [
        ("shot map", "shot.place[0], shot.place[1] = direction * trail.played_x, direction * trail.played_y",
         "shot.place[0], shot.place[1] = trail.played_x, trail.played_y"),
    ],
    MAPS + "shots_beyond_the_first_64_are_counted_and_not_noted": [
        ("shot map", "maps.shots_kept >= SHOTS", "maps.shots_kept >= SHOTS - 1"),
    ],
}  # fmt: skip
MUTANTS = mutants_of("soccer_env/statistics/", {"moving": IN_MOVING, "maps": IN_MAPS})
