"""Steps of a match as they are counted, one by one: what happens in each is written into its records, not played."""

from typing import Any

import numpy as np

from soccer_env.statistics.counting import count_calls, count_step, is_notable
from soccer_env.statistics.players import count_player
from soccer_env.statistics.records import FRESH, GoalKind
from soccer_env.types import QUIET
from tests.scenes.staging import LEGGED, put, put_ball, stage

HALF, SECOND = 8, 16  # steps of the legged league
KEEPER, KICKER, MATE, THEIR_KEEPER, THEIR_PLAYER = range(5)  # rows of 3 against 3


class Steps:
    """A match of robots a side in play whose steps are counted; home attacks +x. Rows 0 and `players` are keepers."""

    def __init__(self, name: str = LEGGED, players: int = 3, direction: float = 1.0) -> None:
        self.match = stage(name, home=players, away=players)
        self.match.matches["home_direction"] = direction
        self.players, self.side = players, direction
        self.k = self.match.batch.constants[0]
        self.tally = np.full(1, FRESH)
        self.bodies = np.zeros((2 * players + 1, 6))
        for row in range(2 * players):  # near nobody, moving
            self.put(row, -1.0 + 0.4 * row, 0.9, speed=0.1)

    def put(self, row: int, x: float, y: float, speed: float = 0.0) -> None:
        """Put a robot somewhere [m] if home attacks +x, going sideways [m/s]."""
        put(self.match, row, self.side * x, y, left=speed)

    def ball(self, x: float, y: float, vx: float = 0.0, vy: float = 0.0) -> None:
        """Put the ball somewhere [m], rolling [m/s], if home attacks +x."""
        put_ball(self.match, self.side * x, y, self.side * vx, vy)

    def set(self, row: int, **fields: Any) -> None:
        for name, value in fields.items():
            self.match.robots[name][0, row] = value

    def count(
        self, seconds: float = 0.0, steps: int = 1, touch: int = -1, kick: int = -1, fouls: Any = (),
        returned: int = -1, **events: Any,
    ) -> None:  # fmt: skip
        """Count steps, or those of some seconds, in all of which the same happens; touch, kick: by which row."""
        match, record, robot_events = self.match, np.full(1, QUIET), self.match.robot_events
        ball, rows = match.balls[0], range(2 * self.players)
        record["ball_x"], record["ball_y"] = ball["x"], ball["y"]
        robot_events[:] = 0
        for row in {touch, kick} - {-1}:
            robot_events["touch"][0, row] = 1
            record["touch_team"] = match.robots["team"][0, row]
            match.matches["last_touch_robot"] = row
        for name, value in events.items():
            record[name] = value
        if "goal" in events:
            match.matches["last_touch_robot"] = -1  # the call of the restart forgets it
        for row, foul in dict(fouls).items():
            robot_events["foul"][0, row] = foul
        if kick >= 0:
            robot_events["kick"][0, kick] = 1
        if returned >= 0:
            robot_events["returned"][0, returned] = 1
        for _ in range(round(seconds / match.league.dt) or steps):
            match.matches["step"] += 1
            for r in rows:
                count_player(match.matches[0], ball, match.robots[0], robot_events[0, r], r, self.k, self.tally[0])
            count_step(match.matches[0], ball, match.robots[0], record[0], self.k, self.tally[0])
            if is_notable(record[0]):
                count_calls(match.matches[0], match.robots[0], record[0], robot_events[0], self.bodies, self.tally[0])

    def score(self, team: int, scorer: int = -1) -> None:
        """Count the step of a goal; the scorer touches the ball in it."""
        self.count(touch=scorer, goal=team, scorer=scorer)

    def of(self, name: str) -> Any:
        """Return a statistic: a number, or home's and away's."""
        return self.tally[name][0].tolist()

    def kinds(self, team: int) -> list[int]:
        """Return the goals of a team by kind."""
        return self.tally["goals"][0, team].tolist()


def only(kind: int) -> list[int]:
    """Return one goal of a kind."""
    return [int(one == kind) for one in GoalKind]


def shoot(steps: Steps, x: float = 1.0, y: float = 0.0, vx: float = 1.0, vy: float = 0.0) -> None:
    """Let home's player kick the ball with a velocity [m/s]."""
    steps.ball(x, y, vx, vy)
    steps.match.balls["roll_x"] = steps.match.balls["roll_y"] = 0.0
    steps.count(kick=KICKER)
