"""Mutants of where a robot believes itself to be."""

from tests.mutation.mutant import Mutant

OWN_POSE, PARTICLES = "soccer_env/belief/own_pose.py", "soccer_env/belief/particles.py"
LANDMARKS, LINES = "soccer_env/belief/legged/landmarks.py", "soccer_env/belief/omni/field_lines.py"
TEST_POSE, TEST_PARTICLES = "tests/belief/test_own_pose.py::", "tests/belief/test_particles.py::"
TEST_LANDMARKS, TEST_LINES = "tests/belief/legged/test_landmarks.py::", "tests/belief/omni/test_field_lines.py::"

MUTANTS = [
    Mutant(
        "MH08",
        "soccer_env/belief/legged/own_pose.py",
        "weigh_by_landmarks(particles, view, motion, noise, hand, k, w)",
        "move_particles(particles, motion, *field_of(k), noise, hand)",
        TEST_POSE + "test_mh08_a_robot_that_was_told_its_pose_keeps_it_while_it_walks_about_and_slips[legged-2001]",
    ),
    Mutant(
        "MH08",
        OWN_POSE,
        "int(count * share_of_fresh(memory, exp(-cost / seen), w) + 0.5)",
        "0",
        TEST_POSE + "test_mh08_a_robot_that_is_carried_away_finds_itself_again[middle-size-2006]",
    ),
    Mutant(
        "MH08",
        OWN_POSE,
        "max(own.confidence - w.pose_fading * k.dt, 0.0)",
        "SURE",
        TEST_POSE + "test_mh08_without_particles_the_same_robot_drifts_and_its_confidence_falls_to_nothing",
    ),
    Mutant(
        "MH08",
        LANDMARKS,
        "particle.weight = cost",
        "particle.weight = 0.0 * cost",
        TEST_LANDMARKS + "test_mh08_the_true_pose_costs_next_to_nothing_and_others_more",
    ),
    Mutant(
        "MH08",
        LINES,
        "bounded(off * off * sharp, OUTLIER)",
        "0.0 * off",
        TEST_LINES + "test_mh08_the_true_pose_costs_next_to_nothing_and_others_more",
    ),
    Mutant(
        "MH08",
        LINES,
        "goal_cost(view.goals[j], x, y, cosine, sine, k, w)",
        "0.0 * goal_cost(view.goals[j], x, y, cosine, sine, k, w)",
        TEST_LINES + "test_mh08_goals_tell_a_pose_from_its_half_turn_which_lines_cannot",
    ),
    Mutant(
        "MH08",
        PARTICLES,
        "pointer < reached",
        "copies < 1",
        TEST_PARTICLES + "test_mh08_resampling_keeps_each_particle_as_often_as_its_weight_deserves",
    ),
    Mutant(
        "MH08",
        PARTICLES,
        "there[0] > REPLACED * weight and there[0] > SETTLED * total",
        "weight < 0.0",
        TEST_PARTICLES + "test_mh08_the_pose_jumps_to_another_cluster_only_if_that_is_clearly_heavier",
    ),
    Mutant(
        "MH08",
        PARTICLES,
        "square < most",
        "square >= 0.0",
        TEST_PARTICLES + "test_mh08_of_two_clusters_the_pose_is_in_one_and_not_between_them",
    ),
    Mutant(
        "MH08",
        PARTICLES,
        "min(max(lost, w.pose_fresh), SHARE_MOST)",
        "w.pose_fresh",
        TEST_PARTICLES + "test_mh08_more_particles_are_drawn_anew_the_worse_they_fit",
    ),
]
