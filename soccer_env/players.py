"""Who plays which robot of a match: learners from outside, or teams inside."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.geometry import clip
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

    def describe(self) -> list[Any]:
        """Return who plays whom: what a save has to agree with."""
        settings = getattr(self.team, "settings", None)
        told = settings.tobytes().hex() if isinstance(settings, np.ndarray) else ""
        return [self.team.name, told, self.players.tolist()]

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
        memory = np.zeros((matches, len(rows)), check_memory(team))
        squads.append(Squad(team, np.array(rows, np.int64), memory))
    return squads


def check_memory(team: Team) -> np.dtype:
    """Return the dtype of a team's memory; ValueError if a match cannot save it."""
    try:
        dtype = np.dtype(team.memory_dtype)
    except TypeError as error:
        raise ValueError(f"memory_dtype of team {team.name!r} is no dtype: {team.memory_dtype!r}") from error
    if dtype.hasobject or (dtype.itemsize == 0 and dtype.names != ()):
        raise ValueError(f"memory_dtype of team {team.name!r} must hold plain numbers, got {dtype}")
    return dtype


@compiled
def believe_slice(matches, balls, robots, beliefs, tracks, constants, players, first, last):
    """Fill the beliefs of some robots with the truth, in a slice of matches."""
    rows, squares = np.empty(MAX_TEAM, np.int64), np.empty(MAX_TEAM)
    for m in range(first, last):
        for r in players:
            believe_truth(matches[m], balls[m], robots[m], beliefs[m], tracks[m, r], constants[0], r, rows, squares)


@compiled
def clip_commands(commands, players, first, last):
    """Clip the commands of some robots into [-1, 1]; return the first (m, r) that is not finite, or (-1, -1)."""
    for m in range(first, last):
        for r in players:
            command = commands[m, r]
            total = command.forward + command.left + command.turn + command.kick
            total += command.head + command.pan + command.tilt
            if total - total != 0.0:
                return m, r
            command.forward, command.left = clip(command.forward, -1.0, 1.0), clip(command.left, -1.0, 1.0)
            command.turn, command.kick = clip(command.turn, -1.0, 1.0), clip(command.kick, -1.0, 1.0)
            command.head, command.pan = clip(command.head, -1.0, 1.0), clip(command.pan, -1.0, 1.0)
            command.tilt = clip(command.tilt, -1.0, 1.0)
    return -1, -1


def run_kernel(
    squad: Squad,
    beliefs: np.ndarray,
    tracks: np.ndarray,
    robots: np.ndarray,
    constants: np.ndarray,
    first: int,
    last: int,
) -> None:
    """Let a compiled team decide in a slice of matches; ValueError if a command is not finite."""
    team: Any = squad.team
    commands = robots["command"]
    team.kernel(
        beliefs, tracks, squad.memory, robots["noise"], commands, squad.players, constants, team.settings, first, last
    )
    m, r = clip_commands(commands, squad.players, first, last)
    if m >= 0:
        command = commands[m, r].item()
        for name in COMMAND.names or ():
            commands[name][m, r] = 0.0
        raise ValueError(f"team {team.name!r} gave robot {r} of match {m} a command that is not finite: {command}")


def run_python(squad: Squad, league: League, beliefs: np.ndarray, tracks: np.ndarray, robots: np.ndarray) -> None:
    """Let a Python team decide in all matches; ValueError, and nothing changed, if it returns nonsense."""
    view = View(league, beliefs[:, squad.players], tracks[:, squad.players])
    memory, states = squad.memory.copy(), robots["noise"].copy()
    commands = np.asarray(squad.team.act(view, memory, TeamRandom(states, squad.players)), np.float64)
    shape = view.beliefs.shape
    if commands.shape not in ((*shape, 4), (*shape, 7)):
        raise ValueError(f"team {squad.team.name!r} returned commands of shape {commands.shape}, not {shape} x 4 or 7")
    if not np.isfinite(commands).all():
        raise ValueError(f"team {squad.team.name!r} returned a command that is not finite")
    if memory.shape != squad.memory.shape:
        raise ValueError(f"team {squad.team.name!r} gave its memory the shape {memory.shape}, not {squad.memory.shape}")
    squad.memory[...], robots["noise"][...] = memory, states
    commands = np.clip(commands, -1.0, 1.0)
    for index, name in enumerate(COMMAND.names or ()):
        column = commands[..., index] if index < commands.shape[-1] else (-1.0 if name == "head" else 0.0)
        robots["command"][name][:, squad.players] = column


def run_python_teams(squads: list[Squad], league: League, field: Any) -> None:
    """Let teams without a kernel decide, in all matches of a Field at once."""
    for squad in squads:
        if not squad.compiled:
            field.believe_truth(squad.players, 0, len(field.matches))
            beliefs, tracks = field.minds(squad.players)
            run_python(squad, league, beliefs, tracks, field.robots)


def empty_beliefs(matches: int, robots: int, league: League) -> tuple[np.ndarray, np.ndarray]:
    """Return beliefs (M, R) and tracks (M, R, slots)."""
    slots = league.slots.teammates + league.slots.opponents
    return np.zeros((matches, robots), BELIEF), np.zeros((matches, robots, slots), TRACK)
