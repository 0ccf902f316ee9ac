"""The part of every observation that a body feels exactly: gait, head, kicker and its own last command."""

from __future__ import annotations

from math import cos, pi, sin

from soccer_env.compiled import compiled

JOINTS = (
    ("gait_cos", "cosine of the gait phase", "1"),
    ("gait_sin", "sine of the gait phase", "1"),
    ("pan", "head pan", "pi"),
    ("tilt", "head tilt", "pi / 2"),
    ("kick_ready", "1 ready, 0 winding up, -1 recharging", "1"),
)
DUTY = (
    ("upright", "1 upright, -1 fallen", "1"),
    ("active", "1 playing, -1 sent off", "1"),
    ("keeper", "1 goalkeeper, -1 field player", "1"),
)
COMMAND = (
    ("last_forward", "last command: forward", "1"),
    ("last_left", "last command: left", "1"),
    ("last_turn", "last command: turn", "1"),
    ("last_kick", "last command: kick", "1"),
)


@compiled
def write_joints(robot, row, k, at):
    """Write the numbers of `JOINTS`; return where the next entry goes."""
    phase = 2.0 * pi * robot.gait_phase / k.gait_steps
    row[at], row[at + 1] = (cos(phase), sin(phase)) if k.gait_steps > 1 else (0.0, 0.0)
    row[at + 2], row[at + 3] = robot.pan / pi, robot.tilt / (0.5 * pi)
    row[at + 4] = 1.0 if robot.kick_clock == 0.0 else (0.0 if robot.kick_clock > 0.0 else -1.0)
    return at + 5


@compiled
def write_duty(upright, active, keeper, row, at):
    """Write the numbers of `DUTY` from what is 1 or 0; return where the next entry goes."""
    row[at], row[at + 1], row[at + 2] = 2.0 * upright - 1.0, 2.0 * active - 1.0, 2.0 * keeper - 1.0
    return at + 3


@compiled
def write_command(robot, row, at):
    """Write the numbers of `COMMAND`; return where the next entry goes."""
    row[at], row[at + 1] = robot.command.forward, robot.command.left
    row[at + 2], row[at + 3] = robot.command.turn, robot.command.kick
    return at + 4
