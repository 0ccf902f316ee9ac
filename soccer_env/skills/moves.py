"""How a scripted player moves, turns, avoids robots, and chooses directions for the ball and its shots.

Skills hold no state and write a command. Only `go` depends on how a base moves: gait, omnidirectional or differential.
Lengths are in metres of the team frame unless a name says otherwise.

`k`: the league's constants; `play`: the team's settings.
"""

from math import sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, cosine_and_sine, into_frame, length, out_of_frame, wrap
from soccer_env.leagues.robot import GAIT, WHEELS_DIFFERENTIAL, WHEELS_OMNI
from soccer_env.skills.sight import side_of

TURNING = 0.4  # [1] share of the acceleration that turning at speed may take, as heinemann-2006's, assumed
SIDESTEP_CONE = 1.2  # [rad] a base that cannot step aside drives only towards what lies within it ahead, assumed
REVERSE_ROOM = 0.6  # [m] such a base backs up to what lies nearer than this behind it, assumed
BRAKE_SHARE = 0.7  # [1] of the acceleration is counted on for braking, assumed
LARGE_TURN = 0.7  # [rad] a turn beyond which paws at a board are in the way, assumed
BOARD_ROOM = 0.03  # [m] more than the paws need that a walker keeps off a board before it turns, assumed
AVOID_AHEAD = 4.0  # [body reaches] how far ahead other robots are looked for, assumed
AVOID_ASIDE = 2.3  # [body reaches] how far aside of the way they are avoided, assumed
AVOID_WEIGHT = 1.2  # [1] how far the way turns aside at most, assumed
FOUGHT_FOR = 0.5  # [m] a robot this near to the ball has it, assumed
KEPT_OFF = 0.05  # [m] kept between robots off the ball, assumed
GOAL_SPOTS = 4  # pairs of spots between the posts that a shot can be aimed at, beside the middle
FAN = 5  # directions to either side of the goal's that are looked at when no shot is open
FAN_STEP = 0.35  # [rad] between them, assumed
FAN_COSINE, FAN_SINE = 0.9393727128473789, 0.34289780745545134  # of FAN_STEP: a kernel called here slows every import
FAN_COST = 0.1  # [1] room that a way may lose for each radian nearer to the goal, assumed
OUT_COST = 0.5  # [1] the same for the share of a way that lies out of the pitch, assumed
WIDE_ENOUGH = 0.12  # [rad] more room than this beside a shot is worth nothing, assumed
TURN_COST = 0.03  # [rad] room that a shot or way may lose for a quarter turn less, assumed


@compiled
def stand(command):
    """Stand still; the head tracks the ball by itself."""
    command.forward = command.left = command.turn = command.kick = 0.0
    command.head = -1.0


@compiled
def turn_by(command, sight, k, play, angle):
    """Turn by an angle [rad] within the settling time; an omnidirectional base turns more slowly at speed.  MH01

    A base that keeps a straight path at speed v while turning at w needs the acceleration v w in its own frame, which
    leaves less for braking.
    """
    most = 1.0
    if k.drive_kind == WHEELS_OMNI:
        speed = max(length(sight.vx, sight.vy), 1e-6)
        most = min(TURNING * k.drive_acceleration / (speed * k.drive_turn), 1.0)
    command.turn = clip(angle / (play.settle * k.drive_turn), -most, most) * sight.pace


@compiled
def push(command, sight, k, ahead, left, speed):
    """Move along a direction of the robot frame (unit vector) at a speed [m/s]."""
    top = k.drive_forward if ahead > 0.0 else k.drive_backward
    command.forward = ahead * min(speed / top, 1.0) * sight.pace
    if k.drive_sideways > 0.0:
        command.left = left * min(speed / k.drive_sideways, 1.0) * sight.pace
    else:
        command.left = 0.0


@compiled
def braking_speed(k, play, distance):
    """Return the speed [m/s] from which a robot can stop within a distance [m]."""
    return min(distance / play.settle, sqrt(2.0 * BRAKE_SHARE * k.drive_acceleration * distance))


@compiled
def go(command, sight, k, play, x, y, facing, final):
    """Go to a point and face a team-frame direction [rad]; `final` is the speed [m/s] on arrival."""
    dx, dy = x - sight.x, y - sight.y
    distance = length(dx, dy)
    if distance < 1e-6:
        turn_by(command, sight, k, play, wrap(facing - sight.heading))
        return
    dx, dy = avoid_others(sight, k, dx / distance, dy / distance, distance)
    ahead, left = into_frame(dx, dy, sight.cosine, sight.sine)
    speed = max(final, braking_speed(k, play, distance))
    if k.rules_charging == 1:
        dx, dy, speed = brake_before_robots(sight, k, play, dx, dy, speed, final > 0.0)
        ahead, left = into_frame(dx, dy, sight.cosine, sight.sine)
    if k.drive_kind == WHEELS_DIFFERENTIAL:
        drive_differential(command, sight, k, play, ahead, left, distance, facing, speed)
    elif k.drive_kind == GAIT and distance > play.walk_ahead:
        walk_ahead(command, sight, k, play, ahead, left, speed, 0.0 < play.walks_turned < distance)
    else:
        push(command, sight, k, ahead, left, speed)
        turn_by(command, sight, k, play, wrap(facing - sight.heading))


