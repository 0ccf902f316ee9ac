"""What the claims of 2006 make of light, places, plans, the goalkeeper and the receiver is right."""

import numpy as np
import pytest

from soccer_env.baselines.weigel_2001.planner import Planner
from soccer_env.train.papers.claim import STAGED, Batch
from soccer_env.train.papers.claims import middle_size
from soccer_env.train.papers.claims.goalkeeping import places, saves, tracking
from soccer_env.train.papers.claims.planning import crossings, runs
from soccer_env.train.papers.staging import MIDDLE, begin_scene, play, put, stage

BATCH = Batch("test", 0, 0, rules=STAGED)


def test_recovery_is_when_a_robot_is_no_longer_lost_for_a_second() -> None:
    dt, lost = 0.25, np.ones((4, 12), bool)
    lost[0, 2:] = False  # found after 2 frames
    lost[1, 2:5] = False  # not for long enough
    lost[2, 3:6] = lost[2, 8:] = False  # not at once for long enough
    time = middle_size.recovery(lost, dt)
    assert time[[0, 2]] == pytest.approx([0.5, 2.0]) and np.isnan(time[[1, 3]]).all()


def test_who_is_carried_is_told_nothing_and_is_elsewhere() -> None:
    match = stage(BATCH, MIDDLE, matches=4, pose="particles", senses={"home": "sensors", "away": "ideal"})
    put(match, 0, 0.0, 0.0)
    put(match, 1, 2.0, 2.0)
    begin_scene(match)
    list(play(match, 2.0))
    before = match.beliefs["own"][:, 0].copy()
    middle_size.carry_away(match, BATCH.rng(3))
    assert (np.hypot(match.robots["x"][:, 0], match.robots["y"][:, 0]) > middle_size.CARRIED).all()
    place, _ = middle_size.pose_errors(match)
    assert (place > 1.5).all()
    assert (match.beliefs["own"][:, 0] == before).all()
    list(play(match, 0.02))
    assert (middle_size.pose_errors(match)[0] > 0.5).any()  # it has not been told


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
    adaptive = [0.9, 0.9, 0.81, 0.9, 0.9, 0.9]
    samples = counts({"constant": [0.9] * 6, "adaptive": adaptive, "fixed": [0.9, 0.5] + [0.0] * 4})
    assert middle_size.seen_shares_by_light(samples, "fixed")[:2] == pytest.approx([0.9, 0.5])
    assert middle_size.range_errors_by_light(samples, "fixed") == pytest.approx(0.1)
    found = middle_size.relative_to_constant_light(samples, "adaptive", middle_size.seen_shares_by_light)
    assert found.min() == pytest.approx(0.9)
    assert middle_size.seen_in_changed_light(samples, "fixed") == 0.0


def test_a_crossing_meets_the_straight_way_when_the_robot_would_be_there_or_nearly() -> None:
    for scene in runs.scenes_of(BATCH, runs.CROSSING, 50):
        (x, y, vx, vy), robot = scene.obstacles[0], np.array(scene.robot)
        way = np.array(scene.target) - robot
        assert np.hypot(*way) == pytest.approx(runs.WAY)
        assert runs.CROSSERS[0] <= np.hypot(vx, vy) <= runs.CROSSERS[1]
        t = np.linspace(0.0, 2.5, 2501)
        gap = np.hypot(*(np.array([[x], [y]]) + np.outer([vx, vy], t) - robot[:, None]
                         - np.outer(way / runs.WAY, np.minimum(t * runs.SPEED, runs.WAY))))  # fmt: skip
        assert gap.min() < runs.LATE * runs.CROSSERS[1] + 0.01


def test_the_side_on_which_an_obstacle_is_passed() -> None:
    for y, side in ((0.3, 1), (-0.3, -1)):  # an obstacle on the left of the way is passed with it on the left
        travel = Planner().travel((-2.0, 0.0), (2.0, 0.0), [(0.0, y, 0.0, 0.0)])
        assert runs.passing_side(travel, 0) == side and runs.side_changes(travel) == 0
    far = Planner().travel((-2.0, 0.0), (2.0, 0.0), [(0.0, 2.5, 0.0, 0.0)])
    assert runs.passing_side(far, 0) == 0


