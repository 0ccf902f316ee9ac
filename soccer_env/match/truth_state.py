"""`state()`: the whole truth of a match as one vector, for centralised critics; every entry has a name.

    side="field"          home's numbers first, in the frame of the field: at half-time all places change their signs
    side="home", "away"   that team's numbers first, turned so that the team always plays towards +x

`WholeTruth` gives these numbers to each robot as an observation.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from typing import Any, get_args

import numpy as np

from soccer_env.guards.checking import check_choice, check_whole_number, raise_not_allowed
from soccer_env.leagues.league import League
from soccer_env.match.arguments import StateSide
from soccer_env.match.settings import Settings
from soccer_env.observations.belief import BARRED, BRIEF, CARD, LASTING, LONG, PLAY, SHORT, STILL, TRESPASS
from soccer_env.observations.entry import FIELD, NONE, ROBOT, TEAM, TURN, Entry, X, Y, copy_to_group
from soccer_env.types import AWAY, HOME, MAX_TEAM, Phase

Match = Any  # soccer_env.match.match.Match, which stands above this file
Records = Mapping[str, np.ndarray]  # of n matches: matches (n,), balls (n,), robots (n, R), beliefs (n, R)
SIDES = get_args(StateSide)

GAME = copy_to_group(
    "game",
    Entry("clock", "play in this half", "the half; without an end soft: t / (t + 60 s)", NONE),
    Entry("half", "0 first half, 1 second half", "1", NONE),
    Entry("phase", "number of the phase of play, see `types.Phase`", "the last phase", NONE),
    Entry("placing", "1 while robots are driven to their places", "1", NONE),
    Entry("restart_home", "1 home's restart, -1 away's, 0 neither", "1", NONE),
    Entry("home_direction", "1: home attacks +x, -1: home attacks -x", "1", FIELD, X),
    Entry("goals_home", "goals of home", "soft: g / (g + 2)", NONE),
    Entry("goals_away", "goals of away", "soft: g / (g + 2)", NONE),
    Entry("ball_still", STILL, LASTING, NONE),
)
BALL = copy_to_group(
    "ball",
    Entry("ball_x", "place along the field", "half length plus goal depth", FIELD, X),
    Entry("ball_y", "place across the field", "half width plus band", FIELD, Y),
    Entry("ball_vx", "speed along the field", "its top speed", FIELD, X),
    Entry("ball_vy", "speed across the field", "its top speed", FIELD, Y),
    Entry("ball_roll_x", "speed of rolling without sliding, along the field", "its top speed", FIELD, X),
    Entry("ball_roll_y", "speed of rolling without sliding, across the field", "its top speed", FIELD, Y),
)
PLAYER = (
    Entry("present", "1: the player is on the field; 0: its entries but the penalty are 0", "1", NONE, present=True),
    Entry("keeper", "1 goalkeeper, 0 field player", "1", NONE),
    Entry("x", "place along the field", "half length plus goal depth", FIELD, X),
    Entry("y", "place across the field", "half width plus band", FIELD, Y),
    Entry("cos", "cosine of its heading", "1", FIELD, X),
    Entry("sin", "sine of its heading", "1", FIELD, Y),
    Entry("vx", "speed along the field", "top speed ahead", FIELD, X),
    Entry("vy", "speed across the field", "top speed ahead", FIELD, Y),
    Entry("omega", "turn rate", "top turn rate", FIELD, TURN),
    Entry("walk_forward", "walk of legs or wheels, ahead", "top speed ahead", ROBOT, X),
    Entry("walk_left", "walk of legs or wheels, to the left", "top speed ahead", ROBOT, Y),
    Entry("walk_turn", "walk of legs or wheels, turn rate", "top turn rate", ROBOT, TURN),
    Entry("gait_phase", "control steps since the gait step began", "those of a gait step", NONE),
    Entry("pan", "head pan", "pi", ROBOT, TURN),
    Entry("tilt", "head tilt", "pi", ROBOT),
    Entry("kick", "0 ready, 1 winding up, -1 recharging", "1", NONE),
    Entry("has_ball", "1: the ball lies in the pocket or at the kicker", "1", NONE),
    Entry("fallen", "1 fallen, 0 upright", "1", NONE),
    Entry("pushing", "time for which it has pushed an opponent, as the referee counts", BRIEF, NONE),
    Entry("holding", "time for which it has held the ball, as the referee counts", BRIEF, NONE),
    Entry("trespass", TRESPASS, BRIEF, NONE),
    Entry("card", CARD, "1", NONE),
    Entry("barred", BARRED, "1", NONE),
    Entry("penalty", "time left of its penalty", LASTING, NONE),
    Entry("ball_age", "time since it saw the ball; 0 without sensors", BRIEF, NONE),
)
SECONDS = 60.0  # [s] half-way point of the soft scale for clocks without an end, assumed
OWN_NAMES = {  # of the game, from a team's side
    "restart_home": ("restart_own", "1: restart of the own team, -1: of the other, 0: neither"),
    "home_direction": ("own_direction", "always 1: the own team attacks +x"),
    "goals_home": ("goals_own", "goals of the own team"),
    "goals_away": ("goals_other", "goals of the other team"),
}
TURNED_FOR_AWAY = ("restart_home", "home_direction")  # entries that change sign if away is the own team


@cache
def entries(players: int, side: str = "field") -> list[Entry]:
    """Return the entries of the state vector in order, with room for `players` robots in each team."""
    teams = ("home", "away") if side == "field" else ("own", "other")
    robots = [
        replace(entry, name=f"{team}_{number}_{entry.name}", group=team, slot=number)
        for team in teams
        for number in range(players)
        for entry in PLAYER
    ]
    if side == "field":
        return [*GAME, *BALL, *robots]
    game = [_rename_for_side(entry) for entry in GAME]
    return [replace(entry, frame=TEAM if entry.frame == FIELD else entry.frame) for entry in (*game, *BALL, *robots)]


def _rename_for_side(entry: Entry) -> Entry:
    """Return an entry about the game, renamed from home and away to own and other."""
    name, meaning = OWN_NAMES.get(entry.name, (entry.name, entry.meaning))
    return replace(entry, name=name, meaning=meaning)


def check_side(side: Any) -> str:
    """Return the checked side; ValueError names the known sides."""
    found: str = check_choice("side", side, SIDES)
    return found


def states(settings: Settings, records: Records, side: str = "field", players: int | None = None) -> np.ndarray:
    """Return the state vectors (n, entries) of n matches, float32 in [-1, 1], zeros for absent players.

    players: rows a side; None: `max_players` of the settings.
    """
    players = settings.max_players if players is None else players
    state = field_states(settings, records, players)
    if side == "field":
        return state
    team = HOME if side == "home" else AWAY
    columns, swapped, turned = conversion_to_side(players, team)
    direction = records["matches"]["home_direction"] * (1.0 if team == HOME else -1.0)
    signs = np.where(direction[:, None] < 0.0, turned, np.float32(1.0)) * swapped
    turned_state: np.ndarray = (signs * state)[:, columns]
    return turned_state


@cache
def conversion_to_side(players: int, team: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return arrays that convert a state to a team's side: column order, signs of the swap, signs of a half-turn."""
    field_entries = entries(players)
    names = [entry.name for entry in field_entries]
    columns, swapped = np.arange(len(field_entries)), np.ones(len(field_entries), np.float32)
    if team == AWAY:
        goals, first, size = names.index("goals_home"), len(GAME) + len(BALL), players * len(PLAYER)
        columns[[goals, goals + 1]] = goals + 1, goals
        columns[first:] = np.roll(columns[first:], size)
        swapped[[names.index(name) for name in TURNED_FOR_AWAY]] = -1.0
    return columns, swapped, np.array([entry.half_turn for entry in field_entries], np.float32)


