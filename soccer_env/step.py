"""One control step of a slice of matches, from commands to observations, in compiled code.

    commands -> drive -> physics -> referee -> restart -> rewards -> observe

The whole step of one match runs before the next match begins, so that its records stay in the cache. Rewards come
after the restart: goals are read from the events, and shaping looks at the state that the next observation shows.
"""

from __future__ import annotations

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import length
from soccer_env.observations.truth import observe_truth
from soccer_env.physics.ball import hold, limit_speed, slow_down
from soccer_env.physics.chipmunk import step_match, write_bodies
from soccer_env.physics.contacts import find_collisions, find_touches
from soccer_env.physics.drive import drive, move_head
from soccer_env.physics.exchange import count_substeps, is_finite, read_records, write_rows, write_twists
from soccer_env.physics.kicker import holds_ball, work_kicker
from soccer_env.physics.legs import disturb
from soccer_env.referee.calls import judge
from soccer_env.referee.restarts import carry_out_restart, end_placing, steer_to_place
from soccer_env.referee.separation import pull_apart, watch_contacts
from soccer_env.rewards import POTENTIALS, measure_potentials, reward_robots
from soccer_env.scenes import judge_drill
from soccer_env.types import MAX_TEAM, NO_TEAM, Phase

PLAY = int(Phase.PLAY)


@compiled
def step_slice(
    matches, balls, robots, events, robot_events, links, bodies, velocities, constants, weights,
    terms, rewards, observations, terminated, truncated, limit, first, last,
):  # fmt: skip
    """Step the matches first, ..., last - 1; return the first whose physics broke down, or -1."""
    k, before, scratch, broken = constants[0], np.empty(POTENTIALS), make_scratch(robots.shape[1]), -1
    for m in range(first, last):
        match, ball, team, happened = matches[m], balls[m], robots[m], events[m]
        if match.over == 1:
            stand_still(happened, robot_events[m], terms[m], rewards[m])
            continue
        substeps = begin_step(match, ball, team, happened, robot_events[m], velocities[m], k, terms[m], before)
        step_match(links, m, substeps, k.dt)
        if not is_finite(bodies[m], robots.shape[1] + 1):
            broken = m if broken < 0 else broken
            continue
        if finish_step(match, ball, team, happened, robot_events[m], bodies[m], velocities[m], k):
            write_bodies(links, m)
        end_step(
            match, ball, team, happened, robot_events[m], k, weights[0], before,
            terms[m], rewards[m], observations[m], scratch,
        )  # fmt: skip
        terminated[m] = match.over == 1
        truncated[m] = not terminated[m] and (match.step >= limit or out_of_time(match, k))
    return broken


@compiled
def begin_slice(
    matches, balls, robots, events, robot_events, velocities, constants, terms, rewards, before, substeps, first, last
):
    """Do the part of a step before the physics, which Python steps; fill `before` (M, *POTENTIALS), `substeps`."""
    for m in range(first, last):
        substeps[m] = 0
        if matches[m].over == 1:
            stand_still(events[m], robot_events[m], terms[m], rewards[m])
            continue
        substeps[m] = begin_step(
            matches[m],
            balls[m],
            robots[m],
            events[m],
            robot_events[m],
            velocities[m],
            constants[0],
            terms[m],
            before[m],
        )


@compiled
def finish_slice(
    matches, balls, robots, events, robot_events, bodies, velocities, constants, weights,
    terms, rewards, observations, terminated, truncated, limit, before, substeps, moved, first, last,
):  # fmt: skip
    """Do the part after the physics; `moved` (M,) marks the matches whose bodies have to be written back."""
    k, scratch, broken = constants[0], make_scratch(robots.shape[1]), -1
    for m in range(first, last):
        match, ball, team, happened = matches[m], balls[m], robots[m], events[m]
        moved[m] = False
        if substeps[m] == 0:
            continue
        if not is_finite(bodies[m], robots.shape[1] + 1):
            broken = m if broken < 0 else broken
            continue
        moved[m] = finish_step(match, ball, team, happened, robot_events[m], bodies[m], velocities[m], k)
        end_step(
            match, ball, team, happened, robot_events[m], k, weights[0], before[m],
            terms[m], rewards[m], observations[m], scratch,
        )  # fmt: skip
        terminated[m] = match.over == 1
        truncated[m] = not terminated[m] and (match.step >= limit or out_of_time(match, k))
    return broken


