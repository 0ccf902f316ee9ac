"""Pictures of a match, drawn from its records alone; pygame is imported when the first one is made."""

from __future__ import annotations

from soccer_env.render.frame import Picture
from soccer_env.render.overlays import Area, Arrows, Label, Overlay, Points, Polyline
from soccer_env.render.sheet import contact_sheet, save_png
from soccer_env.render.window import Window

__all__ = [
    "Area",
    "Arrows",
    "Label",
    "Overlay",
    "Picture",
    "Points",
    "Polyline",
    "Window",
    "contact_sheet",
    "save_png",
]
