"""The README of the teams of 2006: the paper's claims beside the measurements.

`python -m soccer_env.train.pages.tables.heinemann [run FOLDER ... | write]`: see `paper_page.py`.

Each measurement also redraws the paper's figure: planned and travelled paths of both planners.
"""

import sys
from pathlib import Path
from typing import Any

from soccer_env.guards.whole_files import write_atomically
from soccer_env.train.pages.tables.paper_page import SHOWN, PaperPage
from soccer_env.train.papers.claim import HEINEMANN
from soccer_env.train.papers.results import FOLDERS
from soccer_env.train.report.style import canvas, picture_maker

PATHS = "heinemann-paths.png"


PAGE = PaperPage(
    folder=FOLDERS[HEINEMANN],
    paper=HEINEMANN,
    pictures={"H10": 1, "H20": 1},
    run=Path("runs/claims-heinemann"),
    tables={},
)


@picture_maker
def draw_paths() -> Any:
    """Return the paper's figure as a PNG: both planners in crossing a after 1, 30 and 60 cycles.  MH18"""
    from soccer_env.baselines.weigel_2001.planner.drawing import draw_travel
    from soccer_env.train.papers.claims.planning.crossings import CYCLES
    from soccer_env.train.papers.claims.planning.runs import CANONICAL, PLANNERS, travel

    drawn, rows = canvas(5.2, 10.0, 2, len(CYCLES), sharex=True, sharey=True)
    for row, (name, changes) in zip(rows, PLANNERS.items(), strict=True):
        one = travel(CANONICAL["a"], **changes)
        for axes, cycle in zip(row, CYCLES, strict=True):
            draw_travel(axes, one, cycle)
            axes.set_title(f"{'conventional' if name == 'old' else 'time-variant'}, t = {cycle}", fontsize="small")
            axes.set(xlim=(-4.0, 4.0), ylim=(-2.5, 2.5))
    return drawn


def main(words: list[str]) -> int:
    """Run the command and redraw the figure after a measurement; return the exit code."""
    code = PAGE.main(words)
    if code == 0 and words != ["write"]:
        write_atomically(SHOWN / PATHS, draw_paths())
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
