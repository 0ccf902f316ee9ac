"""Staged scenes of what robots see, believe, plan and do: together they run every line of the overlays."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from soccer_env.render import Picture, contact_sheet
from soccer_env.render.overlays.cast import Cast, Snapshot
from soccer_env.render.overlays.flags import FLAGS, OverlayFlags, parse_flags
from soccer_env.render.overlays.layers import make_overlays
from soccer_env.thoughts.groups import PLAN
from soccer_env.thoughts.thought import NoteReader
from tests.render.golden_frames import staged
from tests.render.staged_notes import GOES, LEGGED_LEAGUE, MIDDLE, MUTE, PULLS, cast_for, note_of

EVERYTHING = OverlayFlags(**dict.fromkeys(FLAGS, True), robot="home_1")
WAY = [(-31 + 17 * at, 22 + 3 * at * (9 - at)) for at in range(10)]
LINES = [(at % 7 * 6,) for at in range(32)]


def past_of(shot: Snapshot, rate: int, seconds: float) -> list[Snapshot]:
    """Return shots of the time before one: ball and robots come from the left, after a jump and another match."""
    found = []
    now = int(shot.match["step"])
    for before in range(round(seconds * rate), 0, -1):
        match, ball, robots = shot.match.copy(), shot.ball.copy(), shot.robots.copy()
        match["step"] = now - before
        ago = before / rate
        far = 3.0 if ago > 4.3 else 0.0  # [m] it was put where it is
        ball["x"] += 0.003 * (before % 3) - 0.31 * ago + far
        ball["y"] += 0.21 * np.sin(2.1 * ago)
        robots["x"] -= 0.083 * ago - far
        robots["y"] += 0.17 * np.sin(0.9 * ago)
        found.append(Snapshot(match, ball, robots))
    return found


def drawn(cast: Cast, shot: Snapshot, flags: OverlayFlags, width: int, past: Sequence[Snapshot] = ()) -> np.ndarray:
    overlays = make_overlays(flags, cast, shot, [*past], width)
    return Picture(cast.league, width).draw(shot.match, shot.ball, shot.robots, overlays=overlays)


def legged_mind() -> np.ndarray:
    """All that a robot with a camera on its head thinks, and where it and the ball came from."""
    match = {"step": 200, "clock": 12.5}
    robots = {
        0: {"x": -1.27, "y": 0.07, "heading": 0.2, "keeper": 1},
        1: {"x": -0.413, "y": 0.237, "heading": -0.31, "pan": -0.2},
        2: {"x": 1.21, "y": -0.11, "heading": 3.0, "keeper": 1, "fallen": 1.2},
        3: {"x": 0.33, "y": 0.47, "heading": -2.2},
    }
    records = staged(2, 2, match, {"x": 0.213, "y": -0.137, "vx": 0.31}, robots)
    cast = cast_for(LEGGED_LEAGUE, 2, 2, {0: GOES, 1: GOES, 2: MUTE})
    thinks = {
        "x": -431, "y": 211, "heading": -287, "confidence": 6300, "ball_x": 257, "ball_y": -93, "ball_confidence": 8700,
        "ball_age": 130, "infrared": 613, "spread": 91, "narrow": 37, "axis": 700,
        "tracks": [(-1190, 33, 3), (283, 521, -8), (1230, -70, -31), (-210, -613, 18)], "head": [(-21, -30)],
        "ball": [(11, 3, -9, -17)], "own_goal": [(-31, -43, 20, 9)], "opponent_goal": [(40, 29, 36, 22)],
        "teammates": [(-5, -9, 4, -2)], "opponents": [(26, 17, 14, -6), (-13, -14, 5, 4)],
        "landmarks": [(44, 41, 39, 20), (-20, -22, 30, 15)], "obstacle": [(14, 41)], "plan": WAY,
        "memory": (0, 0, 0, 0, 0, 0, 0),
    }  # fmt: skip
    others = [
        {"memory": (2, 1, 0, 0, 0, 0, 0), "infrared": 0, "head": [(35, 0)], "x": -1250, "y": 90},
        thinks,
        {"memory": (1, 0, 0, 20, 0, 0, 0), "infrared": 270, "head": [(-43, 0)]},
        {"memory": (-1, -1, 10, 30, 4, 0, 0), "infrared": 433, "head": [(60, 0)], "ball_age": 31000},
    ]
    shot = Snapshot(*records, note_of(cast, others))
    return drawn(cast, shot, EVERYTHING, 960, past_of(shot, 16, 5.5))


def legged_other_way() -> np.ndarray:
    """The same of a robot of the other team in the second half; its ball was never seen, its way has no end yet."""
    match = {"step": 31, "home_direction": -1.0, "half": 1}
    robots = {
        0: {"active": 0, "penalty": 4.1},
        1: {"x": 0.9, "y": 0.31, "heading": 2.8},
        2: {"x": 0.11, "y": -0.33, "heading": 0.41},
        3: {"x": -0.27, "y": 0.12, "heading": 0.9, "pan": 0.4},
        4: {"active": 0},
    }
    records = staged(2, 3, match, {"x": -0.71, "y": 0.33}, robots)
    cast = cast_for(LEGGED_LEAGUE, 2, 3, {3: PULLS, 4: PULLS})
    thinks = {
        "x": -243, "y": 133, "heading": 871, "confidence": 4200, "ball_age": 32000, "head": [(40, 10)],
        "tracks": [(110, -330, 1), (930, 290, -26)], "landmarks": [(30, 28, 12, -40)], "infrared": 120,
        "ball": [(-44, -44, -36, -36)], "opponents": [(3, -8, 11, -3)], "memory": (-1, 1, 0, 0, 9, 5, 0),
    }  # fmt: skip
    notes = [
        {"infrared": 300}, {"sees": 0, "memory": (-1, -1, 0, 0, 0, 0, 8)}, {"memory": (0, 1, 0, 0, 0, 0, 0)}, thinks,
        {},
    ]  # fmt: skip
    shot = Snapshot(*records, note_of(cast, notes))
    flags = replace(EVERYTHING, robot="blue 1")
    return drawn(cast, shot, flags, 480, past_of(shot, 16, 9.0)[-20:])


def middle_mind() -> np.ndarray:
    """All that a robot with a mirror thinks: it is the one nearest to the ball of those that think."""
    match = {"step": 900}
    robots = {
        0: {"x": 1.3, "y": -0.6, "heading": 0.2, "active": 0},
        1: {"x": 0.47, "y": -1.31, "heading": 0.63, "has_ball": 1},
        2: {"x": -4.61, "y": 0.23, "heading": 0.1, "keeper": 1},
        3: {"x": 1.73, "y": -0.4, "heading": 2.9},
        4: {"x": 3.91, "y": 1.37, "heading": -2.7},
    }
    records = staged(3, 2, match, {"x": 1.13, "y": -0.87, "vx": -2.3}, robots)
    cast = cast_for(MIDDLE, 3, 2, {1: GOES, 2: PULLS})
    thinks = {
        "x": 513, "y": -1270, "heading": 700, "confidence": 9100, "ball_x": 1210, "ball_y": -790, "ball_age": 40,
        "ball_confidence": 9900, "tracks": [(1810, -350, -1), (-4500, 300, 9)], "ball": [(-7, 78)],
        "own_goal": [(231, 661)], "opponent_goal": [(-37, 571)], "players": [(5, -160), (222, 523), (3, -436)],
        "lines": LINES, "plan": [(51 + 31 * at, -127 + 9 * at) for at in range(10)], "memory": (0, 0, 0, 0, 0, 0, 0),
    }  # fmt: skip
    said = [{}, thinks, {"memory": (-1, -1, 0, 0, 0, 0, 0)}, {"sees": 0}, {"memory": (-1, -1, 20, 10, 0, 7, 3)}]
    shot = Snapshot(*records, note_of(cast, said))
    return drawn(cast, shot, replace(EVERYTHING, robot="ball"), 720, past_of(shot, 50, 3.0))


def middle_other_way() -> np.ndarray:
    """The same of a robot of the other team, with a field towards no plan, and without a camera for lines."""
    match = {"step": 9, "home_direction": -1.0}
    robots = {0: {"x": 2.2, "y": 0.7, "heading": -3.0}, 1: {"x": -1.7, "y": 1.1, "heading": 1.9}}
    records = staged(1, 1, match, {"x": -2.3, "y": 2.1}, robots)
    cast = cast_for(MIDDLE, 1, 1, {1: PULLS})
    reader = cast.reader
    assert reader is not None
    cast = replace(cast, reader=replace(reader, groups=[group for group in reader.groups if group[0] != "lines"]))
    thinks = {
        "x": -1730, "y": 1050, "heading": 1870, "ball_x": -2270, "ball_y": 2230, "ball_age": 950, "ball_confidence": 50,
        "tracks": [(2130, 760, -200)], "ball": [(30, 120)], "own_goal": [(150, 0)], "players": [(-200, -392)],
        "opponent_goal": [(-204, 779)], "spread": 310, "narrow": 0, "axis": -900,
    }  # fmt: skip
    shot = Snapshot(*records, note_of(cast, [{}, thinks]))
    return drawn(cast, shot, replace(EVERYTHING, robot="away_0"), 640, [])


def crowd() -> np.ndarray:
    """Words under robots that stand too near to each other for them, and at both edges."""
    places = [
        (0.0, 0.0), (0.02, 0.01), (0.04, -0.03), (-0.03, 0.02), (0.01, 0.04), (1.43, 0.8), (-1.44, -0.83), (0.7, 0.6),
    ]  # fmt: skip
    robots = {row: {"x": x, "y": y, "heading": 0.8 * row} for row, (x, y) in enumerate(places)}
    records = staged(5, 3, {}, {"x": 0.9, "y": -0.7}, robots)
    cast = cast_for(LEGGED_LEAGUE, 5, 3, {})
    told = [(row % 3, row % 2, 0, 10 * row, row % 4, 0, 0) for row in range(8)]
    shot = Snapshot(
        *records, note_of(cast, [{"memory": memory, "infrared": 90 * row} for row, memory in enumerate(told)])
    )
    return drawn(cast, shot, parse_flags("roles,infrared"), 640)


def corners() -> np.ndarray:
    """The picture of the camera lies in the corner that is farthest from the robot and the ball."""
    cast, frames = cast_for(LEGGED_LEAGUE, 1, 1, {}), []
    for x, y in ((0.8, 0.5), (-0.8, 0.5), (0.8, -0.5), (-0.8, -0.5)):
        records = staged(1, 1, {}, {"x": x, "y": y + 0.2}, {0: {"x": x - 0.1, "y": y, "heading": 1.3}})
        blobs = {"head": [(10, 20)], "ball": [(5, -5, 20, 12)]}
        blobs |= {"own_goal": [(44, 20, -20, -36)], "opponents": [(1, 0, 2, 1)]}
        shot = Snapshot(*records, note_of(cast, [blobs, {}]))
        frames.append(drawn(cast, shot, parse_flags({"sight": True, "robot": "red 0"}), 480))
    return contact_sheet(frames, columns=2, gap=0)


def missing() -> np.ndarray:
    """What a flag cannot show is said, for each reason."""
    records = staged(1, 2, {}, {"x": 0.21}, {1: {"x": 0.3}})
    cast = cast_for(LEGGED_LEAGUE, 1, 2, {0: GOES, 1: MUTE, 2: PULLS})
    assert cast.reader is not None
    few = replace(cast, reader=NoteReader(cast.reader.slots, [[]] * 3, []))
    waits = replace(cast, reader=replace(cast.reader, groups=PLAN))
    knows = {"x": 100, "y": -100, "ball_age": 40, "ball_x": 200, "confidence": 100}
    cases = [
        (cast, None, "home_0"),  # nothing was noted
        (replace(cast, reader=None), None, "away_1"),
        (cast, [{"sees": 0}] * 3, "home_0"),  # it believes nothing
        (few, [knows] * 3, "home_0"),  # an older file: no groups, no memory
        (waits, [knows] * 3, "red 0"),  # a plan of nothing
        (cast, [knows] * 3, "away_0"),  # a team that explains nothing
        (replace(cast, parts={}), [knows] * 3, "ball"),  # learners
        (replace(cast, camera=None, ranger=False), [{**knows, "head": [(9, 9)]}] * 3, "blue_0"),
    ]
    frames = []
    for who, said, robot in cases:
        note = None if said is None else note_of(who, said)
        frames.append(drawn(who, Snapshot(*records, note), replace(EVERYTHING, robot=robot), 480))
    frames.append(drawn(cast, Snapshot(*records), OverlayFlags(), 480))
    return contact_sheet(frames, columns=3, gap=2)


SCENES = (legged_mind, legged_other_way, middle_mind, middle_other_way, crowd, corners, missing)
