"""The potential field of sacks-2001: each mechanism of sections 4.2 and 4.3, mirror symmetry."""

from math import atan2, cos, hypot, isfinite, sin
from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001 import steering
from soccer_env.baselines.sacks_2001.forces import as_sensed, goal_force, player_force, repulsion, wall_force
from soccer_env.baselines.sacks_2001.memory import DRIBBLE, MEMORY
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.baselines.sacks_2001.steering import choose_dribble_direction, force_of_players, off_ahead, step_speed
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.records.beliefs import BELIEF, TRACK
from soccer_env.train.papers.claims.field.point_world import PointWorld, players
from tests.scenes.sacks_mind import LEAGUE, Mind

K = constants_of(find_league("legged-2001"))[0]
EYE, CHEST = 0.142, 0.105  # [m] of the camera ahead of the middle, half of the other body
THEORY = {"exponent": 3, "goal_force": "proportional", "cosine_factor": False}


def play_of(**changes: Any) -> np.void:
    """Return the record of the team's settings, some of them changed."""
    return SacksSettings(**changes).record()[0]


def scene(*places: tuple[float, float], heading: float = 0.0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return belief (1,), tracks, memory (1,) of a dribbler at the centre, players at places [m, robot frame]."""
    belief, tracks = np.zeros(1, BELIEF), np.zeros(max(len(places), 1), TRACK)
    belief["own"]["heading"] = heading
    for slot, (x, y) in enumerate(places):
        tracks[slot]["present"], tracks[slot]["x"], tracks[slot]["y"] = 1, x, y
        tracks[slot]["distance"], tracks[slot]["bearing"] = hypot(x, y), atan2(y, x)
    return belief, tracks, np.zeros(1, MEMORY)


def off_goal(pull: tuple[float, float], push: tuple[float, float], side: float = 0.0, **changes: Any) -> float:
    """Return what `limited` makes of two forces [degrees off the goal]."""
    return float(np.degrees(steering.limited(*pull, *push, side, play_of(**changes))))


def test_ms38_the_theorys_forces_are_khatibs() -> None:
    play = play_of(**THEORY, goal_gain=0.7)
    for x in (0.15, 0.3, 0.444, 0.8, 0.999):
        khatib = 0.8 * (1.0 / x - 1.0 / 1.0) / x**2  # k2 (1/x - 1/x0) / x^2
        assert repulsion(x, 0.8, 1.0, play) == pytest.approx(khatib, rel=1e-12)
        fx, fy = player_force(x * cos(2.0), x * sin(2.0), 1.0, 0.0, play)
        assert (fx, fy) == pytest.approx((-khatib * cos(2.0), -khatib * sin(2.0)), rel=1e-12)
    assert goal_force(3.0, -4.0, play) == pytest.approx((0.7 * 3.0, 0.7 * -4.0), rel=1e-12)


def test_ms38_beyond_the_greatest_distance_nobody_repels() -> None:
    for far in (1.0, 1.0001, 2.0, 50.0):
        assert repulsion(far, 0.8, 1.0, play_of(**THEORY)) == 0.0
        assert repulsion(far, 0.8, 1.0, play_of(**THEORY, cut_off=False)) == pytest.approx(0.8 / far**3, rel=1e-12)


@pytest.mark.parametrize("exponent", [1, 2, 3])
def test_ms39_the_exponent_is_that_of_the_settings(exponent: int) -> None:
    play = play_of(exponent=exponent)
    for x in (0.1, 0.25, 0.6):
        expected = 0.8 * (1.0 / x - 1.0) / x ** (exponent - 1)
        assert repulsion(x, 0.8, 1.0, play) == pytest.approx(expected, rel=1e-12)


def test_ms40_the_goal_pulls_equally_from_everywhere() -> None:
    for x, y in ((0.02, 0.0), (0.3, 0.4), (2.5, -1.0)):
        assert hypot(*goal_force(x, y, play_of())) == pytest.approx(1.0, abs=1e-12)
        pull = goal_force(x, y, play_of(goal_force="proportional"))
        assert hypot(*pull) == pytest.approx(hypot(x, y), rel=1e-12)


def test_ms41_nobody_beside_or_behind_repels() -> None:
    for angle in np.radians(np.arange(90.0, 271.0, 5.0)):
        for goal in (0.0, 1.0, -2.5):
            x, y = 0.3 * cos(goal + angle), 0.3 * sin(goal + angle)
            assert hypot(*player_force(x, y, cos(goal), sin(goal), play_of())) < 1e-15
            assert hypot(*player_force(x, y, cos(goal), sin(goal), play_of(cosine_factor=False))) > 1.0
    aside = hypot(*player_force(0.3 * cos(1.0), 0.3 * sin(1.0), 1.0, 0.0, play_of()))
    assert aside == pytest.approx(cos(1.0) * repulsion(0.3, 0.8, 1.0, play_of()), rel=1e-12)


def test_ms42_a_player_repels_as_much_as_the_goal_pulls_at_444_mm() -> None:
    play = play_of()
    at = 1.0 / (1.0 / 0.8 + 1.0)
    assert at == pytest.approx(0.4444, abs=1e-4)
    assert hypot(*player_force(at, 0.0, 1.0, 0.0, play)) == pytest.approx(1.0, rel=1e-12)
    assert hypot(*player_force(0.2, 0.0, 1.0, 0.0, play)) == pytest.approx(3.2, rel=1e-12)
    assert player_force(1.0, 0.0, 1.0, 0.0, play) == (0.0, 0.0)


def test_ms42_distances_count_from_the_camera_to_the_surface_of_a_player() -> None:
    """A force of 1 at 444 mm of what the sensors measure, wherever the player is; nothing from 1 m on."""
    unit = 1.0 / (1.0 / 0.8 + 1.0)
    for angle in (0.0, 0.7, -1.2):
        for sensed, force in ((unit, 1.0), (0.2, 3.2), (0.9999, 0.0)):
            away = sensed + CHEST
            belief, tracks, _ = scene((EYE + away * cos(angle), away * sin(angle)), heading=0.4)
            goal = cos(0.4 + angle), sin(0.4 + angle)
            push = force_of_players(belief[0], tracks, *goal, K, play_of())
            assert push == pytest.approx((-force * goal[0], -force * goal[1]), abs=1e-4)
    for place, middle in (((unit, 0.0), True), ((EYE + unit + CHEST, 0.0), False)):
        belief, tracks, _ = scene(place)
        push = force_of_players(belief[0], tracks, 1.0, 0.0, K, play_of(distance_from="middle"))
        assert (hypot(*push) == pytest.approx(1.0)) is middle
    assert hypot(*as_sensed(EYE, 0.0, K, play_of())) == hypot(*as_sensed(EYE, 0.1, K, play_of())) == 0.01


def test_ms43_side_walls_push_straight_off_and_less_than_players() -> None:
    play = play_of()
    unit = 1.0 / (1.0 / 0.2 + 1.0 / 0.35)
    assert wall_force(1.0 - unit, 1.0, play) == pytest.approx(-1.0, rel=1e-12)
    assert wall_force(unit - 1.0, 1.0, play) == pytest.approx(1.0, rel=1e-12)
    assert wall_force(0.6, 1.0, play) == wall_force(0.0, 1.0, play) == 0.0
    assert wall_force(0.9, 1.0, play_of(walls=False)) == 0.0
    for x in (0.1, 0.2, 0.3):
        assert abs(wall_force(1.0 - x, 1.0, play)) < repulsion(x, 0.8, 1.0, play)
    belief, tracks, memory = scene()
    belief["own"]["y"] = 0.9
    choose_dribble_direction(belief[0], tracks, memory[0], K, play)
    assert memory["way"][0] < atan2(-0.9, 1.6)  # more to the right than the goal is


def test_ms44_players_are_points_whatever_way_they_face() -> None:
    play = play_of(cosine_factor=False)
    for angle in np.linspace(-3.0, 3.0, 7):
        for distance in (0.12, 0.3, 0.9):
            force = hypot(*player_force(distance * cos(angle), distance * sin(angle), 1.0, 0.0, play))
            assert force == pytest.approx(0.8 * (1.0 / distance - 1.0), rel=1e-12)
    ways = []
    for heading in (0.0, 1.0, 2.0):
        belief, tracks, memory = scene((0.4, 0.1))
        tracks["heading"], tracks["vx"] = heading, 0.1
        choose_dribble_direction(belief[0], tracks, memory[0], K, play)
        ways.append(memory["way"][0])
    assert len(set(ways)) == 1


def test_ms45_steps_of_3_5_cm_and_a_decision_each_half_second() -> None:
    play = play_of()
    assert step_speed(K, play) * 0.5 == pytest.approx(0.035)
    assert step_speed(K, play_of(step_length=0.04)) * 0.5 == pytest.approx(0.04)
    runs = PointWorld().run([[-1.0, 0.0]], players([[0.0, 0.1]]), seconds=5.0)
    assert runs.replan == 0.5 and len(runs.off) == 10
    assert np.linalg.norm(np.diff(runs.path[:, 0], axis=0), axis=1) == pytest.approx(0.035)


def test_ms45_a_dribbler_decides_on_its_way_every_half_second_and_goes_at_that_pace() -> None:
    mind = Mind(shoots=False)
    mind.stand_at(0.0, 0.1)
    mind.see_ball(0.147, held=1)
    mind.tracks["present"][..., 0] = 1
    ways = []
    for step in range(40):  # a player drifts by: every decision is another one
        track = mind.tracks[0, 0, 0]
        track["x"], track["y"] = 0.9, 0.3 - 0.004 * step
        track["distance"], track["bearing"] = hypot(track["x"], track["y"]), atan2(track["y"], track["x"])
        command = mind.think()[0]
        ways.append(float(mind.memory["way"]))
        speed = hypot(command[0] * LEAGUE.drive.forward, command[1] * LEAGUE.drive.sideways)
        assert mind.memory["behaviour"] == DRIBBLE and speed == pytest.approx(0.07, rel=1e-6)
    changed = 1 + np.flatnonzero(np.diff(ways))
    assert len(changed) == 4 and (np.diff(changed) == 8).all()


def test_ms46_the_way_is_never_more_than_70_degrees_off_the_goal() -> None:
    for angle in np.radians([100.0, 150.0, 179.0]):
        push = (3.0 * cos(angle), 3.0 * sin(angle))
        assert off_goal((1.0, 0.0), push) == pytest.approx(70.0)
        assert off_goal((1.0, 0.0), (push[0], -push[1])) == pytest.approx(-70.0)
        assert off_goal((1.0, 0.0), push, clamp=False) > 80.0
    assert off_goal((1.0, 0.0), (0.0, 1.0)) == pytest.approx(45.0)  # within the limit nothing changes


def test_ms47_pushed_mostly_back_it_stays_on_its_side() -> None:
    back_left, back_right = (-3.0, 0.5), (-3.0, -0.5)  # 171 degrees from the goal's force
    assert off_goal((1.0, 0.0), back_left, side=-1.0) == pytest.approx(-70.0)
    assert off_goal((1.0, 0.0), back_right, side=1.0) == pytest.approx(70.0)
    assert off_goal((1.0, 0.0), back_left, side=0.0) == pytest.approx(70.0)
    assert off_goal((1.0, 0.0), back_left, side=-1.0, keep_side=False) == pytest.approx(70.0)
    aside = (-3.0, 3.5)  # 131 degrees: not mostly away
    assert off_goal((1.0, 0.0), aside, side=-1.0) == pytest.approx(70.0)


def test_ms48_at_most_45_degrees_off_the_body_or_55_past_a_player_ahead() -> None:
    for place, limit, start in (
        ((0.8, 0.1), 45.0, "surface"), ((0.35, 0.03), 55.0, "surface"), ((0.3, 0.25), 45.0, "surface"),
        ((EYE + 0.14 + CHEST, 0.0), 55.0, "surface"), ((EYE + 0.16 + CHEST, 0.0), 45.0, "surface"),
        ((0.14, 0.0), 55.0, "middle"), ((0.16, 0.0), 45.0, "middle"),
    ):  # fmt: skip
        belief, tracks, memory = scene(place)
        for way, expected in ((1.2, limit), (-1.2, -limit), (0.5, np.degrees(0.5))):
            memory["way"] = way
            off = off_ahead(belief[0], tracks, memory[0], K, play_of(distance_from=start))
            assert np.degrees(off) == pytest.approx(expected)
        memory["way"] = 1.2
        assert off_ahead(belief[0], tracks, memory[0], K, play_of(body_clamp=False)) == pytest.approx(1.2)


def test_ms49_the_rangers_obstacle_stands_in_for_one_player() -> None:
    """A player seen at 70 cm that is really at 30: its own force counts no more, another player's does."""
    belief, tracks, _ = scene((0.7, 0.0), (0.1, -0.6))
    before = force_of_players(belief[0], tracks, 1.0, 0.0, K, play_of())
    belief["obstacle"]["distance"], belief["obstacle"]["bearing"] = 0.3, 0.05
    for start in ("surface", "middle"):
        play = play_of(distance_from=start)
        after = force_of_players(belief[0], tracks, 1.0, 0.0, K, play)
        places = (float(np.float32(0.3)) * cos(0.05), 0.3 * sin(0.05)), (0.1, -0.6)
        pushes = [player_force(*as_sensed(x, y, K, play), 1.0, 0.0, play) for x, y in places]
        assert after == pytest.approx(tuple(np.sum(pushes, axis=0)), rel=1e-6)
    assert force_of_players(belief[0], tracks, 1.0, 0.0, K, play_of(infrared_obstacle=False)) == before


def test_ms49_the_obstacle_repels_by_the_reading_itself() -> None:
    """The ranger reads 12.5 cm: 4/5 (8 - 1) = 5.6 times the goal's pull, and 55 degrees are allowed."""
    belief, tracks, memory = scene()
    belief["obstacle"]["distance"], belief["obstacle"]["bearing"] = EYE + 0.125 + CHEST, 0.0
    assert force_of_players(belief[0], tracks, 1.0, 0.0, K, play_of())[0] == pytest.approx(-5.6, rel=1e-6)
    memory["way"] = 1.2
    assert np.degrees(off_ahead(belief[0], tracks, memory[0], K, play_of())) == pytest.approx(55.0)


def test_forces_stay_finite_wherever_anybody_is() -> None:
    rng = np.random.default_rng(3)
    for exponent in (1, 2, 3):
        for cut_off in (True, False):
            play = play_of(exponent=exponent, cut_off=cut_off)
            for _ in range(500):
                x, y, goal_x, goal_y = 10.0 ** rng.uniform(-300.0, 6.0, 4) * rng.choice([-1.0, 1.0, 0.0], 4)
                forces = (*player_force(x, y, goal_x, goal_y, play), *goal_force(x, y, play))
                assert all(map(isfinite, (*forces, wall_force(y, 1.0, play))))
