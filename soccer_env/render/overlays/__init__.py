"""Overlays of a picture: shapes that a caller places, and percepts, beliefs and plans of robots, each by a flag.

shapes.py    points, paths, arrows, areas and labels in the field frame
flags.py     `OverlayFlags`: the overlays to show, and the robot
cast.py      `Cast`: the league and teams of a match; `Shot`: one moment of it
layers.py    from flags and a moment to overlays, with a reason if a flag has nothing to show
onlooker.py  `Onlooker` follows a match, `Reel` a replay, and makes their overlays
belief.py    a robot's beliefs about itself, ball and players, beside the truth
sight.py     the field of view, and the percepts of the camera in it
forces.py    the potential field of a robot's team
paths.py     planned path, travelled path, trail of the ball
roles.py     role and recovery state of every robot, beams of the rangers
panels.py    words, key help and the camera's picture, on dark plates
"""

from soccer_env.render.overlays.shapes import Area, Arrows, Label, Overlay, Points, Polyline

__all__ = ["Area", "Arrows", "Label", "Overlay", "Points", "Polyline"]
