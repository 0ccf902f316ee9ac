"""Pictures of results, all in one style: labelled with units, and told apart without colour.

    from soccer_env.train.plots import draw_curves
    png = draw_curves({"title": ..., "x_label": ..., "y_label": ..., "curves": [...], "rules": [0.0]})

style.py        sizes, fonts, colours, markers and hatches; a picture as PNG or SVG
charts.py       curves with intervals, counts as bars, estimates beside a range, tables with coloured cells
pitch_maps.py   heat maps, pass networks and shot maps

Each `draw_...` takes `form="png"`, or "svg" for a page: SVG takes its colours from the page, light or dark. Matplotlib
is imported with the first picture; without it that is an ImportError that says what to install.
"""

from soccer_env.train.plots.charts import draw_bars, draw_curves, draw_heat_table, draw_intervals
from soccer_env.train.plots.style import MISSING, can_draw

__all__ = ["MISSING", "can_draw", "draw_bars", "draw_curves", "draw_heat_table", "draw_intervals"]
