"""Robots that do not play: sent off, or room for players that a team does not have; shown beside the field."""

from __future__ import annotations

from math import ceil

from soccer_env.render import colours
from soccer_env.render.canvas import Canvas
from soccer_env.render.robots import Figure
from soccer_env.render.view import View


def draw_bench(figures: list[Figure], view: View, canvas: Canvas) -> None:
    """Draw robots that are not active as grey discs under the field: home on the left, away on the right."""
    radius = 0.34 * view.margin
    y = canvas.height - 0.46 * view.margin
    for team in (0, 1):
        resting = [figure for figure in figures if figure.team == team and not figure.active]
        x = 0.5 * radius + team * canvas.width / 2
        if resting:
            x += canvas.text("off:", (x, y), 1.4 * radius, colours.DIM, "left") + 1.6 * radius
        for figure in resting:
            canvas.disc((x, y), radius, colours.TEAMS_LIGHT[team])
            canvas.disc((x, y), radius - 1.5, colours.GREY)
            canvas.text(str(figure.number), (x, y), 1.5 * radius, colours.WHITE)
            if figure.penalty > 0.0:
                words = f"{ceil(figure.penalty)} s"
                x += canvas.text(words, (x + 1.3 * radius, y), 1.4 * radius, colours.DIM, "left") + 0.6 * radius
            x += 2.5 * radius
