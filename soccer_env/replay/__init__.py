"""Replays: matches on disk that play again exactly, step by step, or say where they do not.

replay_file.py   `Recorder` records a running match; `Replay` is the file, and plays it again
checks.py        checks of untrusted replay files: format and size
parts.py         parts of a replay file: records and settings as plain values
clips.py         parts of a recording that play again bit for bit
"""

from soccer_env.replay.replay_file import Recorder, Replay
from soccer_env.thoughts.thoughts import Thoughts

__all__ = ["Recorder", "Replay", "Thoughts"]
