"""Assign each robot of a match to a learner outside or to a team inside, and let the teams decide."""

import dataclasses
import hashlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.compiling.numba_parts import NumbaError
from soccer_env.geometry import clip
from soccer_env.leagues.league import League
from soccer_env.match.settings import Settings
from soccer_env.observations import entry_names
from soccer_env.teams import CompiledTeam, Lineup, ObservingTeam, Team, TeamRandom, View, make_team, result_name
from soccer_env.teams.function_teams import FunctionTeam
from soccer_env.types import AWAY, COMMAND, HOME

LONG = 4096  # characters of a team's settings in a save; longer ones are hashed
WriteObservations = Callable[[np.ndarray, str, np.ndarray, int, int], None]  # into (M, R, n), of what, rows, slice
NEEDED_SENSES = {"truth": "ideal", "percepts": "sensors"}  # by a team's observation


class TeamArrays(NamedTuple):
    """The arrays that compiled teams read, and the commands that they write."""

    beliefs: np.ndarray  # (M, R) BELIEF
    tracks: np.ndarray  # (M, R, slots) TRACK
    noise: np.ndarray  # (M, R, streams) the robots' own noise
    commands: np.ndarray  # (M, R) COMMAND
    constants: np.ndarray  # (1,) CONSTANTS


@dataclass
class Squad:
    """A team, the robots of one side that it plays, and its memory (M, P) in M matches."""

    team: Team
    players: np.ndarray  # (P,) rows
    memory: np.ndarray
    observations: np.ndarray  # (M, R, n) of a team that decides from observations, else (M, R, 0)
    name: str  # in the lineup, else in results, see `teams.registry.called`
    settings: Any = None  # of a compiled team, in this league: as its kernel reads them
    lineup: Lineup | None = None  # of which the team is a part
    place: int = 0  # of the team in the lineup
    plays: np.ndarray | None = None  # (M,) flags of a team in a lineup: it plays this match now
    _runs: dict[tuple[int, int], tuple[bytes, list[tuple[int, int]]]] = dataclasses.field(default_factory=dict)

    def describe(self) -> list[Any]:
        """Return name, settings and rows of the team; a save can be loaded only where they are equal."""
        settings = getattr(self.team, "settings", None)
        text = settings.tobytes().hex() if isinstance(settings, np.ndarray) else ""
        if len(text) > LONG:
            text = hashlib.sha256(text.encode()).hexdigest()
        return [self.name, text, self.players.tolist()]

    @property
    def compiled(self) -> bool:
        """Tell whether the team is compiled, so that it runs without Python."""
        return isinstance(self.team, CompiledTeam)

    @property
    def reads_beliefs(self) -> bool:
        """Tell whether the team's kernel reads beliefs; other kernels are blind, or read observations."""
        team = self.team
        if isinstance(team, ObservingTeam):
            return team.skilled
        return isinstance(team, CompiledTeam) and not team.blind

    def runs(self, first: int, last: int) -> list[tuple[int, int]]:
        """Split a slice of matches into the contiguous ranges (first, last) that the team plays in."""
        if self.plays is None:
            return [(first, last)]
        plays = self.plays[first:last].tobytes()
        if self._runs.get((first, last), (b"",))[0] != plays:  # the playing team may change with each episode
            steps = np.flatnonzero(np.diff(self.plays[first:last], prepend=False, append=False)) + first
            self._runs[first, last] = plays, list(zip(steps[::2].tolist(), steps[1::2].tolist(), strict=True))
        return self._runs[first, last][1]


def assign_teams(agents: list[str], home: int, opponents: Any, teammates: Any, controllers: Any) -> dict[str, Any]:
    """Return {agent id: team} from the arguments; `teammates` play all home robots except the last one."""
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


