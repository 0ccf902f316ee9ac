"""Particles: possible poses of a robot, moved with the robot and resampled by how well they fit its measurements.  MH08

Monte-Carlo localisation [Fox, Burgard, Dellaert, Thrun 1999; Heinemann et al. 2006, 1, reference 2]:

    move_block -> weigh (landmarks.py, field_lines.py) -> estimate -> resample -> fresh particles from what is seen

Two rules locate a robot again that was carried away: the share of fresh particles grows when the particles fit worse
than before [Gutmann, Fox 2002, augmented MCL], and fresh ones are drawn from what is seen [Lenser, Veloso 2000, sensor
resetting]. Everything is in the team frame. A lateral draw is multiplied by `hand`, the handedness of the noise.

Particles are moved and weighed in blocks, with a loop over the block for each step of the sum, so that the processor
takes several particles at once.

`w`: settings of the memory.
"""

from math import pi, sqrt

import numpy as np

from soccer_env.compiled import compiled, scratch_records
from soccer_env.geometry import atan2, clip, cosine_and_sine, length, point_of_frame, wrap, wrap_once
from soccer_env.guards.ranges import AMOUNT, NUMBER, ranged_record
from soccer_env.random_numbers import GOLDEN, draw_uniform, mix_bits
from soccer_env.types import RobotStream

PARTICLES = int(RobotStream.PARTICLES)
TRIANGLE = sqrt(6.0)  # half base of the symmetric triangular distribution whose deviation is 1
OUTLIER = 9.0  # [sd2] squared error at which a cost reaches half of what it can, assumed: three deviations
REPLACED = 1.5  # [1] how much heavier another cluster must be before the own pose jumps there, assumed
SETTLED = 0.3  # [1] share of all weight that it must have: a cloud is no place to jump to, assumed
ROWS = 32  # of a block
BYTE = np.uint64(255)
BYTES_UNIT = sqrt(6.0 / 65535.0)  # one over the deviation of the sum of two bytes
SHARE_MOST = 0.5  # [1] largest share of fresh particles, assumed: the old belief keeps a chance

PARTICLE = ranged_record(
    [
        ("x", "f4", NUMBER),  # [m] team frame
        ("y", "f4", NUMBER),  # [m]
        ("heading", "f4", NUMBER),  # [rad]
        ("weight", "f4", AMOUNT),  # [1]; while an update runs also the cost, then how often the particle is kept
    ]
)

BLOCK = np.dtype(
    [  # scratch: some particles while they are moved and weighed
        ("x", "f8", (ROWS,)),  # [m] team frame
        ("y", "f8", (ROWS,)),
        ("heading", "f8", (ROWS,)),  # [rad]
        ("cosine", "f8", (ROWS,)),
        ("sine", "f8", (ROWS,)),
        ("ahead", "f8", (ROWS,)),  # [m] of the motion
        ("left", "f8", (ROWS,)),
        ("cost", "f8", (ROWS,)),  # [1] of the measurements for this pose
        ("cell", "i4", (ROWS,)),  # of a table of the field
    ]
)


@compiled
def draw_triangular(noise):
    """Draw a number from the triangular distribution of mean 0 and deviation 1: fast, and without outliers."""
    return TRIANGLE * (draw_uniform(noise, PARTICLES) + draw_uniform(noise, PARTICLES) - 1.0)


@compiled
def bounded_cost(square, most):
    """Return the cost of a squared error [sd2]: half the square for small errors, at most half of `most` for outliers.

    Half of e2 / (1 + e2 / most), the shape of the error of [Lauer, Lange, Riedmiller 2006].
    """
    return 0.5 * square * most / (square + most)


@compiled
def place_particles(particles, own, spread, turn_spread, noise, hand):
    """Draw all particles around the own pose, with deviations `spread` [m] and `turn_spread` [rad]."""
    for i in range(particles.shape[0]):
        particle = particles[i]
        particle.x = own.x + spread * draw_triangular(noise)
        particle.y = own.y + hand * spread * draw_triangular(noise)
        particle.heading = wrap(own.heading + hand * turn_spread * draw_triangular(noise))
        particle.weight = 1.0


@compiled
def scatter_particles(particles, half_length, half_width, noise, hand):
    """Draw all particles uniformly over the field, for a robot that knows nothing of its pose."""
    for i in range(particles.shape[0]):
        scatter_particle(particles[i], half_length, half_width, noise, hand)