def test_the_canonical_crossings_show_what_the_paper_shows() -> None:
    found = crossings.canonical_crossings()
    assert (found["old gap"] < crossings.NEAR).all() and (found["old away"] > crossings.AWAY).all()
    assert (found["new gap"] > 0.3).all() and (found["new sides"] == 0).all()
    figures = crossings.snapshots({})
    assert [figure.title.partition(", ")[2] for figure in figures] == ["t = 1", "t = 30", "t = 60"] * 2
    planned, travelled, obstacle = figures[0].curves
    assert len(travelled.x) == 2 and planned.x[-1] == pytest.approx(3.0) and len(obstacle.x) == 25


def test_the_results_of_a_drive_are_those_of_its_way() -> None:
    along = np.concatenate([np.linspace(0.0, 1.0, 51), np.full(50, 1.0)])
    aside = np.concatenate([np.zeros(51), np.linspace(0.02, 1.0, 50)])
    way = np.stack([along, aside, np.full(101, 0.1), 3.0 - along + 0.5 * aside], axis=1)[..., None]
    found = runs.results_of(way, 0.02)
    assert found["turn"] == pytest.approx(90.0) and found["time"] == pytest.approx(2.02)
    assert found["away"] == 50.0 and found["hit"] == 0.0 and found["gap"] == pytest.approx(0.1)


def test_believed_velocities_are_compared_in_the_axes_of_the_field() -> None:
    match = stage(BATCH, MIDDLE, matches=1, home=2, away=2)
    put(match, 1, 0.0, 0.0, np.pi / 2)
    put(match, 2, 2.0, 0.0, 0.0, forward=1.0)
    begin_scene(match)
    list(play(match, 0.1))
    track = match.tracks[0, 1, 0]
    for slot in match.tracks[0, 1]:
        slot["present"] = 0
    track["present"], track["teammate"], track["age"] = 1, 0, 0.0
    robot = match.robots[0, 2]
    away = robot["x"] - match.robots["x"][0, 1], robot["y"] - match.robots["y"][0, 1]
    track["x"], track["y"], track["vx"], track["vy"] = away[1], -away[0], 0.0, -0.5 * robot["vx"]  # +x is to its right
    error = tracking.velocity_errors(match)["robots"]
    assert np.nanmin(error) == pytest.approx(0.5, abs=0.02) and np.isfinite(error).sum() == 1


def test_the_open_angle_in_closed_form() -> None:
    goal, half = -6.0, 1.0 - 0.11
    ball, far = np.array([[goal + 4.0, 0.0]]), np.array([[5.0, 3.0]])
    whole = 2.0 * np.degrees(np.arctan2(half, 4.0))
    assert places.open_angle(ball, far) == pytest.approx(whole)  # nobody between
    shadow = 2.0 * np.degrees(np.arcsin((0.22 + 0.11) / 3.0))
    assert places.open_angle(ball, np.array([[goal + 1.0, 0.0]])) == pytest.approx(whole - shadow)
    assert places.open_angle(ball, np.array([[goal + 3.7, 0.0]])) == pytest.approx(0.0)


def test_goals_and_benefits_are_counted() -> None:
    speed = np.array([5.0, 5.0, 9.0, 9.0])
    samples = {"speed": speed, "line passive": np.array([1.0, 1, 1, 1]), "line active": np.array([0.0, 0, 1, 0])}
    assert saves.saved_share(samples, "line active") == 75.0
    assert saves.conceded_share(samples, "line passive", saves.SLOWER) == 100.0
    assert saves.conceded_ratio(samples, "line") == 0.25
    assert saves.conceded_ratio(samples, "line", saves.SLOWER) == 0.0
    noisy = {"fit own passive": np.ones(4), "fit own active": np.array([0.0, 0, 0, 1])}
    assert saves.prevented_goals(noisy, "fit", "own") == 75.0
