"""One control step of a slice of matches, from commands to observations, in compiled code.

    commands -> drive -> physics -> referee -> restart -> statistics -> rewards -> observe
                begin_match         finish_match

Between the two halves `physics.engine.chipmunk` steps the Spaces in the same compiled loop, or Python steps the Spaces
of a whole slice. Rewards come after the restart: goals are read from the events, and shaping uses the state that the
next observation shows.

`k`: the league's constants, under variation those of the match; `nominal`: the league's own.
"""

from typing import NamedTuple

import numpy as np

from soccer_env.compiled import compiled, inlined
from soccer_env.compiling.borrowing import borrow_arrays, keep_alive
from soccer_env.match.episodes import is_cut_off, note_episode_end
from soccer_env.observations.truth import observe_truth
from soccer_env.physics.ball import limit_speed, slow_down, stop_ball
from soccer_env.physics.contacts import find_collisions, find_touches
from soccer_env.physics.drive import drive_robot, move_head
from soccer_env.physics.engine.chipmunk import prefetch_step, step_match, write_bodies
from soccer_env.physics.engine.prefetch import prefetch_row
from soccer_env.physics.exchange import (
    count_substeps,
    is_finite,
    read_physics,
    set_ball_mass,
    write_poses,
    write_twists,
)
from soccer_env.physics.faults import stop_if_failed
from soccer_env.physics.kicker import advance_kicker, holds_ball, kicking_robot, squirt_ball
from soccer_env.physics.solver.contacts import stance_of
from soccer_env.physics.solver.interlock import catch_legs
from soccer_env.records.world import World
from soccer_env.referee.calls import judge_match
from soccer_env.referee.formation import is_onlooker
from soccer_env.referee.fouls.judging import judge_fouls
from soccer_env.referee.fouls.penalties import pardon, serve_penalties
from soccer_env.referee.restarts import carry_out_restart, end_placing
from soccer_env.referee.separation import pull_apart, watch_contacts
from soccer_env.referee.steering import steer_to_place
from soccer_env.rewards import POTENTIALS, measure_potentials, reward_robots
from soccer_env.scenes import judge_drill
from soccer_env.statistics.counting import count_calls, count_step, is_notable
from soccer_env.statistics.players import count_player
from soccer_env.statistics.records import OFTEN
from soccer_env.types import MAX_TEAM, NO_TEAM, Phase

PLAY = int(Phase.PLAY)
GOES_ON, PUT_ELSEWHERE, BROKEN = 0, -1, -2  # result of a match's step; above 0: substeps still to be made


class PhysicsArrays(NamedTuple):
    """Arrays that a step exchanges with the physics of M matches, see `physics.engine.chipmunk`."""

    bodies: np.ndarray  # (M, rows, 6)
    velocities: np.ndarray  # (M, rows, 3)
    solvers: np.ndarray  # (M,) SOLVER


class StepOutcome(NamedTuple):
    """The result of a step for learners, for M matches of R robots."""

    rewards: np.ndarray  # (M, R)
    terms: np.ndarray  # (M, R, terms)
    observations: np.ndarray  # (M, R, n) of the truth; n is 0 if `MatchBatch.observe` writes them
    terminated: np.ndarray  # (M,)
    truncated: np.ndarray  # (M,)
    statistics: np.ndarray  # (M,) STATISTICS


class StepNumbers(NamedTuple):
    """The settings that a step needs, as arrays and plain numbers."""

    constants: np.ndarray  # (1,) CONSTANTS; under variation (1 + M,), first the league's own
    weights: np.ndarray  # (1,) WEIGHTS
    limit: int  # control steps after which an episode is truncated
    cuts: bool  # the final whistle truncates too, since learners do not observe the clock


@compiled
def step_slice(links, world, physics, outcome, numbers, first, last):
    """Step the matches first, ..., last - 1; return the number of the first whose physics failed, or -1.

    The whole step of a match runs before the next match begins, so that its records stay in the cache.
    """
    world, physics, outcome, numbers = to_named_tuples(world, physics, outcome, numbers)
    nominal, weights = numbers.constants[0], numbers.weights[0]
    owned = make_scratch(world.robots.shape[1])
    before, scratch = borrow_arrays(owned)
    broken = -1
    for m in range(first, last):
        match, ball, robots = world.matches[m], world.balls[m], world.robots[m]
        events, robot_events, k = world.events[m], world.robot_events[m], constants_of_match(numbers, m)
        velocities, solver = physics.velocities[m], physics.solvers[m]
        terms, rewards = outcome.terms[m], outcome.rewards[m]
        prefetch_match(links, world.robots, outcome.statistics, m + 1)
        substeps = begin_match(
            match, ball, robots, events, robot_events, velocities, solver, k, weights, before, terms, rewards
        )
        if substeps == 0:
            continue
        step_match(links, m, substeps, k.dt)
        result = finish_match(
            match, ball, robots, events, robot_events, physics.bodies[m], velocities, solver, k, nominal, weights,
            before, scratch, terms, rewards, outcome.observations[m], outcome.statistics[m], numbers.cuts,
        )  # fmt: skip
        if result == PUT_ELSEWHERE:
            write_bodies(links, m)
        elif result == BROKEN:
            broken = m if broken < 0 else broken
            continue
        note_episode_end(match, events, outcome, m, k, numbers)
    keep_alive(owned)
    return broken


