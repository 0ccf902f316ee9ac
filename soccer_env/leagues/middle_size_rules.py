"""Fouls of the middle size, each with a module in referee/fouls/middle_size/: the opponents get a free kick."""

from dataclasses import dataclass

from soccer_env.guards.checking import SHARE
from soccer_env.leagues.checks import LeaguePart


@dataclass(frozen=True)
class MiddleSizeFouls(LeaguePart):
    """The fouls of the middle size: switches and numbers."""

    BOUNDS = {"handling_share": SHARE}

    second_touch: bool = False  # the taker of a restart touches the ball again before another robot
    touch_break: float = 0.2  # [s] without contact after which the taker of a restart has left the ball
    taking_distance: float = 0.5  # [m] from the spot for which the taker may push the ball in one touch
    distances: bool = False  # opponents keep off a restart until the ball is in play
    distance_time: float = 1.0  # [s] for which an opponent may be too near
    distance_slack: float = 0.2  # [m] by which an opponent may always be too near
    charging: bool = False  # a robot drives into an opponent off the ball
    charging_time: float = 2.0  # [s] of driving into an opponent
    charging_speed: float = 0.3  # [m/s] least speed of driving into another robot
    charging_hard: float = 2.0  # [m/s] speed at which a single blow is a foul
    charging_exempt: float = 0.6  # [m] the robot of a team nearest to the ball may fight for it within this distance
    keeper_charge: bool = False  # a robot drives into the goalkeeper in its goal area
    handling: bool = False  # a robot encloses the ball, or goes back with it
    handling_share: float = 1.0 / 3.0  # [1] of the ball's diameter that may lie within the hull of a robot
    handling_time: float = 0.5  # [s] for which more of the ball may, to stop it
    handling_back: float = 0.5  # [m] for which a robot may go back with the ball
    dribble_limit: bool = False  # a robot dribbles for `dribble_distance`
    dribble_distance: float = 3.0  # [m]
    goal_area: bool = False  # a field player in its own goal area, an attacker in the opponents'
    penalty_area: bool = False  # a second field player in its own penalty area
    area_time: float = 10.0  # [s] for which robots may be in an area where they may not stay
    cards: bool = False  # fouls are counted for yellow and red cards
    card_fouls: float = 3.0  # [1] fouls for a yellow card
    timed_cards: bool = False  # two yellow cards: out for `card_time`, not for good
    card_time: float = 90.0  # [s]
    shoot_out: bool = False  # penalty kicks after a draw
    shoot_out_kicks: float = 5.0  # [1] of each team, before single pairs decide
    shoot_out_most: float = 10.0  # [1] of each team, after which it is a draw
    shoot_out_time: float = 10.0  # [s] until a kick is taken, and again until it is over
    penalty_mark: float = 2.0  # [m] from the goal line
