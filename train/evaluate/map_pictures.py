"""Heat maps, pass networks and shot maps as one picture, of a result.json or of a replay; by matplotlib.

Three rows of two pitches, the first team left and the second right, each attacking to the right: where its robots are,
its players' mean places and passes, its shots. The ball's heat map stands below.
"""

from __future__ import annotations

import io
import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.replay import Replay
from soccer_env.settings import plain
from soccer_env.statistics.maps import maps_of
from soccer_env.statistics.records import CELLS_LONG, CELLS_WIDE, Outcome
from soccer_env.types import HOME, MAX_TEAM
from soccer_env.whole_files import read_plain, write_whole

KINDS = (".png", ".svg", ".pdf")
LARGEST = 1 << 26  # [bytes] of a result.json
MOST_SHOTS = 100_000
MARKS = {"goal": "*", "saved": "o", "blocked": "s", "off_target": "x"}  # told apart without colour
MEASURES = ("length", "width", "goal_width", "goal_depth", "penalty_depth", "penalty_width", "circle")


@dataclass(frozen=True)
class Maps:
    """What a picture shows: of two teams, the first one's side is "for"."""

    teams: tuple[str, str]
    pitch: dict[str, float]  # [m] MEASURES
    heat: dict[str, np.ndarray]  # (16, 24) of "for", "against", "ball"
    players: dict[str, np.ndarray]  # (N, 3) of "for", "against"
    passes: dict[str, np.ndarray]  # (N, N)
    shots: dict[str, list[tuple[str, float, float]]]  # outcome, x [m], y [m]


def export_maps(source: Path, out: Path) -> Path:
    """Draw the maps of a result.json or of a replay; ValueError if it holds none, ImportError without matplotlib."""
    try:
        import matplotlib
    except ImportError as error:
        raise ImportError('maps need matplotlib: pip install "soccer_env[plot]"') from error
    matplotlib.use("agg")
    maps = of_result(source) if source.suffix.lower() == ".json" else of_replay(source)
    write_whole(out, draw_maps(maps, out.suffix.lower()[1:]))
    return out


def of_replay(path: Path) -> Maps:
    """Return the maps of the first match of a replay, from home's side."""
    replay = Replay.read(path)
    for match in replay.play():
        last = match
    found = maps_of(last.statistics[0], HOME, last.settings.rows)
    return checked(found | {"pitch": plain(last.league.pitch)}, replay.teams)


def of_result(path: Path) -> Maps:
    """Return the maps of an evaluation from its result.json; ValueError for a file that holds none."""
    try:
        record = json.loads(read_plain(path, LARGEST))
        return checked(record["maps"], (str(record["home"])[:80], str(record["away"])[:80]))
    except FileNotFoundError:
        raise
    except Exception as error:  # a file of a stranger: anything can be missing or of another kind
        raise ValueError(f"{path} is not a result.json with maps: {error!r}"[:300]) from error


def checked(maps: dict[str, Any], teams: tuple[str, str]) -> Maps:
    """Return maps whose shapes and numbers can be drawn; ValueError for others."""
    heat = {name: array_of(maps[f"heat_{name}"], (CELLS_WIDE, CELLS_LONG)) for name in ("for", "against", "ball")}
    players, passes, shots = {}, {}, {}
    for side in ("for", "against"):
        count = len(maps[f"players_{side}"])
        if not 1 <= count <= MAX_TEAM:
            raise ValueError(f"a team of {count}")
        players[side] = array_of(maps[f"players_{side}"], (count, 3))
        passes[side] = array_of(maps[f"passes_{side}"], (count, count))
        shots[side] = [(str(shot[2]), float(shot[3]), float(shot[4])) for shot in maps[f"shots_{side}"][:MOST_SHOTS]]
        if not all(outcome in MARKS and np.isfinite([x, y]).all() for outcome, x, y in shots[side]):
            raise ValueError("a shot without a place or with an unknown outcome")
    pitch = {name: float(maps["pitch"][name]) for name in MEASURES}
    if not all(0.0 <= value <= 1000.0 for value in pitch.values()) or min(pitch["length"], pitch["width"]) <= 0.0:
        raise ValueError("a pitch that cannot be")
    return Maps(teams, pitch, heat, players, passes, shots)


def array_of(values: Any, shape: tuple[int, ...]) -> np.ndarray:
    """Return finite numbers of a shape; ValueError for anything else."""
    found = np.array(values, np.float64)
    if found.shape != shape or not np.isfinite(found).all():
        raise ValueError(f"numbers of shape {found.shape}, not finite {shape}")
    return found