@compiled
def step_to(command, sight, k, play, x, y, facing):
    """Step to a point sideways or backwards, facing a team-frame direction [rad] all the way."""
    dx, dy = x - sight.x, y - sight.y
    distance = max(length(dx, dy), 1e-6)
    ahead, left = into_frame(dx / distance, dy / distance, sight.cosine, sight.sine)
    push(command, sight, k, ahead, left, braking_speed(k, play, distance))
    turn_by(command, sight, k, play, wrap(facing - sight.heading))


@compiled
def brake_before_robots(sight, k, play, dx, dy, speed, fights):
    """Limit a velocity so that the player can brake before every robot; return direction (unit vector) and speed [m/s].

    A player that fights for the ball may drive at players at the ball, but never at a goalkeeper.
    """
    vx, vy = speed * dx, speed * dy
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.x, sight.other_y[i] - sight.y
        away = max(length(x, y), 1e-6)
        into = (vx * x + vy * y) / away
        has_it = length(sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y) < FOUGHT_FOR
        if into <= 0.0 or (fights and has_it and (sight.mate[i] == 1 or sight.field[i] == 1)):
            continue
        most = braking_speed(k, play, max(away - 2.0 * k.body_reach - KEPT_OFF, 0.0))
        if into > most:
            vx, vy = vx - (into - most) * x / away, vy - (into - most) * y / away
    size = length(vx, vy)
    return (dx, dy, 0.0) if size < 1e-6 else (vx / size, vy / size, size)


@compiled
def walk_ahead(command, sight, k, play, ahead, left, speed, turned):
    """Turn along the path and walk; `turned`: sideways or backwards until the turn is done, else forward alone."""
    bearing = atan2(left, ahead)
    turn_by(command, sight, k, play, bearing)
    if turned:
        push(command, sight, k, ahead, left, speed)
    else:
        push(command, sight, k, max(ahead, 0.0) * max(ahead, 0.0), left * max(ahead, 0.0), speed)
    if abs(bearing) > LARGE_TURN:
        leave_boards(command, sight, k)


@compiled
def leave_boards(command, sight, k):
    """Step away from a board that is near enough to catch the paws in a turn on the spot."""
    if k.walled == 0:
        return
    room = k.body_reach + k.legs * k.pitch_board_foot + BOARD_ROOM
    before_goal = abs(sight.y) < 0.5 * k.pitch_goal_width
    x = 0.0 if before_goal else -side_of(sight.x) * max(abs(sight.x) - 0.5 * k.pitch_length + room, 0.0)
    y = -side_of(sight.y) * max(abs(sight.y) - 0.5 * k.pitch_width + room, 0.0)
    away = length(x, y)
    if away > 0.0:
        ahead, left = into_frame(x / away, y / away, sight.cosine, sight.sine)
        push(command, sight, k, ahead, left, k.drive_forward)


@compiled
def drive_differential(command, sight, k, play, ahead, left, distance, facing, speed):
    """Drive along the path on a differential base, backwards to a near point behind the robot."""
    if distance < play.arrived:
        turn_by(command, sight, k, play, wrap(facing - sight.heading))
        return
    back = ahead < 0.0 and distance < REVERSE_ROOM
    bearing = atan2(-left, -ahead) if back else atan2(left, ahead)
    turn_by(command, sight, k, play, bearing)
    if abs(bearing) < SIDESTEP_CONE:
        push(command, sight, k, ahead * abs(ahead), 0.0, speed)


@compiled
def avoid_others(sight, k, dx, dy, distance):
    """Return the unit vector (dx, dy) turned away from robots that stand in the way."""
    aside = 0.0
    ahead_limit, aside_limit = min(AVOID_AHEAD * k.body_reach, distance), AVOID_ASIDE * k.body_reach
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.x, sight.other_y[i] - sight.y
        along, across = dx * x + dy * y, dx * y - dy * x
        if 0.0 < along < ahead_limit and abs(across) < aside_limit:
            aside -= side_of(across) * (1.0 - abs(across) / aside_limit)
    aside = AVOID_WEIGHT * clip(aside, -1.0, 1.0)
    size = sqrt(1.0 + aside * aside)
    return (dx - aside * dy) / size, (dy + aside * dx) / size


@compiled
def goal_room(sight, k, ux, uy):
    """Return the angle [rad] between the path of a ball played along (ux, uy) and the nearer post; below 0: no goal."""
    goal = 0.5 * k.pitch_length - sight.ball_x
    if ux <= 1e-3 or goal <= 0.0:
        return -1.0
    crossing = sight.ball_y + goal * uy / ux
    return (0.5 * k.pitch_goal_width - k.ball_radius - abs(crossing)) * ux * ux / max(goal, k.ball_radius)


