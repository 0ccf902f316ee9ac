"""Windows and sound of every test go nowhere; tests import what they share as `tests.scenes.staging`."""

import os
import sys
from pathlib import Path

import pettingzoo  # noqa: F401  # first, for it sets the sound driver as it is imported

os.environ["SDL_VIDEODRIVER"] = os.environ["SDL_AUDIODRIVER"] = "dummy"
sys.path.append(str(Path(__file__).parents[1]))
