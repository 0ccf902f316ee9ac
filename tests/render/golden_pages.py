"""What pages, films and windows show of staged replays: as text, and as pictures."""

import base64
import hashlib
import json
import zlib
from collections.abc import Mapping
from itertools import islice
from typing import Any

import numpy as np

from soccer_env.render import Picture, contact_sheet
from soccer_env.render.overlays.cast import Cast, camera_of, cast_of, cast_of_replay, count_line_directions
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.render.overlays.onlooker import Onlooker
from soccer_env.shows.browser.collect import collect_page_data
from soccer_env.shows.browser.page import script_json
from soccer_env.shows.film import film_frames
from soccer_env.shows.film_settings import FilmSettings
from tests.render.staged_replays import StagedReplay
from tests.scenes.staging import LEGGED, MIDDLE


def page(replay: StagedReplay, flags: OverlayFlags | None = None) -> str:
    """Return what a page holds, its tables as hashes of what was deflated: zlib's versions differ."""
    found = collect_page_data(replay, flags=flags)
    del found["version"]
    for name, table in found["tables"].items():
        found["tables"][name] = hashlib.md5(zlib.decompress(base64.b64decode(table))).hexdigest()
    return script_json(found)


def legged_page() -> str:
    return page(StagedReplay(LEGGED), OverlayFlags(field=True, belief=True, robot="red 1"))


def middle_page() -> str:
    return page(StagedReplay(MIDDLE))


def page_of_the_truth() -> str:
    """Robots with ideal senses, and a page without thoughts."""
    return page(StagedReplay(MIDDLE, senses="ideal"), OverlayFlags()) + page(StagedReplay(LEGGED, thinks=False))


def notes() -> str:
    """What is noted of robots, number by number."""
    found = []
    for league, senses in ((LEGGED, "sensors"), (MIDDLE, "sensors"), (LEGGED, "ideal")):
        noted = StagedReplay(league, senses=senses).notes()
        assert noted is not None
        found += [noted.steps.tolist(), noted.slots, noted.fields, noted.groups, noted.numbers.tolist()]
        found.append(noted.between(7, 31)["thoughts"].tolist())
    return json.dumps(found)


def casts() -> str:
    """Who plays, live and in a replay, and cameras of all sorts of settings."""
    found: list[Any] = []
    for league in (LEGGED, MIDDLE):
        replay = StagedReplay(league)
        match = next(replay.play())
        found += [told(cast_of(match, None)), told(cast_of_replay(replay, match, None))]
        replay.settings = {**replay.settings, "teams": {"home_1": "os:getcwd", "away_0": "chaser"}}
        found.append(told(cast_of_replay(replay, match, None)))
    known = {"view_width": 1.1, "neck_ahead": 0.07, "resolution": "88x72"}
    for name, value in (("", 0), *((name, None) for name in known), ("view_width", 3.2), ("view_width", 0.0),
                        ("neck_ahead", -1.5), ("neck_ahead", 1), ("resolution", "8x72"), ("lines", 24)):  # fmt: skip
        given: Mapping[str, Any] = {**known, name: value}
        camera = camera_of(given)
        found.append([name, None if camera is None else [*camera, camera.focal], count_line_directions(given)])
    lines = [count_line_directions({"lines": lines}) for lines in (0, 1, 32, 33, "24")]
    return json.dumps([*found, camera_of("88x72"), camera_of(None), count_line_directions(None), lines], indent=1)


def told(cast: Cast) -> list[Any]:
    """Return a cast in plain values."""
    parts = {
        row: [
            part.name,
            None if part.settings is None else hashlib.md5(part.settings.tobytes()).hexdigest(),
            None if part.explanation is None else [part.explanation.forces is None, part.explanation.plan is None],
        ]
        for row, part in cast.parts.items()
    }
    return [list(cast.agents), cast.camera, cast.ranger, parts, cast.why_no_notes, cast.line_directions]


def film() -> np.ndarray:
    """Frames of films: parts of them, fast and slow, with what robots think between two notes of it."""
    frames = []
    part = FilmSettings(width=320, start=0.7, seconds=1.3, fps=4.0, belief=True, trail=True, robot="ball")
    for league, kind, settings in (
        (LEGGED, ".mp4", part),
        (LEGGED, ".gif", FilmSettings(width=320, speed=3.0, roles=True, infrared=True)),
        (MIDDLE, ".png", FilmSettings(width=320, start=0.37, sight=True, path=True, field=True, robot="home_1")),
    ):
        count, drawn, fps = film_frames(StagedReplay(league), settings, kind)
        found = list(islice(drawn, 0, count, 3))
        frames.append(contact_sheet([*found, np.full_like(found[0], count), np.full_like(found[0], round(fps))]))
    return np.concatenate([frame[:, : frames[0].shape[1]] for frame in frames])


def live() -> np.ndarray:
    """Pictures of a match that goes on, as an onlooker sees it."""
    frames = []
    asked = ((LEGGED, "belief,sight,trail,path"), (MIDDLE, "roles"), (LEGGED, {"field": True}), (LEGGED, None))
    for league, flags in asked:
        playing = StagedReplay(league).play()
        match = next(playing)
        onlooker, picture = Onlooker(match, flags), Picture(league, 320)
        for step, match in enumerate(playing):
            overlays = onlooker.see(match, 320)
            if step in (0, 11):
                frame = picture.draw(match.matches[0], match.balls[0], match.robots[0], overlays=overlays)
                frames.append(frame[:240])  # the lower edge of a legged pitch
    return contact_sheet(frames, columns=4)


TEXTS = (legged_page, middle_page, page_of_the_truth, notes, casts)
SCENES = (film, live)
