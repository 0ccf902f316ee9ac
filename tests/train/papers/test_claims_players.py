"""The scenes in which players are looked at stand as they say, and what claims make of them is right."""

import numpy as np
import pytest

from soccer_env.optics import head_camera as optics
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.claims.players import grouping, jersey, views, watching
from soccer_env.train.papers.staging import (
    begin_scene,
    distance_to_point,
    play,
    put,
    still_actions,
    wrap_angle,
)
from soccer_env.train.papers.true_sight import camera_of, turn_head

BATCH = Batch("test", 0, 0)


def looking(matches: int = 6, distance: float = 0.8, **settings: object):
    """Return matches in which robot 0 has looked at an opponent, seen head-on, for a second."""
    match = watching.stage_watchers(BATCH, matches, **settings)
    watching.put_facing(match, 1, distance, np.linspace(-0.5, 0.5, matches), 0.0)
    begin_scene(match)
    actions = still_actions(match)
    for _ in play(match, 1.0, actions):
        watching.look_at(match, actions)
    return match


def test_a_player_stands_where_it_is_put_and_is_seen_as_said() -> None:
    views_asked = np.array([0.0, 1.0, -2.0, 3.0])
    match = watching.stage_watchers(BATCH, 4)
    watching.put_facing(match, 1, 0.7, 0.3, views_asked)
    distance, bearing = distance_to_point(match, 0, match.robots["x"][:, 1], match.robots["y"][:, 1])
    assert distance == pytest.approx(0.7) and bearing == pytest.approx(0.3)
    assert wrap_angle(watching.view_of(match, 1) - views_asked) == pytest.approx(0.0, abs=1e-9)
    facing = match.robots["heading"][:, 1] - np.arctan2(
        match.robots["y"][:, 0] - match.robots["y"][:, 1], match.robots["x"][:, 0] - match.robots["x"][:, 1]
    )
    assert np.abs(wrap_angle(facing))[0] < 1e-9  # view 0: it faces who looks


def test_a_head_that_looks_at_a_player_has_it_on_its_axis() -> None:
    match = looking()
    camera, axis = camera_of(match)
    away = np.stack([match.robots["x"][:, 1], match.robots["y"][:, 1], np.full(6, 0.13)], axis=1) - camera
    cosine = (away * axis).sum(axis=1) / np.linalg.norm(away, axis=1)
    assert np.degrees(np.arccos(np.minimum(cosine, 1.0))).max() < 0.5


def test_directions_of_blobs_are_those_of_optics() -> None:
    match = looking()
    bearing, elevation = watching.blob_directions(match)
    s = match.league.sensors.record()[0]
    for m in range(6):
        percept = match.percepts[m, 0]
        for i, blob in enumerate(percept["opponents"]):
            if blob["area"] == 0:
                assert np.isnan(bearing[m, i])
                continue
            u, v = 0.5 * (int(blob["left"]) + int(blob["right"])), 0.5 * (int(blob["high"]) + int(blob["low"]))
            found = optics.direction_of_pixel(u, v, float(percept["pan"]), float(percept["tilt"]), s)
            assert (bearing[m, i], elevation[m, i]) == pytest.approx(found)
    assert np.isfinite(bearing).any(axis=1).all()


def test_places_of_players_are_in_the_robots_own_axes() -> None:
    match = watching.stage_watchers(BATCH, 3)
    put(match, 0, 0.5, -0.2, np.pi / 2)
    put(match, 1, 0.5, 0.4, 0.0)
    x, y = watching.places_of(match, [1])
    assert x == pytest.approx(0.6) and y == pytest.approx(0.0, abs=1e-12)


def test_each_slot_stands_for_one_player_the_closest_pair_first() -> None:
    gaps = np.array([[[0.1, 0.2], [0.15, 0.9], [9.0, 0.3]], [[0.6, 0.7], [np.inf, np.inf], [0.8, 0.4]]])
    assert watching.matched_distances(gaps, 0.5) == pytest.approx(np.array([[0.1, 0.3], [np.inf, 0.4]]))
    assert watching.matched_distances(gaps, 0.05) == pytest.approx(np.full((2, 2), np.inf))


def test_blobs_belong_to_who_stands_there() -> None:
    match = watching.stage_watchers(BATCH, 4, away=2)
    watching.put_facing(match, 1, 0.7, 0.3, 0.0)
    watching.put_facing(match, 2, 1.2, -0.3, 1.0)
    begin_scene(match)
    actions = still_actions(match)
    turn_head(match, actions, 0, 0.0, -0.1)
    list(play(match, 1.0, actions))
    mine, (bearing, _) = watching.blob_owners(match, [1, 2]), watching.blob_directions(match)
    assert (mine[bearing > 0.1] == 0).all() and (mine[bearing < -0.1] == 1).all()
    assert (mine[np.isnan(bearing)] == -1).all()
    visible, filled = grouping.seen_and_believed(match)
    assert visible.mean() > 0.8 and filled.mean() > 0.8


def test_what_is_too_many_is_a_ghost_and_what_lacks_is_missed() -> None:
    visible = np.array([[True, True], [True, True], [True, False], [True, True]])
    filled = np.array([[1, 1], [2, 0], [1, 1], [0, 0]])
    ghosts, missed = grouping.ghosts_and_misses(visible, filled)
    assert ghosts.tolist() == [0, 1, 1, 0] and missed.tolist() == [0, 1, 0, 2]


def test_views_are_counted_from_head_on_and_only_within_the_picture() -> None:
    match = watching.stage_watchers(BATCH, 2)
    put(match, 0, 0.0, 0.0, 0.0)
    put(match, 1, np.array([1.0, -1.0]), 0.0, np.array([np.pi, np.pi / 2]))
    match.robots["pan"] = 0.0
    view, seen = views.views_in_play(match)
    assert view[0, 0, 1] == pytest.approx(0.0, abs=1e-9)  # it comes towards me
    assert view[1, 0, 1] == pytest.approx(np.pi / 2)
    assert seen[:, 0, 1].tolist() == [True, False]  # the second one is behind me
    assert not seen[:, 0, 0].any()


def test_sectors_thirds_and_variations_take_what_is_there() -> None:
    found = jersey.mean_by_sector(np.array([[0, 0, 3, 3]]), np.array([[1.0, 3.0, np.nan, 5.0]]))
    assert found[0, 0] == 2.0 and found[0, 3] == 5.0 and np.isnan(found[0, 1])
    counts = np.zeros((2, views.SECTORS))
    counts[0, 0], counts[1, 5], counts[1, -1] = 5.0, 3.0, 2.0
    assert views.shares_by_third(counts) == pytest.approx([50.0, 30.0, 20.0])
    assert views.front_lead(counts) == pytest.approx(20.0)
    sizes = np.array([[[9.0, 11.0, np.nan], [10.0, 10.0, 10.0]]])
    assert jersey.variation(sizes) == pytest.approx([0.1, 0.0]), "the deviation over the mean"


def test_a_jump_is_how_much_farther_a_headless_player_seems() -> None:
    samples = {
        "largest with head": np.full((4, 3, 2), 1.0), "largest without head": np.full((4, 3, 2), 1.1),
        "combined with head": np.full((4, 3, 2), 1.0), "combined without head": np.full((4, 3, 2), np.nan),
    }  # fmt: skip
    samples["combined without head"][:, :, 0] = [1.7, 2.0, 2.4]
    assert jersey.sticker_range_ratios(samples, "largest") == pytest.approx(1.1)
    assert jersey.worst_sticker_ratio(samples, "combined") == pytest.approx(2.4)
