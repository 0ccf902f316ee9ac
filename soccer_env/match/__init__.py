"""`Match`: many matches at once, as arrays, and how one control step of them is played.

match.py         `Match` itself                       batch.py     the records of M matches, and how a slice is stepped
arguments.py     its settings, each declared once     settings.py  the same, every name resolved
step.py          one control step, from commands to observations
episodes.py      how an episode begins                squads.py    who plays which robot
senses.py        what robots perceive and believe     views.py     beliefs, states and words, to be read
truth_state.py   the whole truth as one vector, for centralised critics
user_code.py     checks of what a user's own functions return
staging.py       robots and ball put somewhere, for experiments
saving/          save, load, branch, hash
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.match.match import Match

__all__ = ["Match"]
__getattr__, __dir__ = lazy_names(__name__, {"Match": "soccer_env.match.match"})  # its parts are imported by its parts
