"""Exact readings of the own body, part of every observation: gait, head, kicker and last command.

`k`: the league's constants.
"""

from math import pi

from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine
from soccer_env.observations.entry import NONE, OWN_COMMAND, ROBOT, TURN, Entry, X, Y, copy_to_group

JOINTS = copy_to_group(
    "own body",
    Entry("gait_cos", "cosine of the gait phase", "1", NONE),
    Entry("gait_sin", "sine of the gait phase", "1", NONE),
    Entry("pan", "head pan", "pi", ROBOT, TURN),
    Entry("tilt", "head tilt", "pi / 2", ROBOT),
    Entry("kick_ready", "1 ready, 0 winding up, -1 recharging", "1", NONE),
)
DUTY = copy_to_group(
    "own duty",
    Entry("upright", "1 upright, -1 fallen", "1", NONE),
    Entry("active", "1 playing, -1 sent off", "1", NONE),
    Entry("keeper", "1 goalkeeper, -1 field player", "1", NONE),
)
COMMAND = copy_to_group(
    OWN_COMMAND,
    Entry("last_forward", "last command: forward", "1", ROBOT, X),
    Entry("last_left", "last command: left", "1", ROBOT, Y),
    Entry("last_turn", "last command: turn", "1", ROBOT, TURN),
    Entry("last_kick", "last command: kick", "1", NONE),
)


@compiled
def write_joints(robot, row, k):
    """Write the entries `JOINTS` of an observation: gait phase, pan and tilt of the head, state of the kicker."""
    phase = 2.0 * pi * robot.gait_phase / k.gait_steps
    row.gait_cos, row.gait_sin = cosine_and_sine(phase) if k.gait_steps > 1 else (0.0, 0.0)
    row.pan, row.tilt = robot.pan / pi, robot.tilt / (0.5 * pi)
    row.kick_ready = 1.0 if robot.kick_clock == 0.0 else (0.0 if robot.kick_clock > 0.0 else -1.0)


@compiled
def write_status_flags(upright, active, keeper, row):
    """Write the entries `DUTY` of an observation (upright, active, goalkeeper) as 1 or -1, from flags of 1 or 0."""
    row.upright = 2.0 * upright - 1.0
    row.active = 2.0 * active - 1.0
    row.keeper = 2.0 * keeper - 1.0


@compiled
def write_command(robot, row):
    """Write the entries `COMMAND` of an observation: the robot's last command."""
    command = robot.command
    row.last_forward, row.last_left = command.forward, command.left
    row.last_turn, row.last_kick = command.turn, command.kick
