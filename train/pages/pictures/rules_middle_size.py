"""The rules of the middle size: for each, a function that stages the match in which the referee applies the rule.

Rows 0 to 2 are home, red, attacking +x; rows 0 and 3 are goalkeepers.
"""

from functools import partial
from math import pi

import numpy as np

from soccer_env.leagues import find_league
from soccer_env.match import Match
from soccer_env.train.pages.pictures.rules import Ruling, Staged, stage_rule
from soccer_env.types import AWAY, HOME, Foul, Phase

LEAGUE = find_league("middle-size-2006")
BEHIND = 0.449  # [m] between two robots, the tips of the rear one just short of the other's back
FRONT = LEAGUE.body.front + LEAGUE.ball.radius + 0.001  # [m] of a ball at the kicker from the robot's middle
PLACES = ((-5.7, 0.0, 0.0), (-3.0, -2.2, 0.3), (-2.4, 2.0, -0.3), (5.7, 0.0, pi), (3.0, 2.2, pi), (2.4, -2.0, pi))

staged = partial(stage_rule, LEAGUE, PLACES, running=True)


def stage_restart(phase: Phase, x: float, y: float, robots: dict[int, tuple[float, float, float]]) -> Staged:
    """Stage a restart of home, the ball at its spot."""
    return staged((x, y), robots, {}, phase=phase, restart_team=HOME, restart_x=x, restart_y=y)


def stage_second_touch() -> Staged:
    """Return the taker of a throw-in that dribbles the ball."""
    match, actions = stage_restart(Phase.THROW_IN, 0.0, 3.0, {2: (-FRONT, 3.0, 0.0)})
    actions[0, 2, 0] = 0.5
    return match, actions


def stage_too_early() -> Staged:
    """Stage an opponent that touches the ball before it is in play."""
    match, actions = stage_restart(Phase.FREE_KICK, 0.0, 0.0, {2: (-0.6, 0.0, 0.0), 4: (0.5, 0.0, pi)})
    actions[0, 4, 0] = 1.0
    return match, actions


def stage_charging() -> Staged:
    """Stage a robot that keeps driving into a standing opponent, away from the ball."""
    return staged((-1.0, -2.0), {2: (0.0, 1.0, 0.0), 4: (BEHIND, 1.0, 0.0)}, {2: 0.2})


def stage_hard_charge(y: float = 1.0, yellow: int = 0, rules: str = "league") -> Staged:
    """Stage a robot with a number of yellow cards that runs into a standing opponent, away from the ball."""
    robots = {2: (-0.6, y, 0.0), 4: (BEHIND, y, 0.0)}
    return staged((-1.0, -2.0), robots, {2: 1.0}, rules=rules, red_2={"yellow": yellow})


def stage_shoot_out() -> Staged:
    """Stage a drawn match at its end."""
    match = Match("middle-size-2006", home=3, away=3, seed=1, minutes=1.0, rules="league:shoot_out=True")
    match.matches["half"], match.matches["clock"] = 1, 29.9
    return match, np.zeros((1, 6, 4))


def stage_ball_over_line(x: float, y: float, vx: float, vy: float, team: int) -> Staged:
    """Stage a ball that rolls over a line, touched last by a team."""
    return staged((x, y, vx, vy), {}, {}, last_touch_team=team)


