"""The chaser: a complete small scripted team for both leagues and any number of players.

team.py    who does what, by the skills of soccer_env/skills/
"""

from soccer_env.baselines.chaser.team import team

__all__ = ["team"]
