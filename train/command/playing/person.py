"""A person at the controls, who steers a robot by actions, as a learner does."""

from __future__ import annotations

from math import atan2, cos, hypot, pi, remainder, sin

import numpy as np

from soccer_env.actions import FULL
from soccer_env.guards.names import unknown
from soccer_env.match import Match
from soccer_env.match.squads import playing_team_names
from soccer_env.teams import TeamRandom, View
from soccer_env.thoughts.thoughts import own_poses
from soccer_env.train.command.playing.assists import ASSISTS
from soccer_env.train.command.playing.controls import TEAM, Wish

TURNING = 1.5  # [1/rad] turn, of the top rate, for each radian off the way that the person points, assumed


class Person:
    """A person who plays a side of a match robot by robot, or one robot alone; the match's actions are "full".

    The robot that is steered is taken from its team, which plays the others. ValueError for an unknown side or robot,
    and for robots without beliefs, by which the skills go.
    """

    def __init__(self, match: Match, plays: str, drive: str = "robot") -> None:
        if plays not in ("home", "away", *match.agents):
            raise ValueError(unknown("person", plays, ("home", "away", *match.agents)))
        self.match, self.drive = match, drive
        self.rows = [row for row, agent in enumerate(match.agents) if plays in (agent, agent.split("_")[0])]
        if not match.batch.believing[self.rows].all():
            team = playing_team_names(match.squads, self.rows[0], 1)[0]
            raise ValueError(f"team {team!r} reads no beliefs, so that its robots have none for you: name another team")
        self._memory = np.zeros((1, len(match.agents)), next(iter(ASSISTS.values())).memory_dtype)
        self.row = self.rows[0]
        self.take_nearest()
        self.steered: set[str] = set()  # agents that the person has steered

    @property
    def agent(self) -> str:
        """Return the name of the robot that the person steers now."""
        return self.match.agents[self.row]

    def take_next(self) -> None:
        """Take the next robot that plays, by its number."""
        at = self.rows.index(self.row)
        following = self.rows[at + 1 :] + self.rows[: at + 1]
        self.row = next((row for row in following if self.match.robots["active"][0, row]), self.row)

    def take_nearest(self) -> None:
        """Take the robot nearest to the ball."""
        robots, ball = self.match.robots[0, self.rows], self.match.balls[0]
        away = np.hypot(robots["x"] - ball["x"], robots["y"] - ball["y"])
        self.row = self.rows[int(np.argmin(np.where(robots["active"] == 1, away, np.inf)))]

    def compile_skills(self) -> None:
        """Compile the skills, which would else stop the play when a key is first held."""
        for skill in ASSISTS:
            self._by_skill(skill)
        self._memory[:] = np.zeros((), self._memory.dtype)

    def actions(self, wish: Wish) -> np.ndarray:
        """Return the actions (1, R, 7) of a step, of which the match obeys only that of the robot that is steered."""
        self.match.learns[self.rows] = 0
        actions = np.zeros((1, len(self.match.agents), len(FULL)))
        if wish.skill == TEAM:
            return actions
        self.match.learns[self.row] = 1
        self.steered.add(self.agent)
        actions[0, self.row] = self._by_skill(wish.skill) if wish.skill else self._by_hand(wish)
        return actions

    def _by_hand(self, wish: Wish) -> tuple[float, ...]:
        """Return the action of a wish without a skill; the head tracks the ball by itself."""
        ways = (wish.forward, wish.left, wish.turn)
        if self.drive == "pitch":
            ways = ways_on_pitch(wish, float(own_poses(self.match)[1][self.row]))
        return (*ways, wish.kick, -1.0, 0.0, 0.0)

    def _by_skill(self, skill: str) -> np.ndarray:
        """Return the command of a skill, decided from the robot's belief."""
        match, row = self.match, [self.row]
        view = View(match.league, match.beliefs[:1, row], match.tracks[:1, row])
        memory, noise = self._memory[:, row], match.robots["noise"][:1, row]
        command: np.ndarray = ASSISTS[skill].act(view, memory, TeamRandom(noise, np.array([0])))[0, 0]
        self._memory[:, row] = memory
        return command.clip(-1.0, 1.0)


def ways_on_pitch(wish: Wish, heading: float) -> tuple[float, float, float]:
    """Return forward, left and turn with which a robot of a heading [rad] goes where the person points on the picture.

    On the picture x is to the right and y up, so that "forward" points along y and "left" against x. The robot turns
    into its way, unless the person turns it.
    """
    share = min(hypot(wish.forward, wish.left), 1.0)
    bearing = remainder(atan2(wish.forward, -wish.left) - heading, 2.0 * pi) if share > 0.0 else 0.0
    turn = wish.turn if wish.turn != 0.0 else min(max(TURNING * bearing, -1.0), 1.0)
    return share * cos(bearing), share * sin(bearing), turn
