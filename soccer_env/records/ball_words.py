"""Words of four bits for a robot's distance to the ball, in fifteen ranges.  MS06

Word 1 is below NEAREST, each further word covers a range GROWTH times as long, the last word everything beyond:

    word       1      2      3      4      5      6      7     8     9    10    11    12    13    14    15
    up to   0.12   0.15   0.20   0.25   0.32   0.41   0.53  0.68  0.86  1.11  1.42  1.81  2.32  2.97   inf  [m]

So the words distinguish robots near the ball, which may compete for it, but not far robots. Word 0 says that the robot
does not see the ball.
"""

from math import inf, sqrt

from soccer_env.compiled import compiled

SILENT = 0  # the word of a robot that does not see the ball
FARTHEST = 15  # four bits: sound alone, Sacks 2001, 1; 4 bits a second, assumed
NEAREST = 0.12  # [m] a ball at the chest, assumed
GROWTH = 1.28  # [1] so that the words reach from the chest across a field of 3 x 2 m, assumed


@compiled
def word_for_distance(distance: float) -> int:
    """Return the word 1 ... 15 for a distance to the ball [m]; 0 for an infinite distance: no ball is seen."""
    if distance == inf:
        return SILENT
    word, edge = 1, NEAREST
    while word < FARTHEST and distance >= edge:
        word, edge = word + 1, edge * GROWTH
    return word


@compiled
def distance_of_word(word: int) -> float:
    """Return the distance [m] that a word means: the geometric mean of its range; inf for word 0."""
    if word <= SILENT:
        return inf
    distance = NEAREST / sqrt(GROWTH)
    for _ in range(word - 1):
        distance *= GROWTH
    return distance