DIRECT = tuple(f"direct_{name}" for name in ("kick_off", "throw_in", "goal_kick", "corner_kick", "free_kick"))
RULINGS = (
    Ruling("throw-in", ("out_of_play",), "it came off red: blue takes it",
           partial(stage_ball_over_line, 1.0, 3.9, 0.5, 1.0, HOME), event="out"),
    Ruling("goal kick", ("out_of_play",), "it came off red: blue takes it",
           partial(stage_ball_over_line, 5.9, 2.0, 1.0, 0.2, HOME), event="out"),
    Ruling("corner kick", ("out_of_play",), "it came off blue: red takes it",
           partial(stage_ball_over_line, 5.9, 2.0, 1.0, 0.2, AWAY), event="out"),
    Ruling("dropped ball", ("dropped_ball",), "10 s within 30 cm: dropped there",
           partial(staged, (0.5, 1.0), {2: (0.5 - FRONT, 1.0, 0.0), 4: (0.5 + FRONT, 1.0, pi)}, {}, still_clock=9.0),
           event="restart", after=True),
    Ruling("second touch", ("second_touch",), "red 2 took the throw-in and keeps the ball: free kick",
           stage_second_touch, 2, Foul.SECOND_TOUCH),
    Ruling("indirect restart", DIRECT, "straight from a corner kick: no goal, goal kick",
           partial(staged, (5.7, 0.6, 3.0), {1: (5.0, 2.5, -1.0), 3: (5.5, -0.6, pi)}, {}, taker=1, indirect=1)),
    Ruling("indirect restart", DIRECT, "the own goal, from a goal kick: corner kick",
           partial(staged, (-5.7, -0.7, -3.0), {0: (-5.3, 0.6, 0.0)}, {}, taker=0, indirect=1)),
    Ruling("distance", ("distances",), "blue 1 stays within 1 m of a free kick: put back",
           partial(stage_restart, Phase.FREE_KICK, 0.0, 0.0, {2: (-0.4, 0.0, 0.0), 4: (0.6, 0.0, pi)}), 4,
           Foul.DISTANCE),
    Ruling("distance", ("distances",), "blue 1 touches the ball too early: taken again", stage_too_early, 4,
           Foul.DISTANCE),
    Ruling("charging", ("charging",), "red 2 drives into blue 1 for 2 s, off the ball", stage_charging, 2,
           Foul.CHARGING),
    Ruling("charging, hard", ("charging",), "red 2 runs into blue 1: yellow card", stage_hard_charge, 2, Foul.CHARGING),
    Ruling("keeper charge", ("keeper_charge",), "red 2 drives into the goalkeeper",
           partial(staged, (5.4, 0.6), {2: (5.6 - BEHIND - 0.1, 0.0, 0.0), 3: (5.6, 0.0, 0.0)}, {2: 0.4}), 2,
           Foul.KEEPER_CHARGE),
    Ruling("ball handling", ("handling",), "red 2 has gone back 0.5 m with the ball",
           partial(staged, (FRONT, 0.0), {2: (0.0, 0.0, 0.0)}, {2: -0.2}, red_2={"backed": 0.499, "has_ball": 1}), 2,
           Foul.HANDLING),
    Ruling("dribbling (later years)", ("dribble_limit",), "red 2 has dribbled the ball for 3 m",
           partial(staged, (FRONT, 0.0), {2: (0.0, 0.0, 0.0)}, {2: 0.5}, rules="league:dribble_limit=True",
                   red_2={"dribbled": 2.9}), 2, Foul.DRIBBLE),
    Ruling("own goal area", ("goal_area",), "red 2 has stayed in it for 10 s",
           partial(staged, (0.0, 0.0), {2: (-5.75, 1.0, 0.0)}, {}), 2, Foul.GOAL_AREA),
    Ruling("opponents' goal area", ("goal_area",), "red 2 has stayed in it for 10 s",
           partial(staged, (0.0, 0.0), {2: (5.75, -1.0, 0.0)}, {}), 2, Foul.GOAL_AREA),
    Ruling("penalty area", ("penalty_area",), "red 2 is in it for 10 s, red 1 is nearer to the ball",
           partial(staged, (-3.0, 0.0), {1: (-4.9, 0.5, 0.0), 2: (-5.1, -1.2, 0.0)}, {}), 2, Foul.PENALTY_AREA),
    Ruling("free kick", ("charging",), "blue's, 1 m from everybody else", stage_charging, 2, Foul.CHARGING, after=True),
    Ruling("two yellow cards", ("charging", "cards"), "red 2 is out for the rest of the match",
           partial(stage_hard_charge, yellow=1), 2, Foul.CHARGING, after=True),
    Ruling("timed cards (off)", ("timed_cards",), "two yellow cards are 90 s out: red 2 is back",
           partial(stage_hard_charge, -1.0, 1, "league:timed_cards=True"), 2, after=True, longest=100.0),
    Ruling("penalty shoot-out", ("shoot_out",), "after a draw, if it is switched on", stage_shoot_out, event="restart",
           after=True),
)  # fmt: skip
