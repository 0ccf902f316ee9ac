"""All sensors of a legged robot: camera, infrared ranger, touch, own body.  [Sacks 2001, 1, 2]  MS06

`k`: the league's constants; `s`: settings of the sensors.
"""

from soccer_env.compiled import compiled
from soccer_env.guards.ranges import NUMBER, ranged_record
from soccer_env.perception.body import POSE_ERROR
from soccer_env.perception.legged.infrared import measure_range
from soccer_env.perception.legged.picture import take_picture
from soccer_env.perception.legged.sketch import make_sketch
from soccer_env.perception.legged.touch import feel_touch
from soccer_env.perception.sensing import make_sensor_kernel

LEGGED_SENSOR_STATE = ranged_record(
    [  # state of the sensors that they do not deliver
        ("pose_error", POSE_ERROR),
        ("scale", "f4", NUMBER),  # [1] of the sizes that the camera reports, drawn once an episode; 0: not yet
    ]
)


@compiled
def sense_robot(match, ball, robots, r, percept, state, pending, sketches, k, s):
    """Compute the whole percept of robot r; `pending`, for cameras with a delay, is not used here."""
    percept.pan, percept.tilt = robots[r].pan, robots[r].tilt
    take_picture(match, ball, robots, percept, state, k, s, r, sketches)
    feel_touch(ball, robots[r], percept.touch, k, s)
    percept.infrared = measure_range(match, ball, robots, k, s, r)


sense_slice = make_sensor_kernel(make_sketch, sense_robot)
