"""Mutants of what a player of sacks-2001 does with the ball, and of the switches of what the team was before."""

from tests.mutation.mutant import Mutant

PLANNER, XLA = "baselines/sacks_2001/planner.py", "baselines/sacks_2001/xla.py"
GOALKEEPER, SHOOTING = "baselines/sacks_2001/goalkeeper.py", "baselines/sacks_2001/shooting.py"
STUCK, STEERING = "baselines/sacks_2001/stuck.py", "baselines/sacks_2001/steering.py"
BALL, BLOB, PLAYERS = (
    "soccer_env/belief/legged/ball.py",
    "soccer_env/belief/legged/ball_blob.py",
    "soccer_env/belief/legged/players.py",
)
TEST = "tests/baselines/sacks_2001/test_team.py::"
KNEW = TEST + "test_ms52_what_robots_knew_before_is_a_switch_that_changes_play"

MUTANTS = [
    Mutant(
        "MS26",
        PLANNER,
        "return SHOOT",
        "return DRIBBLE",
        TEST + "test_ms26_it_goes_to_the_ball_orbits_it_to_face_the_goal_and_shoots",
    ),
    Mutant(
        "MS26",
        PLANNER,
        "shoots and abs(off) < play.orbit_until",
        "shoots",
        TEST + "test_ms26_it_dribbles_round_who_is_in_the_way_and_shoots_where_nobody_is",
    ),
    Mutant(
        "MS26",
        SHOOTING,
        "play.avoidance == 0 or not is_somebody_in_way(belief, tracks, k, play)",
        "True",
        TEST + "test_ms26_it_dribbles_round_who_is_in_the_way_and_shoots_where_nobody_is",
    ),
    Mutant(
        "MS26",
        SHOOTING,
        "play.shoots == 0",
        "play.shoots == 2",
        TEST + "test_ms26_a_team_that_shoots_not_at_all_dribbles_to_the_goal",
    ),
    Mutant(
        "MS26",
        SHOOTING,
        "play.choose_shots == 1",
        "play.choose_shots == 2",
        TEST + "test_ms26_who_chooses_shots_does_not_shoot_while_it_faces_away_from_the_goal_or_is_far_from_it",
        where="may_shoot",
    ),
    Mutant(
        "MS27",
        XLA,
        "play.avoid_chasing == 1",
        "play.avoid_chasing <= 1",
        TEST + "test_ms27_others_are_avoided_with_the_ball_alone",
    ),
    Mutant(
        "MS27",
        PLANNER,
        "has_ball = memory.had_ball < play.possession_time",
        "has_ball = memory.had_ball <= 0.0",
        TEST + "test_ms27_a_ball_that_was_between_the_paws_counts_as_there_for_a_while",
    ),
    Mutant(
        "MS52",
        PLANNER,
        "play.avoidance == 0",
        "play.avoidance == 2",
        TEST + "test_ms52_without_avoidance_the_ball_is_orbited_instead_of_dribbled",
    ),
    Mutant(
        "MS52",
        STUCK,
        "play.two_counters == 0",
        "play.two_counters == 2",
        TEST + "test_ms52_with_one_counter_a_robot_near_the_ball_thinks_itself_stuck",
    ),
    Mutant(
        "MS52",
        STEERING,
        "play.clamp == 0",
        "play.clamp == 2",
        TEST + "test_ms52_without_the_clamp_a_player_ahead_pushes_the_robot_back",
    ),
    Mutant("MS52", BALL, "forward, left = (0.0 * forward, 0.0 * left)", "pass", KNEW),
    Mutant("MS52", BLOB, "w.ball_range == BY_INFRARED", "w.ball_range == 9", KNEW),
    Mutant("MS52", PLAYERS, "SLOTS['nearest']", "9", KNEW),
    Mutant(
        "MS53",
        GOALKEEPER,
        "passes_by(ball) if play.angular_keeper == 1 else ball.distance * ball.bearing",
        "ball.distance * ball.bearing",
        TEST + "test_ms53_the_goalkeeper_steps_to_where_the_ball_will_pass",
    ),
    Mutant(
        "MS53",
        GOALKEEPER,
        "abs(aside) < reach",
        "True",
        TEST + "test_ms53_the_goalkeeper_blocks_what_passes_within_the_reach_of_its_legs",
    ),
    Mutant(
        "MS53",
        GOALKEEPER,
        "-ball.radial if play.keeper_speed == 1 else FAST",
        "FAST",
        TEST + "test_ms53_the_goalkeeper_blocks_so_that_the_ball_comes_while_its_legs_are_spread",
    ),
    Mutant(
        "MS53",
        PLANNER,
        "play.passes == 1",
        "play.passes == 2",
        TEST + "test_ms53_a_remembered_team_mate_is_passed_to_when_the_goal_is_blocked",
    ),
]
