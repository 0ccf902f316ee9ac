"""Replays: matches on disk that play again exactly, step by step, or say where they do not.

replay_file.py   `Recorder` writes a running match down; `Replay` is the file, and plays it again
"""

from soccer_env.replay.replay_file import Recorder, Replay

__all__ = ["Recorder", "Replay"]
