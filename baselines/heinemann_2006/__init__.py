"""heinemann-2006: the middle-size team of Tübingen, 2006.  [Heinemann 2006]  MH04, MH05, MH14, MH19 to MH23

Each player decides for itself, from its own belief and tracks, which include the radio's reports. The paper's ideas are
here; the play near the ball and at restarts is shared with the chaser.

Files:

    team.py        the teams, and the kernel that decides for all players
    explaining.py  what a player tells people who watch: role, path, forces
    settings.py    every number and switch             memory.py      what a player remembers, and scratch arrays
    playing.py     chooses what to do and does it      roles.py       who attacks, who defends, who supports
    driving.py     along a plan, within limits         intercepting.py  where and when a rolling ball is met
    attacking.py   to the ball, and at the goal        dribbling.py   with the ball in the guide
    goalkeeper.py  passive and active                  passing.py     to whom, how hard, and how supporters stand open

`weigel-2001` is this team with the planner of Weigel et al., which knows no velocities.
"""

from soccer_env.baselines.heinemann_2006.team import team, weigel

__all__ = ["team", "weigel"]