@compiled
def begin_step(match, ball, robots, events, robot_events, velocities, k, terms, before):
    """Do what comes before the physics: drive, kicks, friction; return the number of substeps."""
    clear_events(events, robot_events)
    terms[:] = 0.0
    measure_potentials(match, ball, robots, k, before)
    for r in range(robots.shape[0]):
        robot = robots[r]
        if match.placing == 1:
            steer_to_place(robot, k)
        drive(robot, k, match.step, match.handedness)
        if k.drive_leg_disturbance > 0.0 and robot.gait_phase % k.gait_steps == 1 % k.gait_steps:
            disturb(robots, r, ball, k, match.handedness)
        work_kicker(robot, robot_events[r], k, ball, match.handedness)
        move_head(robot, k, ball)
        robot.placed = 0
        robot.fallen = max(robot.fallen - k.dt, 0.0)
        robot.penalty = max(robot.penalty - k.dt, 0.0)
    limit_speed(ball, k)
    if match.placing == 1:
        hold(ball)
    slow_down(ball, k, 0.5 * k.dt)
    write_twists(ball, robots, velocities)
    return count_substeps(ball, robots, k)


@compiled
def finish_step(match, ball, robots, events, robot_events, bodies, velocities, k):
    """Do what comes after the physics: read back, referee, restarts; tell whether bodies were put elsewhere."""
    read_records(ball, robots, bodies)
    knock_x, knock_y = ball.vx - velocities[0, 0], ball.vy - velocities[0, 1]
    slow_down(ball, k, 0.5 * k.dt)
    limit_speed(ball, k)
    dead = match.placing == 1  # a ball that is held cannot be touched
    toucher = -1 if dead else find_touches(ball, robots, robot_events, k, knock_x, knock_y)
    find_collisions(robots, robot_events, k)
    watch_contacts(robots, robot_events, k)
    match.step += 1
    moved = dead
    if dead:
        end_placing(match, ball, robots, k)
    judge(match, ball, robots, events, k, toucher if toucher >= 0 else kicked_by(ball, robots, robot_events))
    if match.phase == PLAY and pull_apart(ball, robots, match, k):
        events.separated = 1
        moved = True
    judge_drill(match, ball, robots, robot_events, events, k)
    if events.restart != 0 and match.over == 0:
        carry_out_restart(match, ball, robots, k, k.placement_by_driving)
        moved = True
    for r in range(robots.shape[0]):
        robots[r].has_ball = 1 if robots[r].active == 1 and holds_ball(robots[r], k, ball.x, ball.y) else 0
        robot_events[r].possession = robots[r].has_ball
    if moved:
        write_rows(ball, robots, bodies)
    return moved


@compiled
def end_step(match, ball, robots, events, robot_events, k, weights, before, terms, rewards, observations, scratch):
    """Reward and observe."""
    after, axes, rows, squares = scratch
    measure_potentials(match, ball, robots, k, after)
    reward_robots(match, ball, robots, events, robot_events, k, before, after, weights, terms, rewards)
    if observations.shape[1] > 0:
        observe_truth(match, ball, robots, observations, k, axes, rows, squares)


@compiled
def make_scratch(robots):
    """Return arrays to work in: potentials, axes of the robots (R, 2), rows and squared distances of players."""
    return np.empty(POTENTIALS), np.empty((robots, 2)), np.empty(MAX_TEAM, np.int64), np.empty(MAX_TEAM)


@compiled
def stand_still(events, robot_events, terms, rewards):
    """Let nothing happen to a match that is over."""
    clear_events(events, robot_events)
    terms[:] = 0.0
    rewards[:] = 0.0


@compiled
def out_of_time(match, k):
    """Tell whether a drill's time is up."""
    return k.drill != 0 and match.step * k.dt >= k.drill_time - 0.5 * k.dt


@compiled
def clear_events(events, robot_events):
    """Forget the events of the last step."""
    events.goal = events.restart_team = events.touch_team = NO_TEAM
    events.scorer = -1
    events.out = events.restart = events.in_play = events.stuck = events.separated = 0
    events.half_time = events.final_whistle = events.drill = 0
    for r in range(robot_events.shape[0]):
        event = robot_events[r]
        event.touch = event.kick = event.possession = event.collision = 0


@compiled
def kicked_by(ball, robots, robot_events):
    """Return the row of the robot that kicked in this step (of several the one nearest to the ball), or -1."""
    row, least = -1, 0.0
    for r in range(robot_events.shape[0]):
        distance = length(ball.x - robots[r].x, ball.y - robots[r].y)
        if robot_events[r].kick == 1 and (row < 0 or distance < least):
            row, least = r, distance
    return row
