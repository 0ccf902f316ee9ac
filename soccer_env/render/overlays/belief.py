"""The beliefs of one robot beside the truth: its pose and particles, the ball, other players."""

from __future__ import annotations

from math import cos, hypot, pi, sin

import numpy as np

from soccer_env.geometry import point_of_frame
from soccer_env.leagues.league import League
from soccer_env.render.colours import BALL_SHINE, KEEPER, TEAMS_LIGHT, WHITE, Colour
from soccer_env.render.overlays.cast import Cast, Snapshot
from soccer_env.render.overlays.shapes import Area, Label, Overlay, Points, Polyline
from soccer_env.render.robots import robot_pieces
from soccer_env.thoughts.thought import Thought

JUST_SEEN = 0.5  # [s] younger percepts are not marked with their age
WHOLE = 1.95  # [s] from this age on only whole seconds: a decimal point is lost in small pictures
DEVIATIONS = 2.0  # standard deviations in the ellipse around the particles
CORNERS = np.linspace(0.0, 2.0 * pi, 33)[:-1]

Pose = tuple[float, float, float]


def belief_overlays(cast: Cast, shot: Snapshot, row: int, thought: Thought, unit: float) -> list[Overlay]:
    """Return the overlays of the beliefs of robot `row`, with lines from true to believed places of robot and ball."""
    robot = shot.robots[row]
    true = (float(robot["x"]), float(robot["y"]))
    overlays = particle_ellipse(thought, unit)
    overlays.append(Polyline([true, thought.pose[:2]], WHITE, 1.4 * unit))
    overlays += trunk_outline(cast.league, thought.pose, WHITE, 2.6 * unit)
    ring = (15.0 if cast.league.body.legs else 12.0) * unit  # [px]
    for player in thought.players:
        team = int(robot["team"]) if player.mate else 1 - int(robot["team"])
        overlays.append(Points([(player.x, player.y)], TEAMS_LIGHT[team], ring, hollow=True))
        if player.age >= JUST_SEEN:
            away = (13.0 * unit, -13.0 * unit)
            words = f"{player.age:.0f} s" if player.age >= WHOLE else f"{player.age:.1f} s"
            overlays.append(Label((player.x, player.y), words, TEAMS_LIGHT[team], letter_height(unit), away, "left"))
    if thought.ball is not None:
        overlays.append(
            Polyline([(float(shot.ball["x"]), float(shot.ball["y"])), thought.ball], BALL_SHINE, 1.6 * unit)
        )
        overlays.append(Points([thought.ball], BALL_SHINE, 9.0 * unit, hollow=True))
    return overlays


def letter_height(unit: float) -> float:
    """Return the height of letters [px], legible in small pictures too."""
    return max(15.0, 19.0 * unit)


def particle_ellipse(thought: Thought, unit: float) -> list[Overlay]:
    """Return an ellipse of two standard deviations around the robot's particles; nothing without particles."""
    wide, narrow, axis = thought.cloud
    if wide <= 0.0:
        return []
    across, up = DEVIATIONS * wide * np.cos(CORNERS), DEVIATIONS * narrow * np.sin(CORNERS)
    x = thought.pose[0] + across * cos(axis) - up * sin(axis)
    y = thought.pose[1] + across * sin(axis) + up * cos(axis)
    rim = np.column_stack([x, y])
    return [Area(rim, KEEPER, 50), Polyline(rim, KEEPER, 1.4 * unit, closed=True)]


def trunk_outline(league: League, pose: Pose, colour: Colour, width: float) -> list[Overlay]:
    """Return the outline of a robot's trunk at a pose, with a line that shows the heading."""
    x, y, heading = pose
    corners = [
        point_of_frame(x, y, u, v, cos(heading), sin(heading))
        for part in robot_pieces(league.body, 0.0, walks=league.drive.kind == "gait")
        if part.role == "body"
        for u, v in part.outline
    ]
    if not corners:
        radius = league.body.disc_radius
        corners = [(x + radius * cos(angle), y + radius * sin(angle)) for angle in CORNERS]
    ahead = 1.25 * max(hypot(u - x, v - y) for u, v in corners)
    nose = (x + ahead * cos(heading), y + ahead * sin(heading))
    return [Polyline(corners, colour, width, closed=True), Polyline([(x, y), nose], colour, width)]


def belief_words(name: str, thought: Thought) -> str:
    """Return the robot's beliefs in one line."""
    words = f"{name} believes: itself {thought.confidence:.0f} %"
    if thought.ball is None:
        return f"{words}, the ball was never seen"
    seen = "seen now" if thought.ball_age < JUST_SEEN else f"seen {thought.ball_age:.1f} s ago"
    return f"{words}, ball {thought.ball_confidence:.0f} %, {seen}"