@compiled
def begin_slice(world, physics, outcome, numbers, before, substeps, first, last):
    """Run the part of a step before the physics, where Python steps the physics; `before` is (M, *POTENTIALS)."""
    world, physics, outcome, numbers = to_named_tuples(world, physics, outcome, numbers)
    before = borrow_arrays(before)
    for m in range(first, last):
        substeps[m] = begin_match(
            world.matches[m], world.balls[m], world.robots[m], world.events[m], world.robot_events[m],
            physics.velocities[m], physics.solvers[m], constants_of_match(numbers, m), numbers.weights[0],
            before[m], outcome.terms[m], outcome.rewards[m],
        )  # fmt: skip


@compiled
def finish_slice(world, physics, outcome, numbers, before, results, first, last):
    """Run the part of a step after the physics; `results` (M,): substeps at first, then results of `finish_match`."""
    world, physics, outcome, numbers = to_named_tuples(world, physics, outcome, numbers)
    nominal, before = numbers.constants[0], borrow_arrays(before)
    owned = make_scratch(world.robots.shape[1])
    _, scratch = borrow_arrays(owned)
    for m in range(first, last):
        if results[m] == 0:
            continue
        match, k = world.matches[m], constants_of_match(numbers, m)
        results[m] = finish_match(
            match, world.balls[m], world.robots[m], world.events[m], world.robot_events[m],
            physics.bodies[m], physics.velocities[m], physics.solvers[m], k, nominal, numbers.weights[0],
            before[m], scratch, outcome.terms[m], outcome.rewards[m], outcome.observations[m], outcome.statistics[m],
            numbers.cuts,
        )  # fmt: skip
        if results[m] != BROKEN:
            note_episode_end(match, world.events[m], outcome, m, k, numbers)
    keep_alive(owned)


@compiled
def to_named_tuples(world, physics, outcome, numbers):
    """Convert plain tuples of arrays to named tuples, without copying the arrays."""
    world, physics = borrow_arrays(world), borrow_arrays(physics)
    outcome, numbers = borrow_arrays(outcome), borrow_arrays(numbers)
    return World(*world), PhysicsArrays(*physics), StepOutcome(*outcome), StepNumbers(*numbers)


# Below this line every function works on one match.


@compiled
def begin_match(match, ball, robots, events, robot_events, velocities, solver, k, weights, before, terms, rewards):
    """Run one match's step up to the physics; return the number of physics substeps, 0 if the match is over."""
    clear_events(events, robot_events)
    terms[:] = 0.0
    if match.over == 1:
        rewards[:] = 0.0
        return 0
    measure_potentials(match, ball, robots, k, weights, before)
    return begin_step(match, ball, robots, robot_events, velocities, solver, k)


@compiled
def finish_match(
    match, ball, robots, events, robot_events, bodies, velocities, solver, k, nominal, weights,
    before, scratch, terms, rewards, observations, tally, cuts,
):  # fmt: skip
    """Run one match's step after the physics; return GOES_ON, PUT_ELSEWHERE (bodies were moved) or BROKEN.

    The potential is 0 once an episode has ended, but not where time has cut it off: a learner then bootstraps.
    """
    if not is_finite(bodies, robots.shape[0] + 1):
        return BROKEN
    after, axes, rows, squares, touching = scratch
    moved = finish_step(match, ball, robots, events, robot_events, bodies, velocities, solver, k, touching, tally)
    if match.over == 1 and not is_cut_off(events, cuts):
        after[:] = 0.0
    else:
        measure_potentials(match, ball, robots, k, weights, after)
    reward_robots(match, ball, robots, events, robot_events, k, before, after, weights, terms, rewards)
    if observations.shape[1] > 0:
        observe_truth(match, ball, robots, observations, nominal, axes, rows, squares)
    return PUT_ELSEWHERE if moved else GOES_ON


