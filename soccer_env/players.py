"""Who plays which robot of a match: learners from outside, or teams inside."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.leagues.league import League
from soccer_env.perception.ideal import believe_truth
from soccer_env.teams import CompiledTeam, Team, TeamRandom, View, make_team
from soccer_env.types import BELIEF, COMMAND, MAX_TEAM, TRACK


@dataclass
class Squad:
    """A team and the robots of one side that it plays, with its memory (M, P)."""

    team: Team
    players: np.ndarray  # (P,) rows
    memory: np.ndarray

    @property
    def compiled(self) -> bool:
        """Tell whether the team runs without Python."""
        return isinstance(self.team, CompiledTeam)


def assign(agents: list[str], home: int, opponents: Any, teammates: Any, controllers: Any) -> dict[str, Any]:
    """Return agent id -> team for the agents that a team plays; team-mates leave home's last robot that plays.

    `controllers` maps agent ids, or "home" and "away", to teams.
    """
    who: dict[str, Any] = {}
    sides = {side: [agent for agent in agents if agent.startswith(side)] for side in ("home", "away")}
    if opponents is not None:
        who.update(dict.fromkeys(sides["away"], opponents))
    if teammates is not None:
        learner = sides["home"][home - 1]
        who.update({agent: teammates for agent in sides["home"] if agent != learner})
    if controllers is not None and not isinstance(controllers, Mapping):
        raise ValueError(f"controllers must map agents or sides to teams, got {controllers!r}")
    for name, team in sorted((controllers or {}).items(), key=lambda item: item[0] not in sides):
        for agent in sides.get(name, [name]):
            if agent not in agents:
                raise ValueError(f"unknown agent {agent!r} in controllers; known: {', '.join(agents)}, home, away")
            who[agent] = team
    return {agent: team for agent, team in who.items() if team is not None}


def make_squads(agents: list[str], who: dict[str, Any], league: League, matches: int) -> list[Squad]:
    """Return the squads: one for each distinct team on each side."""
    squads: list[Squad] = []
    made: dict[tuple[str, Any], list[int]] = {}
    for row, agent in enumerate(agents):
        if agent in who:
            team = who[agent]
            key = (agent.split("_")[0], team if isinstance(team, str) else id(team))
            made.setdefault(key, []).append(row)
    for rows in made.values():
        team = make_team(who[agents[rows[0]]])
        check = getattr(team, "check_league", None)
        if check is not None:
            check(league)
        memory = np.zeros((matches, len(rows)), team.memory_dtype)
        squads.append(Squad(team, np.array(rows, np.int64), memory))
    return squads


@compiled
def believe_slice(matches, balls, robots, beliefs, tracks, constants, players, first, last):
    """Fill the beliefs of some robots with the truth, in a slice of matches."""
    rows, squares = np.empty(MAX_TEAM, np.int64), np.empty(MAX_TEAM)
    for m in range(first, last):
        for r in players:
            believe_truth(matches[m], balls[m], robots[m], beliefs[m], tracks[m, r], constants[0], r, rows, squares)


def run_kernel(
    squad: Squad,
    beliefs: np.ndarray,
    tracks: np.ndarray,
    robots: np.ndarray,
    constants: np.ndarray,
    first: int,
    last: int,
) -> None:
    """Let a compiled team decide in a slice of matches."""
    team: Any = squad.team
    team.kernel(
        beliefs,
        tracks,
        squad.memory,
        robots["noise"],
        robots["command"],
        squad.players,
        constants,
        team.settings,
        first,
        last,
    )


def run_python(squad: Squad, league: League, beliefs: np.ndarray, tracks: np.ndarray, robots: np.ndarray) -> None:
    """Let a Python team decide in all matches; ValueError if it returns nonsense."""
    view = View(league, beliefs[:, squad.players], tracks[:, squad.players])
    rng = TeamRandom(robots["noise"], squad.players)
    commands = np.asarray(squad.team.act(view, squad.memory, rng), np.float64)
    shape = view.beliefs.shape
    if commands.shape not in ((*shape, 4), (*shape, 7)):
        raise ValueError(f"team {squad.team.name!r} returned commands of shape {commands.shape}, not {shape} x 4 or 7")
    if not np.isfinite(commands).all():
        raise ValueError(f"team {squad.team.name!r} returned a command that is not finite")
    commands = np.clip(commands, -1.0, 1.0)
    for index, name in enumerate(COMMAND.names or ()):
        column = commands[..., index] if index < commands.shape[-1] else (-1.0 if name == "head" else 0.0)
        robots["command"][name][:, squad.players] = column


def empty_beliefs(matches: int, robots: int, league: League) -> tuple[np.ndarray, np.ndarray]:
    """Return beliefs (M, R) and tracks (M, R, slots)."""
    slots = league.slots.teammates + league.slots.opponents
    return np.zeros((matches, robots), BELIEF), np.zeros((matches, robots, slots), TRACK)
