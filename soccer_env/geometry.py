"""Angles, vectors and frames.

A frame is given by the cosine and sine of its heading, which are computed once for all points of the frame.
"""

from math import copysign, floor, pi, sqrt

from soccer_env.compiled import compiled
from soccer_env.types import HOME

TURN = 2.0 * pi
QUARTERS = 2.0 / pi  # of a turn, in a radian
QUARTER_HIGH = 1.5707963267341256  # the first 33 bits of pi / 2, so that products with whole numbers are exact
QUARTER_LOW = 6.077100506506192e-11  # pi / 2 - QUARTER_HIGH
MOST = 0.7853982  # [rad] an eighth of a turn, rounded up
# Coefficients of the best polynomials for sine, cosine and arc tangent near 0 [fdlibm, Sun Microsystems 1993]
S1, S2, S3 = -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04
S4, S5, S6 = 2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10
T0, T1, T2 = 3.33333333333329318027e-01, -1.99999999998764832476e-01, 1.42857142725034663711e-01
T3, T4, T5 = -1.11111104054623557880e-01, 9.09088713343650656196e-02, -7.69187620504482999495e-02
T6, T7, T8 = 6.66107313738753120669e-02, -5.83357013379057348645e-02, 4.97687799461593236017e-02
T9, T10 = -3.65315727442169155270e-02, 1.62858201153657823623e-02
EIGHTH = 0.41421356237309503  # tangent of half an eighth of a turn
C1, C2, C3 = 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05
C4, C5, C6 = -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11


@compiled
def wrap(angle):
    """Return the equivalent of an angle [rad] in (-pi, pi]."""
    if -pi < angle <= pi:
        return angle
    return pi - (pi - angle - TURN * floor((pi - angle) / TURN))


@compiled
def wrap_once(angle):
    """Return an angle [rad] in [-pi, pi] that differs by one turn or none, for an angle in [-3 pi, 3 pi]."""
    turned = angle - TURN if angle > pi else angle
    return turned + TURN if angle < -pi else turned


@compiled
def cosine_and_sine(angle):
    """Return cosine and sine of an angle within 1e6 rad, to 3e-16, by the polynomials about the next quarter turn.

    Both together cost what one of `math` costs, and in a loop the processor takes several angles at once. The bits are
    the same on all machines, as those of `math` need not be.
    """
    quarters = floor(angle * QUARTERS + 0.5)
    x = clip(angle - quarters * QUARTER_HIGH - quarters * QUARTER_LOW, -MOST, MOST)  # beyond 1e6 rad: any finite number
    z = x * x
    sine = x + x * z * (S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)))))
    cosine = 1.0 - 0.5 * z + z * z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))))
    half = floor(0.5 * quarters)  # half turns
    odd = quarters - 2.0 * half  # 0 or 1
    sign = 1.0 - 2.0 * (half - 2.0 * floor(0.5 * half))
    across, along = (cosine, -sine) if odd > 0.0 else (sine, cosine)
    return sign * along, sign * across


@compiled
def from_polar(distance, bearing):
    """Return the vector x, y of a length and a direction [rad]."""
    cosine, sine = cosine_and_sine(bearing)
    return distance * cosine, distance * sine


@compiled
def atan2(y, x):
    """Return the angle [rad] of the vector (x, y), as `math.atan2` does, to 1e-15; 0 for the vector (0, 0)."""
    least, most = min(abs(x), abs(y)), max(abs(x), abs(y))
    if most == 0.0:
        return 0.0
    steep = least > EIGHTH * most  # beyond half of an eighth of a turn: measured from an eighth
    t = (least - most) / (least + most) if steep else least / most
    z = t * t
    z2 = z * z
    even = z * (T0 + z2 * (T2 + z2 * (T4 + z2 * (T6 + z2 * (T8 + z2 * T10)))))
    odd = z2 * (T1 + z2 * (T3 + z2 * (T5 + z2 * (T7 + z2 * T9))))
    angle = (0.25 * pi if steep else 0.0) + (t - t * (even + odd))
    if abs(y) > abs(x):
        angle = 0.5 * pi - angle
    return copysign(pi - angle if x < 0.0 else angle, y)


@compiled
def clip(value, low, high):
    """Return the value limited to between low and high."""
    return low if value < low else (high if value > high else value)


@compiled
def length(x, y):
    """Return the length of a vector (`math.hypot` differs between compiled and plain Python)."""
    return sqrt(x * x + y * y)


@compiled
def step_toward(value, goal, step):
    """Return the value moved towards the goal by at most `step`."""
    if goal > value:
        return goal if goal - value <= step else value + step
    return goal if value - goal <= step else value - step


@compiled
def into_frame(x, y, cosine, sine):
    """Convert a vector x, y to its components ahead and left in a frame whose heading has this cosine and sine."""
    return cosine * x + sine * y, cosine * y - sine * x


@compiled
def out_of_frame(ahead, left, cosine, sine):
    """Convert components ahead and left in a frame whose heading has this cosine and sine to a vector x, y."""
    return cosine * ahead - sine * left, sine * ahead + cosine * left


@compiled
def point_of_frame(x, y, ahead, left, cosine, sine):
    """Return x and y of the point ahead and left of the frame at x, y whose heading has this cosine and sine.

    The sums begin with x and y, so that the results differ in the last bit from `out_of_frame` added to x, y.
    """
    return x + cosine * ahead - sine * left, y + sine * ahead + cosine * left


@compiled
def attack_direction(match, team):
    """Return +1 if the team attacks +x in this half, -1 if -x: the factor from field frame to team frame."""
    return match.home_direction if team == HOME else -match.home_direction
