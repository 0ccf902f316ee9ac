"""sacks-2001: the legged team of the University of Pennsylvania, 2001.  [Sacks 2001]  MS01, MS19 to MS27, MS38 to MS54

Each player decides for itself, from its own belief and tracks, in the three parts of the paper's software:

    XLSs       "extended logical sensors", what it knows of self, ball, foes, pals: belief, tracks, skills/sight.py
    planner    what it does: planner.py, with one module for each mechanism
    XLAs       "extended logical actuators", how it walks and looks: actuators.py

Files:

    team.py        the teams, and the kernel that decides for all players
    explaining.py  what a player tells people who watch: behaviour, path, forces
    settings.py    every number and switch             memory.py      what a player remembers
    planner.py     chooses a behaviour and does it     actuators.py   what legs and head can do
    ball_notes.py  sightings and possession of the ball  positions.py   who goes to the ball, where others stand
    stuck.py       how it notices that it is stuck     recovery.py    how it gets free
    forces.py      the potential field                 steering.py    where a dribbler goes
    shooting.py    shots and passes                    goalkeeper.py  the goalkeeper

`sacks-2001-future` is the team with the paper's future work,
`sacks-2001-tuned` the team with numbers that do better here than the paper's.
"""

from soccer_env.baselines.sacks_2001.team import team, team_with_future_work, tuned

__all__ = ["team", "team_with_future_work", "tuned"]
