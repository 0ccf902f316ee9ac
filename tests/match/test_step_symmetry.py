"""Left and right are equal, and so are home and away, in each stage of a step.

Left-right to 1e-12 with noise draws mirrored too, under a half-turn with the teams swapped to 1e-9.
"""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.compiled import compiled
from soccer_env.match.step import clear_events
from soccer_env.observations.truth import observe_slice
from soccer_env.perception.ideal import believe_truth_slice
from soccer_env.physics.drive import drive_robot, move_head
from soccer_env.physics.engine.memory import BODY_ARBITERS, BODY_COS, BODY_OMEGA, BODY_SIN, BODY_VX, BODY_VY
from soccer_env.physics.solver.records import STANCE
from soccer_env.physics.solver.rounds import apply_ground_drive
from soccer_env.referee.calls import judge_match
from soccer_env.referee.restarts import carry_out_restart, end_placing
from soccer_env.referee.steering import steer_to_place
from soccer_env.types import NO_TEAM, Phase
from tests.scenes import symmetry
from tests.scenes.staging import LEGGED, MIDDLE, each_league, put_ball, scatter, speed

SIZE = 3  # robots a side
DIFFERENTIAL = "middle-size-2006-differential"


def mid_game(name, matches=60, seed=1, **settings) -> Match:
    """Return matches with records as they are in mid-match: random play, both halves, ball anywhere and moving."""
    match = Match(name, home=SIZE, away=SIZE, matches=matches, seed=seed, actions="full", **settings)
    rng = np.random.default_rng(seed)
    for step in range(40):
        if step % 8 == 0:
            actions = rng.uniform(-1.0, 1.0, (matches, 2 * SIZE, 7))
        match.step(actions)
    scatter(match, rng, 0.95)
    match.matches["half"] = rng.integers(0, 2, matches)
    match.matches["home_direction"] = 1.0 - 2.0 * match.matches["half"]
    match.matches["score"] = rng.integers(0, 4, (matches, 2))
    touched = rng.integers(-1, 2 * SIZE, matches)
    match.matches["last_touch_robot"] = touched
    match.matches["last_touch_team"] = np.where(touched < 0, NO_TEAM, touched // SIZE)
    angle, v = rng.uniform(-np.pi, np.pi, matches), rng.uniform(0.0, 0.5, matches) * match.league.ball.top_speed
    put_ball(match, match.balls["x"], match.balls["y"], v * np.cos(angle), v * np.sin(angle))
    match.robots["has_ball"] = rng.integers(0, 2, match.robots.shape)
    match.robots["kick_clock"] = rng.choice([0.0, 0.0, match.league.dt / 2, -0.2], match.robots.shape)
    match.robots["kick_strength"] = rng.uniform(0.3, 1.0, match.robots.shape)
    match.robots["command"]["kick"] = rng.uniform(-1.0, 1.0, match.robots.shape)
    match.rebuild()
    return match


def in_both_worlds(match, stage, events=False):
    """Run a stage on the records, on their mirror image and on their half-turn, and compare what comes out."""
    records, constants = symmetry.Records.of(match), match.settings.constants()
    happened = []
    for image in (records, left_right := symmetry.mirrored(records), half_turn := symmetry.turned(records)):
        happened.append((match.events.copy(), match.robot_events.copy()))
        stage(image, *happened[-1], constants)
    symmetry.assert_same_records(left_right, symmetry.mirrored(records), symmetry.MIRROR)
    symmetry.assert_same_records(half_turn, symmetry.turned(records), symmetry.HALF_TURN)
    if events:
        (one, robots), (mirror, mirror_robots), (turn, turn_robots) = happened
        symmetry.assert_same(mirror, symmetry.mirrored_events(one), symmetry.MIRROR)
        symmetry.assert_same(turn, symmetry.turned_events(one, 2 * SIZE), symmetry.HALF_TURN)
        symmetry.assert_same(mirror_robots, robots, symmetry.MIRROR)
        symmetry.assert_same(turn_robots, symmetry.swapped_rows(robots), symmetry.HALF_TURN)
    return records


@compiled
def drive_all(matches, balls, robots, constants, stances, bodies):
    for m in range(len(matches)):
        for r in range(robots.shape[1]):
            drive_robot(robots[m, r], constants[0], matches[m].step, matches[m].handedness, stances[m, r])
            take_ground(robots[m, r], stances[m, r], bodies[m, r], constants[0].dt)
            move_head(robots[m, r], constants[0], balls[m])
        matches[m].step += 1


@compiled
def take_ground(robot, stance, body, dt):
    """Give a robot that touches nothing the velocity that the ground lets it have; body: what stance.body points to."""
    stance.given_x = stance.given_y = stance.given_turn = 0.0
    body[BODY_VX // 8], body[BODY_VY // 8], body[BODY_OMEGA // 8] = robot.vx, robot.vy, robot.omega
    body[BODY_COS // 8], body[BODY_SIN // 8] = np.cos(robot.heading), np.sin(robot.heading)
    apply_ground_drive(stance, dt)
    robot.vx, robot.vy, robot.omega = body[BODY_VX // 8], body[BODY_VY // 8], body[BODY_OMEGA // 8]


def stances_of(match):
    """Return STANCE records (M, R) of the robots of a league, and the memory of bodies that they point to."""
    bodies = np.zeros((*match.robots.shape, BODY_ARBITERS // 8 + 1))
    stances = np.zeros(match.robots.shape, STANCE)
    size = bodies.itemsize * bodies.shape[-1]
    stances["body"] = bodies.ctypes.data + size * np.arange(stances.size).reshape(stances.shape)
    for i, (x, y) in enumerate(match.league.body.posts):
        stances["posts"]["stand_x"][..., i], stances["posts"]["stand_y"][..., i] = x, y
    return stances, bodies


@compiled
def steer_all(matches, robots, constants):
    for m in range(len(robots)):
        for r in range(robots.shape[1]):
            steer_to_place(matches[m], robots[m, r], constants[0])


@compiled
def judge_all(matches, balls, robots, events, robot_events, constants, placement):
    for m in range(len(matches)):
        clear_events(events[m], robot_events[m])
        judge_match(matches[m], balls[m], robots[m], events[m], constants[0], matches[m].last_touch_robot)
        if events[m].restart != 0 and matches[m].over == 0:
            carry_out_restart(matches[m], balls[m], robots[m], constants[0], placement)


@compiled
def end_all(matches, balls, robots, constants):
    for m in range(len(matches)):
        end_placing(matches[m], balls[m], robots[m], constants[0])


@pytest.mark.parametrize("name", [LEGGED, MIDDLE, DIFFERENTIAL])
def test_driving_is_symmetric_over_many_gait_steps(name):
    def stage(records, events, robot_events, constants):
        stances, bodies = stances_of(before)
        for _ in range(40):
            drive_all(records.matches, records.balls, records.robots, constants, stances, bodies)
        posts.append(stances["posts"].copy())

    before, posts = mid_game(name), []
    after = in_both_worlds(before, stage)
    one, left_right, half_turn = posts
    for axis, sign in (("x", 1.0), ("y", -1.0), ("vx", 1.0), ("vy", -1.0)):
        symmetry.assert_close(left_right[axis], sign * one[axis], symmetry.MIRROR, f"posts.{axis}")
        symmetry.assert_close(half_turn[axis], symmetry.swapped_rows(one[axis]), symmetry.HALF_TURN, f"posts.{axis}")
    assert (abs(one["vx"]).max() > 0.1) == before.league.body.legs
    assert not np.array_equal(after.robots["slip"], before.robots["slip"])
    assert speed(after.robots).max() > 0.3 * before.league.drive.forward


@pytest.mark.parametrize("placement", [0, 1])
@each_league
def test_the_referee_and_restarts_are_symmetric(name, placement):
    match = mid_game(name, 240, seed=2)
    league, rng, count = match.league, np.random.default_rng(3), match.count
    match.matches["phase"] = rng.choice([Phase.PLAY, Phase.KICK_OFF, Phase.THROW_IN], count)
    match.matches["restart_team"] = rng.integers(0, 2, count)
    outside = league.ball.radius + 0.01
    end, side = rng.choice([-1.0, 1.0], (2, count))
    x = end * (league.pitch.length / 2 + outside) * rng.choice([1.0, 0.3], count)
    y = side * np.where(rng.random(count) < 0.4, 0.2, league.pitch.width / 2 + outside)
    put_ball(match, np.where(np.arange(count) % 4 == 0, match.balls["x"], x), y)
    stuck = np.arange(count) % 5 == 0
    match.matches["still_clock"] = np.where(stuck, league.rules.stuck_time, 0.0)
    match.balls["x"][stuck], match.balls["y"][stuck] = 0.4 * end[stuck], 0.3 * side[stuck]
    match.matches["still_x"], match.matches["still_y"] = match.balls["x"], match.balls["y"]
    match.matches["clock"][::7] = match.matches["half_length"][::7]

    def stage(records, events, robot_events, constants):
        judge_all(records.matches, records.balls, records.robots, events, robot_events, constants, placement)
        kinds.update(events["restart"].tolist())

    kinds: set[int] = set()
    in_both_worlds(match, stage, events=True)
    assert kinds >= {0, Phase.KICK_OFF, Phase.DROP_BALL}
    assert name == LEGGED or kinds >= {Phase.THROW_IN, Phase.GOAL_KICK, Phase.CORNER_KICK}


@pytest.mark.parametrize("name", [LEGGED, MIDDLE, DIFFERENTIAL])
def test_driving_to_places_is_symmetric_and_so_is_its_end(name):
    match = mid_game(name, 100, seed=4)
    match.matches["phase"], match.matches["placing"] = Phase.KICK_OFF, 1
    match.matches["restart_team"] = np.arange(100) % 2
    match.matches["restart_x"], match.matches["restart_y"] = 0.3, -0.2
    match.matches["phase_clock"] = match.league.rules.placing_time

    def stage(records, events, robot_events, constants):
        steer_all(records.matches, records.robots, constants)
        end_all(records.matches, records.balls, records.robots, constants)

    after = in_both_worlds(match, stage)
    assert (after.matches["placing"] == 0).all()


@each_league
def test_ideal_beliefs_are_symmetric(name):
    match = mid_game(name, 100, seed=6)
    constants, records = match.settings.constants(), symmetry.Records.of(match)
    everyone = np.arange(2 * SIZE)
    believed = []
    for image in (records, symmetry.mirrored(records), symmetry.turned(records)):
        world = (image.matches, image.balls, image.robots, match.events, match.robot_events)
        beliefs, tracks = np.zeros_like(match.batch.beliefs), np.zeros_like(match.batch.tracks)
        believe_truth_slice(world, beliefs, tracks, constants, everyone, 0, 100)
        believed.append((beliefs, tracks))
    (beliefs, tracks), (mirror, mirror_tracks), (turn, turn_tracks) = believed
    symmetry.assert_same(mirror, symmetry.mirrored_beliefs(beliefs), symmetry.MIRROR)
    symmetry.assert_same(mirror_tracks, symmetry.mirrored_tracks(tracks), symmetry.MIRROR)
    symmetry.assert_same(turn, symmetry.swapped_rows(beliefs), symmetry.HALF_TURN)
    symmetry.assert_same(turn_tracks, symmetry.swapped_rows(tracks), symmetry.HALF_TURN)


@each_league
def test_observations_are_symmetric(name):
    match = mid_game(name, 100, seed=7)
    constants, records = match.settings.constants(), symmetry.Records.of(match)
    seen = []
    for image in (records, symmetry.mirrored(records), symmetry.turned(records)):
        seen.append(np.zeros_like(match.observations))
        observe_slice(image.matches, image.balls, image.robots, seen[-1], constants, 0, 100)
    single = np.finfo(np.float32).eps  # the last bit of a float32
    image = symmetry.mirrored_observations(seen[0], match.observation_entries)
    symmetry.assert_close(seen[1], image, symmetry.MIRROR + single, "mirror")
    symmetry.assert_close(seen[2], symmetry.swapped_rows(seen[0]), symmetry.HALF_TURN + 2.0 * single, "half-turn")
