"""Our part of Chipmunk's contact solver: the ground under the robots, their legs and guides, and the ball's roll.

Chipmunk solves the contacts of a substep together, in a few rounds of impulses. Forces that act at the same time must
take part in those rounds: if the ground acted once a control step, a standing robot would slide as on ice when pushed,
since a solver without the ground only shares out the momentum of the two robots. So each Space holds one constraint of
our own, whose four functions Chipmunk calls in every substep:

    prepare      once contacts are known: find the contacts of posts, drive robots that touch nothing
    resume       apply the impulses of the last substep, from which the rounds start
    solve_round  once a round, after Chipmunk's contacts: contacts of posts, ground under robots that touch something
    finish       after the last round: the ball's roll

The constraint is made as a motor whose functions are replaced by ours; the motor's rate holds the address of the
match's SOLVER record. Impulses of the ground are counted as changes of velocity: divided by the robot's mass.
"""

from __future__ import annotations

import functools
from typing import Any, NamedTuple

import numpy as np
import pymunk

from soccer_env.compiled import compiled
from soccer_env.compiling.callback import callback
from soccer_env.geometry import clip, into_frame, length, out_of_frame
from soccer_env.leagues.constants import CONSTANTS
from soccer_env.leagues.league import League
from soccer_env.physics.engine.memory import (
    BODY_ARBITERS,
    BODY_COS,
    BODY_OMEGA,
    BODY_SIN,
    BODY_VX,
    BODY_VY,
    BODY_X,
    BODY_Y,
    CONSTRAINT_CLASS,
    MOTOR_RATE,
    SPACE_ROUNDS,
    address_at,
    address_of,
    layout_fits,
    number_at,
    record_reader,
    store,
    store_count,
)
from soccer_env.physics.engine.pymunk_parts import ffi, lib
from soccer_env.physics.engine.space import posts_outside_space
from soccer_env.physics.solver.ball import count_ball_contacts, list_ball_contacts, slow_roll_by_contacts
from soccer_env.physics.solver.contacts import resume_posts, solve_posts, stance_of
from soccer_env.physics.solver.interlock import hold_caught
from soccer_env.physics.solver.posts import find_post_contacts
from soccer_env.physics.solver.ramps import put_back_on_ramp, roll_off_ramps
from soccer_env.physics.solver.records import SOLVER, STANCE
from soccer_env.physics.solver.walls import add_wall_contacts

solver_at: Any = record_reader(SOLVER)
constants_at: Any = record_reader(CONSTANTS)


@callback("void", "address", "float64")
def prepare_substep(constraint, dt):
    """Find contacts of posts and ball, let ramps act on the ball and the ground on robots that touch nothing."""
    solver = solver_at(address_at(constraint + MOTOR_RATE))
    solver.time += dt
    k = constants_at(solver.constants)
    beyond_x, beyond_y = roll_off_ramps(solver, k, dt)
    if solver.posts > 0:
        find_post_contacts(solver, k, dt)
        for r in range(solver.robots):
            stance = stance_of(solver, r)
            if stance.active == 1:
                add_wall_contacts(solver, k, r, number_at(stance.body + BODY_X), number_at(stance.body + BODY_Y))
        if k.legs == 1:
            hold_caught(solver, k)
    count = 0
    for r in range(solver.robots):
        stance = stance_of(solver, r)
        if not touches_nothing(stance):
            solver.touching[count] = r
            count += 1
            stance.led = 0
        elif stance.led == 0:
            stance.given_x = stance.given_y = stance.given_turn = 0.0
            apply_ground_drive(stance, dt)
    solver.touching_count = count
    list_ball_contacts(solver)
    touched = count_ball_contacts(solver)
    if touched == 0:
        put_back_on_ramp(solver.ball, beyond_x, beyond_y)
    jammed = solver.holds > 0 or touched > 1
    store_count(solver.space + SPACE_ROUNDS, np.int32(solver.jam_rounds if jammed else solver.rounds))


@callback("void", "address", "float64")
def resume_impulses(constraint, share):
    """Apply the impulses of the last substep, times the ratio of the substeps' lengths."""
    solver = solver_at(address_at(constraint + MOTOR_RATE))
    resume_posts(solver, share)
    for i in range(solver.touching_count):
        stance = stance_of(solver, solver.touching[i])
        body = stance.body
        stance.given_x *= share
        stance.given_y *= share
        stance.given_turn *= share
        store(body + BODY_VX, number_at(body + BODY_VX) + stance.given_x)
        store(body + BODY_VY, number_at(body + BODY_VY) + stance.given_y)
        store(body + BODY_OMEGA, number_at(body + BODY_OMEGA) + stance.given_turn)


@callback("void", "address", "float64")
def solve_round(constraint, dt):
    """Solve the contacts of posts once, then let the ground act on the robots that touch something."""
    solver = solver_at(address_at(constraint + MOTOR_RATE))
    solve_posts(solver)
    for i in range(solver.touching_count):
        apply_ground_drive(stance_of(solver, solver.touching[i]), dt)


@callback("float64", "address")
def zero_impulse(constraint):
    """Return 0: Chipmunk needs this function, and nothing reads its result."""
    return 0.0


@callback("void", "address", "address")
def finish_substep(constraint, space):
    """Slow the ball's roll by the blows of this substep."""
    slow_roll_by_contacts(solver_at(address_at(constraint + MOTOR_RATE)))


