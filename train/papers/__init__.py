"""Measure the claims of the two papers: `soccer reproduce`.

settings.py       the options of the command
reproduction.py   `reproduce`: the claims that a folder lacks, one after another or in processes (workers.py)
examination.py    measure one claim batch by batch for each seed, until its interval decides or the cap is reached
workers.py        processes that measure claims
claim.py          a claim, and the samples and figures of its measurement
verdicts.py       criteria, and their verdicts from intervals
replays.py        whether stored results still hold: hashes of question, world and first batch
results.py        the result of a claim, the folder of a run, and the last results of all claims
report.py         the report in Markdown, on the screen and as a page for the browser
plots.py          figures of claims from few words
staging.py        stage many matches at once, with robots and ball at given places
true_sight.py     the true direction of legged robots' cameras, for all robots of many matches at once
dribble_runs.py   robots that dribble, and the fate of the ball; runs of the dribbling drills
values.py         statistics of samples in which NaN means "no value"
claims/           the claims by theme, with the guide to adding one
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.papers.reproduction import reproduce
    from soccer_env.train.papers.settings import ReproduceSettings

__all__ = ["ReproduceSettings", "reproduce"]
__getattr__, __dir__ = lazy_names(__name__, {"ReproduceSettings": "settings", "reproduce": "reproduction"})
