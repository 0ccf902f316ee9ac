"""Nested infos in words, frames and windows, and checks of arguments, for all APIs of a match."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, get_args

import numpy as np

from soccer_env.api.opponents import opponents_of
from soccer_env.guards.checking import check_choice, check_names, raise_not_allowed
from soccer_env.match import Match
from soccer_env.match.arguments import InfoKind
from soccer_env.statistics.figures import flatten_statistics
from soccer_env.statistics.maps import maps_of_team
from soccer_env.types import AWAY, HOME, QUIET, ROBOT_EVENTS, Phase

RENDER_MODES = ("rgb_array", "human")
OPTIONS = ("match_seed", "opponents", "home", "away", "scene")  # of reset
IGNORED_OPTION = "options"  # PettingZoo's parallel_api_test passes it to every env
TEAMS = ("home", "away")
PHASES = tuple(phase.name.lower().replace("_", "-") for phase in Phase)
DRILL = ("open", "success", "failure")  # at 0, 1 and -1
WORDS: dict[str, Sequence[str]] = {  # meanings of the codes of events; all other events are flags
    "goal": TEAMS, "restart": PHASES, "restart_team": TEAMS, "touch_team": TEAMS, "drill": DRILL,
}  # fmt: skip
NO_EVENTS = ("ball_x", "ball_y")  # fields of the record that are always filled
FINAL_RECORDS = ("matches", "robots", "events", "robot_events", "terms")  # of `match.final`, in the order of `of`
Infos = dict[str, dict[str, Any]]


class NestedReport:
    """Describe in words what happened in a step of a match, for the infos of some robots (rows)."""

    def __init__(self, match: Match, rows: np.ndarray) -> None:
        self.words = {**WORDS, "scorer": match.agents}
        self._events = [
            (index, name, int(QUIET[name]), self.words.get(name))
            for index, name in enumerate(QUIET.dtype.names or ())
            if name not in NO_EVENTS
        ]
        self._robots = [(match.agents[row], int(row), team_of_agent(match.agents[row])) for row in rows]
        self._robot_events = ROBOT_EVENTS.names or ()
        self._robot_quiet = (0,) * len(self._robot_events)
        self.turn_to(match)

    def turn_to(self, match: Match) -> None:
        """Store the opponents at the start of an episode; `match` may be a new Match with the same robots."""
        self._match = match
        self.opponents = opponents_of(match, 0), opponents_of(match, 1)  # of each team, by match

    def infos(self) -> Infos:
        """Return the infos of the first match by agent, with statistics at the end of an episode."""
        match = self._match
        infos = self.of(0, match.matches[0], match.robots[0], match.events[0], match.robot_events[0], match.terms[0])
        return self.add_statistics(infos, match.statistics[0]) if match.terminated[0] or match.truncated[0] else infos

    def last(self, index: int) -> Infos:
        """Return the last infos of an ended episode by agent; `index` is its row in `match.final`."""
        final = self._match.final
        infos = self.of(int(self._match.ended[index]), *(final[name][index] for name in FINAL_RECORDS))
        return self.add_statistics(infos, final["statistics"][index])

    def add_statistics(self, infos: Infos, statistics: Any) -> Infos:
        """Add the statistics and maps of the episode to the infos of its agents, each from its team's side."""
        maps = [maps_of_team(statistics, team, self._match.settings.rows) for team in (HOME, AWAY)]
        for agent, _, team in self._robots:
            infos[agent]["statistics"] = flatten_statistics(statistics, team)
            infos[agent]["maps"] = maps[team]
        return infos

    def of(
        self, m: int, match: Any, robots: np.ndarray, events: Any, robot_events: np.ndarray, terms: np.ndarray
    ) -> Infos:
        """Return the infos of each agent, made from the records of match m."""
        happened = dict(self._say(events.item()))
        home, away = match["score"].tolist()
        scores, phase = ((home, away), (away, home)), PHASES[match["phase"]]
        active = robots["active"].tolist()
        own = robot_events.tolist()
        shares = terms.tolist()
        infos = {}
        for agent, row, team in self._robots:
            mine = dict(happened)
            if own[row] != self._robot_quiet:
                mine.update((name, True) for name, flag in zip(self._robot_events, own[row], strict=True) if flag)
            infos[agent] = {
                "active": active[row] == 1,
                "events": mine,
                "rewards": dict(zip(self._match.term_names, shares[row], strict=True)),
                "score": scores[team],
                "phase": phase,
                "opponent": self.opponents[team][m],
            }
        return infos

    def _say(self, values: tuple[Any, ...]) -> Iterator[tuple[str, Any]]:
        """Yield name and meaning of each event that happened."""
        for index, name, quiet, words in self._events:
            if values[index] != quiet:
                yield name, True if words is None else words[values[index]]