@compiled
def drive_free_robots(solver, dt):
    """Let the ground act before the first substep of a control step of dt [s] on robots that touch nothing.

    Chipmunk moves bodies first and then changes their velocities: a walk would start a substep late.
    """
    for r in range(solver.robots):
        stance = stance_of(solver, r)
        stance.led = 0
        if touches_nothing(stance):
            stance.given_x = stance.given_y = stance.given_turn = 0.0
            apply_ground_drive(stance, dt)
            stance.given_x = stance.given_y = stance.given_turn = 0.0
            stance.led = 1


@compiled
def touches_nothing(stance):
    """Tell whether a robot touches nothing in this substep; between substeps, in the last substep."""
    return address_at(stance.body + BODY_ARBITERS) == 0 and stance.meets == 0


@compiled
def apply_ground_drive(stance, dt):
    """Bring a robot towards its wanted velocity, with at most the impulse that the ground bears in a substep."""
    body = stance.body
    vx, vy = number_at(body + BODY_VX), number_at(body + BODY_VY)
    x, y = stance.given_x + stance.vx - vx, stance.given_y + stance.vy - vy
    if stance.grip == stance.traction:
        size, most = length(x, y), stance.traction * dt
        if size > most:
            x *= most / size
            y *= most / size
    else:
        cosine, sine = number_at(body + BODY_COS), number_at(body + BODY_SIN)
        ahead, left = into_frame(x, y, cosine, sine)
        ahead = clip(ahead, -stance.traction * dt, stance.traction * dt)
        left = clip(left, -stance.grip * dt, stance.grip * dt)
        x, y = out_of_frame(ahead, left, cosine, sine)
    store(body + BODY_VX, vx + x - stance.given_x)
    store(body + BODY_VY, vy + y - stance.given_y)
    stance.given_x = x
    stance.given_y = y
    omega, most = number_at(body + BODY_OMEGA), stance.turn_traction * dt
    turn = clip(stance.given_turn + stance.omega - omega, -most, most)
    store(body + BODY_OMEGA, omega + turn - stance.given_turn)
    stance.given_turn = turn


# For the class that owns the Spaces


class SolverArrays(NamedTuple):
    """The arrays of a match that its SOLVER record points to."""

    stances: np.ndarray  # (R,) STANCE
    contacts: np.ndarray  # (n,) POST_CONTACT
    last_contacts: np.ndarray  # (n,) LAST_CONTACT


def attach_solver(space: pymunk.Space, solver: np.ndarray, room: SolverArrays, league: League, k: np.ndarray) -> None:
    """Add our constraint to a Space whose dynamic bodies are the ball and the robots, in this order.

    Its functions use a SOLVER record (1,), the room of a match, and the league's constants (1,). The caller keeps all
    of them alive and in place.
    """
    if not layout_fits():
        raise RuntimeError(f"this package needs pymunk 7.3 on a 64-bit machine, found {pymunk.version}")
    bodies = [address_of(body) for body in space.bodies]
    solver[0] = np.zeros((), SOLVER)
    solver["robots"], solver["posts"] = len(bodies) - 1, len(posts_outside_space(league.body))
    solver["space"] = address_of(space)
    solver["rounds"], solver["jam_rounds"] = league.substeps.iterations, league.substeps.jam_iterations
    solver["constants"], solver["slop"] = k.ctypes.data, league.substeps.slop
    solver["ground"], solver["ball"] = address_of(space.static_body), bodies[0]
    solver["spin_mass"] = league.ball.shell * league.ball.mass
    ball = next(iter(space.bodies))
    solver["ball_lightness"], solver["ball_ease"] = 1.0 / ball.mass, 1.0 / ball.moment
    for name in ("ball", "robot", "board"):
        pair = league.materials.pairs()[{"ball": "ball_robot", "robot": "robot_robot", "board": "robot_board"}[name]]
        solver[f"{name}_elasticity"], solver[f"{name}_friction"] = pair.elasticity, pair.friction
    for name, array in room._asdict().items():
        solver[name] = array.ctypes.data
    solver["contact_room"] = len(room.contacts)
    room.stances[:] = np.zeros((), STANCE)
    room.stances["body"] = bodies[1:]
    for i, (x, y) in enumerate(posts_outside_space(league.body)):
        room.stances["posts"]["stand_x"][:, i], room.stances["posts"]["stand_y"][:, i] = x, y
    _add_constraint(space, solver.ctypes.data)


def _add_constraint(space: pymunk.Space, solver: int) -> None:
    """Add the constraint with our functions, and give it the address of the match's SOLVER record."""
    motor = pymunk.SimpleMotor(space.static_body, next(iter(space.bodies)), float(np.uint64(solver).view(np.float64)))
    space.add(motor)
    ffi.cast("uintptr_t *", address_of(motor) + CONSTRAINT_CLASS)[0] = _class_table().ctypes.data
    lib.cpConstraintSetPostSolveFunc(motor._constraint, ffi.cast("cpConstraintPostSolveFunc", finish_substep.address))


@functools.cache
def _class_table() -> np.ndarray:
    """Return the addresses of the four functions of our constraint, in the order of Chipmunk's struct."""
    return np.array(
        [function.address for function in (prepare_substep, resume_impulses, solve_round, zero_impulse)], np.uint64
    )
