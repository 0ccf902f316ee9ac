"""Replays: matches on disk that play again exactly, step by step, or say where they do not.

replay_file.py   `Recorder` writes a running match down; `Replay` is the file, and plays it again
parts.py         its parts: records and settings as plain values
clips.py         parts of a recording that play again bit for bit
thoughts.py      what robots saw, believed and decided, noted beside the commands
browser/         a replay as one page for the browser
film.py          a replay as MP4 or GIF
"""

from soccer_env.replay.replay_file import Recorder, Replay
from soccer_env.replay.thoughts import Thoughts

__all__ = ["Recorder", "Replay", "Thoughts"]