@compiled
def shot_room(sight, k, ux, uy):
    """Return the angle [rad] by which a ball played along (ux, uy) clears posts and opponents; below 0: it does not."""
    room = goal_room(sight, k, ux, uy)
    if room == -1.0:
        return room
    return min(room, lane_room(sight, k, ux, uy, (0.5 * k.pitch_length - sight.ball_x) / ux))


@compiled
def lane_room(sight, k, ux, uy, far):
    """Return the angle [rad] by which a ball played along (ux, uy) clears the opponents within a distance [m]."""
    room = WIDE_ENOUGH
    width = max(k.body_disc_radius, k.body_tip_y + k.body_tip_radius) + k.ball_radius
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y
        along = ux * x + uy * y
        if sight.mate[i] == 0 and 0.0 < along < far:
            room = min(room, (abs(ux * y - uy * x) - width) / max(along, width))
    return room


@compiled
def misalignment(sight, ux, uy):
    """Return 1 - cosine of the angle between heading and (ux, uy): 0 facing along it, 1 square to it, 2 opposite."""
    return 1.0 - sight.cosine * ux - sight.sine * uy


@compiled
def choose_shot(sight, k):
    """Return the unit vector from the ball to the best spot between the opponents' posts, and the room there [rad]."""
    goal = 0.5 * k.pitch_length + k.ball_radius - sight.ball_x
    widest = 0.5 * k.pitch_goal_width - k.ball_radius
    side = side_of(sight.ball_y)
    best = -1e9
    best_x, best_y = 1.0, 0.0
    best_room = -1.0
    for i in range(-GOAL_SPOTS, GOAL_SPOTS + 1):
        y = side * widest * i / (GOAL_SPOTS + 1.0) - sight.ball_y
        away = max(length(goal, y), 1e-6)
        ux, uy = goal / away, y / away
        room = shot_room(sight, k, ux, uy)
        worth = room - TURN_COST * misalignment(sight, ux, uy)
        if worth > best:
            best = worth
            best_x, best_y = ux, uy
            best_room = room
    return best_x, best_y, best_room


@compiled
def choose_dribble_direction(sight, k, play):
    """Return the best unit vector along which to dribble, out of a fan around the direction of the goal."""
    x, y = 0.5 * k.pitch_length - sight.ball_x, -sight.ball_y
    away = max(length(x, y), 1e-6)
    side = side_of(sight.ball_y)
    far = min(play.way_on, away)
    ux, uy = rotate_vector(x / away, y / away, -side * FAN * FAN_STEP)
    best = -1e9
    best_x, best_y = ux, uy
    for i in range(-FAN, FAN + 1):
        worth = (
            lane_room(sight, k, ux, uy, far) - FAN_COST * abs(i) * FAN_STEP - TURN_COST * misalignment(sight, ux, uy)
        )
        worth -= OUT_COST * max(1.0 - free_roll_distance(sight, k, ux, uy) / play.way_on, 0.0)
        worth -= play.wing_cost * abs(sight.ball_y + play.way_on * uy) / (0.5 * k.pitch_width)
        if worth > best:
            best = worth
            best_x, best_y = ux, uy
        ux, uy = out_of_frame(ux, uy, FAN_COSINE, side * FAN_SINE)
    return best_x, best_y


@compiled
def clearing_direction(sight, k):
    """Return the unit vector along which the ball is played clear of the own goal, never across its mouth.

    The direction leads away from a point half a goal's width behind the middle of the goal: straight out from the
    middle, at most 45 degrees to the side between the posts. Away from the middle itself it could lead along the goal
    line.
    """
    x, y = sight.ball_x + 0.5 * k.pitch_length + 0.5 * k.pitch_goal_width, sight.ball_y
    away = max(length(x, y), 1e-6)
    return x / away, y / away


@compiled
def faces(sight, ux, uy, cosine):
    """Tell whether the player faces along (ux, uy) now, to an angle of this cosine."""
    return sight.now_cosine * ux + sight.now_sine * uy > cosine


@compiled
def free_roll_distance(sight, k, ux, uy):
    """Return the distance [m] that a ball can roll along (ux, uy) before it leaves the pitch or meets a board."""
    ahead = (0.5 * k.pitch_length - side_of(ux) * sight.ball_x) / max(abs(ux), 1e-6)
    aside = (0.5 * k.pitch_width - side_of(uy) * sight.ball_y) / max(abs(uy), 1e-6)
    return max(min(ahead, aside), 0.0)


@compiled
def rotate_vector(ux, uy, angle):
    """Return a vector turned by an angle [rad]."""
    return out_of_frame(ux, uy, *cosine_and_sine(angle))
