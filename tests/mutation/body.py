"""Mutants of a legged robot's league, modules, ranger, body, head and voice."""

from tests.mutation.mutant import Mutant

BODY, INFRARED = "soccer_env/perception/body.py", "soccer_env/perception/legged/infrared.py"
DRIVE, HEAD = "soccer_env/physics/drive.py", "soccer_env/belief/legged/head.py"
MEMORY, TALK, WORDS = (
    "soccer_env/belief/legged/believe.py",
    "soccer_env/belief/legged/talk.py",
    "soccer_env/ball_words.py",
)
GAIT, TEST_GAIT = "soccer_env/physics/gait.py", "tests/physics/test_gait.py::"
TEST_BLOCK = "tests/physics/test_block.py::"
INTERLOCK, TEST_INTERLOCK = "soccer_env/physics/solver/interlock.py", "tests/physics/test_interlock.py::"
TEST_SWING = (
    "tests/physics/test_blow_energy.py::test_ms51_a_paw_that_swings_hits_the_ball_at_twice_the_speed_of_the_walk"
)
TEST_HEAD, TEST_TALK = "tests/belief/legged/test_head.py::", "tests/belief/test_talk.py::"
TEST_FELT = "tests/perception/test_body.py::test_ms06_a_robot_feels_whether_it_lies_on_its_side"
TOUCH, TEST_TOUCH = "soccer_env/perception/legged/touch.py", "tests/perception/legged/test_touch.py::"
TEST_FILLED = "tests/senses/test_modules.py::test_ms01_memory_gets_percepts_alone_and_fills_the_shared_records"

