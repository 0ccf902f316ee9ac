"""Play matches and say what came of them: `soccer evaluate`, `record`, `replay` and `watch`.

settings.py        what the command line asks for, and the conditions that follow
play_settings.py   what `record`, `replay` and `export` are asked for
evaluation.py      `evaluate`: the matches that a folder lacks are played, the result of all is returned
contest.py         the matches: pairs from the same seeds with sides swapped, many at once
results.py         one line for each match; the result that follows from the lines     line_checks.py   are they sound?
statistics.py      statistics of play: of a line, totals with intervals, tables
map_tables.py      where things happened, as tables of a report
report.py          the result in Markdown and on the screen
page.py            the same as a page for the browser, with pictures
recording.py       a match into a replay file, and out of it again
exporting.py       a replay as a film, a page, data or a picture
drills.py          `run_drill`: how often a team succeeds in a drill
rechecking.py      `recheck`: a sample played again, every line compared bit for bit
same_contest.py    what a folder of results says, and the contest that it tells of, made again
map_pictures.py    heat maps, pass networks and shot maps as a picture
replays/           replays of matches worth keeping
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.evaluate.evaluation import evaluate
    from soccer_env.train.evaluate.rechecking import RecheckResult, recheck
    from soccer_env.train.evaluate.results import EvaluationResult
    from soccer_env.train.evaluate.settings import EvaluateSettings

__all__ = ["EvaluateSettings", "EvaluationResult", "RecheckResult", "evaluate", "recheck"]
__getattr__, __dir__ = lazy_names(
    __name__,
    {
        "EvaluateSettings": "soccer_env.train.evaluate.settings",
        "EvaluationResult": "soccer_env.train.evaluate.results",
        "RecheckResult": "soccer_env.train.evaluate.rechecking",
        "evaluate": "soccer_env.train.evaluate.evaluation",
        "recheck": "soccer_env.train.evaluate.rechecking",
    },
)