def field_states(settings: Settings, records: Records, players: int) -> np.ndarray:
    """Return states in the field frame: match, ball, then `players` rows for home and for away."""
    league, home_rows, count = settings.league, settings.rows[HOME], len(records["matches"])
    players_of_both = np.zeros((count, 2, players, len(PLAYER)))
    numbers = stack_entries(PLAYER, robot_numbers(league, records))
    players_of_both[:, 0, :home_rows] = numbers[:, :home_rows]
    players_of_both[:, 1, : numbers.shape[1] - home_rows] = numbers[:, home_rows:]
    game, ball = (
        stack_entries(GAME, game_numbers(records["matches"])),
        stack_entries(BALL, ball_numbers(league, records["balls"])),
    )
    parts = [game, ball, players_of_both.reshape(count, -1)]
    state: np.ndarray = np.clip(np.concatenate(parts, axis=1), -1.0, 1.0).astype(np.float32)
    return state


class FinalRecords(dict[str, np.ndarray]):
    """The last records of the episodes that have just ended, by name; "state" is computed when first read."""

    def __init__(self, settings: Settings, records: Records | None = None) -> None:
        super().__init__(records or {})
        self._settings = settings

    def __missing__(self, name: str) -> np.ndarray:
        if name != "state" or "matches" not in self:
            raise KeyError(name)
        self["state"] = self.state()
        return self["state"]

    def state(self, side: str | None = None) -> np.ndarray:
        """Return the final states (n, entries) seen from a side; None: the side given in the settings."""
        return states(self._settings, self, self._settings.state_side if side is None else check_side(side))