@compiled
def scatter_particle(particle, half_length, half_width, noise, hand):
    """Draw a particle's pose uniformly over the field and all headings."""
    particle.x = half_length * (2.0 * draw_uniform(noise, PARTICLES) - 1.0)
    particle.y = hand * half_width * (2.0 * draw_uniform(noise, PARTICLES) - 1.0)
    particle.heading = hand * pi * (2.0 * draw_uniform(noise, PARTICLES) - 1.0)
    particle.weight = 1.0


@compiled
def move_block(block, particles, first, motion, half_length, half_width, noise, hand):
    """Load the particles from row `first` on into a BLOCK, moved by the robot's motion with noise, and set costs to 0.

    motion: forward and left [m] in the axes at the end of the motion, turn [rad], the deviations of place [m] and
    heading [rad], and the share of particles that stay behind, since a robot that is held walks on the spot. One draw
    a particle: two bytes for the share, two for each triangular error.
    """
    ahead, left, turn, spread, turn_spread, stuck = motion
    count = min(particles.shape[0] - first, ROWS)
    for j in range(count):
        one = particles[first + j]
        block.x[j], block.y[j], block.heading[j] = one.x, one.y, one.heading
    state, held = noise[PARTICLES], int(stuck * 65536.0)
    noise[PARTICLES] = state + GOLDEN * np.uint64(count)
    spread, aside, turned = BYTES_UNIT * spread, hand * BYTES_UNIT * spread, hand * BYTES_UNIT * turn_spread
    for j in range(ROWS):
        bits = mix_bits(state + GOLDEN * np.uint64(j + 1))
        goes = 0.0 if np.int32(bits >> np.uint64(48)) < held else 1.0
        block.ahead[j] = goes * ahead + spread * sum_of_bytes(bits)
        block.left[j] = goes * left + aside * sum_of_bytes(bits >> np.uint64(16))
        block.heading[j] = wrap_once(block.heading[j] + goes * turn + turned * sum_of_bytes(bits >> np.uint64(32)))
    for j in range(ROWS):
        block.cosine[j], block.sine[j] = cosine_and_sine(block.heading[j])
    for j in range(ROWS):
        x, y = point_of_frame(block.x[j], block.y[j], block.ahead[j], block.left[j], block.cosine[j], block.sine[j])
        block.x[j] = min(max(x, -half_length), half_length)
        block.y[j] = min(max(y, -half_width), half_width)
        block.cost[j] = 0.0
    return count


@compiled
def sum_of_bytes(bits):
    """Return the sum of the two lowest bytes less its mean, from -255 to 255."""
    return np.float64(np.int32(bits & BYTE) + np.int32((bits >> np.uint64(8)) & BYTE)) - 255.0


@compiled
def store_block(block, particles, first, count):
    """Store the poses of a BLOCK in its particles, and its costs in their weights."""
    for j in range(count):
        one = particles[first + j]
        one.x, one.y, one.heading, one.weight = block.x[j], block.y[j], block.heading[j], block.cost[j]


@compiled
def move_particles(particles, motion, half_length, half_width, noise, hand):
    """Move all particles by the robot's motion with noise, and set their weights to 1."""
    block = scratch_records(1, BLOCK)[0]
    for first in range(0, particles.shape[0], ROWS):
        count = move_block(block, particles, first, motion, half_length, half_width, noise, hand)
        block.cost[:] = 1.0
        store_block(block, particles, first, count)


@compiled
def weights_from_costs(particles):
    """Replace the particles' costs by weights, 1 for the best; return sum of weights, mean cost, index of the best."""
    best = 0
    summed = 0.0
    for i in range(particles.shape[0]):
        summed += np.float64(particles[i].weight)
        if particles[i].weight < particles[best].weight:
            best = i
    least = np.float64(particles[best].weight)
    for i in range(particles.shape[0]):
        particles[i].weight = decay(np.float64(particles[i].weight) - least)
    total = 0.0
    for i in range(particles.shape[0]):
        total += np.float64(particles[i].weight)
    return total, summed / particles.shape[0], best


@compiled
def decay(cost):
    """Return about exp(-cost), within 1 % up to a cost of 8: the 16th power of a series for a 16th of the cost."""
    y = 0.0625 * cost
    grown = 1.0 + y * (1.0 + y * (0.5 + y * (1.0 / 6.0 + y * (1.0 / 24.0))))
    grown *= grown
    grown *= grown
    grown *= grown
    return 1.0 / (grown * grown)


