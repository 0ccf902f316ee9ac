"""Measure what the two papers claim: `soccer reproduce`.

settings.py       what the command line asks for
reproduction.py   `reproduce`: the claims that a folder lacks, one after another or in processes (workers.py)
examination.py    one claim: batch by batch of each seed, until the interval decides or the cap is reached
workers.py        processes that measure claims
claim.py          what a claim is, and what its measurement hands over
verdicts.py       what a criterion asks for, and what an interval says about it
results.py        what was found of a claim, and what a run leaves in its folder
stored.py         what was measured last, as the pages of the teams show it
page.py           as a page for the browser
report.py         that in Markdown and on the screen
staging.py        stage many matches at once, robots and ball put somewhere
true_sight.py     where legged robots truly look, all robots of many matches at once
dribble_runs.py   robots that dribble, and what became of the ball       drill_runs.py   runs of the dribbling drills
values.py         quantities of samples in which NaN means "no value"
claims/           the claims by theme, with the guide to adding one
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.papers.reproduction import reproduce
    from soccer_env.train.papers.settings import ReproduceSettings

__all__ = ["ReproduceSettings", "reproduce"]
__getattr__, __dir__ = lazy_names(
    __name__,
    {"ReproduceSettings": "soccer_env.train.papers.settings", "reproduce": "soccer_env.train.papers.reproduction"},
)