def stack_entries(entries: Sequence[Entry], numbers: Mapping[str, Any]) -> np.ndarray:
    """Stack numbers (...), given by name, into one array (..., n) in the order of `entries`."""
    return np.stack([np.asarray(numbers[entry.name], float) for entry in entries], axis=-1)


def game_numbers(game: np.ndarray) -> dict[str, Any]:
    """Return the entries about the game by name, each (n,), scaled to [-1, 1]."""
    half = game["half_length"]
    score = game["score"] / (game["score"] + 2.0)
    return {
        "clock": np.where(np.isfinite(half), game["clock"] / half, game["clock"] / (game["clock"] + SECONDS)),
        "half": game["half"],
        "phase": game["phase"] / max(Phase),
        "placing": game["placing"],
        "restart_home": np.select([game["restart_team"] == 0, game["restart_team"] == 1], [1.0, -1.0], 0.0),
        "home_direction": game["home_direction"],
        "goals_home": score[:, 0],
        "goals_away": score[:, 1],
        "ball_still": soft_time(game["still_clock"], LONG),
    }


def ball_numbers(league: League, ball: np.ndarray) -> dict[str, Any]:
    """Return the entries about the ball by name, each (n,), scaled to [-1, 1]."""
    pitch, top = league.pitch, league.ball.top_speed
    return {
        "ball_x": ball["x"] / (pitch.length / 2 + pitch.goal_depth),
        "ball_y": ball["y"] / (pitch.width / 2 + pitch.band_side),
        "ball_vx": ball["vx"] / top,
        "ball_vy": ball["vy"] / top,
        "ball_roll_x": ball["roll_x"] / top,
        "ball_roll_y": ball["roll_y"] / top,
    }


def soft_time(time: np.ndarray, half: float) -> np.ndarray:
    """Map times [s] from [0, inf] to [0, 1], so that `half` becomes 0.5."""
    scaled: np.ndarray = 1.0 - half / (time + half)
    return scaled


