"""How a player turns with the ball and pushes it: as fast as paws or wheels can keep it, and as opponents allow.

`k`: the league's constants; `play`: the team's settings.
"""

from math import sqrt

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, clip, length, step_toward, wrap
from soccer_env.skills.moves import free_roll_distance, goal_room
from soccer_env.skills.sight import is_opponent_near

PRESSED = 0.6  # [m] from the ball of an opponent that is at it too, assumed
AGAINST = 0.5  # cosine of the angle off the ball's way within which an opponent stands against it, 60 degrees, assumed
SLOW = 0.4  # [m/s] at which the ball is pushed at least, also towards a line, assumed


@compiled
def turn_to_goal(command, sight, memory, k, play, ux, uy):
    """Turn with the ball while walking, which keeps the ball in front; an omnidirectional base turns about the ball."""
    error = wrap(atan2(uy, ux) - sight.heading)
    if play.circle_share > 0.0:
        turn_about_ball(command, sight, memory, k, play, error)
    else:
        command.turn = clip(error / (play.settle * k.drive_turn), -play.turn_share, play.turn_share) * sight.pace
    command.forward = (play.push_share if abs(error) < play.aligned else play.carry_share) * sight.pace
    if k.walled == 0:
        most = pushing_speed(sight, k, sight.now_cosine, sight.now_sine)
        command.forward = min(command.forward, most / k.drive_forward)


@compiled
def turn_about_ball(command, sight, memory, k, play, error):
    """Turn by `error` [rad] on a circle about the ball, as fast as the motors can follow.

    A circle of radius r needs the acceleration w^2 r across, and a change of the turn rate needs r dw/dt along the
    circle: each gets an equal share of the wheels' acceleration. A robot that turns faster, or before its wheels have
    moved it sideways, loses the ball.
    """
    rate = sqrt(play.circle_share * k.drive_acceleration / sight.touch) * sight.pace
    last = clip(memory.turn * k.drive_turn, -rate, rate)
    wanted = clip(error / play.settle * sight.pace, -rate, rate)
    turn = step_toward(last, wanted, rate * rate * sight.elapsed)
    command.turn = turn / k.drive_turn
    command.left = -turn * sight.touch / k.drive_sideways


@compiled
def is_pressed(sight):
    """Tell whether an opponent is at the ball as well as the player."""
    return is_opponent_near(sight, sight.ball_x, sight.ball_y, PRESSED)


@compiled
def is_opposed(sight, ux, uy):
    """Tell whether an opponent stands at the ball, against a push along the unit vector (ux, uy).

    A ball pressed between two robots at speed shoots out sideways. An opponent beside or behind it does not press.
    """
    for i in range(sight.others):
        x, y = sight.other_x[i] - sight.ball_x, sight.other_y[i] - sight.ball_y
        away = length(x, y)
        if sight.mate[i] == 0 and away < PRESSED and x * ux + y * uy > AGAINST * away:
            return True
    return False


@compiled
def pushing_speed(sight, k, ux, uy):
    """Return the speed [m/s] at which to push a ball at the feet along (ux, uy): full speed towards the goal."""
    if is_opposed(sight, ux, uy):
        return SLOW
    return line_speed(sight, k, ux, uy) if goal_room(sight, k, ux, uy) < 0.0 else k.drive_forward


@compiled
def line_speed(sight, k, ux, uy):
    """Return the speed [m/s] at which to push the ball along (ux, uy): half the speed that rolls it off the pitch."""
    return max(0.5 * sqrt(2.0 * k.ball_rolling * free_roll_distance(sight, k, ux, uy)), SLOW)