def draw_maps(maps: Maps, kind: str) -> bytes:
    """Return the picture in a format of matplotlib's; it depends on the maps alone."""
    import matplotlib.pyplot as plt

    with plt.rc_context({"text.parse_math": False, "svg.hashsalt": "soccer_env", "font.size": 9}):
        canvas, axes = plt.subplots(4, 2, figsize=(9.6, 9.6), dpi=110, layout="constrained")
        for column, (side, team) in enumerate(zip(("for", "against"), maps.teams, strict=True)):
            top, middle, bottom = (axes[row][column] for row in range(3))
            draw_heat(canvas, top, maps, side, f"{team}: presence")
            draw_passes(middle, maps, side, f"{team}: mean places and completed passes")
            draw_shots(bottom, maps, side, f"{team}: shots")
        draw_heat(canvas, axes[3][0], maps, "ball", f"ball, {maps.teams[0]} attacks to the right")
        axes[3][1].axis("off")
        handles = [axes[3][1].scatter([], [], marker=mark, c="black", s=40, label=words(name))
                   for name, mark in MARKS.items()]  # fmt: skip
        axes[3][1].legend(handles=handles, title="shots", loc="center left")
        file = io.BytesIO()
        unstamped = {"png": {"Software": ""}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}[kind]
        canvas.savefig(file, format=kind, metadata=unstamped)
        plt.close(canvas)
    return file.getvalue()


def words(name: str) -> str:
    """Return a name in words."""
    return name.replace("_", " ")


def draw_pitch(axes: Any, maps: Maps, title: str) -> None:
    """Draw the lines of a pitch, goals outside it; both axes in metres."""
    pitch = maps.pitch
    x, y, line = 0.5 * pitch["length"], 0.5 * pitch["width"], {"color": "0.25", "linewidth": 1.0, "zorder": 2}
    axes.plot([-x, x, x, -x, -x], [-y, -y, y, y, -y], **line)
    axes.plot([0.0, 0.0], [-y, y], **line)
    angle = np.linspace(0.0, 2.0 * np.pi, 60)
    axes.plot(pitch["circle"] * np.cos(angle), pitch["circle"] * np.sin(angle), **line)
    for sign in (-1.0, 1.0):
        for depth, half in ((pitch["penalty_depth"], 0.5 * pitch["penalty_width"]),
                            (-pitch["goal_depth"], 0.5 * pitch["goal_width"])):  # fmt: skip
            inner = sign * (x - depth)
            axes.plot([sign * x, inner, inner, sign * x], [-half, -half, half, half], **line)
    room = pitch["goal_depth"] + 0.02 * pitch["length"]
    axes.set(xlim=(-x - room, x + room), ylim=(-1.04 * y, 1.04 * y), xlabel="x [m]", ylabel="y [m]", title=title)
    axes.set_aspect("equal")


def draw_heat(canvas: Any, axes: Any, maps: Maps, name: str, title: str) -> None:
    """Draw in which share of the looks a robot or the ball was in each cell."""
    heat, x, y = maps.heat[name], 0.5 * maps.pitch["length"], 0.5 * maps.pitch["width"]
    shares = 100.0 * heat / max(heat.sum(), 1.0)
    image = axes.imshow(shares, origin="lower", extent=(-x, x, -y, y), cmap="Greys", vmin=0.0)
    canvas.colorbar(image, ax=axes, label="share of time [%]", shrink=0.8)
    draw_pitch(axes, maps, title)


def draw_passes(axes: Any, maps: Maps, side: str, title: str) -> None:
    """Draw players at their mean places, and arrows from player to player, the wider the more passes."""
    players, passes = maps.players[side], maps.passes[side]
    draw_pitch(axes, maps, title)
    present = np.flatnonzero(players[:, 2] > 0.0)
    places = {int(n): players[n, :2] / players[n, 2] for n in present}
    most = max(passes.max(), 1.0)
    for sender, receiver in np.argwhere(passes > 0).tolist():
        if sender in places and receiver in places:
            count = passes[sender, receiver]
            style = {"arrowstyle": "-|>", "connectionstyle": "arc3,rad=0.15", "shrinkA": 8, "shrinkB": 8,
                     "linewidth": 0.6 + 3.0 * count / most, "color": "0.45"}  # fmt: skip
            axes.annotate("", xy=places[receiver], xytext=places[sender], arrowprops=style, zorder=3)
            middle = 0.5 * (places[sender] + places[receiver])
            axes.text(*middle, f"{count:g}", fontsize=7, zorder=5, ha="center", va="center",
                      bbox={"boxstyle": "round,pad=0.1", "fc": "white", "ec": "none", "alpha": 0.8})  # fmt: skip
    for number, (x, y) in places.items():
        axes.scatter(x, y, s=180, c="white", edgecolors="black", zorder=4)
        axes.text(x, y, f"{number}", ha="center", va="center", fontsize=8, zorder=6)


def draw_shots(axes: Any, maps: Maps, side: str, title: str) -> None:
    """Draw a mark for each shot where the ball was played."""
    shots = maps.shots[side]
    goals = sum(outcome == Outcome.GOAL.name.lower() for outcome, _, _ in shots)
    draw_pitch(axes, maps, f"{title}, {len(shots)}, of them {goals} goals")
    for outcome, mark in MARKS.items():
        places = [(x, y) for found, x, y in shots if found == outcome]
        if places:
            axes.scatter(*zip(*places, strict=True), marker=mark, c="black", s=36, alpha=0.7, zorder=3, linewidths=0.8)
