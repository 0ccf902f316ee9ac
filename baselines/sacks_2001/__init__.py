"""sacks-2001: the legged team of the University of Pennsylvania, 2001.  [Sacks 2001]  MS01, MS19 to MS27, MS38 to MS54

Each player decides for itself, from its own belief and tracks, in the three parts of the paper's software:

    XLSs       what it knows: self, ball, foes, pals          belief, tracks; sight (baselines/sight.py)
    planner    what it does                                   planner.py, with one module for each mechanism
    XLAs       how it walks and looks                         xla.py

`settings.py` has every number and switch. `sacks-2001-future` is the team with the paper's future work,
`sacks-2001-tuned` the team with numbers that do better here than the paper's.
"""

from soccer_env.baselines.sacks_2001.team import future, team, tuned

__all__ = ["future", "team", "tuned"]
