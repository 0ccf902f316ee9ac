"""Percepts, beliefs, decisions and plans of robots, recorded while a match is played, for replays and pictures.

thoughts.py   `Thoughts` takes notes five times a second; `Notes` are the checked notes of a file
groups.py     further columns of a note: percepts of the camera, and planned paths
thought.py    one note as numbers in metres, for drawing
"""

from soccer_env.thoughts.thoughts import Notes, Thoughts

__all__ = ["Notes", "Thoughts"]
