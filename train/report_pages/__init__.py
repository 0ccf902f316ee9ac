"""Report pages: what a command found, as one file for any browser, that asks nothing of any network.

    page = ReportPage("chaser against random", "soccer evaluate")
    page.say("chaser beats random.")
    page.table(("", "value"), [("matches", "20")])
    page.figure(draw_curves(figure, form="svg"), "Goal difference over matches")
    path.write_text(page.html())

page.py       `ReportPage`: parts in order; every text that it is given is escaped
replays.py    kept replays as a part of a page
report.html   markup              report.css   style: the colours are those of the browser replay, light and dark
report.js     light or dark, and tables that are sorted by a tap on their heads
"""

from soccer_env.train.report_pages.page import ReportPage

__all__ = ["ReportPage"]
