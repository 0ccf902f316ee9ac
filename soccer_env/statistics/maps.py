"""Heat maps, pass networks and shot maps: counted step by step, and read from the statistics record.

A team's places are in the frame in which it attacks +x, in either half: turned by 180 degrees where it attacks -x.

`k`: the league's constants.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import attack_direction
from soccer_env.statistics.records import CELLS_LONG, CELLS_WIDE, SHOTS, Outcome
from soccer_env.types import HOME

BALL = 2  # layer of the heat map, after home's and away's robots
OUTCOMES = tuple(outcome.name.lower() for outcome in Outcome)
MAP_TEXTS = {  # of what `maps_of_team` returns; places are in the frame in which the team of the map attacks +x
    "heat_for, _against": "How often robots of the team were in each cell, at every fourth control step in play: 16 "
    "rows from the right touchline to the left one, 24 columns from the own goal line on.",
    "heat_ball": "How often the ball was in each cell, in the frame of this team.",
    "players_for, _against": "Of each player its place times its time in play [m s], x and y, and that time [s].",
    "passes_for, _against": "Pass network: completed passes from each player (row) to each mate (column).",
    "shots_for, _against": "Shot map, the first 64 of a match: control step, number of the player, outcome, and where "
    "the ball was played, x and y [m].",
    "outcome": "What became of a shot. goal: it went in. saved: on target, and the opponents' goalkeeper touched it "
    "first. blocked: another robot touched it first. off_target: anything else. kloppy: GOAL, SAVED, BLOCKED, "
    "OFF_TARGET; Common Data Format: successful, saved, blocked, wide.",
}


@compiled
def note_place(thing, layer, direction, k, maps):
    """Count the position of a robot or the ball in its cell of the heat map; off the pitch, in the nearest cell."""
    along = int((direction * thing.x / k.pitch_length + 0.5) * CELLS_LONG)
    across = int((direction * thing.y / k.pitch_width + 0.5) * CELLS_WIDE)
    along, across = min(max(along, 0), CELLS_LONG - 1), min(max(across, 0), CELLS_WIDE - 1)
    maps.heat[layer, across, along] += 1


@compiled
def note_shot(match, row, team, outcome, tally, trail):
    """Record a shot of a robot (row) with the position where it played the ball, if there is room left."""
    maps = tally.maps
    if maps.shots_kept >= SHOTS:
        return
    trail.shot = maps.shots_kept
    maps.shots_kept += 1
    shot, direction = maps.shots[trail.shot], attack_direction(match, team)
    shot.step, shot.row, shot.team, shot.outcome = match.step, row, team, outcome
    shot.place[0], shot.place[1] = direction * trail.played_x, direction * trail.played_y


def maps_of_team(record: Any, team: int, rows: tuple[int, int]) -> dict[str, Any]:
    """Return the maps of one match (a STATISTICS record), seen from a team's side, as plain lists to be added.

    rows: robots of home and of away in the record. Heat maps have shape (16, 24), passes (players, players), players
    (players, 3); MAP_TEXTS says what each map holds.
    """
    maps = record["maps"]
    ball = maps["heat"][BALL]
    result: dict[str, Any] = {"heat_ball": (ball if team == HOME else ball[::-1, ::-1]).tolist()}
    for side, of in (("for", team), ("against", 1 - team)):
        first, last = (0, rows[0]) if of == HOME else (rows[0], sum(rows))
        result[f"heat_{side}"] = maps["heat"][of].tolist()
        result[f"passes_{side}"] = maps["passes"][first:last, first:last].tolist()
        result[f"players_{side}"] = np.round(maps["places"][first:last], 6).tolist()
        shots = maps["shots"][: maps["shots_kept"]]
        result[f"shots_{side}"] = [
            [int(shot["step"]), int(shot["row"]) - first, OUTCOMES[shot["outcome"]],
             *(round(float(value), 4) for value in shot["place"])]
            for shot in shots[shots["team"] == of]
        ]  # fmt: skip
    return result


def sum_maps(maps: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return the sums of the maps of several matches, all seen from the side of one team."""
    total: dict[str, Any] = {}
    for name in maps[0] if maps else ():
        if name.startswith("shots"):
            total[name] = [shot for one in maps for shot in one[name]]
        else:
            total[name] = np.sum([one[name] for one in maps], axis=0).tolist()
    return total
