"""Skills that scripted players share, from a belief to a command.

sight.py          a belief, converted to the team frame once a decision
moves.py          ways to move, to aim and to play the ball
approaching.py    to the ball, straight or round it
attacking.py      the whole attacker: get the ball, turn it to the goal, shoot, free a stuck ball
boards.py         a ball out of a corner
carrying.py       the ball carried between the paws or the arms of the guide
kicking.py        kicks aside, past what stands ahead, clearances and passes
deciding.py       when a player decides, and how its strength limits it
supporting.py     the places of supporters
goalkeeping.py    the whole goalkeeper: meet a shot, clear, guard
glancing.py       a look up from the ball for landmarks
searching.py      the search for a lost ball
settings.py       the numbers that skills read, and what they remember
set_pieces.py     restarts: pass, and leave the ball to others
choices.py        skills with a target that learners, searches and people choose, and which apply
keeping_rules.py  where a player may not go, and how it avoids pushing
"""

from soccer_env.skills.moves import go, push, stand, turn_by
from soccer_env.skills.settings import fitted, skill_settings
from soccer_env.skills.sight import SIGHT, fill_sight

__all__ = ["SIGHT", "fitted", "go", "fill_sight", "push", "skill_settings", "stand", "turn_by"]
