"""The events of a match in words, with time and place: goals and how they were scored, whistles, kicks, halves."""

from math import hypot
from typing import Any, NamedTuple

import numpy as np

from soccer_env.match import Match
from soccer_env.referee.shoot_out import SCORED
from soccer_env.render.captions import PHASES, player_words
from soccer_env.render.colours import TEAM_NAMES
from soccer_env.statistics.records import FRESH, GoalKind
from soccer_env.types import NO_TEAM, Foul, Phase

KICK_COUNTS = 3.0  # [s] an own goal comes from a kick of its robot that is at most so long ago
KICKS_APART = 0.25  # [s] kicks of a robot that follow each other faster count as one
NOBODY = -1
HOW = {  # kicks and own goals have longer descriptions
    GoalKind.CLEAN_DRIBBLE: "dribbled in, without touching an opponent",
    GoalKind.PUSHED_IN: "pushed in, in contact with an opponent",
    GoalKind.SCRUM: "bumped in out of a scrum",
}


class BallPlay(NamedTuple):
    """A kick or touch of the ball by a robot."""

    row: int
    step: int  # control step of the replay
    x: float  # [m] field frame: the ball
    y: float  # [m]
    kicked: bool = True
    strength: float = 0.0  # of the kick, as a share of the strongest one


class EventCollector:
    """Collects events as lists [step, kind, team, robot, words]; kind: goal, penalty, foul, restart, kick, half.

    A penalty is a kick of a shoot-out; its sixth value is the score of the shoot-out. The sixth value of a goal is a
    dict: its `kind` in the statistics, `how` it was scored, the `score` after it, and the step in which its scorer
    `played` the ball. The scorer of a deflected kick is the kicker.
    """

    def __init__(self, match: Match, teams: tuple[str, str]) -> None:
        self.rate = match.league.control_rate
        self.events: list[list[Any]] = []
        self._teams = teams
        self._kicks: dict[int, BallPlay] = {}  # the last of each robot
        self._touches: dict[int, BallPlay] = {}
        self._flight: BallPlay | None = None  # that sent the ball on its way
        self._others: list[int] = []  # robots that touched the ball since, first to last
        self._step = int(match.matches["step"][0])
        self._goals = match.statistics["goals"][0].copy()
        self._shooter = NO_TEAM  # team whose turn it is in a shoot-out
        self._called = 0  # step in which its kick was called

    def listen(self, match: Match, step: int, before: np.ndarray) -> None:
        """Note the events of a control step in the first match; `before` are the robots' records one step earlier."""
        events = match.events[0]
        if match.matches["step"][0] <= self._step:
            match.statistics[0] = FRESH  # another episode has begun
            self._kicks, self._touches, self._flight = {}, {}, None
        self._step = int(match.matches["step"][0])
        self._listen_to_plays(match, step)
        if events["penalty"] != 0:
            self._tell_penalty(match, step)
        if events["goal"] != NO_TEAM:
            self._tell_goal(match, step, before)
        elif events["foul"] != 0:
            self._tell_foul(match, step)
        elif events["restart"] not in (0, Phase.KICK_OFF):
            team = int(events["restart_team"])
            whose = "" if team == NO_TEAM else f" for {TEAM_NAMES[team]}"
            self._add(step, "restart", team, NOBODY, f"{PHASES[Phase(int(events['restart']))]}{whose}")
        if events["annulled"]:
            self._add(step, "foul", NO_TEAM, NOBODY, "the ball was in, but this is no goal")
        for name, words in (("half_time", "half-time"), ("final_whistle", "final whistle")):
            if events[name]:
                self._add(step, "half", NO_TEAM, NOBODY, words)
        if events["restart"] == Phase.PENALTY_KICK:
            self._shooter, self._called = int(events["restart_team"]), step
        trail = match.statistics["trail"][0]
        r = int(trail["flight"])  # of the kick or push that sent the ball on its way, as the statistics count it
        if r < 0:
            self._flight = None
        elif self._flight is None or r != self._flight.row or trail["flight_step"] == self._step:
            self._flight, self._others = self._last_play(r, step), []
        self._goals = match.statistics["goals"][0].copy()

    def _listen_to_plays(self, match: Match, step: int) -> None:
        """Note kicks and touches with the place of the ball."""
        x, y = float(match.events["ball_x"][0]), float(match.events["ball_y"][0])
        for r in np.flatnonzero(match.robot_events["touch"][0]).tolist():
            self._touches[r] = BallPlay(r, step, x, y, kicked=False)
            if self._flight is not None and r != self._flight.row:
                self._others.append(r)
        for r in np.flatnonzero(match.robot_events["kick"][0]).tolist():
            last = self._kicks.get(r)
            self._kicks[r] = BallPlay(r, step, x, y, strength=float(match.robots["kick_strength"][0, r]))
            if last is None or step - last.step > KICKS_APART * self.rate:
                robot = match.robots[0, r]
                self._add(step, "kick", int(robot["team"]), r, f"{player_words(robot)} kicks")

    def _last_play(self, r: int, step: int) -> BallPlay:
        """Return the last play of the ball by a robot: a recent kick, else a touch."""
        kick = self._kicks.get(r)
        if kick is not None and step - kick.step <= KICKS_APART * self.rate:
            return kick
        return self._touches.get(r, BallPlay(r, step, 0.0, 0.0, kicked=False))

    def _tell_goal(self, match: Match, step: int, before: np.ndarray) -> None:
        """Add a goal with its scorer and a description of how it was scored."""
        team, r = int(match.events["goal"][0]), int(match.events["scorer"][0])
        kinds = np.flatnonzero(match.statistics["goals"][0, team] > self._goals[team])
        kind = GoalKind(int(kinds[0])) if len(kinds) else GoalKind.SCRUM
        side = f"{TEAM_NAMES[team]} ({self._teams[team]})"
        if not 0 <= r < len(before):
            play, how = BallPlay(NOBODY, step, 0.0, 0.0, kicked=False), "nobody is known to have touched it"
            self._add_goal(match, step, NOBODY, f"a goal for {side}", kind, how, play)
        elif kind in (GoalKind.CLEAN_KICK, GoalKind.DEFLECTED_KICK):
            play = self._shot(team, r, step, before)
            words = f"{player_words(before[play.row])} scores for {self._teams[team]}"
            self._add_goal(match, step, play.row, words, kind, self._how_shot(match, play, kind, r, before), play)
        else:
            play = self._touches.get(r, BallPlay(r, step, 0.0, 0.0, kicked=False))
            words = f"{player_words(before[r])} scores for {self._teams[team]}"
            how = HOW.get(kind, "")
            if int(before["team"][r]) != team:
                words = f"own goal by {player_words(before[r])}, counts for {side}"
                play, how = self._own_goal(r, step, play)
            self._add_goal(match, step, r, words, kind, how, play)

    def _shot(self, team: int, r: int, step: int, before: np.ndarray) -> BallPlay:
        """Return the kick or push that led to a team's goal; r: the robot that touched the ball last."""
        if self._flight is not None and int(before["team"][self._flight.row]) == team:
            return self._flight
        plays = [*self._touches.values(), *(kick for kick in self._kicks.values() if kick.step == step)]
        own = [play for play in plays if int(before["team"][play.row]) == team]
        return max(own, key=lambda play: play.step, default=self._last_play(r, step))  # scored before it was followed

    def _how_shot(self, match: Match, play: BallPlay, kind: GoalKind, r: int, before: np.ndarray) -> str:
        """Describe in words the kick or push that scored."""
        goal_x = float(np.sign(match.events["ball_x"][0])) * match.league.pitch.length / 2
        away = hypot(goal_x - play.x, play.y)
        verb = "kick" if play.kicked else "hard push"
        if kind == GoalKind.CLEAN_KICK:
            return f"clean {verb} from {away:.1f} m, nobody else touched the ball"
        touched = [*self._others, r]
        other = next((row for row in touched if row != play.row), NOBODY)
        by = f" by {player_words(before[other])}" if other >= 0 else ""
        return f"{verb} from {away:.1f} m, deflected{by}"

    def _own_goal(self, r: int, step: int, touch: BallPlay) -> tuple[BallPlay, str]:
        """Return the kick or touch that led to an own goal, and a description of it."""
        kick = self._kicks.get(r)
        if kick is None or step - kick.step > KICK_COUNTS * self.rate or kick.step < touch.step - self.rate:
            return touch, "it touched the ball last, and no kick of the other team came before that"
        return kick, f"it kicked the ball {(step - kick.step) / self.rate:.1f} s before"

    def _add_goal(self, match: Match, step: int, r: int, words: str, kind: GoalKind, how: str, play: BallPlay) -> None:
        """Add a goal to the events, with the details that the page shows."""
        score = [int(goals) for goals in match.matches["score"][0]]
        kick = round(play.strength, 2) if play.kicked else None
        self._add(step, "goal", int(match.events["goal"][0]), r, words)
        goal = {"kind": kind.name.lower(), "how": how, "score": score, "played": min(play.step, step - 1), "kick": kick}
        self.events[-1].append(goal)

    def _tell_penalty(self, match: Match, step: int) -> None:
        """Add the result of a kick of a shoot-out."""
        own = np.flatnonzero(match.robots["team"][0] == self._shooter).tolist()
        plays = [play for play in self._touches.values() if play.row in own and play.step > self._called]
        r = min(plays, key=lambda play: play.step).row if plays else NOBODY
        who = player_words(match.robots[0, r]) if r >= 0 else TEAM_NAMES[self._shooter]
        score = [int(goals) for goals in match.matches["shoot_out_score"][0]]
        did = "scores" if match.events["penalty"][0] == SCORED else "misses"
        words = f"penalty kick: {who} ({self._teams[self._shooter]}) {did}, {score[0]} : {score[1]}"
        self._add(step, "penalty", self._shooter, r, words)
        self.events[-1].append(score)

    def _tell_foul(self, match: Match, step: int) -> None:
        """Add a foul with the robot or team that committed it."""
        foul, team = Foul(int(match.events["foul"][0])), int(match.events["foul_team"][0])
        against = np.flatnonzero(match.robot_events["foul"][0] == foul)
        r = int(against[0]) if len(against) else NOBODY
        who = player_words(match.robots[0, r]) if r >= 0 else TEAM_NAMES[team] if team != NO_TEAM else "both"
        self._add(step, "foul", team, r, f"foul by {who}: {foul.name.lower().replace('_', ' ')}")

    def _add(self, step: int, kind: str, team: int, r: int, words: str) -> None:
        self.events.append([step, kind, team, r, words])
