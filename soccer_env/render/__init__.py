"""Pictures of a match, drawn from its records alone; pygame is imported when the first one is made.

frame.py        `Picture`: one frame, from the records of a match
pitch.py        its background                     robots.py       robots and ball
header.py       the bar above the pitch            captions.py     what it says
overlays/       what robots see, believe and plan, on top
view.py         where things lie in a picture      canvas.py       smooth drawing
colours.py      the colours                        sheet.py        frames on disk and side by side
closeup.py      a picture that goes near and follows
window.py       a window, in real time             video.py       frames as MP4 or GIF
"""

from __future__ import annotations

from soccer_env.render.frame import Picture
from soccer_env.render.overlays import Area, Arrows, Label, Overlay, Points, Polyline
from soccer_env.render.sheet import contact_sheet, png_of_frame, save_png
from soccer_env.render.window import Window, check_display

__all__ = [
    "Area",
    "Arrows",
    "Label",
    "Overlay",
    "Picture",
    "Points",
    "Polyline",
    "Window",
    "check_display",
    "contact_sheet",
    "png_of_frame",
    "save_png",
]
