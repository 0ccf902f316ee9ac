"""Mutants of the team of 2006: driving, obstacles, goalkeeper, interception, passes, roles, what it hears."""

from tests.mutation.mutant import By, mutants_of

TEST = "tests/baselines/heinemann_2006/test_{}.py::test_{}"
AIMS, ENDS = (
    TEST.format("driving", "mh01_what_it_looks_at_is_free_of_where_it_drives"),
    TEST.format("driving", "mh14_it_follows_the_plan_to_its_end_within_the_bases_limits"),
)
ANEW = TEST.format("driving", "mh14_every_decision_plans_anew_from_where_the_robot_is")
BEHIND = TEST.format("driving", "mh15_whoever_moves_is_passed_behind_and_a_static_planner_does_not_know")
BOUNDED = TEST.format("driving", "mh25_an_obstacle_is_no_faster_than_robots_are")
CIRCLE = TEST.format("goalkeeper", "mh19_on_the_half_circle_it_stands_on_the_line_from_ball_to_goal")
LINE = TEST.format("goalkeeper", "mh19_on_the_goal_line_it_stands_where_the_line_from_ball_to_goal_meets_it")
SHOT = TEST.format("goalkeeper", "mh20_a_shot_is_a_ball_that_rolls_over_the_line_between_the_posts")
SHOTS_ONLY = TEST.format(
    "goalkeeper", "mh20_it_moves_into_a_shot_only_and_the_passive_one_stays_on_the_line_from_ball_to_goal"
)
CYCLE = TEST.format("team", "mh03_it_decides_anew_every_20_ms_or_once_in_a_longer_cycle")
INTO = TEST.format("goalkeeper", "mh20_it_moves_perpendicular_into_the_trajectory")
MOVE = TEST.format("goalkeeper", "mh21_reaction_and_acceleration_tell_how_long_a_move_takes")
SPARE = TEST.format("goalkeeper", "mh21_what_it_can_spare_is_the_balls_time_less_its_own")
LATE = TEST.format("goalkeeper", "mh21_too_late_for_the_nearest_point_it_goes_where_it_is_least_late")
MEET = TEST.format("goalkeeper", "mh22_a_rolling_ball_is_met_at_the_first_moment_at_which_the_robot_can_be_there")
FIRST = TEST.format("passing", "mh22_the_player_takes_a_rolling_ball_that_can_be_there_first_not_the_nearest_one")
CHOSEN = TEST.format("passing", "mh04_a_pass_goes_to_the_mate_that_is_nearest_to_the_goal")
NOBODY = TEST.format("passing", "mh04_nobody_is_passed_to_who_is_marked_behind_an_opponent_near_far_or_behind")
ARRIVES = TEST.format("passing", "mh04_a_pass_arrives_at_the_speed_that_is_asked_for")
ONE_EACH = TEST.format("team", "mh23_one_attacks_one_defends_and_the_others_support")
GIVEN_UP = TEST.format("team", "mh23_a_role_is_given_up_for_somebody_clearly_nearer_after_a_while")
ROUND = TEST.format("dribbling", "mh24_it_dribbles_the_ball_round_still_obstacles_and_touches_hardly_any")
BEARS = TEST.format("dribbling", "mh24_at_speed_it_turns_no_faster_than_the_guide_bears_and_slows_down_to_turn")
KEEPS = TEST.format("dribbling", "mh24_it_turns_with_the_ball_and_keeps_it_and_scores")
HEARD = TEST.format("hearing", "mh05_a_call_is_heard_after_the_radios_delay")
NO_SOONER = TEST.format("hearing", "mh05_a_call_that_takes_back_another_is_heard_no_sooner_for_it")
PLACES = TEST.format("hearing", "mh05_nobody_goes_to_a_place_for_a_restart_before_the_word_of_it_can_have_come")

