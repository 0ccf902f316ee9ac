"""Slips of the hand that an editing developer makes most. `make test-quick` has to notice each: `mutate.py --quick`.

The test of each is one that is in `tests/quick.txt`, which names what `make test-quick` runs.
"""

from tests.mutation.mutant import Mutant

MATCH, REPOSITORY = "tests/match/", "tests/repository/"

QUICK = [
    Mutant(
        "wrong sign of a rotation",
        "soccer_env/observations/truth.py",
        "into_frame(x, y, cosine, sine)",
        "into_frame(x, y, cosine, -sine)",
        "tests/observations/test_observations.py::test_entries_mean_what_the_layout_says",
        where="write_ball",
    ),
    Mutant(
        "home and away swapped",
        "soccer_env/referee/calls.py",
        "HOME if (ball.x > 0.0) == (match.home_direction > 0.0) else AWAY",
        "AWAY if (ball.x > 0.0) == (match.home_direction > 0.0) else HOME",
        "tests/referee/test_goals.py::test_an_own_goal_counts_for_the_opponents",
    ),
    Mutant(
        "one slot too few",
        "soccer_env/perception/ideal.py",
        "min(found + 1, slots)",
        "min(found + 1, slots - 1)",
        "tests/observations/test_observations.py::test_slots_hold_the_nearest_first_and_drop_the_farthest",
    ),
    Mutant(
        "memory not reset",
        "soccer_env/senses.py",
        "array[m] = np.zeros((), array.dtype)",
        "pass",
        "tests/senses/test_senses.py::test_an_episode_begins_with_nothing_remembered",
    ),
    Mutant(
        "degrees for radians",
        "soccer_env/leagues/legged_2001.py",
        "spread=10.0 * pi / 180.0",
        "spread=10.0",
        "tests/physics/test_kicker.py::test_kicks_stray_from_the_heading_with_the_leagues_deviation",
    ),
    Mutant(
        "stale row of REFERENCES.md",
        "soccer_env/REFERENCES.md",
        "| MS03 | `soccer_env.belief.legged.ball.confidence_in` |",
        "| MS03 | `soccer_env.belief.legged.ball.confidence_of` |",
        REPOSITORY + "test_references.py::test_references_are_true",
    ),
    Mutant(
        "import upward",
        "soccer_env/belief/legged/ball.py",
        "import numpy as np",
        "import numpy as np\nfrom soccer_env.perception.ideal import nearest_players",
        REPOSITORY + "test_layers.py::test_imports_point_downward",
    ),
    Mutant(
        "broken flag",
        "train/command_line.py",
        "words[0] not in get_args(What)",
        "words[0] not in ()",
        "tests/train/test_command_line.py::test_a_mistake_is_one_line_and_exit_code_2",
        where="run_list",
    ),
    Mutant(
        "entries in another order",
        "soccer_env/observations/truth.py",
        "row.ball_vx, row.ball_vy = forward / (abs(forward) + slow), aside / (abs(aside) + slow)",
        "row.ball_vy, row.ball_vx = forward / (abs(forward) + slow), aside / (abs(aside) + slow)",
        "tests/observations/test_observations.py::test_entries_mean_what_the_layout_says",
    ),
    Mutant(
        "wrong sign of another player's heading",
        "soccer_env/observations/truth.py",
        "clip(left, -1.0, 1.0)",
        "clip(-left, -1.0, 1.0)",
        "tests/observations/test_observations.py::test_the_heading_of_another_player_is_seen_from_the_robots_own",
    ),
    Mutant(
        "wrong sign of a reward",
        "soccer_env/rewards/terms.py",
        "weight if events.goal == robots[r].team else -weight",
        "-weight if events.goal == robots[r].team else weight",
        "tests/rewards/test_rewards.py::test_a_goal_pays_one_to_every_robot_of_the_team_and_costs_the_others_one_once",
    ),
    Mutant(
        "noise shared by two robots",
        "soccer_env/episodes.py",
        "1 + 2 * robots[r].number + robots[r].team",
        "1 + robots[r].number",
        "tests/test_random_numbers.py::test_no_two_robots_share_noise_nor_do_matches_or_episodes",
    ),
    Mutant(
        "save without the senses",
        "soccer_env/saving/saves.py",
        "match.batch.senses is not None",
        "False",
        "tests/senses/test_senses_saving.py::test_a_save_goes_on_with_the_same_senses",
    ),
    Mutant(
        "hash of the play without the ball",
        "soccer_env/saving/saves.py",
        "(match.matches, match.balls, robots)",
        "(match.matches, robots)",
        MATCH + "test_saving.py::test_a_replay_notices_that_the_ball_alone_is_another",
    ),
    Mutant(
        "one stream for all",
        "soccer_env/random_numbers.py",
        "key ^ (GOLDEN * np.uint64(owner + 1))",
        "key",
        "tests/test_random_numbers.py::test_streams_of_two_robots_are_unrelated",
    ),
]
