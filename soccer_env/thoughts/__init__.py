"""What robots saw, believed, decided and planned, noted while a match is played, for replays and pictures.

thoughts.py   `Thoughts` notes them five times a second; `Notes` are those of a file, checked
groups.py     what cameras delivered and where robots plan to go, noted with it
thought.py    one note as numbers in metres, for drawing
recorded.py   what pictures ask of a replay
"""

from soccer_env.thoughts.thoughts import Notes, Thoughts

__all__ = ["Notes", "Thoughts"]
