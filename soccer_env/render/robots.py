"""Robots and ball as seen from above, drawn from their records."""

from __future__ import annotations

from functools import lru_cache
from math import ceil, cos, hypot, sin
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from soccer_env.leagues.constants import constants_of
from soccer_env.leagues.league import League
from soccer_env.leagues.robot import Body
from soccer_env.physics.block import paws_off_stance
from soccer_env.physics.gait import LEGS, TIPS
from soccer_env.render import colours
from soccer_env.render.canvas import FACTOR, Canvas, Point, new_surface
from soccer_env.render.colours import Colour
from soccer_env.render.view import View, rounded_outline

if TYPE_CHECKING:
    import pygame

TRAIL_TIME = 0.25  # [s] of the ball's path behind it
TRAIL_SPEED = 0.15  # [m/s] slower balls leave no trail
TRAIL_PIECES = 5
TRAIL_ALPHA = 170  # of 255, next to the ball
LEAST_BALL = 4.0  # [px] radius
KICK_SHOWN = 0.2  # [s] after a kick
HIND_LEG = ((-0.105, 0.055), (-0.055, 0.055), 0.0175)  # [m] from, to, radius; drawn on walkers without legs
SHOULDER = (0.0595, 0.0592)  # [m] kinematics of the ERS-210; its hips as far behind
NOSE = ((0.50, -0.42), (0.84, 0.0), (0.50, 0.42))  # corners ahead and left, in lengths of the front; for the eye
NECK = 0.082  # [m] axis of the head, ahead of the origin, for the eye
HEAD = (  # [m] discs of the head: ahead of the neck, to the left, radius; for the eye
    (0.036, 0.0, 0.033),  # skull
    (0.056, 0.0, 0.022),  # snout
    (0.069, 0.0, 0.008),  # nose
    (0.014, 0.031, 0.012),  # ears
    (0.014, -0.031, 0.012),
)


class Figure(NamedTuple):
    """The fields of a robot record that are drawn, as plain numbers."""

    x: float
    y: float
    heading: float
    pan: float
    team: int
    number: int
    keeper: int
    active: int
    has_ball: int
    fallen: float
    penalty: float
    kick_clock: float
    paws: tuple[Point, ...] = ()  # [m] offset of each paw from its stance, robot frame


cached_constants = lru_cache(maxsize=8)(constants_of)


def figures_of(robots: np.ndarray, league: League, handedness: float) -> list[Figure]:
    """Return the robots of shape (R,) as plain numbers; ValueError names a robot whose pose is not finite."""
    for name in ("x", "y", "heading", "pan"):
        bad = np.flatnonzero(~np.isfinite(robots[name]))
        if len(bad):
            raise ValueError(f"robot {bad[0]} has {name} = {robots[name][bad[0]]}, a picture needs finite numbers")
    rows = zip(*(robots[name].tolist() for name in Figure._fields[:-1]))
    if not league.body.legs:
        return [Figure(*row) for row in rows]
    paws = np.zeros((len(robots), LEGS, 2))
    paws_off_stance(robots, cached_constants(league)[0], handedness, paws)
    swings = [tuple((x, y) for x, y in legs) for legs in paws.tolist()]
    return [Figure(*row)._replace(paws=swing) for row, swing in zip(rows, swings, strict=True)]


class RobotPiece(NamedTuple):
    """A piece of a robot in the robot's frame [m]: the outline with a rim, and the outline itself."""

    rim: list[Point]
    outline: list[Point]
    role: str
    leg: int = -1  # leg whose paw the second half of both outlines surrounds; -1: no leg


