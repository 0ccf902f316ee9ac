"""What the middle-size claims make of light and places is right."""

import numpy as np
import pytest

from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.claims import all_claims, middle_size, own_pose
from soccer_env.train.papers.staging import MIDDLE, begin, play, put, stage

BATCH = Batch("test", 0, 0)


def test_recovery_is_when_a_robot_is_no_longer_lost_for_a_second() -> None:
    dt, lost = 0.25, np.ones((4, 12), bool)
    lost[0, 2:] = False  # found after 2 frames
    lost[1, 2:5] = False  # not for long enough
    lost[2, 3:6] = lost[2, 8:] = False  # not at once for long enough
    time = own_pose.recovery(lost, dt)
    assert time[[0, 2]] == pytest.approx([0.5, 2.0]) and np.isnan(time[[1, 3]]).all()


def test_who_is_carried_is_told_nothing_and_is_elsewhere() -> None:
    match = stage(BATCH, MIDDLE, matches=4, pose="particles", senses={"home": "sensors", "away": "ideal"})
    put(match, 0, 0.0, 0.0)
    put(match, 1, 2.0, 2.0)
    begin(match)
    for _ in play(match, 2.0):
        pass
    before = match.beliefs["own"][:, 0].copy()
    own_pose.carry_away(match, BATCH.rng(3))
    assert (np.hypot(match.robots["x"][:, 0], match.robots["y"][:, 0]) > own_pose.CARRIED).all()
    place, _ = own_pose.errors_of(match)
    assert (place > 1.5).all()
    assert (match.beliefs["own"][:, 0] == before).all()
    for _ in play(match, 0.02):
        pass
    assert (own_pose.errors_of(match)[0] > 0.5).any()  # it has not been told


def test_a_robot_that_stands_still_finds_out_where_it_is() -> None:
    match = stage(BATCH, MIDDLE, matches=8, pose="particles", senses={"home": "sensors", "away": "ideal"})
    put(match, 0, np.linspace(-4.0, 4.0, 8), np.linspace(-2.0, 2.0, 8), np.linspace(-3.0, 3.0, 8))
    begin(match)
    for _ in play(match, 3.0):
        pass
    place, heading = own_pose.errors_of(match)
    assert np.median(place) < 0.15 and np.median(heading) < 0.1


def test_drivers_stay_on_the_field_and_move() -> None:
    match = stage(BATCH, MIDDLE, matches=3, away=3)
    for r in range(4):
        put(match, r, 2.0 * r - 3.0, 0.0)
    begin(match)
    drivers = own_pose.Drivers(match, BATCH.rng())
    for step in play(match, 4.0, drivers.actions):
        drivers.steer(step)
    assert np.hypot(match.robots["vx"], match.robots["vy"]).mean() > 0.5 * own_pose.SPEED
    assert (np.abs(match.robots["x"]) < 6.0).all() and (np.abs(match.robots["y"]) < 4.0).all()


def counts(found: dict[str, list[float]]) -> dict[str, np.ndarray]:
    """Return samples of one match with ten frames in each bin of light."""
    bins = len(middle_size.BINS) - 1
    samples = {}
    for name, shares in found.items():
        samples[f"frames {name}"] = np.full((1, bins), 10.0)
        samples[f"found {name}"] = 40.0 * np.array([shares])
        samples[f"read {name}"], samples[f"square {name}"] = np.full((1, bins), 10.0), np.full((1, bins), 0.1)
    return samples


def test_shares_and_errors_go_by_the_light() -> None:
    samples = counts(
        {"constant": [0.9] * 6, "adaptive": [0.9, 0.9, 0.81, 0.9, 0.9, 0.9], "fixed": [0.9, 0.5] + [0.0] * 4}
    )
    assert middle_size.shares(samples, "fixed")[:2] == pytest.approx([0.9, 0.5])
    assert middle_size.errors(samples, "fixed") == pytest.approx(0.1)
    assert middle_size.over_best(samples, "adaptive", middle_size.shares).min() == pytest.approx(0.9)
    assert middle_size.seen_in_changed_light(samples, "fixed") == 0.0


def test_the_ball_and_player_of_the_scene_stay_on_the_field() -> None:
    seen = middle_size.watch_under(BATCH, middle_size.VARIANTS["constant"])
    assert seen["found"].max() == 4 and np.mean(seen["found"]) > 3.0
    assert np.sqrt(np.nanmean(seen["error"] ** 2)) < 0.1
    assert seen["light"].max() == 0.0


def test_the_claims_are_built() -> None:
    assert {"H26", "H27"} <= set(all_claims())
