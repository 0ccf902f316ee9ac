"""The README of the teams of 2006: the paper's claims beside the measurements.

`python -m soccer_env.train.pages.tables.heinemann [run FOLDER ... | write]`: see `paper_page.py`.
"""

import sys
from pathlib import Path

from soccer_env.train.pages.tables.paper_page import PaperPage
from soccer_env.train.papers.claim import HEINEMANN
from soccer_env.train.papers.results import FOLDERS

PAGE = PaperPage(
    folder=FOLDERS[HEINEMANN],
    paper=HEINEMANN,
    pictures={"H10": 1, "H20": 1},
    run=Path("runs/claims-heinemann"),
    tables={},
)


if __name__ == "__main__":
    sys.exit(PAGE.main(sys.argv[1:]))
