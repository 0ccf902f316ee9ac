"""Drive along a path, planned anew at every decision, within the base's limits.  [Heinemann 2006, 2, 3]  MH01, MH14

    "With the continuous replanning this approach generates very efficient and smooth paths"    [Heinemann 2006, 3]

The base can move sideways, so it can face any direction and turns while it drives. Velocity and turn share one
acceleration: to keep a straight path while turning at w with speed v, a base needs the acceleration v w in its frame.

Obstacles are the other robots, with believed places and velocities (MH06, MH15): the robot's own tracks, from its
camera and from its team-mates' reports by radio. The goals, with posts and nets, are obstacles that stand still.

    "the position of the obstacles is no longer static for the whole planning process"    [Heinemann 2006, 3]

`k`: the league's constants; `play`: the team's settings.
"""

from math import sqrt

from soccer_env.baselines.heinemann_2006.settings import PLANNERS
from soccer_env.baselines.weigel_2001.planner.measuring import place_along_path
from soccer_env.baselines.weigel_2001.planner.planning import plan_way
from soccer_env.baselines.weigel_2001.planner.records import MOST_OBSTACLES
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, into_frame, length, wrap
from soccer_env.leagues.robot import WHEELS_DIFFERENTIAL
from soccer_env.skills.moves import (
    FOUGHT_FOR,
    brake_before_robots,
    braking_speed,
    drive_differential,
    go,
    push,
    turn_by,
)
from soccer_env.skills.sight import side_of

NO_PLANNER = PLANNERS["none"]
NEAR_GOAL = 2.0  # [m] before a goal line from which the goal is an obstacle, assumed: beyond its repulsion
GOAL_DISCS = 5  # that fill a goal from post to post, a quarter of its width apart
KEPT = 2  # decisions, this one and the next, for which the velocity asked for is known


@compiled
def drive_to(command, memory, k, play, scratch, x, y, facing, final):
    """Drive to x, y [m], past other robots, facing a direction [rad], team frame; `final`: speed [m/s] on arrival."""
    sight = scratch.sight
    if play.planner == NO_PLANNER:
        go(command, sight, k, play.skills, x, y, facing, final)
        return
    if length(x - sight.x, y - sight.y) < play.arrived and final == 0.0:
        memory.arrived = 1
        command_velocity(command, memory, k, play, sight, 0.0, 0.0, 0.0, facing)
        return
    note_crowd(scratch, k, play, final > 0.0)
    note_goals(scratch, k, x)
    plan_to(k, play, scratch, x, y)
    follow(command, memory, k, play, scratch, facing, final)


@compiled
def plan_to(k, play, scratch, x, y):
    """Plan the path to x, y [m], past the robots in the present belief, into `scratch.plan`.  MH14"""
    sight = scratch.sight
    fill_planner_settings(scratch, k, play)
    side = 1 if side_of(y - sight.y if y != sight.y else y) > 0.0 else -1
    crowd, ways, work, plan = scratch.crowd[: scratch.count], scratch.ways[0], scratch.work[0], scratch.plan[0]
    plan_way(sight.x, sight.y, x, y, side, crowd, ways, work, plan)


@compiled
def fill_planner_settings(scratch, k, play):
    """Write the planner's settings into the scratch record: pitch, robot size, and the robot's speed."""
    ways = scratch.ways[0]
    scratch.ways[0] = play.ways[0]
    ways.pitch_length, ways.pitch_width = k.pitch_length, k.pitch_width
    ways.margin = min(k.pitch_band_side, k.pitch_band_end)
    ways.speed, ways.robot_radius = k.drive_forward * scratch.sight.pace, k.body_reach


@compiled
def follow(command, memory, k, play, scratch, facing, final):
    """Drive towards a point ahead on the planned path, at a speed that suits the path's bends and its end."""
    sight, plan, place = scratch.sight, scratch.plan[0], scratch.place[0]
    now = length(sight.vx, sight.vy)
    ahead = play.look_ahead + play.look_ahead_time * now
    place_along_path(plan.path, plan.count, ahead, place)
    x, y = place.x - sight.x, place.y - sight.y
    away = max(length(x, y), 1e-9)
    place_along_path(plan.path, plan.count, 2.0 * ahead, place)
    bend = bend_angle(x, y, place.x - sight.x - x, place.y - sight.y - y)
    speed = min(bend_speed(k, play, bend, ahead), max(final, braking_speed(k, play.skills, plan.length)))
    x, y, speed = brake_before_robots(sight, k, play.skills, x / away, y / away, speed, final > 0.0)
    if k.drive_kind == WHEELS_DIFFERENTIAL:
        ahead, left = into_frame(x, y, sight.cosine, sight.sine)
        drive_differential(command, sight, k, play.skills, ahead, left, plan.length, facing, speed)
    else:
        command_velocity(command, memory, k, play, sight, x, y, min(speed, k.drive_forward * sight.pace), facing)


