"""The README of the team sacks-2001: what the paper says beside what was measured, and which numbers are the paper's.

`python -m soccer_env.train.pages.tables.sacks [run FOLDER ... | write]`: see `paper_page.py`.
"""

import sys
from pathlib import Path

from soccer_env.train.pages.tables.claims import RUN, measure_all
from soccer_env.train.pages.tables.paper_page import PaperPage
from soccer_env.train.pages.tables.sacks_settings import constants_text
from soccer_env.train.papers.claim import SACKS
from soccer_env.train.papers.stored import FOLDERS


def measure() -> Path:
    """Measure every claim of both papers; return the folder of the run."""
    measure_all()
    return RUN


PAGE = PaperPage(
    folder=FOLDERS[SACKS],
    paper=SACKS,
    pictures={"S06": 1, "S29": 1, "S35": 1, "S47": 1, "S63": 1},
    measure=measure,
    tables={"constants": constants_text},
)


if __name__ == "__main__":
    sys.exit(PAGE.main(sys.argv[1:]))