def robot_pieces(body: Body, rim: float, walks: bool) -> list[RobotPiece]:
    """Return the pieces of a robot, the lowest first, with rims `rim` wide [m]."""
    if body.legs:
        return legged_pieces(body, rim)
    root = min(body.front - body.tip_radius, body.tip_x)
    pieces: list[tuple[list[Point], float, str]] = []
    for side in (-1.0, 1.0):
        inner = (root, side * body.tip_y) if walks else (body.disc_x + 0.5 * body.disc_radius, side * 0.6 * body.tip_y)
        pieces.append(([inner, (body.tip_x, side * body.tip_y)], body.tip_radius, "tip"))
    if body.corners:
        pieces.append((list(body.corners), 0.0, "body"))
    if walks:
        (start, y), (end, _), radius = HIND_LEG
        pieces += [([(start, side * y), (end, side * y)], radius, "leg") for side in (-1.0, 1.0)]
    return [
        RobotPiece(rounded_outline(corners, radius + rim), rounded_outline(corners, radius), role)
        for corners, radius, role in pieces
    ]


def legged_pieces(body: Body, rim: float) -> list[RobotPiece]:
    """Return the pieces of a robot with legs: forelegs and hind legs from shoulder to paw, then its trunk."""
    shoulders = [(x, y) for x in (SHOULDER[0], -SHOULDER[0]) for y in (SHOULDER[1], -SHOULDER[1])]
    pieces: list[tuple[list[Point], float, str, int]] = [
        ([shoulder, paw], body.tip_radius, "tip" if leg < TIPS else "leg", leg)
        for leg, (shoulder, paw) in enumerate(zip(shoulders, body.posts, strict=True))
    ]
    pieces.append(([(body.disc_x - body.disc_back, 0.0), (body.disc_x, 0.0)], body.disc_radius, "body", -1))
    return [
        RobotPiece(rounded_outline(way, wide + rim), rounded_outline(way, wide), role, leg)
        for way, wide, role, leg in pieces
    ]


def swing_leg_outline(points: list[Point], offset: Point) -> list[Point]:
    """Return the outline of a leg whose paw is moved by an offset."""
    half = len(points) // 2
    return points[:half] + [(x + offset[0], y + offset[1]) for x, y in points[half:]]


