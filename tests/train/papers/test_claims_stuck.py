"""The runs of the claims on collisions stand as they say: held robots stay, anchored ones too, causes are known."""

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK, ROTATE
from soccer_env.match.staging import memory_of
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.claims.stuck import detection, runs, surface
from soccer_env.train.papers.claims.stuck.branches import count_hits
from soccer_env.train.papers.claims.stuck.sampled import behaviours, branch, distance_from_camera, sample_moments
from soccer_env.train.papers.staging import distance_to_ball, play
from soccer_env.types import HOME

BATCH = Batch("test", 0, 0)


def test_a_held_robot_goes_nowhere_can_turn_and_notices() -> None:
    match = runs.set_up_walk(BATCH, 8, 0.4, 0.6)
    list(play(match, 1.0))
    assert (distance_from_camera(match, *distance_to_ball(match)) < 0.55).all()
    assert (memory_of(match)["behaviour"] == APPROACH).all()
    runs.immobilise_robots(match)
    x, y = match.robots["x"][:, 0].copy(), match.robots["y"][:, 0].copy()
    noticed = np.zeros(8, bool)
    for _ in play(match, 8.0):
        noticed |= runs.is_recovering(match)
    assert np.hypot(match.robots["x"][:, 0] - x, match.robots["y"][:, 0] - y).max() < 1e-3
    assert noticed.mean() > 0.7


def test_one_in_the_way_that_is_anchored_stays_and_overlaps_with_the_straight_way() -> None:
    match = runs.set_up_blocked_path(BATCH, 16, recovery=False)
    robot, other = match.robots[:, 0].copy(), match.robots[:, 1].copy()
    x, y = other["x"] - robot["x"], other["y"] - robot["y"]
    aside = np.abs(-np.sin(robot["heading"]) * x + np.cos(robot["heading"]) * y)
    assert (aside <= runs.ABREAST + 1e-9).all() and (aside >= runs.ABREAST - runs.OVERLAP - 1e-9).all()
    assert np.abs(distance_to_ball(match)[1]).max() < 1e-9
    list(play(match, 6.0))
    moved = np.hypot(match.robots["x"][:, 1] - other["x"], match.robots["y"][:, 1] - other["y"])
    assert (moved[match.matches["score"].sum(axis=1) == 0] < 1e-3).all()
    assert match.robot_events["collision"][:, 0].any()


def test_branches_are_the_same_until_somebody_recovers() -> None:
    moments = sample_moments(BATCH)
    rows = np.flatnonzero(moments.team == HOME)
    matches = [branch(BATCH, moments, rows, HOME, {"recovery": recovery}) for recovery in (True, False)]
    recovered = np.zeros(len(rows), bool)
    np.testing.assert_array_equal(matches[0].robots["x"], moments.parts["robots"]["x"][rows])
    for _ in zip(*(play(match, 3.0) for match in matches), strict=True):
        doing = behaviours(matches[0])
        recovered |= ((doing >= BACK) & (doing <= ROTATE)).any(axis=1)
        same = (matches[0].robots["x"] == matches[1].robots["x"]).all(axis=1)
        assert same[~recovered].all()
    assert recovered.any() and not recovered.all() and not same.all()


def test_moments_without_the_flags_that_are_asked_for_do_not_count() -> None:
    found = {"near": np.array([[1.0, 0.0, np.nan]]), "freed": np.array([[5.0, np.nan, np.nan]])}
    trials, hits = count_hits(found, lambda f: f["freed"] <= 10.0)
    assert trials.tolist() == [2.0] and hits.tolist() == [1.0]
    assert count_hits(found, lambda f: f["freed"] <= 10.0, near=0.0)[0].tolist() == [1.0]


def test_the_cause_of_a_false_alarm_is_the_first_that_holds() -> None:
    signs = [
        (0.05, 1.0, 0.0, 0.2), (0.0, 1.0, 0.0, 0.2), (0.0, 0.0, 0.5, 0.5), (-0.1, 0.0, 0.0, 0.2), (0.0, 0.1, 0.1, 0.6),
    ]  # fmt: skip
    found = [detection.CAUSES[detection.cause_of(np.array(one))] for one in signs]
    assert found == ["receding", "turning", "turning", "near", "other"]


def test_the_area_under_the_curve_is_one_for_what_is_apart_and_a_half_for_what_is_the_same() -> None:
    assert detection.roc_area({"free": np.array([-3.0, -2.0]), "stuck": np.array([0.0, 1.0])}) == 1.0
    rng = np.random.default_rng(1)
    same = {"free": rng.normal(size=4000), "stuck": rng.normal(size=4000)}
    assert detection.roc_area(same) == pytest.approx(0.5, abs=0.02)


def settings_with(one: float, two: float, good: tuple[int, int] | None = None) -> dict[str, np.ndarray]:
    """Return samples of 40 runs: shares of false alarms everywhere, and robots that notice in time at `good` alone."""
    shape = (40, len(surface.COUNTS), len(surface.TIMES))
    names = ("near", "near soon", "all", "all late", "one", "two", "approaches")
    samples = {name: np.ones(shape) for name in names} | {"half": np.arange(40) % 2}
    samples["one"][round(40 * one) :], samples["two"][round(40 * two) :] = 0.0, 0.0
    if good is not None:
        samples["near soon"] = np.zeros(shape)
        samples["near soon"][:, good[0], good[1]] = 1.0
    return samples


def test_how_many_times_fewer_alarms_there_are_is_unknown_without_any() -> None:
    assert np.isnan(surface.alarm_ratio(settings_with(0.0, 0.0)))
    assert surface.alarm_ratio(settings_with(0.1, 0.0)) == 8.0
    assert surface.alarm_ratio(settings_with(0.5, 0.1)) == 5.0


def test_a_sentence_is_judged_at_the_setting_that_suits_it() -> None:
    samples = settings_with(0.5, 0.0, good=(1, 2))
    assert surface.at_best_setting(samples, "S22")["near soon"].all()
    assert surface.settings_that_hold(samples, "S22") == surface.settings_that_hold(samples, "S22", "S23") == 1.0
    assert surface.settings_that_hold(samples, "S23") == 16.0


def test_no_run_is_judged_at_a_setting_that_it_helped_to_choose() -> None:
    samples = settings_with(0.5, 0.0, good=(1, 2))
    samples["near soon"][1::2] = 0.0
    samples["near soon"][1::2, 3, 3] = 1.0  # another setting suits the other half
    assert not surface.at_best_setting(samples, "S22")["near soon"].any()
