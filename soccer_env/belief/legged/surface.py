"""Distances to a player's middle converted to distances to its surface.  [Sacks 2001, 4.1.2, 4.3]  MS35, MS42

Tracks hold middles, in the robot's own frame: from middle to middle. In the paper a robot's distance to another player
is a reading of the ranger or of a table, from its camera to the nearest part of the other's jersey:

    own middle   camera            surface    the other's middle
        |----------|------ reading ---|-------------|
          k.head_camera_ahead            half a body

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import length


@compiled
def chest_to_middle(k):
    """Return the distance [m] from a player's chest, which the sensors measure, to the player's middle; assumed.

    The value is for the head-on view, the most common. From the side it is 3 cm less, from behind 2 cm more, but vision
    does not show headings.
    """
    return k.body_front


@compiled
def surface_distance(x, y, k):
    """Return the distance [m] from the camera to the surface of a player whose middle is at x, y [m], robot frame.

    The camera is at its place in a level head that looks ahead; a lowered head moves it by up to 2 cm.
    """
    return max(length(x - k.head_camera_ahead, y) - chest_to_middle(k), 0.0)
