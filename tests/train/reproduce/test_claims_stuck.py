"""The runs of the claims on collisions stand as they say: held robots stay, anchored ones too, causes are known."""

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK
from soccer_env.staging import memory_of
from soccer_env.train.reproduce.claim import Batch
from soccer_env.train.reproduce.claims import all_claims, find_claims
from soccer_env.train.reproduce.claims.stuck import detection as stuck_detection
from soccer_env.train.reproduce.claims.stuck import false_alarms, recovery, stealing
from soccer_env.train.reproduce.claims.stuck.runs import (
    ABREAST,
    OVERLAP,
    behind_post,
    hold,
    recover,
    recovers,
    walk_up,
)
from soccer_env.train.reproduce.staging import ball_from, play
from soccer_env.train.reproduce.verdicts import find

BATCH = Batch("test", 0, 0)


def test_a_held_robot_goes_nowhere_can_turn_and_notices() -> None:
    match = walk_up(BATCH, 8, 0.6, 0.9)
    for _ in play(match, 1.0):
        pass
    assert (ball_from(match)[0] < 0.85).all() and (memory_of(match)["behaviour"] == APPROACH).all()
    hold(match)
    x, y = match.robots["x"][:, 0].copy(), match.robots["y"][:, 0].copy()
    noticed = np.zeros(8, bool)
    for _ in play(match, 8.0):
        noticed |= recovers(match)
    assert np.hypot(match.robots["x"][:, 0] - x, match.robots["y"][:, 0] - y).max() < 1e-3
    assert noticed.mean() > 0.7


def test_one_in_the_way_that_is_anchored_stays_and_overlaps_with_the_straight_way() -> None:
    match = behind_post(BATCH, 16, recovery=False)
    robot, other = match.robots[:, 0].copy(), match.robots[:, 1].copy()
    x, y = other["x"] - robot["x"], other["y"] - robot["y"]
    aside = np.abs(-np.sin(robot["heading"]) * x + np.cos(robot["heading"]) * y)
    assert (aside <= ABREAST + 1e-9).all() and (aside >= ABREAST - OVERLAP - 1e-9).all()
    assert np.abs(ball_from(match)[1]).max() < 1e-9
    for _ in play(match, 6.0):
        pass
    moved = np.hypot(match.robots["x"][:, 1] - other["x"], match.robots["y"][:, 1] - other["y"])
    assert (moved[match.matches["score"].sum(axis=1) == 0] < 1e-3).all()
    assert match.robot_events["collision"][:, 0].any()


def test_without_an_anchor_a_standing_robot_gives_way_by_millimetres() -> None:
    match = behind_post(BATCH, 16, recovery=False)
    match.rebuild()  # bodies as the league has them
    other = match.robots[:, 1].copy()
    for _ in play(match, 8.0):
        pass
    moved = np.hypot(match.robots["x"][:, 1] - other["x"], match.robots["y"][:, 1] - other["y"])
    assert 0.0015 < moved.max() < 0.01


def test_a_recovery_that_is_begun_for_it_goes_as_the_team_goes() -> None:
    match = recovery.begin_recovery(BATCH, 0.4, back_steps=2)
    assert (memory_of(match)["behaviour"] == BACK).all() and (memory_of(match)["tries"] == 1).all()
    seen = set()
    for _ in play(match, 5.0):
        seen |= set(memory_of(match)["behaviour"].tolist())
    assert BACK in seen and APPROACH in seen
    recover(match, np.arange(match.count) < 3)
    assert (memory_of(match)["behaviour"][:3] == BACK).all()


@pytest.mark.parametrize(
    ("signs", "cause"),
    [
        ((0.05, 1.0, 0.0, 0.2), "receding"),
        ((0.0, 1.0, 0.0, 0.2), "turning"),
        ((0.0, 0.0, 0.5, 0.5), "turning"),
        ((-0.1, 0.0, 0.0, 0.2), "near"),
        ((0.0, 0.1, 0.1, 0.6), "other"),
    ],
)
def test_the_cause_of_a_false_alarm_is_the_first_that_holds(signs: tuple[float, ...], cause: str) -> None:
    assert false_alarms.CAUSES[false_alarms.cause_of(np.array(signs))] == cause


def test_the_area_under_the_curve_is_one_for_what_is_apart_and_a_half_for_what_is_the_same() -> None:
    apart = {"free": np.array([-3.0, -2.0]), "stuck": np.array([0.0, 1.0])}
    assert stuck_detection.area(apart) == 1.0
    rng = np.random.default_rng(1)
    same = {"free": rng.normal(size=4000), "stuck": rng.normal(size=4000)}
    assert stuck_detection.area(same) == pytest.approx(0.5, abs=0.02)


def test_how_many_times_fewer_alarms_there_are_is_unknown_without_any() -> None:
    none = {"counters 1": np.zeros(3), "counters 2": np.zeros(3)}
    assert np.isnan(false_alarms.fewer(none, "counters"))
    assert false_alarms.fewer({"counters 1": np.ones(3), "counters 2": np.zeros(3)}, "counters") == 6.0


def test_a_ball_is_won_now_and_then_and_now_and_then_not() -> None:
    won = stealing.steal(BATCH, avoid=False)
    assert 0.2 < won.mean() < 1.0


@pytest.mark.slow
@pytest.mark.parametrize("name", ["S03", "S04", "S22", "S26", "S27", "S28", "S29"])
def test_a_batch_of_a_claim_has_the_units_that_its_criteria_need(name: str) -> None:
    claim = all_claims()[name]
    samples = claim.measure(Batch(name, 1, 0))
    assert len({len(array) for array in samples.values()}) == 1
    for criterion in claim.criteria:
        assert np.isfinite(find(criterion, samples).estimate)
    claim.figures(samples)


def test_the_claims_on_collisions_are_built() -> None:
    ids = ["S01", "S02", "S03", "S04", *(f"S{number}" for number in range(22, 31))]
    assert [claim.id for claim in find_claims(ids, all_claims())] == ids
    assert all_claims()["S26"].without is not None
