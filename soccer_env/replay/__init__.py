"""Replays: matches on disk that play again exactly, step by step, or say where they do not.

replay_file.py   `Recorder` writes a running match down; `Replay` is the file, and plays it again
checks.py        whether a stranger's file is one, and no larger than one ever is
parts.py         its parts: records and settings as plain values
clips.py         parts of a recording that play again bit for bit
"""

from soccer_env.replay.replay_file import Recorder, Replay
from soccer_env.thoughts.thoughts import Thoughts

__all__ = ["Recorder", "Replay", "Thoughts"]
