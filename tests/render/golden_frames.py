"""Staged scenes of pitch, robots, header and shapes: together they run every line that draws them.

Nothing is played: records are written by hand, at places that lie on no edge of a pixel.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.render import Arrows, Label, Picture, Points, Polyline, contact_sheet
from soccer_env.render.closeup import Closeup
from soccer_env.render.overlays.panels import HelpPanel, TextPanel
from soccer_env.render.overlays.shapes import Area, ArrowGrid
from soccer_env.render.video import swatches
from soccer_env.types import Phase
from tests.render.staged_frames import make_records
from tests.scenes.staging import LEGGED, MIDDLE, boarded

PINK, MINT, SNOW = (250, 20, 220), (120, 255, 190), (250, 250, 250)
Fields = dict[str, Any]
Records = tuple[np.ndarray, np.ndarray, np.ndarray]


def staged(home: int, away: int, match: Fields, ball: Fields, robots: dict[int, Fields]) -> Records:
    """Return the records of `make_records` with other values in some fields; `walk` is ahead [m/s]."""
    found = make_records(home, away)
    for record, fields in ((found[0], match), (found[1], ball), *((found[2][row], robots[row]) for row in robots)):
        for name, value in fields.items():
            if name == "walk":
                record["walk"]["forward"], record["walk"]["turn"] = value, 3.0 * value
            else:
                record[name] = value
    found[0]["handedness"] = 1.0
    return found


def legged_play() -> np.ndarray:
    """Every state of a four-legged robot; a fast ball; somebody has it."""
    match = {"clock": 83.4, "score": (2, 11), "last_touch_robot": 1, "last_touch_team": 0}
    robots = {
        0: {"keeper": 1, "x": -1.357, "y": 0.083, "heading": 0.31, "pan": -1.1},
        1: {"fallen": 1.3, "x": -0.613, "y": -0.412, "heading": 2.47},
        2: {"kick_clock": 0.37, "x": -0.171, "y": 0.643, "heading": -0.77, "pan": 0.9},
        3: {"kick_clock": -0.41, "x": 0.523, "y": -0.714, "heading": 1.03, "walk": 0.11, "gait_phase": 3},
        4: {"keeper": 1, "fallen": 0.4, "x": 1.389, "y": -0.127, "heading": -2.9},
        5: {"has_ball": 1, "x": 0.287, "y": 0.094, "heading": 2.51, "pan": 0.33},
        6: {"kick_clock": -0.22, "x": 1.031, "y": 0.563, "heading": -1.9, "walk": -0.07, "gait_phase": 6},
        7: {"x": 0.861, "y": -0.293, "heading": 3.01, "pan": 1.47},
    }
    records = staged(4, 4, match, {"x": 0.137, "y": 0.221, "vx": -1.13, "vy": 0.62}, robots)
    return Picture(LEGGED).draw(*records, title=("Sacks 2001", "möwen"))


def middle_play() -> np.ndarray:
    """Every state of a round robot, with both teams at the ball."""
    match = {"clock": 601.0, "half": 1, "home_direction": -1.0, "half_length": 900.0, "score": (10, 3)}
    robots = {
        0: {"keeper": 1, "x": 5.57, "y": 0.31, "heading": 2.9},
        1: {"fallen": 2.2, "x": 1.93, "y": -2.41, "heading": 0.77},
        2: {"has_ball": 1, "kick_clock": 0.1, "x": 0.63, "y": 1.37, "heading": -2.6},
        3: {"kick_clock": -0.93, "x": -2.21, "y": 2.73, "heading": 1.41},
        4: {"keeper": 1, "fallen": 7.6, "x": -5.43, "y": -0.47, "heading": 0.23},
        5: {"has_ball": 1, "x": 0.07, "y": 1.11, "heading": 0.59},
        6: {"kick_clock": -0.71, "x": -3.37, "y": -1.83, "heading": -0.39},
        7: {"x": 6.37, "y": 4.71, "heading": -1.2},
    }
    records = staged(4, 4, match, {"x": 0.37, "y": 1.23, "vx": 3.7, "vy": -1.9}, robots)
    return Picture(MIDDLE).draw(*records)


def legged_small() -> np.ndarray:
    """The smallest picture: names without room, robots sent off by both teams, the kick-off after a goal."""
    match = {
        "clock": 61.7,
        "phase": Phase.KICK_OFF,
        "restart_team": 0,
        "score": (0, 1),
        "phase_clock": 1.2,
        "placing": 1,
    }
    robots = {
        1: {"active": 0, "penalty": 12.3},
        2: {"active": 0},
        3: {"keeper": 1, "x": -1.31, "y": 0.111, "has_ball": 1},
        6: {"active": 0, "penalty": 0.2},
    }
    records = staged(4, 3, match, {"x": 0.013, "y": -0.021}, robots)
    return Picture(LEGGED, 240).draw(*records, title=("a team whose name has no room at all, however small", "b\nc\0d"))


def middle_large() -> np.ndarray:
    """Eleven a side on a wide picture of an odd width; robots outside it on all sides are left out."""
    half_x, half_y, reach = 6.5, 5.0, 2 * 0.287  # [m] what is drawn of the pitch, a little less; and beyond it
    places = [
        (half_x + 0.52, 0.3), (-half_x - 0.56, 0.2), (0.5, half_y + 0.54), (0.6, -half_y - 0.59),
        (half_x + 3 * reach, 0.4), (-half_x - 3 * reach, 0.5), (0.7, half_y + 3 * reach), (0.8, -half_y - 3 * reach),
    ]  # fmt: skip
    robots = {row: {"x": x, "y": y} for row, (x, y) in enumerate(places)}
    for row in range(8, 22):
        robots[row] = {"x": 0.41 * (row - 14) + 0.03, "y": 0.37 * (row - 13), "heading": 0.7 * row}
    robots[9]["active"] = robots[21]["active"] = 0
    match = {"phase": Phase.FREE_KICK, "restart_team": 1, "half_length": np.inf, "clock": 5999.0}
    records = staged(11, 11, match, {"x": -1.03, "y": -2.11, "vx": 0.11, "vy": 0.09}, robots)
    return Picture(MIDDLE, 1441).draw(*records, title=("", "x" * 60))


def pitches() -> np.ndarray:
    """Pitches as no league has them: boards without feet, lines on a walled one; robots that walk without legs."""
    legged, middle = find_league(LEGGED), find_league(MIDDLE)
    bare = {"penalty_depth": 0.0, "goal_area_width": 0.0, "penalty_width": 0.0}
    short = {"length": 3.9, "width": 4.7, "goal_depth": 0.9, "goal_width": 1.3}
    short |= {"penalty_width": 3.1, "goal_area_width": 2.1}
    leagues: list[League] = [
        boarded(middle),
        replace(legged, body=replace(legged.body, legs=False, disc_radius=0.0, disc_back=0.0, corners=TRUNK)),
        replace(legged, pitch=replace(legged.pitch, walled=False, band_side=0.1, band_end=0.2)),
        replace(middle, pitch=replace(middle.pitch, **bare)),
        replace(middle, pitch=replace(middle.pitch, **short)),
    ]
    records = staged(1, 1, {}, {"x": 0.31, "y": 0.17}, {})
    frames = [Picture(league, 361).draw(*records) for league in leagues]
    return stacked(frames)


def stacked(frames: list[np.ndarray], width: int | None = None) -> np.ndarray:
    """Return frames one below the other, black beside those that are not as wide as the whole."""
    wide = width or frames[0].shape[1]
    return np.concatenate([np.pad(frame, ((0, 0), (0, wide - frame.shape[1]), (0, 0))) for frame in frames])


def headers() -> np.ndarray:
    """Every phase of play and whose it is, clocks, halves, goals, and who has the ball."""
    picture, found = Picture(LEGGED, 480), []

    def add(match: dict[str, Any], robots: dict[int, dict[str, Any]] | None = None) -> None:
        records = staged(2, 2, match, {}, robots or {})
        found.append(picture.draw(*records)[: picture.header_height])

    for phase in Phase:
        for team in (-1, 0, 1):
            add({"phase": phase, "restart_team": team, "clock": 100.0, "phase_clock": 60.0})
    for placing in (0.0, 3.2, 99.0):
        add({"phase": Phase.CORNER_KICK, "restart_team": 0, "placing": 1, "phase_clock": placing})
    for team, since, clock in ((0, 1.0, 9.0), (1, 3.9, 9.0), (1, 4.1, 9.0), (1, 2.0, 2.0), (-1, 1.0, 9.0)):
        goal = {"phase": Phase.KICK_OFF, "restart_team": team, "phase_clock": since, "clock": clock}
        add(goal | {"score": (3, 4)})
        add(goal | {"score": (0, 0)})
    add({"over": 1, "phase": Phase.PLAY})
    add({"over": 1, "phase": Phase.OVER})
    for half, length, clock in ((0, 90.0, 59.9999999999), (1, 45.0, -3.0), (2, np.inf, 3600.0), (-1, 61.0, 1e-12)):
        add({"half": half, "half_length": length, "clock": clock})
    for row, team in ((3, 1), (0, 0), (-1, 0), (-1, 1), (9, -1), (4, 1)):
        add({"last_touch_robot": row, "last_touch_team": team}, {0: {"keeper": 1}})
    add({}, {0: {"has_ball": 1, "keeper": 1}, 1: {"has_ball": 1}, 2: {"has_ball": 1, "active": 0}})
    return stacked(found)


def shapes() -> np.ndarray:
    """Every shape that can be laid over a picture, inside, at its edges and outside, over and under robots."""
    angle = np.linspace(0.0, 5.1, 21)
    way = np.stack([1.3 * angle - 4.1, 1.7 * np.sin(2.3 * angle) + 0.07], axis=1)
    middles = np.array([(-4.3, -3.1), (-3.4, -3.1), (-2.6, -3.2), (-1.7, -3.1)])
    arrows = [(0.7, 0.3), (0.0, -0.9), (0.09, 0.04), (0.01, 0.01)]
    fall = np.array([(0.61, 0.23), (-0.37, 0.51), (0.0, 0.0), (0.02, -0.07)])
    corners = ((1.3, 2.2), (6.9, 1.1), (-6.8, 2.3), (-2.7, 5.3), (2.9, -5.4), (40.0, 0.0), (0.0, -40.0))
    boxes = [[(x - 1.1, y - 0.6), (x + 1.2, y - 0.7), (x + 0.9, y + 0.8)] for x, y in corners]
    overlays = [
        Points([(2.03, 2.11), (-2.2, 2.3)], PINK, radius=5.3),
        Points([(0.63, 2.07)], MINT, radius=11.0, hollow=True),
        Points([(0.13, 2.27)], MINT, radius=3.0, hollow=True),
        Points([(-4.17, 1.63)], SNOW, under=True),
        Polyline(way, SNOW),
        Polyline(way[:5] + (0.4, -1.1), PINK, 4.3, closed=True, under=True),
        Polyline(np.zeros((0, 2)), PINK, closed=True),
        Polyline([(1.03, -1.7)], PINK),
        Polyline([(3.3, 3.1), (3.3, 3.1), (9e9, 3.3)], MINT, 3.1),
        Arrows([(-4.1, 3.2), (-3.3, 3.1), (-2.7, 3.3), (-2.1, 3.1)], arrows, PINK, 3.3),
        Arrows([(-1.1, 3.2)], [(-0.4, -0.31)], MINT, under=True),
        ArrowGrid(middles, fall, [0.0, 1.0, 0.43, 0.77], MINT, PINK),
        ArrowGrid(middles + (4.7, 0.2), fall, [0.1, 0.9, 0.5, 0.3], SNOW, PINK, 3.7, under=False),
        *(Area(box, MINT, 60 + 20 * at) for at, box in enumerate(boxes)),
        Area(boxes[0] + np.array([0.9, -1.1]), PINK, under=False),
        *(Label((x, -1.9), words, SNOW, size, (7.3, -5.1), align) for x, words, size, align in LABELS),
        Label((5.9, 3.9), "beside", PINK, 15.0, (3.0, 4.0), under=True),
        *(Label((x, y), "outside", PINK) for x, y in ((9.0, 0.0), (-9.0, 0.0), (0.0, 7.0), (0.0, -7.0))),
    ]  # fmt: skip
    robots = {0: {"x": -4.27, "y": 1.71}, 1: {"x": 2.1, "y": 2.31, "heading": 0.4}}
    records = staged(1, 1, {"phase": Phase.DROP_BALL, "restart_team": 1}, {"x": 3.13, "y": -2.17}, robots)
    return Picture(MIDDLE, 800).draw(*records, overlays=overlays)


TRUNK = ((0.105, -0.05), (0.105, 0.05), (-0.12, 0.05), (-0.12, -0.05))  # [m]
LABELS = ((-4.7, "left", 17.0, "left"), (-1.1, "centre", 31.0, "centre"), (4.3, "right end", 12.0, "right"))


def closeups() -> np.ndarray:
    """Three looks from near: in the middle, and at two corners that it does not look beyond."""
    frames = []
    for league, places in ((LEGGED, [(0.113, -0.071), (-1.5, 1.0)]), (MIDDLE, [(6.1, -4.3)])):
        picture = Closeup(league, 400)
        robots = {0: {"keeper": 1, "has_ball": 1, "x": -0.17, "y": 0.13}, 1: {"active": 0}, 2: {"x": -1.1, "y": 0.73}}
        robots[3] = {"x": 5.71, "y": -3.3, "heading": 1.7}
        records = staged(2, 2, {"clock": 7.0}, {"x": 0.21, "y": 0.07, "vx": 0.9}, robots)
        triangle = Area([(0, 0), (-1, 0), (-1, 1)], MINT)
        overlays = [Points([(0.2, 0.1)], PINK, 7.0), Label((5.1, -3.7), "near", SNOW), triangle]
        frames += [picture.draw_near(*records, place, title=("ones", "others"), overlays=overlays) for place in places]
    return stacked(frames)


def words() -> np.ndarray:
    """Lines in a corner, above a bench and without one, some too long; help in the middle."""
    frames = []
    for league, width in ((LEGGED, 480), (MIDDLE, 480), (MIDDLE, 960)):
        records = staged(2, 2, {}, {}, {1: {"active": 0, "penalty": 3.0}} if league == LEGGED else {})
        lines = ("a first line", "a second one, " + 9 * "longer than the picture is wide, ")
        helped = HelpPanel(("H  help", "space  pause") + 14 * ("more",) * (width == 480))
        overlays = [TextPanel(lines, width / 960.0, above_bench=league == LEGGED), helped]
        frames.append(Picture(league, width).draw(*records, overlays=overlays))
    return stacked(frames, 960)


def sheet() -> np.ndarray:
    """Frames in rows, and a patch of every colour."""
    picture = Picture(LEGGED, 240)
    frames = [picture.draw(*staged(1, 1, {"clock": 7.0 * turn}, {"x": 0.3 * turn}, {})) for turn in range(4)]
    tall = contact_sheet(frames)
    return stacked([contact_sheet(frames[:2], columns=5, gap=3), tall, swatches(333)], tall.shape[1])


SCENES = (legged_play, middle_play, legged_small, middle_large, pitches, headers, shapes, closeups, words, sheet)
