"""Starts drawn from saved states, scene="states:FILE": each episode goes on from a running match of a save.

Ball and robots begin as saved, with their speeds, gaits, kicks and penalties, and so do the phase of play and the
referee's clocks. The match itself begins: its clock, score and random numbers are new, robots are told where they
stand, and neither teams nor senses remember anything. FILE is written by `Match.save`, or by
`match.saving.collect_states`; the league, the players a side and the room for robots must be those of the match.
"""

from dataclasses import dataclass, field
from hashlib import sha256
from typing import Any

import numpy as np

from soccer_env.guards.checking import short_repr
from soccer_env.guards.ranges import first_out_of_range
from soccer_env.guards.whole_files import read_regular_file
from soccer_env.leagues.league import League
from soccer_env.records.save_file import check_caught_legs, read_parts
from soccer_env.scenes.scene import Scene, SceneRandom
from soccer_env.types import BALL, MATCH, ROBOT, Phase

BEGINS = "states:"  # of the scene's name
MOST = 2**31  # [bytes] of a file
RECORDS = {"matches": MATCH, "balls": BALL, "robots": ROBOT}
NEW_OF_MATCH = (  # fields of an episode of its own; all others are those of the saved match
    "seed", "episode", "step", "clock", "half_length", "half", "over", "kick_off_team", "score", "shoot_out",
    "shoot_out_score", "drill_clock", "handedness", "noise",
)  # fmt: skip
NEW_OF_ROBOT = ("team", "number", "keeper", "senses", "gaze", "noise")


@dataclass(frozen=True, repr=False)
class SavedStates(Scene):
    """A scene that begins each episode in a saved state, drawn by the match's seed."""

    league: str = ""  # name of the league of the states
    sizes: tuple[int, int] = (0, 0)  # robots of home, of away
    digest: str = ""  # SHA-256 of the file
    records: tuple[np.ndarray, ...] = field(default=(), compare=False)  # matches (S,), balls (S,), robots (S, R)

    @property
    def meant_for(self) -> str:
        """Return the players of home and away."""
        return f"{self.sizes[0]} v {self.sizes[1]}"

    def check(self, league: League, home: int, away: int) -> None:
        """Raise ValueError unless the states are of this league and of teams of these sizes, on its pitch."""
        if (self.league, self.sizes) != (league.name, (home, away)):
            raise ValueError(
                f"scene {self.name!r} holds states of {short_repr(self.league)} at {self.meant_for}, "
                f"the match is of {league.name!r} at {home} v {away}"
            )
        pitch, (_, balls, robots) = league.pitch, self.records
        check_caught_legs(robots, bool(league.body.legs))
        room = 0.5 * pitch.length + max(pitch.band_end, pitch.goal_depth), 0.5 * pitch.width + pitch.band_side
        for name, most in zip("xy", room, strict=True):
            if (np.abs(balls[name]) > most).any() or (np.abs(robots[name])[robots["active"] == 1] > most).any():
                raise ValueError(f"scene {self.name!r} holds a state beyond the boards of {league.name!r}")

    def set_up(self, league: League, match: Any, ball: Any, robots: Any) -> None:
        """Write a saved state into the records of an episode that has begun; ValueError for other rows of robots."""
        drawn = int(SceneRandom(match).between(0.0, len(self.records[0])))
        saved_match, saved_ball, saved_robots = (records[drawn] for records in self.records)
        if len(saved_robots) != len(robots) or (saved_robots["team"] != robots["team"]).any():
            raise ValueError(
                f"scene {self.name!r} holds states of {len(saved_robots)} rows of robots, the match has "
                f"{len(robots)}: give the same max_players"
            )
        for records, saved, new in (
            (match, saved_match, NEW_OF_MATCH), (ball, saved_ball, ()), (robots, saved_robots, NEW_OF_ROBOT),
        ):  # fmt: skip
            for name in records.dtype.names:
                if name not in new:
                    records[name] = saved[name]
        slots = league.delay_steps + 1  # of the delay line, in which a step's slot depends on its number
        robots["delayed"][:, :slots] = np.roll(saved_robots["delayed"][:, :slots], -int(saved_match["step"]), axis=1)


def read_states(name: str) -> SavedStates:
    """Return the scene "states:FILE"; ValueError names the file and the reason."""
    try:
        data = read_regular_file(name.removeprefix(BEGINS), MOST)
        header, arrays = read_parts(data, RECORDS)
        league, home, away = (header["told"][what][0] for what in ("league", "home", "away"))
        sizes = int(home), int(away)
        records = in_play(arrays["matches"], arrays["balls"], arrays["robots"])
    except (OSError, ValueError, KeyError, IndexError, TypeError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else error
        reason = reason if isinstance(error, (OSError, ValueError)) else "it does not say of which match it is"
        raise ValueError(f"scene {name!r}: {reason}") from None
    return SavedStates(
        name, "in a saved state", league=str(league), sizes=sizes, digest=sha256(data).hexdigest(), records=records
    )  # fmt: skip


def in_play(matches: np.ndarray, balls: np.ndarray, robots: np.ndarray) -> tuple[np.ndarray, ...]:
    """Return the records of the matches (S,) that go on; ValueError if none does, or for numbers out of range."""
    if matches.ndim != 1 or balls.shape != matches.shape or robots.ndim != 2 or len(robots) != len(matches):
        raise ValueError("this save is damaged: its records are not of the same matches")
    for name, records in (("matches", matches), ("balls", balls), ("robots", robots)):
        wrong = first_out_of_range(records, robots.shape[1])
        if wrong:
            raise ValueError(f"this save is damaged: {wrong} of {name} is out of range")
    going = (matches["over"] == 0) & (matches["phase"] != Phase.OVER) & (matches["shoot_out"] == 0)
    if not going.any():
        raise ValueError("no match in it goes on")
    return matches[going], balls[going], robots[going]
