"""Maps of play on a pitch: presence of robots and ball, mean positions with completed passes, and shots.

Each team attacks to the right on its own pitches. `soccer_env/data_out/README.md` has a class for those who use
mplsoccer, which draws the same and brings pandas, scipy, seaborn and requests.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.train.report.style import COLOURS, DIM, INK, STYLE, canvas, picture_maker

LEVELS = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0)  # [%] of the time, from which a cell is darker: the same in all pictures
DEPTHS = np.linspace(0.12, 0.95, len(LEVELS))  # [1] of the colour
TILE = 0.92  # [1] of a cell that is filled
MARKS = {"goal": ("*", 90.0, 2), "saved": ("o", 30.0, 0), "blocked": ("s", 30.0, 3), "off_target": ("x", 30.0, 1)}
BADGE = 0.062  # [1] diameter of a player's disc, of the pitch's length
APART = 2.8  # [1] diameters between players' middles, at least: room for arrows between them, of a few players
FEW = 5
LONGEST = 20  # letters of a team's name
BEND = 0.25  # [1] of an arrow: its height over its length is half of it
ROUNDS = 200  # of moving discs apart, at most; eleven players in one place need 60


@dataclass(frozen=True)
class Maps:
    """The data of heat maps, pass networks and shot maps; "for" is the first team's side."""

    teams: tuple[str, str]
    pitch: dict[str, float]  # [m] fields of `leagues.league.Pitch`
    heat: dict[str, np.ndarray]  # (16, 24) of "for", "against", "ball"
    players: dict[str, np.ndarray]  # (N, 3) of "for", "against": place times time [m s], time [s]
    passes: dict[str, np.ndarray]  # (N, N)
    shots: dict[str, list[tuple[str, float, float]]]  # outcome, x [m], y [m]

    def sides(self) -> list[tuple[str, str]]:
        """Return (side, team name) for the sides "for" and "against"."""
        return [("for", self.teams[0]), ("against", self.teams[1])]


@picture_maker
def draw_map(maps: Maps, kind: str) -> Any:
    """Draw one of KINDS: the "presence" of robots and ball, the "network" of completed passes, or "shots"."""
    plot, columns, height = KINDS[kind]
    drawn, axes = canvas(height, columns=columns)
    plot(drawn, axes, maps)
    return drawn


def draw_maps(maps: Maps, form: str) -> bytes:
    """Draw all maps as one picture on white, "png", "svg" or "pdf"; return its bytes."""
    import io

    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context(STYLE):
        heights = [height for _, _, height in KINDS.values()]
        drawn = Figure(figsize=(7.6, 1.19 * sum(heights)), layout="constrained")
        parts: Any = drawn.subfigures(3, 1, height_ratios=heights)
        for part, (plot, columns, _) in zip(parts, KINDS.values(), strict=True):
            plot(part, part.subplots(1, columns), maps)
        file = io.BytesIO()
        unstamped: Any = {"png": {"Software": ""}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}[form]
        drawn.savefig(file, format=form, metadata=unstamped)
    return file.getvalue()


def plot_presence(part: Any, axes: Sequence[Any], maps: Maps) -> None:
    """Draw heat maps of the share of time spent in each cell, for each team's robots and for the ball."""
    from matplotlib.patches import Patch

    for one, (name, title) in zip(axes, [*maps.sides(), ("ball", "ball")], strict=True):
        plot_heat_cells(one, maps.heat[name], maps.pitch)
        draw_pitch(one, maps.pitch, cut_team_name(title))
    shades = [
        Patch(facecolor=heat_colour(depth), label=f"{level:g}") for level, depth in zip(LEVELS, DEPTHS, strict=True)
    ]
    part.legend(handles=shades, loc="outside lower center", ncols=len(shades), handlelength=1.2, columnspacing=1.0,
                title="share of the time in a cell, from [%]", title_fontsize=9.0)  # fmt: skip