def robot_numbers(league: League, records: Records) -> dict[str, Any]:
    """Return the entries about the robots by name, each (n, R), scaled to [-1, 1]; zeros for inactive robots.

    Only the penalty is that of inactive robots too. Beliefs of robots without sensors are empty.
    """
    pitch, drive, robots = league.pitch, league.drive, records["robots"]
    walk, heading, active = robots["walk"], robots["heading"], robots["active"].astype(float)
    numbers = {
        "present": active, "keeper": robots["keeper"], "x": robots["x"] / (pitch.length / 2 + pitch.goal_depth),
        "y": robots["y"] / (pitch.width / 2 + pitch.band_side), "cos": np.cos(heading), "sin": np.sin(heading),
        "vx": robots["vx"] / drive.forward, "vy": robots["vy"] / drive.forward, "omega": robots["omega"] / drive.turn,
        "walk_forward": walk["forward"] / drive.forward, "walk_left": walk["left"] / drive.forward,
        "walk_turn": walk["turn"] / drive.turn, "gait_phase": robots["gait_phase"] / max(drive.gait_steps, 1),
        "pan": robots["pan"] / np.pi, "tilt": robots["tilt"] / np.pi, "has_ball": robots["has_ball"],
        "kick": np.where(robots["kick_clock"] > 0.0, 1.0, np.where(robots["kick_clock"] < 0.0, -1.0, 0.0)),
        "fallen": robots["fallen"] > 0.0, "ball_age": soft_time(records["beliefs"]["ball"]["age"], SHORT),
        **what_the_referee_counts(records["matches"], robots),
    }  # fmt: skip
    shown = {name: np.asarray(column, float) * active for name, column in numbers.items()}
    return shown | {"penalty": soft_time(robots["penalty"], LONG)}


def what_the_referee_counts(game: np.ndarray, robots: np.ndarray) -> dict[str, np.ndarray]:
    """Return the entries of what the referee holds against each robot, (n, R)."""
    taker = np.where(game["phase"] == PLAY, game["taker"], -1)  # until another robot touches the ball
    clocks = {  # of the fouls that each league judges; the others' stay at 0
        "pushing": ("pushing", "keeper_pushing", "charging"),
        "holding": ("holding", "handling"),
        "trespass": ("trespass", "area_clock", "crowd_clock"),
    }
    longest = {name: np.maximum.reduce([robots[clock] for clock in each]) for name, each in clocks.items()}
    return {
        **{name: soft_time(time, SHORT) for name, time in longest.items()},
        "card": robots["yellow"] % 2,
        "barred": taker[:, None] == np.arange(robots.shape[1]),
    }


def records_of(match: Match) -> Records:
    """Return the present records of a match, from which `states` computes the state."""
    return {"matches": match.matches, "balls": match.balls, "robots": match.robots, "beliefs": match.batch.beliefs}


class WholeTruth:
    """An observation of the whole truth, `observe=WholeTruth(players)`: the numbers of `state` from each robot's side.

    The robot itself comes first, then its team-mates and its opponents by number, with room for `players` a side, so
    that the layout is the same at every team size. ValueError for a match with larger teams.
    """

    needs_beliefs = False  # the robots that observe the truth need no sensors

    def __init__(self, players: int) -> None:
        self.players = check_whole_number("players", players, 1, MAX_TEAM)
        self.entries = [self._rename_for_robot(entry) for entry in entries(self.players, "home")]

    def _rename_for_robot(self, entry: Entry) -> Entry:
        """Return an entry of home's state, renamed for the observation of one robot."""
        if entry.slot is None:
            return entry
        group, slot = ("opponent", entry.slot) if entry.group == "other" else ("teammate", entry.slot - 1)
        name = entry.name.split("_", 2)[2]
        if slot < 0:
            return replace(entry, name=f"self_{name}", group="self", slot=None)
        return replace(entry, name=f"{group}_{slot}_{name}", group=group, slot=slot)

    def __call__(self, match: Match) -> np.ndarray:
        """Return the observations (M, R, numbers) of all robots, in [-1, 1]."""
        settings = match.settings
        if settings.max_players > self.players:
            raise_not_allowed(
                "players of WholeTruth", f"at least the match's {settings.max_players} a side", self.players
            )
        by_side = [states(settings, records_of(match), side, self.players) for side in ("home", "away")]
        first, size, home = len(GAME) + len(BALL), len(PLAYER), settings.rows[HOME]
        seen = np.stack([by_side[int(r >= home)] for r in range(sum(settings.rows))], axis=1)
        for r in range(sum(settings.rows)):
            number = r if r < home else r - home
            own = slice(first, first + size * (number + 1))
            seen[:, r, own] = np.roll(seen[:, r, own], size, axis=-1)
        return seen