@compiled
def share_to_redraw(memory, fit, w):
    """Return the share of particles to draw anew, given how well (0 to 1) the particles fit the measurements.

    The share rises as the short-term average of the fit falls below the long-term average, or below the expected fit of
    a robot that knows its pose.  [Gutmann, Fox 2002; Lenser, Veloso 2000]
    """
    memory.fast += w.pose_fast * (fit - memory.fast)
    memory.slow += w.pose_slow * (fit - memory.slow)
    expected = max(memory.slow, w.pose_fit)
    lost = 1.0 - memory.fast / max(expected, 1e-9)
    return min(max(lost, w.pose_fresh), SHARE_MOST)


@compiled
def cluster_near(particles, x, y, heading, w):
    """Return weight, mean x, y, heading and squared spread [m2] of the particles near a pose.

    Near is within `pose_radius` [m] and `pose_angle` [rad]; with none near, return the pose, weight 0 and spread 0.
    """
    weight = along = across = turned = squares = 0.0
    most = w.pose_radius * w.pose_radius
    for i in range(particles.shape[0]):
        particle = particles[i]
        dx, dy = np.float64(particle.x) - x, np.float64(particle.y) - y
        square = dx * dx + dy * dy
        if square < most:
            turn = wrap(np.float64(particle.heading) - heading)
            if -w.pose_angle < turn < w.pose_angle:
                one = np.float64(particle.weight)
                weight += one
                along += one * dx
                across += one * dy
                turned += one * turn
                squares += one * square
    share = 1.0 / max(weight, 1e-30)
    along = share * along
    across = share * across
    turned = share * turned
    spread = max(share * squares - along * along - across * across, 0.0)
    return weight, x + along, y + across, wrap(heading + turned), spread


@compiled
def estimate_pose(particles, own, total, best, w):
    """Set the own pose to the mean of the heaviest cluster; return the cluster's weight and squared spread [m2].

    The cluster round the believed pose is left only for a clearly heavier one: the mean of two clusters would lie in
    neither.
    """
    weight, x, y, heading, spread = cluster_near(particles, own.x, own.y, own.heading, w)
    other = particles[best]
    there = cluster_near(particles, np.float64(other.x), np.float64(other.y), np.float64(other.heading), w)
    if there[0] > REPLACED * weight and there[0] > SETTLED * total:
        weight, x, y, heading, spread = there
    weight, own.x, own.y, own.heading, spread = cluster_near(particles, x, y, heading, w)
    return weight, spread


@compiled
def resample(particles, total, kept, noise):
    """Resample `kept` particles in proportion to their weights (systematic resampling); the others get weight 0.

    In place: a kept particle stays in its row and its copies fill the rows of dropped ones. The weights sum to `total`;
    kept particles get the weight 1.
    """
    step = total / max(kept, 1)
    pointer = step * draw_uniform(noise, PARTICLES)
    reached = 0.0
    used = 0
    for i in range(particles.shape[0]):
        reached += np.float64(particles[i].weight)
        copies = 0
        while used < kept and pointer < reached:
            copies += 1
            used += 1
            pointer += step
        particles[i].weight = copies
    free = 0
    for i in range(particles.shape[0]):
        for _ in range(int(particles[i].weight) - 1):
            while particles[free].weight > 0.0:
                free += 1
            particles[free] = particles[i]
            particles[free].weight = 1.0
        particles[i].weight = min(particles[i].weight, np.float32(1.0))


@compiled
def draw_from_sighting(particle, sight, half_length, half_width, noise, hand):
    """Draw a particle's pose from which a known object would be seen at its measured bearing, and range if known.

    sight: x, y of the thing [m], its direction as a unit vector of the robot frame, its range [m] (0 unknown), the
    relative error of the range, and x, y of the camera in the robot frame [m].
    """
    x, y, ahead, left, far, error, camera_x, camera_y = sight
    at_x = half_length * (2.0 * draw_uniform(noise, PARTICLES) - 1.0)
    at_y = hand * half_width * (2.0 * draw_uniform(noise, PARTICLES) - 1.0)
    away_x, away_y = at_x - x, at_y - y
    away = max(length(away_x, away_y), 1e-6)
    if far > 0.0:  # on the circle round the thing, in a direction that leads into the field
        scale = far * max(1.0 + error * draw_triangular(noise), 0.1) / away
        at_x, at_y = x + scale * away_x, y + scale * away_y
    heading = wrap(atan2(-away_y, -away_x) - atan2(left, ahead))
    cosine, sine = cosine_and_sine(heading)
    x, y = point_of_frame(at_x, at_y, -camera_x, -camera_y, cosine, sine)
    particle.x, particle.y = clip(x, -half_length, half_length), clip(y, -half_width, half_width)
    particle.heading = heading
    particle.weight = 1.0
