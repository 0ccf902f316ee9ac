"""What a person sees who plays: one moment by the truth, and by the belief of the person's robot."""

import numpy as np

from soccer_env.render import contact_sheet
from soccer_env.train.command.playing.controls import CARRY, Wish
from soccer_env.train.command.playing.person import Person
from soccer_env.train.command.playing.playing import SELF, Game
from soccer_env.train.command.playing.settings import PersonSettings
from soccer_env.train.evaluate.recording import start_match
from soccer_env.train.pages.pictures.settings import WIDTH

SEED, SECONDS = 9, 12.0  # of the match, [s] of play before the moment


def play_picture(width: int = WIDTH, seconds: float = SECONDS) -> np.ndarray:
    """Play a match for some time, the person's robot carrying the ball; return both frames beside each other."""
    settings = PersonSettings(away="sacks-2001", seed=SEED, width=width)
    match, cast = start_match(settings, actions="full")
    person = Person(match, settings.person)
    game = Game(match, person, (f"{SELF} + {cast.names[0]}", cast.names[1]), settings)
    for _ in range(round(seconds * match.league.control_rate / game.stride)):
        game.advance(Wish(skill=CARRY))
    by_truth = game.frame()
    game.press("b")
    return contact_sheet([by_truth, game.frame()], 2)