class PlayerDrawer:
    """Draws robots and ball through a view onto a canvas."""

    def __init__(self, league: League, view: View, canvas: Canvas) -> None:
        self.league = league
        self.view = view
        self.canvas = canvas
        body = league.body
        self.walks = league.drive.kind == "gait"
        self.rim = max(1.2, 0.006 * view.scale)  # [px]
        self.parts = robot_pieces(body, self.rim / view.scale, self.walks)
        self.keeper_rim = 2.4 * self.rim  # [px]
        self.keeper_parts = robot_pieces(body, self.keeper_rim / view.scale, self.walks)
        self.keeper_edges = robot_pieces(body, (self.keeper_rim + 1.0) / view.scale, self.walks)
        self.shadow = soft_shadow(1.25 * body.reach * view.scale)
        half = league.kicker.half_width
        depth = 0.14 * body.front
        self.kicker = [(body.front - depth, -half), (body.front, -half), (body.front, half), (body.front - depth, half)]
        self.nose = [(along * body.front, aside * body.front) for along, aside in NOSE]
        self.number_x = -0.03 if self.walks else body.disc_x - 0.22 * body.disc_radius
        self.number_size = max(13.0, (0.11 if self.walks else 0.32) * view.scale)

    def draw_robots(self, figures: list[Figure]) -> None:
        """Draw the robots that play, then their marks."""
        playing = [figure for figure in figures if figure.active and self._in_sight(figure)]
        for figure in playing:
            x, y = self.view.pixel(figure.x, figure.y)
            self.canvas.stamp(self.shadow, (x + 1.5, y + 2.5))
        for figure in playing:
            with self.canvas.shrink_as_one():
                if self.walks:
                    self._draw_walker(figure)
                else:
                    self._draw_base(figure)
                place = self._pixels([(self.number_x, 0.0)], figure)[0]
                self.canvas.text(str(figure.number), place, self.number_size, colours.WHITE)
        for figure in playing:
            self._draw_marks(figure)

    def draw_ball(self, x: float, y: float, vx: float, vy: float) -> None:
        """Draw the ball, with a trail of its last places if it is fast."""
        radius = max(self.league.ball.radius * self.view.scale, LEAST_BALL)
        if hypot(vx, vy) > TRAIL_SPEED:
            self._draw_trail(x, y, vx, vy, radius)
        centre_x, centre_y = self.view.pixel(x, y)
        self.canvas.disc((centre_x + 1.0, centre_y + 2.0), radius + 1.0, colours.INK)
        self.canvas.disc((centre_x, centre_y), radius + 1.0, colours.BALL_EDGE)
        self.canvas.disc((centre_x, centre_y), radius, colours.BALL)
        self.canvas.disc((centre_x - 0.35 * radius, centre_y - 0.35 * radius), 0.22 * radius, colours.BALL_SHINE)

    def _draw_trail(self, x: float, y: float, vx: float, vy: float, radius: float) -> None:
        speed = hypot(vx, vy)
        across, up = -vy / speed * radius / self.view.scale, vx / speed * radius / self.view.scale
        for piece in range(TRAIL_PIECES):
            corners = []
            for edge, sides in ((piece / TRAIL_PIECES, (1.0, -1.0)), ((piece + 1) / TRAIL_PIECES, (-1.0, 1.0))):
                back_x = x - edge * TRAIL_TIME * vx
                back_y = y - edge * TRAIL_TIME * vy
                thin = 0.9 * (1.0 - edge)
                corners += [self.view.pixel(back_x + side * thin * across, back_y + side * thin * up) for side in sides]
            self.canvas.glass(corners, colours.BALL, round(TRAIL_ALPHA * (1.0 - piece / TRAIL_PIECES)))

    def _in_sight(self, figure: Figure) -> bool:
        x, y = self.view.pixel(figure.x, figure.y)
        reach = 2.0 * self.league.body.reach * self.view.scale
        return -reach < x < self.canvas.width + reach and -reach < y < self.canvas.height + reach

    def _pixels(self, points: list[Point], figure: Figure) -> list[Point]:
        return self.view.pixels(points, figure.x, figure.y, figure.heading)

    def _kicks(self, figure: Figure) -> bool:
        """Tell whether a robot winds up a kick or has just kicked."""
        recharge = self.league.kicker.recharge
        return figure.kick_clock > 0.0 or (recharge > 0.0 and figure.kick_clock < -max(0.0, recharge - KICK_SHOWN))

    def _draw_parts(self, figure: Figure, tip: Colour) -> None:
        """Draw legs or guides and the trunk, a goalkeeper's trunk with a wide yellow rim."""
        team = colours.TEAMS[figure.team]
        darker: Colour = tuple(part * 7 // 10 for part in team)  # type: ignore[assignment]
        fills = {"tip": tip, "body": fade_colour(team) if figure.fallen > 0.0 else team, "leg": darker}
        for part, wide, edge in zip(self.parts, self.keeper_parts, self.keeper_edges):
            if part.leg >= 0 and figure.paws:
                offset = figure.paws[part.leg]
                part = part._replace(
                    rim=swing_leg_outline(part.rim, offset), outline=swing_leg_outline(part.outline, offset)
                )
            if part.role == "body" and figure.keeper:
                self.canvas.polygon(self._pixels(edge.rim, figure), colours.INK)
                self.canvas.polygon(self._pixels(wide.rim, figure), colours.KEEPER)
            elif part.role != "leg":
                self.canvas.polygon(self._pixels(part.rim, figure), colours.INK)
            self.canvas.polygon(self._pixels(part.outline, figure), fills[part.role])

    def _draw_walker(self, figure: Figure) -> None:
        """Draw a four-legged robot: forepaws, trunk, hind legs and a head that shows its pan."""
        self._draw_parts(figure, colours.AMBER if self._kicks(figure) else colours.PAW)
        ahead, aside = cos(figure.pan), sin(figure.pan)
        places = [(NECK + along * ahead - across * aside, along * aside + across * ahead) for along, across, *_ in HEAD]
        rounds = [
            (place, radius * self.view.scale) for place, (_, _, radius) in zip(self._pixels(places, figure), HEAD)
        ]
        skull, snout, nose, *ears = rounds
        for place, radius in (*ears, skull, snout):
            self.canvas.disc(place, radius + self.rim, colours.INK)
        for place, radius in (skull, snout):
            self.canvas.disc(place, radius, colours.TEAMS_PALE[figure.team])
        self.canvas.disc(nose[0], max(1.2, nose[1]), colours.INK)

    def _draw_base(self, figure: Figure) -> None:
        """Draw a round robot: guide, base, kicker, and a nose that shows its heading."""
        self._draw_parts(figure, colours.STEEL)
        body, scale = self.league.body, self.view.scale
        centre = self._pixels([(body.disc_x, 0.0)], figure)[0]
        radius = body.disc_radius * scale
        if figure.keeper:
            self.canvas.disc(centre, radius + self.keeper_rim + 1.0, colours.INK)
            self.canvas.disc(centre, radius + self.keeper_rim, colours.KEEPER)
        self.canvas.disc(centre, radius + (0.0 if figure.keeper else 0.5 * self.rim), colours.CHASSIS)
        team = colours.TEAMS[figure.team]
        self.canvas.disc(centre, radius - 1.6 * self.rim, fade_colour(team) if figure.fallen > 0.0 else team)
        self.canvas.polygon(self._pixels(self.kicker, figure), colours.AMBER if self._kicks(figure) else colours.STEEL)
        self.canvas.polygon(self._pixels(self.nose, figure), colours.WHITE)

    def _draw_marks(self, figure: Figure) -> None:
        """Mark the robot that has the ball, the goalkeeper, and fallen robots."""
        x, y = self.view.pixel(figure.x, figure.y)
        reach = self.league.body.reach * self.view.scale
        if figure.has_ball:
            width = max(2.5, 0.1 * reach)
            self.canvas.ring((x, y), 1.3 * reach + width, width + 2.0, colours.INK)
            self.canvas.ring((x, y), 1.3 * reach + width, width, colours.BALL)
        if figure.keeper:
            radius = max(6.0, 0.2 * reach)
            away = 0.7 * (reach + radius)
            place = (x + away, y - away)
            self.canvas.disc(place, radius + 1.0, colours.INK)
            self.canvas.disc(place, radius, colours.KEEPER)
            self.canvas.text("K", place, 1.75 * radius, colours.INK)
        if figure.fallen > 0.0:
            words, below, size = f"fallen {ceil(figure.fallen)} s", y + 1.15 * reach, max(11.0, 0.4 * reach)
            wide = 0.52 * size * len(words) + size
            self.canvas.box(x - wide / 2, below - 0.62 * size, wide, 1.24 * size, colours.AMBER, 0.4 * size)
            self.canvas.text(words, (x, below), size, colours.INK, room=wide - 0.3 * size)


def soft_shadow(radius: float) -> pygame.Surface:
    """Return a round shadow that fades out at the radius [px], for `Canvas.stamp`."""
    import pygame

    large = int(radius * FACTOR)
    image = new_surface(2 * large, 2 * large, glass=True)
    steps = 24
    for step in range(steps):
        near = step / steps  # from the edge inwards; each disc replaces what it covers
        pygame.draw.circle(image, (0, 0, 0, round(90 * near * near)), (large, large), large * (1.0 - near))
    return image


def fade_colour(colour: Colour) -> Colour:
    """Return the colour mixed half and half with grey."""
    return tuple((part + grey) // 2 for part, grey in zip(colour, colours.GREY))  # type: ignore[return-value]
