"""Heat maps, pass networks and shot maps of a result.json or a replay, drawn by `train.report.pitch_maps`; tables."""

import json
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.guards.whole_files import read_regular_file, write_atomically
from soccer_env.match.settings import to_plain_types
from soccer_env.replay import Replay
from soccer_env.statistics.maps import OUTCOMES, maps_of_team
from soccer_env.statistics.records import CELLS_LONG, CELLS_WIDE
from soccer_env.train.report import can_draw
from soccer_env.train.report.pitch_maps import MARKS, Maps, draw_maps
from soccer_env.types import HOME, MAX_TEAM

KINDS = (".png", ".svg", ".pdf")
LARGEST = 1 << 26  # [bytes] of a result.json
MOST_SHOTS = 100_000
MEASURES = ("length", "width", "goal_width", "goal_depth", "penalty_depth", "penalty_width", "circle",
            "goal_area_depth", "goal_area_width")  # fmt: skip


def export_maps(source: Path, out: Path) -> Path:
    """Draw the maps of a result.json or a replay; ValueError for a file without maps; needs matplotlib."""
    if not can_draw():
        raise ImportError('maps need matplotlib: pip install "soccer_env[plot]"')
    maps = maps_from_result(source) if source.suffix.lower() == ".json" else maps_from_replay(source)
    write_atomically(out, draw_maps(maps, out.suffix.lower()[1:]))
    return out


def maps_from_replay(path: Path) -> Maps:
    """Return the maps of the first match in a replay, seen from home's side."""
    replay = Replay.read(path)
    for match in replay.play():
        last = match
    maps = maps_of_team(last.statistics[0], HOME, last.settings.rows)
    return check_maps(maps | {"pitch": to_plain_types(last.league.pitch)}, replay.teams)


def maps_from_result(path: Path) -> Maps:
    """Return the maps of an evaluation from its result.json; ValueError for a file without maps."""
    try:
        record = json.loads(read_regular_file(path, LARGEST))
        return check_maps(record["maps"], (str(record["home"])[:80], str(record["away"])[:80]))
    except FileNotFoundError:
        raise
    except Exception as error:  # an untrusted file: anything can be missing or of the wrong type
        raise ValueError(f"{path} is not a result.json with maps: {error!r}"[:300]) from error


def check_maps(maps: dict[str, Any], teams: tuple[str, str]) -> Maps:
    """Return maps read from a file as Maps, after checks of shapes and numbers; ValueError for invalid maps."""
    heat = {name: checked_array(maps[f"heat_{name}"], (CELLS_WIDE, CELLS_LONG)) for name in ("for", "against", "ball")}
    players, passes, shots = {}, {}, {}
    for side in ("for", "against"):
        count = len(maps[f"players_{side}"])
        if not 1 <= count <= MAX_TEAM:
            raise ValueError(f"a team of {count}")
        players[side] = checked_array(maps[f"players_{side}"], (count, 3))
        passes[side] = checked_array(maps[f"passes_{side}"], (count, count))
        shots[side] = [(str(shot[2]), float(shot[3]), float(shot[4])) for shot in maps[f"shots_{side}"][:MOST_SHOTS]]
        if not all(outcome in MARKS and np.isfinite([x, y]).all() for outcome, x, y in shots[side]):
            raise ValueError("a shot without a place or with an unknown outcome")
    given = {"goal_area_depth": 0.0, "goal_area_width": 0.0} | maps["pitch"]
    pitch = {name: float(given[name]) for name in MEASURES}
    if not all(0.0 <= value <= 1000.0 for value in pitch.values()) or min(pitch["length"], pitch["width"]) <= 0.0:
        raise ValueError("a pitch that cannot be")
    return Maps(teams, pitch, heat, players, passes, shots)


def checked_array(values: Any, shape: tuple[int, ...]) -> np.ndarray:
    """Convert nested lists to an array of the given shape; ValueError unless all values are finite numbers."""
    array = np.array(values, np.float64)
    if array.shape != shape or not np.isfinite(array).all():
        raise ValueError(f"numbers of shape {array.shape}, not finite {shape}")
    return array


SIDES = ("for", "against")
THIRDS = ("in its own third", "in the middle third", "in the opponents' third")
MOST_PAIRS = 12  # of players, shown for both teams


def map_rows(maps: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return rows (name, first team, second team): shots by outcome, and the ball's and robots' time in each third."""
    rows: list[tuple[str, str, str]] = []
    for outcome in sorted(OUTCOMES, key=("goal", "saved", "blocked", "off_target").index):
        ours, theirs = (sum(shot[2] == outcome for shot in maps[f"shots_{side}"]) for side in SIDES)
        rows.append((f"shots: {outcome.replace('_', ' ')}", f"{ours}", f"{theirs}"))
    ball = np.array(maps["heat_ball"])
    layers = [(ball, ball[::-1, ::-1]), tuple(np.array(maps[f"heat_{side}"]) for side in SIDES)]
    for what, (first, second) in zip(("ball", "robots"), layers, strict=True):
        shares = zip(THIRDS, share_by_third(first), share_by_third(second), strict=True)
        rows += [(f"{what} {where}", f"{one:.0f} %", f"{other:.0f} %") for where, one, other in shares]
    return rows


def share_by_third(heat: np.ndarray) -> list[float]:
    """Return the share [%] of a heat map (16, 24) in each third of the pitch, from the own goal on."""
    total = max(int(heat.sum()), 1)
    return [100.0 * float(part.sum()) / total for part in np.split(heat, 3, axis=1)]


def pass_rows(maps: dict[str, Any]) -> list[tuple[str, str, str]]:
    """Return rows (pair, both teams' passes) of the most frequent pairs of passer and receiver, and of the total."""
    teams = [np.array(maps[f"passes_{side}"]) for side in SIDES]
    counts = {(a, b): [int(one[a, b]) if max(a, b) < len(one) else 0 for one in teams]
              for a, b in np.ndindex(*np.max([one.shape for one in teams], axis=0).tolist())}  # fmt: skip
    shown = sorted((pair for pair in counts if any(counts[pair])), key=lambda pair: (-sum(counts[pair]), pair))
    rows = [(f"{a} to {b}", *map(str, counts[a, b])) for a, b in shown[:MOST_PAIRS]]
    return [*rows, ("all", *(f"{one.sum()}" for one in teams))]  # type: ignore[list-item]
