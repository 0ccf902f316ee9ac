"""Mutants of what the statistics count of steps, calls and robots, by the test that must notice."""

from tests.mutation.mutant import By, mutants_of

STATISTICS = "soccer_env/statistics/"
STEPS = "tests/statistics/test_counted_steps.py::test_"
GOALS = "tests/statistics/test_counted_goals.py::test_"
SHOTS = "tests/statistics/test_counted_shots.py::test_"

IN_COUNTING: By = {
    STEPS + "time_counts_always_and_in_play_while_no_restart_is_placed_or_waited_for": [
        ("time played", "tally.played += k.dt", "pass"),
        ("time in play", "match.phase == PLAY and match.placing == 0", "match.phase == PLAY", "count_step"),
        ("time in play", "match.phase == PLAY and match.placing == 0", "match.placing == 0", "count_step"),
        ("time in play", "tally.in_play += k.dt", "tally.in_play += 2.0 * k.dt"),
        ("still ball", "tally.still += k.dt", "pass"),
    ],
    STEPS + "a_ball_slower_than_2_cm_a_second_lies_still": [
        ("still ball", "ball.vx * ball.vx + ball.vy * ball.vy < STILL * STILL", "ball.vx * ball.vx < STILL * STILL"),
        ("still ball", "STILL = 0.02", "STILL = 0.03"),
    ],
    STEPS + "a_ball_within_20_cm_of_a_line_is_at_the_boards_and_within_25_of_two_in_a_corner": [
        ("time at boards", "min(along, aside) < AT_LINE", "along < AT_LINE"),
        ("time at boards", "min(along, aside) < AT_LINE", "aside < AT_LINE"),
        ("time at boards", "AT_LINE, IN_CORNER = 0.20, 0.25", "AT_LINE, IN_CORNER = 0.22, 0.25"),
        ("time in corners", "along < IN_CORNER and aside < IN_CORNER", "along < IN_CORNER or aside < IN_CORNER"),
        ("time in corners", "AT_LINE, IN_CORNER = 0.20, 0.25", "AT_LINE, IN_CORNER = 0.20, 0.20"),
    ],
    STEPS + "dropped_balls_and_separations_are_counted_and_how_far_they_carried_whom": [
        ("separations", "tally.separations += 1", "pass"),
        ("dropped balls", "events.restart_team == NO_TEAM", "False", "count_restart"),
        ("dropped balls", "tally.drops += 1", "pass"),
        ("carried robots", "max(tally.carried, far)", "far"),
        ("carried robots", "events.separated == 1 or events.restart == DROP_BALL", "events.restart == DROP_BALL"),
        (
            "carried robots",
            "events.separated == 1 or events.restart == DROP_BALL",
            "events.separated == 1 or events.restart != 0",
        ),
        ("carried robots", "robots[r].active == 1 and robot_events[r].returned == 0", "robots[r].active == 1"),
        ("carried robots", "robots[r].y - bodies[r + 1, 1]", "0.0"),
    ],
    STEPS + "a_restart_counts_for_the_team_that_takes_it": [
        (
            "restarts",
            "tally.restarts[events.restart_team, events.restart] += 1",
            "tally.restarts[1 - events.restart_team, events.restart] += 1",
        ),
        (
            "restarts",
            "tally.restarts[events.restart_team, events.restart] += 1",
            "tally.restarts[events.restart_team, events.restart] = 1",
        ),
    ],
    STEPS + "each_robot_that_is_whistled_counts_and_a_foul_of_a_team_once": [
        (
            "whistles",
            "tally.fouls[robots[r].team, robot_events[r].foul] += 1",
            "tally.fouls[events.foul_team, robot_events[r].foul] += 1",
        ),
        (
            "whistles",
            "tally.fouls[robots[r].team, robot_events[r].foul] += 1",
            "tally.fouls[robots[r].team, events.foul] += 1",
        ),
        ("whistles", "found += 1", "pass"),
        ("whistles", "found == 0 and events.foul_team != NO_TEAM", "False"),
    ],
    STEPS + "an_annulled_goal_counts_for_the_team_that_attacks_there": [
        ("annulled goals", "events.ball_x > 0.0", "events.ball_x < 0.0"),
        ("annulled goals", "direction_of(match, HOME) > 0.0", "True"),
        ("annulled goals", "events.foul != 0 or events.annulled == 1", "events.foul != 0", "count_calls"),
        (
            "annulled goals",
            "events.restart != 0 or events.separated == 1 or events.foul != 0 or events.annulled == 1",
            "events.restart != 0 or events.separated == 1 or events.foul != 0",
        ),
    ],
    GOALS + "goals_within_six_seconds_of_a_separation_say_so": [
        ("goals after a separation", "tally.trail.separated = match.step", "pass"),
    ],
    GOALS + "goals_within_ten_seconds_of_a_restart_say_which": [
        ("goals after a restart", "trail.kind = match.phase", "pass"),
        ("goals after a restart", "match.phase != PLAY and match.phase != OVER", "match.phase != PLAY"),
        ("goals after a restart", "trail.in_play = match.step", "pass"),
    ],
    GOALS + "a_goal_is_a_solo_if_one_robot_of_the_scorers_alone_touched_the_ball_since_the_restart": [
        ("goals of one robot", "trail.since_restart[HOME] = trail.since_restart[AWAY] = 0", "pass"),
    ],
    SHOTS + "a_restart_forgets_who_played_the_ball": [
        ("passes", "trail.player = trail.kicker = -1", "pass", "count_restart"),
    ],
    SHOTS + "a_restart_or_another_kick_ends_a_save_that_was_made": [
        ("saves", "end_flight(tally, trail)", "pass", "count_restart"),
    ],
    GOALS + "who_touches_the_ball_for_the_first_time_in_the_step_of_the_goal_has_scored_it": [
        (
            "goals by kind",
            "events.scorer if events.goal != NO_TEAM else match.last_touch_robot",
            "match.last_touch_robot",
        ),
    ],
}
IN_PLAYERS: By = {
    STEPS + "penalties_count_as_time_out_of_their_team_and_empty_places_do_not": [
        ("time out", "robot.penalty > 0.0 or robot.banned == 1", "robot.penalty > 0.0"),
        ("time out", "robot.penalty > 0.0 or robot.banned == 1", "robot.banned == 1"),
        ("time out", "robot.penalty > 0.0 or robot.banned == 1", "True"),
        ("time out", "tally.out[robot.team] += k.dt", "tally.out[1 - robot.team] += k.dt"),
    ],
    STEPS + "a_touch_before_the_ball_is_in_play_is_none_but_a_kick_counts": [
        ("kicks", "tally.kicks[robot.team] += 1", "tally.kicks[1 - robot.team] += 1"),
    ],
    STEPS + "a_spell_ends_with_the_play_and_a_longer_one_stays_the_longest": [
        ("touches", "match.phase == PLAY and match.placing == 0 and robot.active == 1", "robot.active == 1"),
    ],
    STEPS + "three_robots_that_play_near_the_ball_are_a_scrum": [
        (
            "scrums",
            "match.phase == PLAY and match.placing == 0 and robot.active == 1",
            "match.phase == PLAY and match.placing == 0",
        ),
        ("scrums", "trail.crowd = trail.has_ball = 0", "trail.has_ball = 0"),
        ("scrums", "CROWD = 3", "CROWD = 2"),
        ("scrums", "CROWD = 3", "CROWD = 4"),
        ("scrums", "MARGIN = 0.10", "MARGIN = 0.11"),
        ("scrums", "tally.scrum += k.dt", "pass"),
    ],
    STEPS + "a_touch_counts_anew_after_more_than_a_second_without_one": [
        ("touches", "AGAIN + 0.5 * k.dt", "AGAIN - 0.5 * k.dt"),
        ("touches", "AGAIN + 0.5 * k.dt", "AGAIN + 1.5 * k.dt"),
        ("touches", "step - player.touched - 1", "step - player.touched"),
        ("touches", "player.touched = step", "pass"),
        ("touches", "tally.touches[team] += 1", "tally.touches[1 - team] += 1"),
    ],
    STEPS + "a_spell_goes_on_after_half_a_second_without_the_ball_and_not_after_longer": [
        ("spells", "LOST + 0.5 * k.dt", "LOST - 0.5 * k.dt"),
        ("spells", "LOST + 0.5 * k.dt", "LOST + 1.5 * k.dt"),
        ("spells", "player.held_last - player.held_since + 1", "player.held_last - player.held_since", "end_spell"),
        ("spells", "player.held_since = 0", "pass"),
        ("spells", "tally.spells[team] += 1", "tally.spells[1 - team] += 1"),
        ("spells", "tally.spell_time[team] += seconds", "tally.spell_time[team] = seconds"),
        ("spells", "max(tally.longest_spell[team], seconds)", "seconds"),
        (
            "spells",
            "tally.spell_lengths[team, min(place, BINS - 1)] += 1",
            "tally.spell_lengths[team, min(place + 1, BINS - 1)] += 1",
        ),
        ("spells", "player.held_last = step", "pass"),
        ("spells", "robot.has_ball == 1 or player.held_since > 0", "robot.has_ball == 1"),
    ],
    STEPS + "possession_is_a_teams_that_has_the_ball_alone": [
        ("possession", "1 << robot.team", "1"),
        ("possession", "trail.has_ball == 3", "trail.has_ball == 4"),
        ("possession", "trail.crowd = trail.has_ball = 0", "trail.crowd = 0"),
    ],
    STEPS + "time_counts_always_and_in_play_while_no_restart_is_placed_or_waited_for": [
        ("possession", "HOME if trail.has_ball == 1 else AWAY", "AWAY if trail.has_ball == 1 else HOME"),
    ],
    STEPS + "mates_are_field_players_that_are_not_nearest_to_the_ball_and_idle_those_that_stand": [
        ("idle mates", "SLOW_LEGS if k.drive_kind == GAIT else SLOW_WHEELS", "SLOW_LEGS"),
        ("idle mates", "SLOW_LEGS if k.drive_kind == GAIT else SLOW_WHEELS", "SLOW_WHEELS"),
        ("idle mates", "robot.vx * robot.vx + robot.vy * robot.vy < slow * slow", "robot.vx * robot.vx < slow * slow"),
        ("idle mates", "tally.mates[team] -= k.dt", "pass"),
        ("idle mates", "tally.idle[team] -= k.dt", "pass"),
        ("idle mates", "trail.nearest_counts[team] >= 1", "True"),
        ("idle mates", "trail.nearest_counts[team] == 2", "trail.nearest_counts[team] >= 1"),
        ("idle mates", "squared < trail.nearest[team]", "squared > trail.nearest[team]"),
        ("idle mates", "trail.nearest[team], trail.nearest_counts[team] = NOBODY, 0", "pass"),
        ("idle mates", "robot.keeper == 1", "False", "count_standing"),
    ],
    STEPS + "a_goalkeeper_is_away_a_quarter_of_the_pitch_from_its_goal_and_in_it_behind_its_line": [
        ("goalkeeper away", "ahead * ahead + robot.y * robot.y > far * far", "ahead * ahead > far * far"),
        ("goalkeeper away", "FAR = 0.25", "FAR = 0.26"),
        ("goalkeeper away", "direction_of(match, robot.team) * robot.x", "robot.x", "count_keeper"),
        ("goalkeeper in goal", "ahead < 0.0", "ahead < 0.1"),
        ("goalkeeper in goal", "tally.keeper_in_goal[robot.team] += k.dt", "pass"),
    ],
    GOALS + "a_dribble_in_touch_with_an_opponent_within_three_seconds_is_a_push_and_not_in_the_legs_of_a_mate": [
        ("goals by kind", "player.contact = match.step", "pass"),
        ("goals by kind", "robot.locked > player.locked", "True"),
    ],
    GOALS + "goals_within_ten_seconds_of_a_goalkeeper_in_contact_with_opponents_for_one_say_so": [
        ("goals after a pushed goalkeeper", "PUSHED - 0.5 * k.dt", "PUSHED - 1.5 * k.dt"),
        (
            "goals after a pushed goalkeeper",
            "trail.keeper_pushed[robot.team] = match.step",
            "trail.keeper_pushed[1 - robot.team] = match.step",
        ),
    ],
    GOALS + "in_a_scrum_only_who_has_kept_the_ball_for_a_second_and_still_has_it_dribbles": [
        ("goals by kind", "trail.crowded = step", "pass"),
    ],
}
PARTS = {"counting": IN_COUNTING, "players": IN_PLAYERS}
MUTANTS = mutants_of(STATISTICS, PARTS)
