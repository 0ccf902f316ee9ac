"""Use of team-mates' radio reports in a middle-size robot's belief.  [Heinemann et al. 2006, 2]  MH05

A report is in the team frame; the own believed pose converts it to the robot frame, so that the result has the errors
of both poses. The own camera is trusted more.

`k`: the league's constants; `w`: settings of the memory.
"""

from math import inf

from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, cosine_and_sine, into_frame, length, out_of_frame, wrap
from soccer_env.records.beliefs import UNKNOWN

SURE = 100.0  # confidence of what is seen
TOLD = 0.95  # [1] confidence in a report against a sighting, assumed: as good as a look 0.2 s earlier
ASTRAY = 0.1  # [rad] by which own heading and bearing may err together, assumed
NEAREST = 1e-3  # [m] below which rates of distance and bearing are those at this distance


@compiled
def write_report(report, belief):
    """Write own pose, ball and number of a robot into its report, in the team frame.  MH05"""
    own, ball = belief.own, belief.ball
    cosine, sine = cosine_and_sine(own.heading)
    report.number, report.keeper = belief.situation.number, belief.situation.keeper
    report.x = own.x
    report.y = own.y
    report.heading = own.heading
    report.confidence = own.confidence
    report.vx, report.vy = out_of_frame(own.forward, own.left, cosine, sine)
    x, y = out_of_frame(ball.x, ball.y, cosine, sine)
    report.ball_x, report.ball_y = own.x + x, own.y + y
    report.ball_vx, report.ball_vy = out_of_frame(ball.vx, ball.vy, cosine, sine)
    report.ball_age = ball.age
    report.ball_confidence = ball.confidence * own.confidence / SURE


# Team-mates


@compiled
def place_teammates(own, tracks, messages, r, frame, scratch, k, w, home, rows):
    """Merge the team-mates whose reports have just arrived into the tracks (slots,) of robot r.  MH05

    The nearest pair of report and track within w.gate comes first. A track that the own camera has seen lately keeps
    its place and gets the number; a report without a track takes a free slot, or the slot of a farther team-mate.
    scratch (rows or slots, 4): x, y of each speaker in the robot frame [m], 1 while its report is open; and 1 for each
    slot that is taken.
    """
    scratch[:, 2:] = 0.0
    axes = cosine_and_sine(own.heading)
    locate_teammates(own, axes, messages, r, frame, scratch, k, w, home, rows)
    while True:
        other, slot = nearest_report_and_track(tracks, scratch, k, w, rows)
        if other < 0:
            break
        copy_report_to_track(own, axes, tracks, slot, messages[other], scratch[other], scratch[slot], frame, k, w)
    for other in rows:
        if scratch[other, 2] == 1.0:
            slot = slot_for_report(tracks, messages[other], scratch, other, frame, k, w)
            if slot >= 0:
                tracks[slot].present, tracks[slot].confidence = 1, 0.0
                copy_report_to_track(
                    own, axes, tracks, slot, messages[other], scratch[other], scratch[slot], frame, k, w
                )


@compiled
def locate_teammates(own, axes, messages, r, frame, scratch, k, w, home, rows):
    """Compute the positions of the team-mates whose reports have just arrived, unless their pose is uncertain.

    A report is old when it arrives: the team-mate's motion since then is predicted.
    """
    for other in rows:
        message = messages[other]
        report = message.reports[message.latest]
        if (
            other == r
            or (other < home) != (r < home)
            or message.fresh == 0
            or report_confidence(report, frame, k, w) <= 0.0
        ):
            continue
        late = (frame - report.frame) * k.dt if w.delay_compensation == 1 else 0.0
        x, y = report.x + late * report.vx - own.x, report.y + late * report.vy - own.y
        scratch[other, 0], scratch[other, 1] = into_frame(x, y, axes[0], axes[1])
        scratch[other, 2] = 1.0


@compiled
def nearest_report_and_track(tracks, scratch, k, w, rows):
    """Return the indices of the nearest pair of an unused report and track within the gate; -1, -1 for none.

    The gate is w.gate, wider for a distant team-mate, whose place depends on the error of the own heading.
    """
    best = -1
    best_slot = -1
    least = inf
    for other in rows:
        if scratch[other, 2] == 0.0:
            continue
        gate = w.gate + ASTRAY * length(scratch[other, 0], scratch[other, 1])
        for slot in range(k.teammate_slots):
            if tracks[slot].present == 1 and scratch[slot, 3] == 0.0:
                x, y = scratch[other, 0] - tracks[slot].x, scratch[other, 1] - tracks[slot].y
                if x * x + y * y < min(least, gate * gate):
                    best = other
                    best_slot = slot
                    least = x * x + y * y
    return best, best_slot


