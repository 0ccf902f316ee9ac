"""Things drawn over a picture: shapes that a caller places, and what robots see, believe and plan, each by a flag.

shapes.py    points, paths, arrows, areas and labels in the field frame
flags.py     `OverlayFlags`: what is to be shown, and of which robot
scene.py     `Cast` and `Shot`: who plays, and what is drawn of one moment
layers.py    from flags and a moment to overlays, and what a flag cannot show
onlooker.py  follows a match or a replay, for whoever draws it
belief.py    ball, players and itself as a robot believes, against the truth
sight.py     the field of view, and what the camera delivered in it
forces.py    the potential field that its team computes
ways.py      planned path, travelled path, trail of the ball
states.py    role and recovery state of every robot, the ranger's beam
panel.py     the camera's picture, and words in a corner
"""

from soccer_env.render.overlays.shapes import Area, Arrows, Label, Overlay, Points, Polyline

__all__ = ["Area", "Arrows", "Label", "Overlay", "Points", "Polyline"]