PARTS: dict[str, By] = {
    "driving": {
        AIMS: [
            ("MH01", "play.turning * k.drive_acceleration / max(speed, 1e-3)", "100.0"),
            ("MH01", "wrap(facing - sight.heading)", "wrap(atan2(vy, vx) - sight.heading)"),
        ],
        ENDS: [
            ("MH14", "1.0 if change <= most else most / change", "1.0"),
            ("MH14", "max(final, braking_speed(k, play.skills, plan.length))", "k.drive_forward"),
            ("MH14", "place_on(plan.path, plan.count, ahead, place)", "place_on(plan.path, plan.count, 9.0, place)"),
        ],
        ANEW: [
            (
                "MH14",
                "plan_to(k, play, scratch, x, y)",
                "if scratch.plan[0].count == 0: plan_to(k, play, scratch, x, y)",
            )
        ],
    },
    "attacking": {ROUND: [("MH24", "way_round(k, play, scratch)", "ux, uy")]},
    "team": {CYCLE: [("MH03", "max(skill.wait, play.cycle - 0.5 * k.dt)", "skill.wait")]},
    "crowd": {
        BEHIND: [("MH15", "bounded(sight.other_vx[i], sight.other_vy[i], play)", "(0.0, 0.0)")],
        BOUNDED: [("MH25", "speed <= play.fastest", "True")],
    },
    "goalkeeper": {
        CIRCLE: [("MH19", "play.keeper_radius * y / away", "0.0")],
        LINE: [("MH19", "play.keeper_out * y / x", "y")],
        SHOT: [
            ("MH20", "abs(crossing) < 0.5 * k.pitch_goal_width + play.shot_wide", "True"),
            ("MH20", "rolling_time(speed, far, k) < 1e6", "True"),
        ],
        INTO: [
            ("MH20", "nearest = foot(sight.x - sight.ball_x, sight.y - sight.ball_y, ux, uy, last)", "nearest = last")
        ],
        SHOTS_ONLY: [
            ("MH20", "play.keeper == ACTIVE and is_shot(sight, k, play)", "is_shot(sight, k, play)"),
            ("MH20", "play.keeper == ACTIVE and is_shot(sight, k, play)", "play.keeper == ACTIVE"),
        ],
        SPARE: [("MH21", "max(play.reaction - k.dt * k.delay_steps, 0.0)", "0.0")],
        LATE: [("MH21", "spare > best_spare", "False")],
    },
    "intercepting": {
        MOVE: [
            ("MH21", "reaction + sqrt(2.0 * whole / a) - speed / a", "sqrt(2.0 * whole / a) - speed / a"),
            ("MH21", "reaction + whole / top + 0.5 * top / a - speed / a", "reaction + whole / top"),
        ],
        MEET: [("MH22", "rolls_to(sight, k, t)", "rolls_to(sight, k, 0.0)")],
    },
    "passing": {
        CHOSEN: [("MH04", "gain + LANE_WORTH * room - TURN_COST * turned_away(sight, ux, uy)", "-gain")],
        NOBODY: [("MH04", "room < play.pass_room or opponent_near(sight, x, y, play.pass_free)", "False")],
        ARRIVES: [("MH04", "strength_for(k, far, play.pass_arrival) if play.pass_strength == 1 else 1.0", "1.0")],
    },
    "roles": {
        FIRST: [("MH22", "play.intercepts == 0 or length(sight.ball_vx, sight.ball_vy) < ROLLS", "True")],
        ONE_EACH: [("MH23", "rank += 1", "rank += 0"), ("MH23", "way < least", "False")],
        GIVEN_UP: [
            ("MH23", "memory.role_age > play.role_time or memory.begun == 0", "True"),
            ("MH23", "keeps if memory.begun == 1 and memory.skill.rank == 0 else 0.0", "0.0"),
        ],
    },
    "dribbling": {
        BEARS: [
            ("MH24", "clip(wanted, -most, most)", "wanted"),
            ("MH24", "min(play.dribble_speed * sight.pace, grip_speed(play, wanted))", "play.dribble_speed"),
        ],
    },
    "settings": {KEEPS: [("MH24", "dribble_grip: float = 0.35", "dribble_grip: float = 20.0")]},
    "playing": {
        HEARD: [("MH05", "memory.listens == 0 or memory.said_age > play.word_delay - SAME_TIME", "True")],
        NO_SOONER: [
            (
                "MH05",
                "0.0 if is_new(situation, said) else memory.said_age + sight.elapsed",
                "memory.said_age + sight.elapsed",
            ),
            ("MH05", "situation.phase_clock < said.clock", "False"),
        ],
        PLACES: [
            (
                "MH05",
                "heard.phase, heard.placing, heard.ours, heard.clock",
                "said.phase, said.placing, said.ours, said.clock",
            )
        ],
    },
}

MUTANTS = mutants_of("baselines/heinemann_2006/", PARTS)
