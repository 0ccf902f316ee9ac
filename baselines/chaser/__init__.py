"""The chaser: a complete small scripted team for both leagues and any number of players.

team.py         who does what, and the numbers      attacking.py   the attacker
goalkeeping.py  the goalkeeper                      supporting.py  where supporters stand
boards.py       a ball in a corner                  glancing.py    when it looks up for landmarks
"""

from soccer_env.baselines.chaser.team import team

__all__ = ["team"]