@compiled
def bend_angle(x, y, then_x, then_y):
    """Return the angle [rad], 0 or more, between two segments of a path; 0 if either has no length."""
    if length(x, y) < 1e-6 or length(then_x, then_y) < 1e-6:
        return 0.0
    return abs(atan2(x * then_y - y * then_x, x * then_x + y * then_y))


@compiled
def bend_speed(k, play, bend, far):
    """Return the top speed [m/s] through a bend of `bend` [rad] in `far` [m], limited by sideways acceleration."""
    return sqrt(play.bending * k.drive_acceleration * far / max(bend, 1e-3))


@compiled
def command_velocity(command, memory, k, play, sight, x, y, speed, facing):
    """Command `speed` [m/s] along the unit vector (x, y), approached within the base's acceleration limit.  MH01"""
    if memory.drove == 0:
        memory.drive_x, memory.drive_y = sight.vx, sight.vy
    vx, vy = speed * x - memory.drive_x, speed * y - memory.drive_y
    change, most = length(vx, vy), k.drive_acceleration * sight.elapsed
    share = 1.0 if change <= most else most / change
    vx, vy = memory.drive_x + share * vx, memory.drive_y + share * vy
    memory.drive_x, memory.drive_y, memory.drove = vx, vy, KEPT
    size = length(vx, vy)
    ahead, left = into_frame(vx, vy, sight.cosine, sight.sine)
    push(command, sight, k, ahead / max(size, 1e-9), left / max(size, 1e-9), size / max(sight.pace, 1e-9))
    turn_by(command, sight, k, play.skills, wrap(facing - sight.heading))
    most_turn = turn_limit(k, play, size) / k.drive_turn
    command.turn = clip(command.turn, -most_turn, most_turn)


@compiled
def turn_limit(k, play, speed):
    """Return the largest turn rate w [rad/s] at speed v [m/s], so that v w keeps to its share of the acceleration."""
    return play.turning * k.drive_acceleration / max(speed, 1e-3)


@compiled
def note_crowd(scratch, k, play, fights):
    """List the tracked players as obstacles; without those at the ball if the player fights for the ball."""
    sight, count = scratch.sight, 0
    for i in range(sight.others):
        at_ball = length(sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y) < FOUGHT_FOR
        if count == MOST_OBSTACLES or (fights and at_ball and (sight.mate[i] == 1 or sight.field[i] == 1)):
            continue
        one = scratch.crowd[count]
        one.x, one.y = sight.other_x[i], sight.other_y[i]
        one.vx, one.vy = bounded(sight.other_vx[i], sight.other_vy[i], play)
        one.radius = k.body_reach + play.keeps_off
        count += 1
    scratch.count = count


@compiled
def note_goals(scratch, k, x):
    """Add to the obstacles the goal that the robot or its target, at x [m], is near, as discs that fill the goal.

    A way past a goalkeeper would otherwise lead through the goal, and end at a side net.
    """
    wide, radius = 0.5 * k.pitch_goal_width, 0.5 * k.pitch_goal_depth
    for end in range(-1, 2, 2):
        if max(end * x, end * scratch.sight.x) < 0.5 * k.pitch_length - NEAR_GOAL:
            continue
        for i in range(GOAL_DISCS):
            if scratch.count < MOST_OBSTACLES:
                one = scratch.crowd[scratch.count]
                one.x, one.y = end * (0.5 * k.pitch_length + radius), wide * (2.0 * i / (GOAL_DISCS - 1.0) - 1.0)
                one.vx, one.vy, one.radius = 0.0, 0.0, radius
                scratch.count += 1


@compiled
def bounded(vx, vy, play):
    """Return a believed velocity [m/s] clipped to the top speed of robots, since readings may be wrong.  MH25"""
    if play.velocity == 0:
        return 0.0, 0.0
    speed = length(vx, vy)
    if speed <= play.fastest:
        return vx, vy
    return play.fastest * vx / speed, play.fastest * vy / speed
