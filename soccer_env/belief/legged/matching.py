"""Match the players in view to the players in memory.  [Sacks 2001, 4.1.1, after Veloso et al. 1999]  MS30, MS31, MS32

For a player A in the view and a player B of the same team in memory:

    likelihood(A, B) = uncertainty of B / distance(A, B)^3 / angle(A, B)

Greedy: each player in view, the largest blob first, replaces the likeliest slot that no other player in view has taken.
An unlikely player gets a slot, too: a ghost may push a real player out of the memory.

Unlike the paper's slots, which are never empty, one here may be: it counts as the most uncertain player,
`empty_distance` and `empty_angle` away from A. So A goes to an empty slot unless it is near a player in memory: within
about 0.3 m of a player seen in the last frame (0.9 m in nearly the same direction), or within about 0.65 m, as far as
it can have walked, of a player seen 5 s ago.

`w`: settings of the memory.
"""

from math import exp, log, pi

from soccer_env.compiled import compiled
from soccer_env.geometry import TURN, atan2, length
from soccer_env.leagues.legged_sensors import DEGREE

LEAST_DISTANCE = 0.001  # [m] nearer players are this near, so that nothing is infinitely likely; assumed
LEAST_ANGLE = 0.1 * DEGREE  # [rad] the same for angles, assumed
EXPONENT_MOST = 300.0  # [1] e to the power of twice this is still a number


@compiled
def track_uncertainty(track, w):
    """Return the uncertainty of a player in memory: 0.5 if it has just been seen, growing to 100.  MS32"""
    if track.present == 0:
        return w.uncertainty_most
    return min(w.uncertainty_least + w.uncertainty_growth * track.age, w.uncertainty_most)


@compiled
def inverse_power(value, power):
    """Return value^-power for a value above zero and any power, with equal bits in compiled and plain Python."""
    return exp(min(-power * log(value), EXPONENT_MOST))


@compiled
def angle_between(one, other):
    """Return the angle [rad], 0 to pi, between two bearings in [-pi, pi]; equal to the last bit in a mirrored match."""
    angle = abs(one - other)
    return TURN - angle if angle > pi else angle


@compiled
def match_likelihood(track, x, y, bearing, w):
    """Return the likelihood that the player seen at x, y [m], robot frame, is the player of a track.  MS30

    With `distance_power` 1, tried first, one player filled all slots; `angle_power` 0 leaves the angle out.  MS31
    """
    if track.present == 1:
        distance, angle = length(track.x - x, track.y - y), angle_between(track.bearing, bearing)
    else:
        distance, angle = w.empty_distance, w.empty_angle
    near = inverse_power(max(distance, LEAST_DISTANCE), w.distance_power)
    return track_uncertainty(track, w) * near * inverse_power(max(angle, LEAST_ANGLE), w.angle_power)


@compiled
def likeliest_slot(tracks, first, last, x, y, w):
    """Return the slot, first to last - 1, to which a player seen at x, y [m] most likely belongs, -1 if none.  MS30

    Slots of age 0 have been taken by another player of the same view.
    """
    bearing = atan2(y, x)
    likeliest, best = -1, -1.0
    for slot in range(first, last):
        if tracks[slot].present == 1 and tracks[slot].age == 0.0:
            continue
        value = match_likelihood(tracks[slot], x, y, bearing, w)
        if value > best:
            likeliest, best = slot, value
    return likeliest