def plot_heat_cells(axes: Any, heat: np.ndarray, pitch: dict[str, float]) -> None:
    """Draw the cells of a heat map; cells of equal level share one path, which keeps the file small."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    shares = 100.0 * heat / max(heat.sum(), 1.0)
    rows, columns = heat.shape
    cell = np.array([pitch["length"] / columns, pitch["width"] / rows])
    corners = 0.5 * TILE * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]])
    levels = np.digitize(shares, LEVELS)
    for level, depth in enumerate(DEPTHS, 1):
        cells = np.argwhere(levels == level)[:, ::-1] + 0.5 - 0.5 * np.array([columns, rows])
        if len(cells):
            vertices = (cells[:, None] + corners) * cell
            codes = np.tile([Path.MOVETO, *[Path.LINETO] * 3, Path.CLOSEPOLY], len(cells))
            path = Path(vertices.reshape(-1, 2), codes)
            axes.add_patch(PathPatch(path, facecolor=heat_colour(depth), edgecolor="none", zorder=1))


def heat_colour(depth: float) -> str:
    """Return the colour of heat maps with an opacity `depth` of 0 to 1."""
    return f"{COLOURS[0]}{round(255 * depth):02x}"


def plot_network(part: Any, axes: Sequence[Any], maps: Maps) -> None:
    """Draw players at their mean positions, and arrows from passer to receiver, wider for more passes."""
    from matplotlib.patches import Circle

    for one, (side, team) in zip(axes, maps.sides(), strict=True):
        players, passes = maps.players[side], maps.passes[side]
        draw_pitch(one, maps.pitch, f"{cut_team_name(team)}: {count_in_words(int(passes.sum()), 'pass', 'es')}")
        present = np.flatnonzero(players[:, 2] > 0.0)
        true = players[present, :2] / players[present, 2:]
        size = BADGE * maps.pitch["length"]
        apart = APART * size * min(1.0, FEW / max(len(true), 1)) ** 0.5
        places = dict(zip(present.tolist(), spread_places(true, apart), strict=True))
        for (x, y), place in zip(true, places.values(), strict=True):
            one.plot([x, place[0]], [y, place[1]], color=DIM, linewidth=0.8, marker="o", markevery=[0], markersize=2)
        for sender, receiver in np.argwhere(passes > 0).tolist():
            if sender in places and receiver in places:
                share = passes[sender, receiver] / passes.max()
                draw_arrow(one, places[sender], places[receiver], size, share, f"{passes[sender, receiver]:g}")
        for number, place in places.items():
            one.add_patch(Circle(tuple(place), 0.5 * size, facecolor="#ffffff", edgecolor=INK, linewidth=1.0, zorder=5))
            one.text(*place, f"{number}", ha="center", va="center", fontsize=7.5, color=INK, zorder=6)


def draw_arrow(axes: Any, start: np.ndarray, end: np.ndarray, size: float, share: float, words: str) -> None:
    """Draw a curved arrow for passes, labelled by their number if there is room."""
    from matplotlib.patches import FancyArrowPatch

    way = end - start
    room = float(np.hypot(*way)) - 1.2 * size
    if room <= 0.0:
        return
    along = 0.6 * size * way / np.hypot(*way)
    axes.add_patch(FancyArrowPatch(
        tuple(start + along), tuple(end - along), arrowstyle="-|>", connectionstyle=f"arc3,rad={BEND}", shrinkA=0.0,
        shrinkB=0.0, mutation_scale=7.0, linewidth=0.7 + 2.2 * share, color=COLOURS[0], alpha=0.75, zorder=3,
    ))  # fmt: skip
    if room > 0.5 * size:
        top = start + 0.5 * way + 0.5 * BEND * np.array([way[1], -way[0]])  # where the arrow bends most
        behind = {"boxstyle": "round,pad=0.12", "facecolor": "#ffffff", "edgecolor": "none", "alpha": 0.9}
        axes.text(*top, words, fontsize=7.0, color=INK, zorder=4, ha="center", va="center", bbox=behind)


def plot_shots(part: Any, axes: Sequence[Any], maps: Maps) -> None:
    """Draw a marker at the position of each shot, with a symbol for its outcome."""
    for one, (side, team) in zip(axes, maps.sides(), strict=True):
        shots = maps.shots[side]
        draw_pitch(one, maps.pitch, f"{cut_team_name(team)}: {count_in_words(len(shots), 'shot')}")
        for outcome, (mark, size, colour) in MARKS.items():
            places = np.array([(x, y) for found, x, y in shots if found == outcome]).reshape(-1, 2)
            look = {"c": COLOURS[colour]} if mark == "x" else {"fc": COLOURS[colour] + "55", "ec": COLOURS[colour]}
            words = outcome.replace("_", " ")
            one.scatter(*places.T, marker=mark, s=size, zorder=3, linewidths=1.2, label=words, **look)
    part.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=len(MARKS))


KINDS: dict[str, tuple[Callable[..., None], int, float]] = {  # function, pitches in a row, [inch] of its height
    "presence": (plot_presence, 3, 2.25), "network": (plot_network, 2, 2.5), "shots": (plot_shots, 2, 2.7),
}  # fmt: skip


def draw_pitch(axes: Any, pitch: dict[str, float], title: str) -> None:
    """Draw the lines of a pitch and the goals behind them, with both axes in metres."""
    x, y, look = 0.5 * pitch["length"], 0.5 * pitch["width"], {"color": DIM, "linewidth": 0.9, "zorder": 2}
    axes.plot([-x, x, x, -x, -x], [-y, -y, y, y, -y], **look)
    axes.plot([0.0, 0.0], [-y, y], **look)
    angle = np.linspace(0.0, 2.0 * np.pi, 49)
    axes.plot(pitch["circle"] * np.cos(angle), pitch["circle"] * np.sin(angle), **look)
    boxes = [(pitch[f"{name}_depth"], 0.5 * pitch[f"{name}_width"]) for name in ("penalty", "goal_area")]
    for depth, half in [*boxes, (-pitch["goal_depth"], 0.5 * pitch["goal_width"])]:
        for sign in (-1.0, 1.0) if depth else ():
            inner = sign * (x - depth)
            axes.plot([sign * x, inner, inner, sign * x], [-half, -half, half, half], **look)
    room = pitch["goal_depth"] + 0.02 * pitch["length"]
    axes.set(xlim=(-x - room, x + room), ylim=(-1.04 * y, 1.04 * y), aspect="equal", xlabel="x [m]")
    axes.set_title(title, loc="center", fontsize=9.5)
    axes.spines[:].set_visible(False)
    axes.grid(visible=False)
    axes.locator_params(nbins=5)
    axes.tick_params(length=0)
    if axes.get_subplotspec().is_first_col():
        axes.set_ylabel("y [m]")
    else:
        axes.set_yticks([])


def cut_team_name(name: str) -> str:
    """Return a team's name, shortened to fit above a pitch."""
    return name if len(name) <= LONGEST else name[: LONGEST - 1] + "…"


def count_in_words(number: int, thing: str, plural: str = "s") -> str:
    """Return a number with its noun, in the plural unless the number is 1: "2 passes"."""
    return f"{number} {thing}{'' if number == 1 else plural}"


def spread_places(places: np.ndarray, distance: float) -> np.ndarray:
    """Move positions (N, 2) at least `distance` apart, mostly across the pitch, without random numbers."""
    moved = np.array(places, np.float64).reshape(-1, 2)
    if len(moved) < 2:
        return moved
    crowded = np.flatnonzero((np.hypot(*(moved[:, None] - moved).transpose(2, 0, 1)) < distance).sum(1) > 1)
    crowded = crowded[np.argsort(moved[crowded, 0], kind="stable")]  # along x they keep their order
    number = np.arange(len(crowded))
    moved[crowded] += distance * np.stack([0.01 * number, 0.4 * (-1.0) ** number], 1)
    for _ in range(ROUNDS):
        apart = moved[:, None] - moved
        far = np.hypot(*apart.transpose(2, 0, 1)) + np.eye(len(moved)) * distance
        short = np.maximum(distance - far, 0.0)
        if short.max() < 1e-3 * distance:
            break
        moved += 0.5 * (apart / far[..., None] * short[..., None]).sum(1)
    return moved
