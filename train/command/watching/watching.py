"""The window of `soccer watch`, which shows a replay file or a live match."""

from math import ceil

import numpy as np

from soccer_env.render import Window, check_display
from soccer_env.render.closeup import Closeup
from soccer_env.render.overlays.cast import Cast, cast_of
from soccer_env.render.overlays.flags import select_flags
from soccer_env.render.overlays.layers import make_overlays
from soccer_env.render.overlays.onlooker import ReplaySnapshots
from soccer_env.render.overlays.panels import HelpPanel
from soccer_env.render.overlays.paths import TRAVELLED
from soccer_env.replay import Replay, Thoughts
from soccer_env.thoughts.thought import NoteReader
from soccer_env.train.command.watching.deck import HELP, KEPT, PlaybackControls, Tape, play_live
from soccer_env.train.command.watching.settings import WatchSettings
from soccer_env.train.evaluate.recording import start_match


def watch(settings: WatchSettings) -> None:
    """Show a replay file or a live match in a window; ValueError without a display."""
    if settings.file is not None:
        replay = Replay.read(settings.file)
        check_display()
        reel = ReplaySnapshots(replay)
        cast, teams, stride = reel.cast, replay.teams, max(1, ceil(len(replay) / KEPT))
        tape = Tape(reel.shots(), stride)
    else:
        check_display()
        match, played = start_match(settings)
        teams, stride = played.names, 1
        thoughts = Thoughts(match)
        cast = cast_of(match, NoteReader.of(thoughts) if thoughts.slots else None)
        tape = Tape(play_live(match, thoughts), stride)
    rate, flags = cast.league.control_rate / stride, select_flags(settings)
    tape.move_by(round(settings.start * rate))
    if tape.ended:
        raise ValueError(f"start must lie before the end of the match, got {settings.start:g}")
    cast.selected_row(flags, tape.shot)
    deck = PlaybackControls(tape, rate, settings.speed, flags, tuple(cast.agents), settings.follow)
    stays = settings.file is not None
    show(deck, cast, Closeup(cast.league, settings.width), Window("soccer_env"), teams, stays)


def show(
    deck: PlaybackControls, cast: Cast, picture: Closeup, window: Window, teams: tuple[str, str], stays: bool
) -> None:
    """Show a tape until the user closes the window; it also closes at the end of the tape, unless it `stays`."""
    try:
        while True:
            window.fps = deck.fps
            window.say(deck.words())
            if not window.show(frame_of(deck, cast, picture, teams)):
                return
            for key in window.pressed():
                deck.press(key)
            if deck.paused:
                continue
            deck.tape.move_by(deck.skip)
            if deck.over() and not stays:
                return
    finally:
        window.close()


def frame_of(deck: PlaybackControls, cast: Cast, picture: Closeup, teams: tuple[str, str]) -> np.ndarray:
    """Draw the current frame of the tape; return it as (H, W, 3) uint8."""
    shot, past = deck.tape.shot, deck.tape.past(ceil(TRAVELLED * deck.rate))
    overlays = make_overlays(deck.flags, cast, shot, past, picture.width)
    if deck.helps:
        overlays.append(HelpPanel(HELP))
    if not deck.follow:
        return picture.draw(shot.match, shot.ball, shot.robots, title=teams, overlays=overlays)
    followed = shot.ball if deck.follow == "ball" else shot.robots[cast.selected_row(deck.flags, shot)]
    around = (float(followed["x"]), float(followed["y"]))
    return picture.draw_near(shot.match, shot.ball, shot.robots, around, title=teams, overlays=overlays)
