"""Play matches and report the results: `soccer evaluate`, `record`, `replay` and `export`.

settings.py        the options of `evaluate`, and the conditions that follow
play_settings.py   the options of `record`, `replay` and `export`
evaluation.py      `evaluate`: play the matches that a folder lacks, return the result of all
contest.py         the matches: pairs from the same seeds with sides swapped, many at once
results.py         one line for each match; the result of all lines        line_checks.py   check the lines
statistics.py      statistics of play: of a line, totals with intervals, tables
report.py          the result in Markdown and on the screen
page.py            the result as a page for the browser, with pictures
recording.py       record a match into a replay file, and check a replay file
exporting.py       a replay as a film, a page, data or a picture
drills.py          `evaluate_drills`: how often teams succeed in drills
rechecking.py      `recheck`: play a sample again and compare every line bit for bit
same_contest.py    read a folder of results, and rebuild its contest
map_pictures.py    heat maps, pass networks and shot maps as a picture, and as tables of a report
belief_pictures.py errors of beliefs against range and age, as a picture
replays/           replays of matches worth keeping
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.evaluate.drills import evaluate_drills
    from soccer_env.train.evaluate.evaluation import evaluate
    from soccer_env.train.evaluate.rechecking import RecheckResult, recheck
    from soccer_env.train.evaluate.results import EvaluationResult
    from soccer_env.train.evaluate.settings import EvaluateSettings

__all__ = ["EvaluateSettings", "EvaluationResult", "RecheckResult", "evaluate", "evaluate_drills", "recheck"]
__getattr__, __dir__ = lazy_names(
    __name__,
    {
        "EvaluateSettings": "settings",
        "EvaluationResult": "results",
        "RecheckResult": "rechecking",
        "evaluate": "evaluation",
        "evaluate_drills": "drills",
        "recheck": "rechecking",
    },
)
