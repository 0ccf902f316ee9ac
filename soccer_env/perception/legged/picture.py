"""The picture of a legged robot's head camera, up to the blobs that its vision reports.  [Sacks 2001, 2]

From the truth: where the camera looks (camera.py), which robots stand before it (bodies.py), where each thing lies in
the picture (jersey.py, scenery.py, sketch.py), which parts are hidden (occlusion.py), and the blobs (blobs.py).

`k`: the league's constants; `s`: settings of the sensors.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction
from soccer_env.perception.legged.blobs import clear_blob, deliver_blobs
from soccer_env.perception.legged.bodies import HEAD, TRUNK, find_bodies
from soccer_env.perception.legged.camera import from_camera, point_camera, update_pose_angles
from soccer_env.perception.legged.jersey import is_lowered, put_head_stickers, put_trunk_stickers
from soccer_env.perception.legged.scenery import draw_goals, draw_landmarks, draw_patches
from soccer_env.perception.legged.sketch import BALL, KINDS, OPPONENTS, TEAMMATES, draw_panel, draw_sphere


@compiled
def take_picture(match, ball, robots, percept, state, k, s, r, sketches):
    """Write the blobs that robot r sees into its percept; `sketches` (1,) is scratch made by `make_sketch`.  MS04

    A robot that lies on its side or is sent off gets no blobs.
    """
    robot = robots[r]
    if robot.active == 0 or robot.fallen > 0.0:
        clear_picture(percept)
        return
    draw_scene(match, ball, robots, k, s, r, sketches[0])
    deliver_blobs(sketches[0], percept, state, robot.noise, s)


@compiled
def draw_scene(match, ball, robots, k, s, r, sketch):
    """Draw everything before robot r's camera into a sketch, without noise."""
    camera, side = sketch.camera, attack_direction(match, robots[r].team)
    for kind in range(KINDS):
        sketch.counts[kind] = 0
    update_pose_angles(sketch.poses[r], robots[r], match.handedness)
    point_camera(camera, robots[r], sketch.poses[r], match.handedness, s)
    sketch.body_count = find_bodies(camera, robots, r, sketch.poses, sketch.hull, s, sketch.bodies)
    ahead, left = from_camera(camera, ball.x, ball.y)
    draw_sphere(sketch, ahead, left, k.ball_radius, BALL)
    for i in range(sketch.body_count):
        draw_jersey(sketch, i, s)
    draw_goals(sketch, side, k, s)
    draw_landmarks(sketch, side, k, s)
    draw_patches(sketch, match, side, k, s)


@compiled
def draw_jersey(sketch, owner, s):
    """Draw the stickers of a robot's body into a sketch.  MS37, MS50"""
    body, stickers = sketch.bodies[owner], sketch.stickers
    kind, lowered = TEAMMATES if body.teammate == 1 else OPPONENTS, is_lowered(body, s)
    body.first = sketch.counts[kind]
    if body.boxes[TRUNK].shown == 1:
        for i in range(put_trunk_stickers(body, s, stickers)):
            draw_panel(sketch, stickers[i], kind, owner, lowered, False)
    if body.boxes[HEAD].shown == 1 and not lowered:
        for i in range(put_head_stickers(body, s, stickers)):
            draw_panel(sketch, stickers[i], kind, owner, False, False)
    body.pieces = sketch.counts[kind] - body.first


@compiled
def clear_picture(percept):
    """Remove all blobs from a percept."""
    for blobs in (percept.ball, percept.teammates, percept.opponents, percept.own_goal, percept.opponent_goal):
        for i in range(blobs.shape[0]):
            clear_blob(blobs[i])
    for i in range(percept.landmarks.shape[0]):
        clear_blob(percept.landmarks[i])
