"""Learners that choose skills: their memory between steps, the commands of their skills, and masks of what applies."""

from typing import Any

import numpy as np

from soccer_env.match.squads import TeamArrays, clip_commands
from soccer_env.skills.choices import SKILLS, mask_skills, write_skill_commands
from soccer_env.skills.settings import MEMORY, fitted, skill_settings

Settings = Any  # soccer_env.match.settings.Settings


class SkillPlayers:
    """The learners of a match with actions="skills": each robot decides by its belief how to do what it is told.

    `memory` (M, R) is what the skills remember; it is saved, hashed and branched with the match.
    """

    def __init__(self, league: Any, arrays: TeamArrays) -> None:
        self._arrays = arrays
        self._settings = fitted(skill_settings(), league)
        self._everyone = np.arange(arrays.beliefs.shape[1])
        self.memory = np.zeros(arrays.beliefs.shape, MEMORY)

    def begin(self, m: int) -> None:
        """Forget everything in match m."""
        self.memory[m] = np.zeros((), MEMORY)

    def write_commands(self, choices: np.ndarray, learns: np.ndarray, first: int, last: int) -> None:
        """Write the commands of the robots that learn (R,), by their choices (M, R, 1), in a slice of matches."""
        beliefs, tracks, noise, commands, k = self._arrays
        write_skill_commands(
            beliefs, tracks, self.memory, noise, commands, choices, learns, k, self._settings, first, last
        )
        clip_commands(commands, self._everyone, first, last)

    def masks(self) -> np.ndarray:
        """Return masks (M, R, n) int8: 1 for each of the n SKILLS that applies, as far as the robot knows."""
        beliefs, tracks, _, _, k = self._arrays
        masks = np.zeros((*self.memory.shape, len(SKILLS)), np.int8)
        mask_skills(beliefs, tracks, self.memory, k, self._settings, masks)
        return masks
