"""The own pose in a robot's belief: from a given pose, from particles, or from odometry.  MH08

* it has just been placed, and was told where: that pose, with all particles put round it;
* it senses a noisy pose (`pose="percept"`): that pose, which costs next to nothing;
* it has particles: odometry in every frame, landmarks or lines every few frames;
* it has none: odometry alone. The error grows and the confidence falls.

All robots share this; `legged/landmarks.py` weighs particles by landmarks, `omni/field_lines.py` by white lines.

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import exp, sqrt

import numpy as np

from soccer_env.belief.odometry import read_odometry
from soccer_env.belief.particles import (
    cluster_near,
    estimate_pose,
    move_particles,
    place_particles,
    resample,
    scatter_particles,
    share_to_redraw,
    weights_from_costs,
)
from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, into_frame, out_of_frame, wrap
from soccer_env.guards.ranges import COUNT, FLAG, NUMBER, SHARE, ranged_record
from soccer_env.records.percepts import POSE_SENSED, POSE_TOLD

SURE = 100.0  # confidence of a pose that is given
HELD = 0.3  # [1] share of the particles that do not move with the odometry while others are near, assumed
RECENT = 1.0  # [s] unseen after which a player that was near may have gone, assumed
PATIENCE = 4  # [1] times `pose_every` without a landmark or line after which the particles move all the same, assumed

POSE_MEMORY = ranged_record(
    [
        ("ahead", "f8", NUMBER),  # [m] odometry since the particles were moved, in the axes of then
        ("left", "f8", NUMBER),  # [m]
        ("turn", "f8", NUMBER),  # [rad]
        ("path", "f8", NUMBER),  # [m] length of the way
        ("turned", "f8", NUMBER),  # [rad] sum of the turns to either side
        ("crowded", "f8", NUMBER),  # [s] with a player so near that the two may touch
        ("fast", "f8", SHARE),  # [0, 1] short-term average of the fit of the particles to what is seen
        ("slow", "f8", SHARE),  # [0, 1] long-term average
        ("frames", "i4", COUNT),  # since the particles were moved
        ("begun", "i1", FLAG),  # 1: the particles have been put somewhere
    ]
)


@compiled
def is_crowded(tracks, k):
    """Return 1 if another player is believed to be near enough to touch the robot, else 0.

    No sensor feels that the robot is pushed or held (MS06), but the robot sees the player that may do so.
    """
    for i in range(tracks.shape[0]):
        track = tracks[i]
        if track.present == 1 and track.age <= RECENT and track.distance < 2.0 * k.body_reach:
            return 1
    return 0


@compiled
def particles_are_due(body, own, crowded, memory, particles, noise, k, s, w):
    """Update the own pose by odometry or a given pose; return whether the particles must be updated now.

    crowded: 1 while another player may be pushing or holding the robot, which cannot feel that.
    """
    forward, left, turn = read_odometry(body)
    own.forward, own.left, own.turn = forward / k.dt, left / k.dt, turn / k.dt
    if body.pose == POSE_SENSED or body.pose == POSE_TOLD:
        own.x = body.x
        own.y = body.y
        own.heading = body.heading
        own.confidence = SURE
        if body.pose == POSE_TOLD and particles.shape[0] > 0:
            hand = np.float64(body.handedness)
            place_particles(particles, own, s.place_noise, s.place_turn_noise, noise, hand)
            reset_motion(memory)
            memory.begun = 1
            memory.fast = 1.0
            memory.slow = w.pose_fit
        return False
    cosine, sine = cosine_and_sine(own.heading)
    x, y = out_of_frame(forward, left, cosine, sine)
    own.x += x
    own.y += y
    own.heading = wrap(own.heading + turn)
    if particles.shape[0] == 0:
        own.confidence = max(own.confidence - w.pose_fading * k.dt, 0.0)
        return False
    if memory.begun == 0:
        half_length, half_width = field_half_size(k)
        scatter_particles(particles, half_length, half_width, noise, np.float64(body.handedness))
        memory.begun = 1
    add_motion(memory, forward, left, turn, crowded * k.dt)
    return memory.frames >= w.pose_every


@compiled
def add_motion(memory, forward, left, turn, crowded):
    """Add a frame's odometry [m, m, rad], and the time with another player nearby [s], to the accumulated motion."""
    cosine, sine = cosine_and_sine(memory.turn)
    ahead, aside = out_of_frame(forward, left, cosine, sine)
    memory.ahead += ahead
    memory.left += aside
    memory.turn += turn
    memory.path += sqrt(forward * forward + left * left)
    memory.turned += abs(turn)
    memory.crowded += crowded
    memory.frames += 1


@compiled
def reset_motion(memory):
    """Reset the accumulated motion to zero."""
    memory.ahead = memory.left = memory.turn = memory.path = memory.turned = memory.crowded = 0.0
    memory.frames = 0


@compiled
def take_summed_motion(memory, k, w):
    """Return the motion since the last particle update, as `move_block` takes it, and reset it to zero.

    The motion's deviations grow with the distance (feet and wheels slip), with time, and most of all while another
    player is near: legs and wheels do not feel that the body is pushed, turned or held.
    """
    cosine, sine = cosine_and_sine(memory.turn)
    ahead, left = into_frame(memory.ahead, memory.left, cosine, sine)
    turn, passed = memory.turn, sqrt(memory.frames * k.dt)
    spread = w.pose_slip * memory.path + w.pose_drift * passed + w.pose_push * memory.crowded
    turn_spread = w.pose_slip * memory.turned + w.pose_turn_drift * passed + w.pose_push_turn * memory.crowded
    stuck = w.pose_stuck if memory.crowded == 0.0 else HELD
    reset_motion(memory)
    return ahead, left, turn, spread, turn_spread, stuck


@compiled
def field_half_size(k):
    """Return half the length and half the width [m] of the area open to robots: the pitch and the band around it."""
    return 0.5 * k.pitch_length + k.pitch_band_end, 0.5 * k.pitch_width + k.pitch_band_side


@compiled
def move_without_measurements(own, memory, particles, noise, hand, k, w):
    """Move the particles by odometry alone, after PATIENCE updates without any measurement.

    The confidence is then the share of particles that are still near the pose.
    """
    if memory.frames < PATIENCE * w.pose_every:
        return
    half_length, half_width = field_half_size(k)
    move_particles(particles, take_summed_motion(memory, k, w), half_length, half_width, noise, hand)
    weight, _, _, _, spread = cluster_near(particles, own.x, own.y, own.heading, w)
    own.confidence = SURE * weight / particles.shape[0] / (1.0 + spread / (w.pose_radius * w.pose_radius))


@compiled
def estimate_and_resample(own, memory, particles, seen, noise, w):
    """Estimate the own pose from particles weighed by `seen` measurements, and resample; return whether any are free.

    Free particles have weight 0 and need new poses. The confidence is the share of weight in the heaviest cluster,
    lower for a wide cluster and for a bad fit.
    """
    count = particles.shape[0]
    total, cost, best = weights_from_costs(particles)
    fresh = int(count * share_to_redraw(memory, exp(-cost / seen), w) + 0.5)
    weight, spread = estimate_pose(particles, own, total, best, w)
    fit = min(memory.fast / max(memory.slow, w.pose_fit), 1.0)
    own.confidence = SURE * fit * weight / total / (1.0 + spread / (w.pose_radius * w.pose_radius))
    resample(particles, total, count - fresh, noise)
    return fresh > 0
