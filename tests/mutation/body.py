"""Mutants of a legged robot's league, modules, ranger, body, head and voice."""

from tests.mutation.mutant import Mutant

BODY, INFRARED = "soccer_env/perception/body.py", "soccer_env/perception/legged/infrared.py"
DRIVE, HEAD = "soccer_env/physics/drive.py", "soccer_env/belief/legged/head.py"
MEMORY, TALK, WORDS = (
    "soccer_env/belief/legged/believe.py",
    "soccer_env/belief/legged/talk.py",
    "soccer_env/ball_words.py",
)
LEGS, TEST_LEGS = "soccer_env/physics/legs.py", "tests/physics/test_legs.py::"
TEST_HEAD, TEST_TALK = "tests/belief/legged/test_head.py::", "tests/belief/test_talk.py::"
TEST_FELT = "tests/perception/test_body.py::test_ms06_a_robot_feels_touch_and_whether_it_lies_on_its_side"
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
        "choose_gaze(percept, belief, memory.head, gaze, k, s, w)",
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
        BODY,
        "1 if events.touch == 1 or events.collision == 1 else 0",
        "0",
        TEST_FELT,
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
        LEGS,
        "LENGTH_PUSH * max(step - SHORT_STEP, 0.0)",
        "0.0 * max(step - SHORT_STEP, 0.0)",
        TEST_LEGS + "test_ms51_longer_steps_kick_the_ball_away",
    ),
    Mutant(
        "MS51",
        LEGS,
        "ANGLE_PUSH * max(angle - SMALL_ANGLE, 0.0)",
        "0.0 * max(angle - SMALL_ANGLE, 0.0)",
        TEST_LEGS + "test_ms51_steps_far_aside_lose_the_ball",
    ),
    Mutant(
        "MS51",
        LEGS,
        "CONTACT_PUSH if touched else 0.0",
        "CONTACT_PUSH if False else 0.0",
        TEST_LEGS + "test_ms51_pushes_grow_with_step_angle_and_contact",
    ),
    Mutant(
        "MS51",
        LEGS,
        "robot.target.forward = robot.target.left = robot.target.turn = 0.0",
        "pass",
        TEST_LEGS + "test_ms51_legs_interlock_with_a_robot_ahead_the_less_the_farther_aside_a_step_goes",
    ),
    Mutant(
        "MS56",
        "soccer_env/leagues/legged_2001.py",
        "team_size=3",
        "team_size=4",
        "tests/repository/test_mechanisms.py::test_ms56_the_legged_preset_is_what_the_paper_says",
    ),
]
