"""Reports: plots of results in one style, and HTML pages of plots and tables, each in a single file.

    page = ReportPage("chaser against random", "soccer evaluate")
    page.say("chaser beats random.")
    page.table(("", "value"), [("matches", "20")])
    page.figure(draw_curves(figure, form="svg"), "Goal difference over matches")
    path.write_text(page.html())

style.py        sizes, fonts, colours, markers and hatches; a picture as PNG or SVG
charts.py       curves with intervals, counts as bars, estimates beside a range, tables with coloured cells
pitch_maps.py   heat maps, pass networks and shot maps
page.py         `ReportPage`: parts in order, with every text escaped
report.html     markup              report.css   style, with the light and dark colours of the browser replay
report.js       switches light and dark, and sorts tables by a tap on their heads

Each `draw_...` takes `form="png"`, or "svg" for a page: SVG takes its colours from the page, light or dark, and needs
no network. Matplotlib is imported with the first picture; without it an ImportError names the package to install.
"""

from soccer_env.train.report.charts import draw_bars, draw_curves, draw_heat_table, draw_intervals
from soccer_env.train.report.page import ReportPage
from soccer_env.train.report.style import MISSING, can_draw

__all__ = ["MISSING", "ReportPage", "can_draw", "draw_bars", "draw_curves", "draw_heat_table", "draw_intervals"]