@compiled
def begin_step(match, ball, robots, robot_events, velocities, solver, k):
    """Apply the commands (drive, kick, head) and the friction of the ball; return the number of physics substeps."""
    for r in range(robots.shape[0]):
        robot = robots[r]
        if match.placing == 1 or (match.shoot_out > 0 and is_onlooker(match, robots, r)):
            steer_to_place(match, robot, k)
        if k.legs == 1 and robot.gait_phase % k.gait_steps == 0:
            catch_legs(robots, r, k, match.handedness)
        failed = stop_if_failed(match, robot, k)
        drive_robot(robot, k, match.step, match.handedness, stance_of(solver, r))
        advance_kicker(robots, r, robot_events[r], k, ball, match.handedness)
        if not failed:
            move_head(robot, k, ball)
        robot.placed, robot.fallen = 0, max(robot.fallen - k.dt, 0.0)
    limit_speed(ball, k)
    if match.placing == 1:
        stop_ball(ball)
    slow_down(ball, k, 0.5 * k.dt)
    write_twists(ball, robots, velocities, solver, match.handedness)
    set_ball_mass(solver, match.placing)
    return count_substeps(ball, robots, k)


@compiled
def finish_step(match, ball, robots, events, robot_events, bodies, velocities, solver, k, touching, tally):
    """Read the results of the physics and let the referee judge; return whether any body was moved by the referee."""
    knock_x, knock_y = read_physics(ball, robots, bodies, velocities, solver, k)
    squirted = squirt_ball(ball, robots, robot_events, k, match.handedness)
    dead = match.placing == 1  # a held ball cannot be touched
    toucher = -1 if dead else find_touches(ball, robots, robot_events, k, knock_x, knock_y, match.handedness)
    find_collisions(robots, robot_events, touching, k)
    watch_contacts(robots, robot_events, touching, k)
    match.step += 1
    if dead:
        end_placing(match, ball, robots, k)
    moved = serve_penalties(match, ball, robots, robot_events, k) or dead or squirted
    if not dead and match.over == 0:
        moved = judge_fouls(match, ball, robots, events, robot_events, touching, k) or moved
    judge_match(match, ball, robots, events, k, toucher if toucher >= 0 else kicking_robot(ball, robots, robot_events))
    if match.phase == PLAY and match.over == 0 and pull_apart(ball, robots, match, k):
        events.separated = 1
        moved = True
    judge_drill(match, ball, robots, robot_events, events, k)
    if events.restart != 0 and match.over == 0:
        pardon(match, ball, robots, events, robot_events, k)
        carry_out_restart(match, ball, robots, k, k.placement_by_driving)
        moved = True
    for r in range(robots.shape[0]):
        note_possession(ball, robots[r], robot_events[r], k)
        count_player(match, ball, robots, robot_events[r], r, k, tally)
    count_step(match, ball, robots, events, k, tally)
    if is_notable(events):
        count_calls(match, robots, events, robot_events, bodies, tally)
    if moved:
        write_poses(ball, robots, bodies)
    return moved


@compiled
def note_possession(ball, robot, events, k):
    """Write into a robot's record and events whether the robot has the ball."""
    robot.has_ball = 1 if robot.active == 1 and holds_ball(robot, k, ball.x, ball.y) else 0
    events.possession = robot.has_ball


@compiled
def make_scratch(robots):
    """Return working arrays: potentials before a step, and temporary arrays for `finish_match`."""
    rows, squares, touching = np.empty(MAX_TEAM, np.int64), np.empty(MAX_TEAM), np.empty(robots, np.int64)
    return np.empty(POTENTIALS), (np.empty(POTENTIALS), np.empty((robots, 2)), rows, squares, touching)


@inlined
def constants_of_match(numbers, m):
    """Return the constants of match m: the league's own, or those of its present episode."""
    return numbers.constants[m + 1 if len(numbers.constants) > 1 else 0]


@inlined
def prefetch_match(links, robots, statistics, m):
    """Prefetch the records of match m, if it exists, into the processor's cache."""
    if prefetch_step(links, m):
        prefetch_row(robots, m, robots.strides[0])
        prefetch_row(statistics, m, OFTEN)


@compiled
def clear_events(events, robot_events):
    """Clear the events of the last step."""
    events.goal = events.restart_team = events.touch_team = events.foul_team = NO_TEAM
    events.scorer = -1
    events.out = events.restart = events.in_play = events.stuck = events.separated = events.penalty = 0
    events.half_time = events.final_whistle = events.drill = events.foul = events.annulled = 0
    for r in range(robot_events.shape[0]):
        event = robot_events[r]
        event.touch = event.kick = event.squirt = event.possession = event.collision = 0
        event.pushes = event.pushed = event.foul = event.card = event.returned = 0