def make_squads(agents: list[str], who: dict[str, Any], settings: Settings, matches: int) -> list[Squad]:
    """Return the squads: one for each distinct team on each side, or one for each team of a lineup."""
    squads: list[Squad] = []
    rows_by_team: dict[tuple[str, Any], list[int]] = {}
    for row, agent in enumerate(agents):
        if agent in who:
            team = who[agent]
            key = (agent.split("_")[0], team if isinstance(team, str) else id(team))
            rows_by_team.setdefault(key, []).append(row)
    for rows in rows_by_team.values():
        chosen, players = who[agents[rows[0]]], np.array(rows, np.int64)
        if not isinstance(chosen, Lineup):
            squads.append(make_squad(make_team(chosen), players, settings, matches, len(agents)))
            squads[-1].name = result_name(chosen, squads[-1].team)
            continue
        squads += [make_lineup_squad(chosen, place, players, settings, matches) for place in range(len(chosen.teams))]
    return squads


def make_lineup_squad(lineup: Lineup, place: int, players: np.ndarray, settings: Settings, matches: int) -> Squad:
    """Return the squad of one team of a lineup, which plays nowhere yet; ValueError as by `make_squad`."""
    squad = make_squad(lineup.teams[place], players, settings, matches, len(settings.agents))
    squad.name, squad.lineup, squad.place = lineup.names[place], lineup, place
    squad.plays = np.zeros(matches, bool)
    return squad


def with_added_teams(squads: list[Squad], settings: Settings, matches: int) -> list[Squad]:
    """Return the squads, and behind those of each lineup the squads of teams that were added to it since."""
    found: list[Squad] = []
    for index, squad in enumerate(squads):
        found.append(squad)
        lineup, following = squad.lineup, squads[index + 1] if index + 1 < len(squads) else None
        if lineup is not None and (following is None or following.place <= squad.place):  # the lineup's last squad
            added = range(squad.place + 1, len(lineup.teams))
            found += [make_lineup_squad(lineup, place, squad.players, settings, matches) for place in added]
    return found


def make_squad(team: Any, players: np.ndarray, settings: Settings, matches: int, robots: int) -> Squad:
    """Return the squad of a team that plays `players`; ValueError if the league or the senses do not suit the team."""
    check = getattr(team, "check_league", None)
    if check is not None:
        check(settings.league)
    observed = 0
    if isinstance(team, (ObservingTeam, FunctionTeam)):
        senses = settings.senses[int(players[0] >= settings.rows[0])]
        needed = NEEDED_SENSES.get(team.observe, senses) if isinstance(team.observe, str) else senses
        if senses != needed:
            raise ValueError(
                f"team {team.name!r} observes {team.observe}: it needs senses={needed!r}, got {senses!r} "
                f"(a command takes --senses {needed}; a policy trained with observe='belief' plays by either)"
            )
        observed = len(entry_names(settings.league, team.observe))
    memory = np.zeros((matches, len(players)), check_memory(team))
    numbers = team.settings_in(settings.league) if isinstance(team, CompiledTeam) else None
    return Squad(team, players, memory, np.zeros((matches, robots, observed), np.float32), team.name, numbers)


def choose_teams(squads: list[Squad], home: int, m: int, seed: int, episode: int) -> None:
    """Choose which team of each lineup plays the next episode of match m; home has the first `home` rows."""
    for squad in squads:
        if squad.lineup is not None and squad.plays is not None:
            side = AWAY if squad.players[0] >= home else HOME
            squad.plays[m] = squad.lineup.choose(seed, episode, side) == squad.place


def check_memory(team: Team) -> np.dtype:
    """Return the dtype of a team's memory; ValueError for a dtype that cannot be saved."""
    try:
        dtype = np.dtype(team.memory_dtype)
    except TypeError as error:
        raise ValueError(f"memory_dtype of team {team.name!r} is no dtype: {team.memory_dtype!r}") from error
    if dtype.hasobject or (dtype.itemsize == 0 and dtype.names != ()):
        raise ValueError(f"memory_dtype of team {team.name!r} must hold plain numbers, got {dtype}")
    return dtype