@compiled
def slot_for_report(tracks, message, scratch, other, frame, k, w):
    """Return the slot for a reported team-mate that matches no track, or -1 if no slot is free for it.

    In this order: the team-mate's former slot; a free slot; the slot of the farthest team-mate, if that team-mate is
    farther away. A slot whose player the own camera has seen lately is never given to a merely reported player.
    """
    report = message.reports[message.latest]
    confidence = report_confidence(report, frame, k, w)
    empty = -1
    last = -1
    farthest = length(scratch[other, 0], scratch[other, 1])
    for slot in range(k.teammate_slots):
        track = tracks[slot]
        if track.present == 0:
            empty = slot if empty < 0 else empty
        elif track.confidence > confidence:
            continue
        elif track.number == report.number:
            return slot
        elif length(track.x, track.y) > farthest:
            last, farthest = slot, length(track.x, track.y)
    return empty if empty >= 0 else last


@compiled
def copy_report_to_track(own, axes, tracks, slot, message, place, taken, frame, k, w):
    """Copy a report into a track: number and heading; position and velocity unless recently seen by the camera."""
    report, track = message.reports[message.latest], tracks[slot]
    place[2], taken[3] = 0.0, 1.0
    for i in range(k.teammate_slots):
        if tracks[i].number == report.number:
            tracks[i].number, tracks[i].keeper = UNKNOWN, 0
    track.number = report.number
    track.keeper = report.keeper
    track.teammate = 1
    track.heading = wrap(report.heading - own.heading)
    confidence = report_confidence(report, frame, k, w)
    if confidence >= track.confidence:
        track.x, track.y = place[0], place[1]
        track.vx, track.vy = into_frame(report.vx, report.vy, axes[0], axes[1])
        track.distance, track.bearing = length(track.x, track.y), atan2(track.y, track.x)
        track.confidence, track.age = confidence, (frame - report.frame) * k.dt


@compiled
def report_confidence(report, frame, k, w):
    """Return the confidence in a team-mate's reported position, which fades with the report's age."""
    if report.confidence <= 0.0:
        return 0.0
    return TOLD * max(SURE - w.fading * (frame - report.frame) * k.dt, 0.0)


# The ball


@compiled
def adopt_reported_ball(belief, messages, r, frame, k, w, home, rows):
    """Adopt the ball of the most confident team-mate that has seen it more recently than the robot.  MH05

    Of equally confident team-mates the nearest to the ball counts, then the lowest number.
    """
    best = -1
    most = 0.0
    nearest = 0.0
    for other in rows:
        message = messages[other]
        if other == r or (other < home) != (r < home) or message.known == 0:
            continue
        report = message.reports[message.latest]
        elapsed = (frame - report.frame) * k.dt
        confidence = report.ball_confidence - w.fading * elapsed
        if confidence <= 0.0 or report.ball_age + elapsed >= belief.ball.age:
            continue
        if confidence > most or (confidence == most and report.distance < nearest):
            best = other
            most = confidence
            nearest = report.distance
    if best >= 0:
        message = messages[best]
        report = message.reports[message.latest]
        elapsed = (frame - report.frame) * k.dt
        fill_reported_ball(belief, report, elapsed, elapsed if w.delay_compensation == 1 else 0.0, TOLD * most, k)


@compiled
def fill_reported_ball(belief, report, elapsed, late, confidence, k):
    """Write the ball that a team-mate reported `elapsed` ago into the belief, extrapolated by `late` [s] of rolling."""
    own, ball = belief.own, belief.ball
    cosine, sine = cosine_and_sine(own.heading)
    speed = length(report.ball_vx, report.ball_vy)
    lost = min(k.ball_rolling * late, speed)  # [m/s]
    share = 1.0 - lost / speed if speed > 0.0 else 1.0
    rolls = min(late, speed / k.ball_rolling) if k.ball_rolling > 0.0 else late  # [s] until it lies still
    travel = 0.5 * (1.0 + share) * rolls
    x, y = report.ball_x + travel * report.ball_vx - own.x, report.ball_y + travel * report.ball_vy - own.y
    x, y = into_frame(x, y, cosine, sine)
    ball.x, ball.y = x, y
    ball.vx, ball.vy = into_frame(share * report.ball_vx, share * report.ball_vy, cosine, sine)
    ball.distance, ball.bearing = length(x, y), atan2(y, x)
    ball.filtered_distance, ball.filtered_bearing = ball.distance, ball.bearing
    vx = ball.vx - own.forward
    vy = ball.vy - own.left
    away = max(ball.distance, NEAREST)
    ball.radial = (x * vx + y * vy) / away
    ball.angular = (x * vy - y * vx) / (away * away) - own.turn
    ball.confidence, ball.age = confidence, report.ball_age + elapsed
