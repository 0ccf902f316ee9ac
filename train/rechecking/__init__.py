"""Play a random sample of an evaluation again and compare every line bit for bit: `soccer recheck`.

    result = recheck(RecheckSettings(folder="runs/match", pairs=5))

Results are text that anybody can change. A match follows from its seed, so whoever doubts them can see for themselves.
Nothing is written, and nothing that the folder names as code is run.

settings.py     what the command line asks for
folder.py       what a folder of results says, read without a change to it
contest.py      the same contest again: its teams, league and scene, or why they cannot be had
comparing.py    a line as it stands there, and as it was played again
rechecking.py   `recheck`
"""

from typing import TYPE_CHECKING

from soccer_env.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.rechecking.rechecking import RecheckResult, recheck
    from soccer_env.train.rechecking.settings import RecheckSettings

__all__ = ["RecheckResult", "RecheckSettings", "recheck"]
__getattr__, __dir__ = lazy_names(
    __name__,
    {
        "RecheckResult": "soccer_env.train.rechecking.rechecking",
        "RecheckSettings": "soccer_env.train.rechecking.settings",
        "recheck": "soccer_env.train.rechecking.rechecking",
    },
)
