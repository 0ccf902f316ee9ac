"""Pictures of a match, drawn from its records alone; pygame is imported when the first one is made.

frame.py        `Picture`: one frame, from the records of a match
pitch.py        the background                     robots.py       robots and ball
header.py       the bar above the pitch            captions.py     the words in the bar
overlays/       percepts, beliefs and plans of robots, on top
view.py         places of the field in a picture   canvas.py       smooth drawing
colours.py      the colours                        sheet.py        frames as PNG, and several in one picture
closeup.py      a picture that zooms in and follows
window.py       a window, in real time             video.py       frames as MP4 or GIF
"""

from __future__ import annotations

from soccer_env.render.frame import Picture
from soccer_env.render.overlays import Area, Arrows, Label, Overlay, Points, Polyline
from soccer_env.render.sheet import contact_sheet, png_of_frame, save_png
from soccer_env.render.window import Window, check_display

__all__ = [
    "Area", "Arrows", "Label", "Overlay", "Picture", "Points", "Polyline", "Window", "check_display",
    "contact_sheet", "png_of_frame", "save_png",
]  # fmt: skip
