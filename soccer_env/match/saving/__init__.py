"""Save, restore, hash and branch matches: checked bytes without executable content, or copies in memory.

saves.py      a match as bytes and back, checked; hashes, copies by pickle
states.py     states of running matches, collected for scene="states:FILE"
fitting.py    the settings in which two matches differ, for error messages
branches.py   matches of one Match copied over matches of another, in memory
branching.py  the methods of Match for saves and branches
whole.py      guards of these methods: one thread at a time, done whole or not at all
"""

from soccer_env.match.saving.branching import Branching
from soccer_env.match.saving.saves import dump, parts, play_hash, reduce_by_save, restore, state_hash
from soccer_env.match.saving.states import collect_states
from soccer_env.match.saving.whole import calls_python, guard_match_methods, make_undo, signals_wait
from soccer_env.records.save_file import open_save

__all__ = [
    "Branching", "reduce_by_save", "calls_python", "collect_states", "dump", "open_save", "parts", "play_hash",
    "restore", "signals_wait", "state_hash", "make_undo", "guard_match_methods",
]  # fmt: skip
