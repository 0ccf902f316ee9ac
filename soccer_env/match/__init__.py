"""`Match`: many matches simulated side by side as arrays, and the stages of one control step.

match.py         `Match` itself                       batch.py     the records of M matches, and how a slice is stepped
arguments.py     each setting, declared once          settings.py  the settings with every name resolved
step.py          one control step, from commands to observations
episodes.py      how an episode begins and ends       squads.py    which team plays which robot
senses.py        percepts and beliefs of the robots   views.py     read-only methods: beliefs, state, repr
skill_players.py learners that choose skills
variation.py     numbers of the league that differ from episode to episode
truth_state.py   the whole truth as one vector, for centralised critics
user_code.py     calls to a user's own functions, with checks of their results
staging.py       placing robots and ball by hand, for experiments
saving/          save, load, branch, hash
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.match.match import Match

__all__ = ["Match"]
__getattr__, __dir__ = lazy_names(__name__, {"Match": "match"})  # lazy: match.py imports this package
