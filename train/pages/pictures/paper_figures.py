"""The figures of the two papers, and of sections that have none, drawn from runs of this repository.

    python -m soccer_env.train.pages.pictures.paper_figures [NAME ...]     paths, far-post, occluded-ball, ball-memory

Without names all are drawn. The site shows each beside the number of the paper's figure.
"""

import sys
from collections.abc import Callable
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from soccer_env.baselines.weigel_2001.planner.drawing import draw_travel
from soccer_env.guards.names import unknown
from soccer_env.guards.whole_files import write_atomically
from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.train.pages.pictures.settings import FOLDER
from soccer_env.train.papers.claim import STAGED, Batch, as_plain
from soccer_env.train.papers.claims.ball import memory, occlusion
from soccer_env.train.papers.claims.goalkeeping.saves import KEEPERS, LINE
from soccer_env.train.papers.claims.goalkeeping.shots import face_shots
from soccer_env.train.papers.claims.planning.crossings import CYCLES
from soccer_env.train.papers.claims.planning.runs import CANONICAL, PLANNERS, travel
from soccer_env.train.papers.plots import plot
from soccer_env.train.papers.staging import MIDDLE
from soccer_env.train.papers.values import median
from soccer_env.train.report import draw_curves
from soccer_env.train.report.style import canvas, picture_maker

SEED = 1
SHOTS = 12  # tried, of which the first that tells the keepers apart is drawn
SHOWN = 6  # bins of the hidden share: beyond three quarters errors by width dwarf all others
NAMES = {"old": "conventional", "new": "time-variant"}  # of PLANNERS


class PaperFigure(NamedTuple):
    """A figure: the paper's, what ours shows, and the function that draws ours as a PNG."""

    paper: str
    shows: str
    draw: Callable[[], bytes]


