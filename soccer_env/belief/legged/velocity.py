"""The ball's velocity, from two of its positions a third of a second apart.  [Sacks 2001, 3.2]  MS17, MS18

Two velocities come out of each pair of readings:

    radial, angular    as the moving, turning robot sees it: these tell the robot that it is stuck
    vx, vy             over the ground: the first reading is moved along by odometry before the difference is taken.
                       That is the relative velocity plus own velocity plus turn rate x place, and exact however the
                       robot walked in between

`w`: settings of the memory.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import from_polar, into_frame, wrap
from soccer_env.leagues.legged_sensors import POSITIONS

RAW = POSITIONS["raw"]
ROUNDING = 1e-9  # [s] times of whole frames that differ by less are the same


@compiled
def update_velocity(ball, memory, frame, dt, w):
    """Every `velocity_interval`, sample the ball's position and compute the velocity since the last sample.  MS17

    memory is a BALL_MEMORY in which `sample_x`, `sample_y` have been moved along by odometry. Radial and angular
    velocity are kept between readings; vx and vy too, in axes that turn with the robot.
    """
    since = (frame - memory.sampled) * dt
    if memory.has_sample == 0 or since > w.velocity_gap + ROUNDING:
        ball.vx = ball.vy = ball.radial = ball.angular = 0.0  # a reading that old says nothing of the ball's motion now
    interval = max(w.velocity_interval, dt)
    period = int((frame * dt + ROUNDING) / interval)
    if period == memory.period:
        return
    memory.period = period
    if memory.known == 1 and (frame - memory.seen) * dt <= interval + ROUNDING:
        take_reading(ball, memory, frame, since, w)


@compiled
def take_reading(ball, memory, frame, since, w):
    """Compute the velocity from the ball's position now and in the sample `since` [s] ago; store a sample.  MS17, MS18

    After a gap of more than `velocity_gap` the reading is only stored. Each reading is the believed place at its time;
    for a ball missed in just this frame, odometry has updated that place.
    """
    distance = ball.distance if w.radial_from == RAW else ball.filtered_distance
    bearing = ball.bearing if w.angular_from == RAW else ball.filtered_bearing
    x, y = from_polar(distance, bearing)
    recent = since <= w.velocity_gap + ROUNDING or w.velocity_gate == 0
    if memory.has_sample == 1 and since > 0.0 and recent:
        ball.radial = (distance - memory.sample_distance) / since
        ball.angular = wrap(bearing - memory.sample_bearing) / since
        ball.vx, ball.vy = (x - memory.sample_x) / since, (y - memory.sample_y) / since
    memory.sample_distance, memory.sample_bearing = distance, bearing
    memory.sample_x, memory.sample_y = x, y
    memory.sampled, memory.has_sample = frame, 1


@compiled
def turn_velocity(ball, memory, forward, left, cosine, sine):
    """Convert velocity and last sample to the present robot frame, after the robot's motion since the last frame."""
    ball.vx, ball.vy = into_frame(ball.vx, ball.vy, cosine, sine)
    memory.sample_x, memory.sample_y = into_frame(memory.sample_x - forward, memory.sample_y - left, cosine, sine)