def team_of_agent(agent: str) -> int:
    """Return the team of an agent: HOME or AWAY."""
    return HOME if agent.startswith("home") else AWAY


def check_infos_kind(infos: InfoKind | bool) -> InfoKind:
    """Return the kind of infos; ValueError names the known kinds."""
    if isinstance(infos, bool):
        return "flat" if infos else "none"
    kind: InfoKind = check_choice("infos", infos, get_args(InfoKind))
    return kind


class MatchScreen:
    """Frames of a Match, and a window for its first match; pygame is imported when the first frame is drawn.

    `overlays`, as in `render.overlays.flags.flags_of`, lie over frames of the first match; ValueError for unknown ones.
    """

    def __init__(self, match: Match, overlays: Any = None) -> None:
        self._match, self.overlays = match, None
        if overlays is not None:
            from soccer_env.render.overlays.flags import parse_flags

            self.overlays = parse_flags(overlays)
        self.fps = match.league.control_rate / match.settings.action_repeat  # [1/s] steps, in real time
        self._title = teams_title(match)
        self._picture: Any = None
        self._window: Any = None
        self._onlooker: Any = None

    def turn_to(self, match: Match) -> None:
        """Show another match of the same league from now on."""
        self._match, self._title, self._onlooker = match, teams_title(match), None

    def frame(self, m: int = 0) -> np.ndarray:
        """Return a frame (H, W, 3) uint8 of match m."""
        if self._picture is None:
            from soccer_env.render import Picture

            self._picture = Picture(self._match.league)
        match, over = self._match, self._over() if m == 0 else []
        frame: np.ndarray = self._picture.draw(
            match.matches[m], match.balls[m], match.robots[m], title=self._title, overlays=over
        )
        return frame

    def _over(self) -> list[Any]:
        """Return the overlays of a frame of the first match."""
        if self.overlays is None:
            return []
        if self._onlooker is None:
            from soccer_env.render.overlays.onlooker import Onlooker

            self._onlooker = Onlooker(self._match, self.overlays)
        overlays: list[Any] = self._onlooker.see(self._match, self._picture.width)
        return overlays

    def show(self) -> None:
        """Show a frame of the first match in real time; do nothing once the user has closed the window."""
        if self._window is None:
            from soccer_env.render import Window

            self._window = Window("soccer_env", self.fps)
        if not self._window.closed_by_user:
            self._window.show(self.frame())

    def close(self) -> None:
        """Close the window, if there is one."""
        if self._window is not None:
            self._window.close()


def teams_title(match: Match) -> tuple[str, str] | None:
    """Return the names of the teams home and away, or None if no team plays."""
    if not match.squads:
        return None
    names: tuple[list[str], list[str]] = ([], [])
    for team, first, last in ((0, 0, match.settings.rows[0]), (1, match.settings.rows[0], len(match.agents))):
        names[team].extend(["learner"] * bool(match.learns[first:last].any()))
        names[team].extend(squad.name for squad in match.squads if first <= squad.players[0] < last)
    return " + ".join(dict.fromkeys(names[0])), " + ".join(dict.fromkeys(names[1]))


def check_render_mode(mode: str | None, modes: tuple[str, ...] = RENDER_MODES) -> str | None:
    """Return the render mode; ValueError names the known modes."""
    return None if mode is None else check_choice("render_mode", mode, modes)


def check_options(options: Any, known: tuple[str, ...]) -> dict[str, Any]:
    """Return the options of a reset; ValueError names the known options."""
    if options is None:
        return {}
    if not isinstance(options, Mapping):
        raise_not_allowed("options", "a dict", options)
    check_names("option", set(options) - {IGNORED_OPTION}, known)
    return dict(options)


def check_agents(actions: Any, agents: list[str]) -> None:
    """Raise ValueError unless the keys of the actions are exactly the agents."""
    if not isinstance(actions, Mapping):
        raise ValueError(f"actions must be a dict from agents to actions, got {type(actions).__name__}")
    for agent in agents:
        if agent not in actions:
            raise ValueError(f"the action of {agent} is missing; actions are needed for {', '.join(agents)}")
    for agent in actions:
        if agent not in agents:
            raise ValueError(f"unknown agent {agent!r} in actions; known: {', '.join(agents)}")