@picture_maker
def draw_paths() -> Any:
    """Return both planners in the chosen crossing a after 1, 30 and 60 cycles, upwards as in the paper.  MH18"""
    from matplotlib.transforms import Affine2D

    upwards = Affine2D([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # x, y of the field to y, x of the picture
    drawn, rows = canvas(6.9, 6.4, 2, len(CYCLES), sharex=True, sharey=True)
    for row, (name, changes) in zip(rows, PLANNERS.items(), strict=True):
        one = travel(CANONICAL["a"], **changes)
        for axes, cycle in zip(row, CYCLES, strict=True):
            draw_travel(axes, one, cycle)
            for artist in (*axes.lines, *axes.patches):
                artist.set_transform(upwards + axes.transData)
            axes.set_title(f"{NAMES[name]}, t = {cycle}", fontsize="small")
            axes.set(xlim=(2.5, -2.5), ylim=(-4.0, 4.0), xlabel="y [m]", ylabel="x [m]")
    return drawn


@picture_maker
def draw_far_post() -> Any:
    """Return a shot at the farther post from above, at the passive keeper and at the active one."""
    from matplotlib.patches import Circle

    trails = {name: record_shots(name) for name in ("passive", "active")}
    conceded, saved = trails["passive"][1], ~trails["active"][1]
    m = int(np.argmax(conceded & saved))
    league = find_league(MIDDLE)
    goal, half = -league.pitch.length / 2, league.pitch.goal_width / 2
    drawn, columns = canvas(3.0, 7.6, 1, 2, sharex=True, sharey=True)
    for axes, (name, (trail, scored)) in zip(columns, trails.items(), strict=True):
        keeper_x, keeper_y, ball_x, ball_y = until_decided(trail[:, :, m].T)
        axes.plot([half, -half], [goal, goal], color="0.2", linewidth=3.0, label="goal")
        axes.plot([ball_y[0], 0.0], [ball_x[0], goal], ":", color="0.45", label="line d")
        axes.plot(ball_y, ball_x, "-", color="tab:orange", label="ball")
        axes.plot(keeper_y, keeper_x, "-", color="tab:red", linewidth=2.5, label="goalkeeper")
        for x, y, radius, colour in (
            (keeper_x[-1], keeper_y[-1], league.body.disc_radius, "tab:red"),
            (ball_x[-1], ball_y[-1], league.ball.radius, "tab:orange"),
        ):
            axes.add_patch(Circle((y, x), radius, color=colour, alpha=0.5))
        axes.set_title(f"{name}: {'goal' if scored[m] else 'saved'}", fontsize="small")
        axes.set(xlabel="y [m]", ylabel="x [m]", aspect="equal")
    columns[0].set_xlim(2.6, -2.6)
    columns[0].legend(fontsize="x-small")
    return drawn


def record_shots(name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the places x, y [m] of keeper and ball (T, 4, SHOTS) after each step of equal shots, and the goals."""
    rows: list[np.ndarray] = []

    def look(match: Match) -> None:
        keeper, ball = match.robots[:, 0], match.balls
        rows.append(np.array([keeper["x"], keeper["y"], ball["x"], ball["y"]]))

    settings, remembers = KEEPERS[name]
    batch = Batch("far-post", SEED, 0, rules=STAGED)
    faced = face_shots(batch, settings | LINE, shots=SHOTS, look=look, memory=remembers)
    return np.array(rows), faced.goal


def until_decided(trail: np.ndarray) -> np.ndarray:
    """Return the trail (4, T) of a shot until its ball comes no nearer to the goal: in, saved, or past."""
    nearer = np.diff(trail[2]) < 0.0
    return trail[:, : len(nearer) if nearer.all() else int(nearer.argmin()) + 1]


def draw_occluded_ball() -> bytes:
    """Return the error of a ball's range against its hidden share, by width, by height and by the closer of both."""
    samples = occlusion.compare_dimensions(Batch("S07", SEED, 0, rules=STAGED))
    (figure,) = occlusion.hidden_figure(samples)
    shorter = [replace(curve, x=curve.x[:SHOWN], y=curve.y[:SHOWN]) for curve in figure.curves]
    return draw_curves(as_plain(replace(figure, curves=tuple(shorter))))


def draw_ball_memory() -> bytes:
    """Return the error of an unseen ball's place over the way walked, for the three ways to update the memory."""
    batch, lines = Batch("S12", SEED, 0, rules=STAGED), {}
    for name, title in {"full": "rotation and translation", "rotation": "rotation only", "none": "no update"}.items():
        errors = [100.0 * median(memory.ball_errors(match)["place"]) for match in memory.walk_blind(batch, name)]
        lines[title] = lambda samples, errors=errors: errors
    ways = list(np.linspace(0.0, 100.0 * memory.WAY, len(errors) + 1)[1:])
    title, place = "Memory of a still ball that is no longer seen", "way walked without sight of it [cm]"
    (figure,) = plot(title, place, "median error of its place [cm]", ways, lines)({})
    return draw_curves(as_plain(figure))


FIGURES = {
    "paths": PaperFigure(
        "Heinemann et al. 2006, figures 1 and 2 (the text calls them 3)",
        "Paths of the conventional and of the time-variant planner, thin blue as planned and thick red as travelled, "
        "at t = 1, 30 and 60 cycles; the obstacle grey, its course dotted. The scene was chosen, 1 of 260 draws.",
        draw_paths,
    ),
    "far-post": PaperFigure(
        "Heinemann et al. 2006, figures 3 and 4",
        "A shot at the farther post at a keeper that stands on the line d as if the ball did not move, and at one that "
        f"moves into its predicted trajectory, both from the goal line; the first of {SHOTS} equal shots that tells "
        "them apart.",
        draw_far_post,
    ),
    "occluded-ball": PaperFigure(
        "Sacks 2001, 3.1.1, which has no figure",
        "A ball hidden up to three quarters seems farther away; the closer of its ranges by width and by height guards "
        "against it.",
        draw_occluded_ball,
    ),
    "ball-memory": PaperFigure(
        "Sacks 2001, 3.1.1, which has no figure",
        "The place of a ball that is no longer seen, remembered by the robot's odometry.",
        draw_ball_memory,
    ),
}


def main(names: list[str]) -> int:
    """Draw the named figures, or all, into the folder of pictures; return the exit code."""
    for name in names or FIGURES:
        if name not in FIGURES:
            print(unknown("figure", name, FIGURES), file=sys.stderr)
            return 2
        write_atomically(FOLDER / f"paper-{name}.png", FIGURES[name].draw())
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
