"""All sensors of a middle-size robot: mirror camera, wheels, light barrier.  MH02, MH07

    exposure -> pending, for `camera_delay` frames -> percept, with its age; what the body feels is current

A robot that was just placed gets its first pictures without delay: pictures on their way show its old place.

`k`: the league's constants; `s`: settings of the sensors.
"""

from soccer_env.compiled import compiled, scratch_records
from soccer_env.guards.ranges import NUMBER, ranged_record
from soccer_env.optics.mirror_camera import mirror_parameters
from soccer_env.perception.body import POSE_ERROR, sense_light_barrier
from soccer_env.perception.omni.around import AROUND, find_bodies_around
from soccer_env.perception.omni.lighting import (
    LEAST_LINES,
    begin_colour_table,
    brightness,
    measure_light,
    recognised_share,
    train_colour_table,
)
from soccer_env.perception.omni.line_picture import LINE_MAP, count_lines, draw_map, find_lines
from soccer_env.perception.omni.sightings import clear_sighting, find_ball, find_goals, find_players
from soccer_env.perception.sensing import make_sensor_kernel
from soccer_env.records.percepts import NO_POSE, POSE_TOLD
from soccer_env.types import MAX_TEAM

OMNI_SENSOR_STATE = ranged_record(
    [  # state of the sensors that they do not deliver
        ("pose_error", POSE_ERROR),
        ("table", "f4", NUMBER),  # [1] the light that the colour table is made for, trained up to the latest picture
    ]
)


@compiled
def make_scratch(k, s):
    """Return scratch for sensing: the robots in view, the map of the pitch's lines for the camera, and the mirror."""
    around, maps = scratch_records(2 * MAX_TEAM, AROUND), scratch_records(1, LINE_MAP)
    draw_map(maps[0], k, s)
    return around, maps, mirror_parameters(s)


@compiled
def sense_robot(match, ball, robots, r, percept, state, pending, scratch, k, s):
    """Compute the percept of robot r; pending (camera_delay,) holds pictures that are not yet delivered."""
    sense_light_barrier(robots[r], percept.body, s)
    take_and_deliver_picture(match, ball, robots, r, percept, state, pending, brightness(match, s), scratch, k, s)


@compiled
def take_and_deliver_picture(match, ball, robots, r, percept, state, pending, light, scratch, k, s):
    """Take a new picture, and deliver the delayed picture that is due in this frame.  MH02"""
    late, robot = pending.shape[0], robots[r]
    if late == 0:
        percept.age = 0.0
        take_picture(match, ball, robots, r, percept, state, percept.body.pose, light, scratch, k, s)
        return
    slot = pending[match.step % late]
    if robot.placed == 1:  # pictures on their way show the old place
        for i in range(late):
            pending[i].body.active = 0
    due = slot.body.active == 1 and slot.body.frame + late == match.step
    if due:
        copy_picture(slot, percept)
    take_picture(match, ball, robots, r, slot, state, percept.body.pose, light, scratch, k, s)
    slot.body.frame, slot.body.active = match.step, robot.active
    percept.age = late * k.dt if due else 0.0
    if not due:
        copy_picture(slot, percept)


@compiled
def take_picture(match, ball, robots, r, picture, state, pose, light, scratch, k, s):
    """Compute the camera's picture of this frame, and adapt the colour table to it.  MH07"""
    robot, handedness = robots[r], match.handedness
    picture.light = measure_light(light, s, robot.noise)
    state.table = begin_colour_table(state.table, picture.light, s, match.step == 0 or pose == POSE_TOLD)
    if robot.active == 0:
        clear_picture(picture)
        return
    colour = recognised_share(light, state.table, s)
    around, maps, mirror = scratch
    count = find_bodies_around(robots, r, k, around)
    find_ball(ball, robot, picture, around, count, mirror, k, s, robot.noise, handedness, colour)
    find_players(picture, around, count, mirror, k, s, robot.noise, handedness, colour)
    picture.searched = is_searched(match, robot, s)
    if picture.searched == 1:
        find_goals(match, robot, picture, around, count, mirror, k, s, robot.noise, handedness, colour)
        find_lines(robot, picture.lines, around, count, maps[0], mirror, k, s, robot.noise, handedness, colour)
    placed = pose != NO_POSE or count_lines(picture.lines, s) >= LEAST_LINES
    state.table = train_colour_table(state.table, picture.light, s, k.dt, placed)


@compiled
def is_searched(match, robot, s):
    """Tell whether a robot searches this picture for goals and lines: every few frames, and when it was just placed.

    Only the own pose is read from them. Robots take turns, by number.
    """
    return 1 if robot.placed == 1 or (match.step + robot.number) % s.search_every == 0 else 0


@compiled
def clear_picture(picture):
    """Remove everything from a picture, for a robot that is sent off and sees nothing."""
    picture.searched = 1
    clear_sighting(picture.ball)
    clear_sighting(picture.own_goal)
    clear_sighting(picture.opponent_goal)
    for i in range(picture.players.shape[0]):
        clear_sighting(picture.players[i])
    picture.lines[:] = 0.0


@compiled
def copy_picture(picture, percept):
    """Copy a picture into the percept."""
    copy_sighting(picture.ball, percept.ball)
    percept.searched = picture.searched
    if picture.searched == 1:
        copy_sighting(picture.own_goal, percept.own_goal)
        copy_sighting(picture.opponent_goal, percept.opponent_goal)
        percept.lines[:] = picture.lines
    for i in range(picture.players.shape[0]):
        if picture.players[i].seen == 0 and percept.players[i].seen == 0:
            break
        copy_sighting(picture.players[i], percept.players[i])
    percept.light = picture.light


@compiled
def copy_sighting(one, other):
    """Copy a sighting from one record to the other."""
    other.distance, other.bearing = one.distance, one.bearing
    other.seen, other.teammate = one.seen, one.teammate


sense_slice = make_sensor_kernel(make_scratch, sense_robot)