@compiled
def clip_commands(commands, players, first, last):
    """Clip the commands of `players` to [-1, 1]; return the first (m, r) with a number not finite, or (-1, -1)."""
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


def cannot_compile_message(team: CompiledTeam, error: Exception) -> str:
    """Return a one-line message that says why a team's kernel cannot be compiled, such as a missing record field."""
    if isinstance(error, KeyError):
        why = f"it reads {error} of a record that has no such field; skills read the numbers of skills.skill_settings()"
    else:
        lines = [line.strip() for line in str(error).splitlines() if line.strip()]
        why = next((line for line in lines if not line.startswith("Failed in")), "numba does not say why")
    return f"team {team.name!r} cannot be compiled: {why}"


def run_compiled(squad: Squad, arrays: TeamArrays, write: WriteObservations, first: int, last: int) -> None:
    """Let a compiled team decide in a slice of matches; ValueError for a command that is not finite."""
    team: Any = squad.team
    runs = squad.runs(first, last)
    if not runs:
        return
    beliefs, tracks, noise, commands, k = arrays
    rows = squad.players
    for run in runs:
        seen: tuple[np.ndarray, ...] = (beliefs, tracks, squad.memory, noise)
        if isinstance(team, ObservingTeam):
            if not squad.memory["wait"][slice(*run)].all():
                write(squad.observations, team.observe, rows, *run)
            seen = (squad.observations, *seen) if team.skilled else (squad.observations, squad.memory)
        try:
            team.kernel(*seen, commands, rows, k, squad.settings, *run)
        except (KeyError, NumbaError) as error:
            raise ValueError(cannot_compile_message(team, error)) from error
    m, r = clip_commands(commands, rows, first, last)
    if m >= 0:
        command = commands[m, r].item()
        for name in COMMAND.names or ():
            commands[name][m, r] = 0.0
        raise ValueError(f"team {team.name!r} gave robot {r} of match {m} a command that is not finite: {command}")


def run_python(squad: Squad, league: League, beliefs: np.ndarray, tracks: np.ndarray, robots: np.ndarray) -> None:
    """Let a Python team decide in its matches; for invalid commands or memory raise ValueError and change nothing."""
    matches = np.arange(len(robots)) if squad.plays is None else np.flatnonzero(squad.plays)
    if not len(matches):
        return
    at, players = np.ix_(matches, squad.players), squad.players
    view = View(league, beliefs[at], tracks[at])
    memory, states = squad.memory[matches], robots["noise"][matches]
    commands = checked_commands(
        squad.team.name, squad.team.act(view, memory, TeamRandom(states, players)), view.beliefs.shape
    )
    if memory.shape != squad.memory[matches].shape:
        raise ValueError(f"team {squad.team.name!r} gave its memory the shape {memory.shape}, not {view.beliefs.shape}")
    squad.memory[matches], robots["noise"][matches] = memory, states
    for index, name in enumerate(COMMAND.names or ()):
        column = commands[..., index] if index < commands.shape[-1] else (-1.0 if name == "head" else 0.0)
        robots["command"][name][at] = column


def checked_commands(name: str, returned: Any, shape: tuple[int, ...]) -> np.ndarray:
    """Return the commands (M, P, 4 or 7) of a Python team, clipped; ValueError for a wrong shape or number."""
    commands = np.asarray(returned, np.float64)
    if commands.shape not in ((*shape, 4), (*shape, 7)):
        raise ValueError(f"team {name!r} returned commands of shape {commands.shape}, not {shape} x 4 or 7")
    if not np.isfinite(commands).all():
        raise ValueError(f"team {name!r} returned a command that is not finite")
    return np.clip(commands, -1.0, 1.0)


def playing_team_names(squads: list[Squad], row: int, matches: int) -> np.ndarray:
    """Return the name of the team that now plays a robot (row) in each match, (M,) objects; "" for a learner."""
    names = np.full(matches, "", object)
    for squad in squads:
        if row in squad.players:
            names[slice(None) if squad.plays is None else squad.plays] = squad.name
    return names
