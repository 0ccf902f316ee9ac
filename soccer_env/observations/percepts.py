"""observe="percepts": the readings of a robot's sensors in this frame, without any memory.

First the readings of its body, then the picture of its kind of robot (legged.py, omni.py), last the state of the match.
The robot's own pose is included only while the noisy pose is a percept (`pose="percept"`).

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, from_polar
from soccer_env.observations.body import COMMAND, DUTY, JOINTS, write_command, write_joints, write_status_flags
from soccer_env.observations.entry import NONE, ROBOT, TEAM, TURN, Entry, X, Y, copy_to_group, entries_dtype

BODY = (
    *copy_to_group(
        "own pose",
        Entry("pose_known", "1: a pose was given in this frame; else its entries are 0", "1", NONE),
        Entry("own_x", "given position, towards the opponent's goal", "half length plus goal depth", TEAM, X),
        Entry("own_y", "given position, to the left", "half width plus band", TEAM, Y),
        Entry("own_cos", "cosine of the given heading", "1", TEAM, X),
        Entry("own_sin", "sine of the given heading", "1", TEAM, Y),
    ),
    *copy_to_group(
        "odometry",
        Entry("odometry_forward", "displacement ahead since the last frame", "a control step at top speed", ROBOT, X),
        Entry("odometry_left", "displacement to the left", "a control step at top speed", ROBOT, Y),
        Entry("odometry_turn", "turn", "a control step at the top turn rate", ROBOT, TURN),
    ),
    *JOINTS,
    *copy_to_group(
        "own body",
        Entry("held", "1: the light barrier at the kicker is broken (middle size)", "1", NONE),
    ),
    *DUTY,
    *COMMAND,
)
BODY_ROW, BODY_SIZE = entries_dtype(BODY), len(BODY)


@compiled
def write_body(body, robot, row, k):
    """Write the readings of the robot's own body into an observation."""
    known = 1.0 if body.pose > 0 else 0.0
    row.pose_known = known
    row.own_x = known * clip(body.x / (0.5 * k.pitch_length + k.pitch_goal_depth), -1.0, 1.0)
    row.own_y = known * clip(body.y / (0.5 * k.pitch_width + k.pitch_band_side), -1.0, 1.0)
    row.own_cos, row.own_sin = from_polar(known, body.heading)
    row.odometry_forward = clip(body.forward / (k.drive_forward * k.dt), -1.0, 1.0)
    row.odometry_left = clip(body.left / (k.drive_forward * k.dt), -1.0, 1.0)
    row.odometry_turn = clip(body.turn / (k.drive_turn * k.dt), -1.0, 1.0)
    write_joints(robot, row, k)
    row.held = body.held
    write_status_flags(body.upright, body.active, robot.keeper, row)
    write_command(robot, row)
