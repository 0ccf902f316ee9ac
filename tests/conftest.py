"""Windows and sound of every test go nowhere."""

import os

import pettingzoo  # noqa: F401  # first, for it sets the sound driver as it is imported

os.environ["SDL_VIDEODRIVER"] = os.environ["SDL_AUDIODRIVER"] = "dummy"