MUTANTS = [
    Mutant(
        "MS01",
        MEMORY,
        "believe_players(percept, belief.own, tracks, memory.players, k, s, w, table)",
        "pass",
        TEST_FILLED,
    ),
    Mutant(
        "MS01",
        MEMORY,
        "choose_gaze(percept, belief, np.float64(memory.ball.height), memory.head, gaze, k, s, w)",
        "pass",
        TEST_FILLED,
    ),
    Mutant(
        "MS01",
        DRIVE,
        "(robot.gaze.pan, robot.gaze.tilt)",
        "gaze_at(robot, k, ball)",
        "tests/senses/test_modules.py::test_ms01_actuation_reads_what_memory_wrote",
    ),
    Mutant(
        "MS05",
        INFRARED,
        "reading if s.infrared_near <= reading <= s.infrared_far else 0.0",
        "reading",
        "tests/perception/legged/test_infrared.py::test_ms05_readings_outside_the_window_are_discarded",
    ),
    Mutant(
        "MS06",
        TOUCH,
        "touch.back = robot.placed",
        "touch.back = 1",
        TEST_TOUCH + "test_ms06_a_collision_presses_no_touch_sensor",
    ),
    Mutant(
        "MS06",
        TOUCH,
        "touch.back = robot.placed",
        "touch.back = 0",
        TEST_TOUCH + "test_ms06_who_puts_a_robot_down_starts_it_by_its_back",
    ),
    Mutant(
        "MS06",
        TOUCH,
        "LEGS // 2 if walks else LEGS",
        "LEGS",
        TEST_TOUCH + "test_ms06_paws_feel_the_ground_and_not_what_stands_before_them",
    ),
    Mutant(
        "MS06",
        TOUCH,
        "x * x + y * y + up * up <= reach * reach",
        "False",
        TEST_TOUCH + "test_ms06_a_ball_presses_the_chin_if_the_neck_lets_it_down",
    ),
    Mutant(
        "MS06",
        "soccer_env/belief/own_pose.py",
        "track.distance < 2.0 * k.body_reach",
        "track.distance < 0.0",
        "tests/belief/test_own_pose.py::test_ms06_that_somebody_may_push_is_seen_and_not_felt",
    ),
    Mutant(
        "MS06",
        BODY,
        "0 if robot.fallen > 0.0 else 1",
        "1",
        TEST_FELT,
    ),
    Mutant(
        "MS06",
        WORDS,
        "word < FARTHEST",
        "word < 1",
        TEST_TALK + "test_ms06_fifteen_words_tell_near_distances_finely_and_far_ones_coarsely",
    ),
    Mutant(
        "MS06",
        TALK,
        "word_for(ball.filtered_distance) if seen else SILENT",
        "SILENT",
        TEST_TALK + "test_ms06_a_word_is_heard_by_team_mates_alone_half_a_second_later",
    ),
    Mutant(
        "MS06",
        TALK,
        "uniform(noise[r], RADIO) < s.audio_loss",
        "False",
        TEST_TALK + "test_the_share_of_messages_that_is_lost_is_the_one_that_is_set",
    ),
    Mutant(
        "MS06",
        "soccer_env/belief/talk.py",
        "frame + wait",
        "frame",
        TEST_TALK + "test_ms06_a_word_is_heard_by_team_mates_alone_half_a_second_later",
    ),
    Mutant(
        "MS07",
        DRIVE,
        "toward(robot.pan, clip(pan, -k.head_pan_limit, k.head_pan_limit), k.head_pan_speed * k.dt)",
        "toward(0.0 * robot.pan, clip(pan, -k.head_pan_limit, k.head_pan_limit), k.head_pan_speed * k.dt)",
        "tests/repository/test_mechanisms.py::test_ms07_the_head_keeps_the_ball_ahead_of_the_camera",
    ),
    Mutant(
        "MS07",
        HEAD,
        "asin(clip(s.camera_up / away, -1.0, 1.0))",
        "0.0 * asin(clip(s.camera_up / away, -1.0, 1.0))",
        TEST_HEAD + "test_ms07_the_believed_ball_is_put_at_the_centre_of_the_picture",
    ),
    Mutant(
        "MS07",
        HEAD,
        "height if ball.age == 0.0 else k.ball_radius",
        "k.ball_radius",
        TEST_HEAD + "test_ms07_a_blob_comes_to_the_middle_of_the_picture_however_far_it_seems",
    ),
    Mutant(
        "MS07",
        HEAD,
        "height if ball.age == 0.0 else k.ball_radius",
        "height",
        TEST_HEAD + "test_ms07_a_ball_that_was_seen_a_moment_ago_is_still_looked_at",
    ),
    Mutant(
        "MS07",
        HEAD,
        "ball.bearing if ball.bearing != 0.0 else handedness",
        "handedness",
        TEST_HEAD + "test_ms07_the_search_begins_on_the_side_where_the_ball_was_believed",
    ),
    Mutant(
        "MS07",
        HEAD,
        "clip(pan, -k.head_pan_limit, k.head_pan_limit)",
        "clip(0.0 * pan, -k.head_pan_limit, k.head_pan_limit)",
        TEST_HEAD + "test_ms07_the_ball_stays_at_the_centre_of_the_picture_while_the_robot_walks",
    ),
    Mutant(
        "MS51",
        GAIT,
        "ahead if leg == 0 or leg == 3 else -ahead",
        "ahead",
        TEST_GAIT + "test_ms51_a_paw_in_its_stance_stands_still_and_one_that_swings_is_twice_as_fast_as_the_walk",
    ),
    Mutant(
        "MS51",
        GAIT,
        "swing(robot.gait_phase, k.gait_steps, leg) * 0.25 * k.gait_steps * k.dt",
        "swing(robot.gait_phase, k.gait_steps, leg) * 0.5 * k.gait_steps * k.dt",
        TEST_GAIT + "test_ms51_at_12_cm_per_s_and_steps_of_half_a_second_a_stroke_is_3_cm",
    ),
    Mutant(
        "MS51",
        GAIT,
        "robot.walk.left + robot.walk.turn * x",
        "robot.walk.left",
        TEST_GAIT + "test_ms51_a_robot_that_turns_on_the_spot_moves_its_paws_round_its_centre",
    ),
    Mutant(
        "MS51",
        "soccer_env/physics/contacts.py",
        "length(ahead - x - off_x, left - y - off_y)",
        "length(ahead - x, left - y)",
        "tests/physics/test_touches.py::test_ms51_a_paw_touches_the_ball_where_it_is_in_its_stroke",
    ),
    Mutant(
        "MS51",
        "soccer_env/physics/solver/walls.py",
        "half_width - k.pitch_board_foot - abs(post.field_y)",
        "half_width - abs(post.field_y)",
        "tests/physics/test_space.py::test_ms51_paws_meet_a_board_at_its_foot_and_trunk_and_ball_the_upright_board",
    ),
    Mutant(
        "MS51",
        "soccer_env/physics/solver/posts.py",
        "contact.surface_x = -vx",
        "contact.surface_x = 0.0",
        TEST_SWING,
    ),
    Mutant(
        "MS53",
        "soccer_env/physics/solver/posts.py",
        "share = share_along(x, y, leg_x, leg_y)",
        "share = 0.0",
        TEST_BLOCK + "test_ms53_spread_legs_stop_a_ball_as_far_aside_as_they_reach_and_none_a_centimetre_farther",
    ),
    Mutant(
        "MS53",
        "soccer_env/physics/block.py",
        "left = robot.kick_clock - later",
        "left = k.block_recover_time",
        TEST_BLOCK + "test_ms53_a_block_takes_the_time_of_its_joints_and_stands_for_as_long_as_the_league_says",
    ),
    Mutant(
        "MS53",
        "soccer_env/physics/block.py",
        "length(x - share * leg_x, y - share * leg_y)",
        "length(x, y)",
        TEST_BLOCK + "test_ms53_a_blocked_ball_is_touched_and_lies_off_the_leg",
    ),
    Mutant(
        "MS53",
        "soccer_env/physics/block.py",
        "robot.keeper == 1",
        "robot.keeper < 2",
        TEST_BLOCK + "test_ms53_only_a_goalkeeper_blocks_and_only_a_ball_out_of_its_kickers_reach",
    ),
    Mutant(
        "MS53",
        "soccer_env/physics/block.py",
        "side = handedness if leg == 0 else -handedness",
        "side = 1.0 if leg == 0 else -1.0",
        TEST_BLOCK + "test_ms53_a_mirrored_block_is_the_mirror_of_a_block",
        where="paw_out",
    ),
    Mutant(
        "MS51",
        INTERLOCK,
        "contact.held = 1",
        "contact.held = 0",
        TEST_INTERLOCK + "test_ms51_a_leg_between_two_legs_of_another_robot_moves_straight_out_or_not_at_all",
    ),
    Mutant(
        "MS51",
        INTERLOCK,
        "(0.0, handedness) if gap == 2 else (0.0, -handedness)",
        "(0.0, -handedness) if gap == 2 else (0.0, handedness)",
        TEST_INTERLOCK + "test_ms51_it_comes_free_straight_apart",
    ),
    Mutant(
        "MS51",
        INTERLOCK,
        "gap_distance(k, gap, ahead, left, handedness) < k.body_tip_radius",
        "gap_distance(k, gap, ahead, left, handedness) < 2.0 * k.body_tip_radius",
        TEST_INTERLOCK + "test_ms51_a_leg_beside_the_gap_is_free",
    ),
    Mutant(
        "MS56",
        "soccer_env/leagues/legged_2001.py",
        "team_size=3",
        "team_size=4",
        "tests/repository/test_mechanisms.py::test_ms56_the_legged_preset_is_what_the_paper_says",
    ),
]
