"""Fouls of the legged league, each with a module in referee/fouls/legged/: the guilty robot is taken out."""

from dataclasses import dataclass

from soccer_env.leagues.checks import LeaguePart


@dataclass(frozen=True)
class LeggedFouls(LeaguePart):
    """The fouls of the legged league: switches and numbers."""

    removal_time: float = 30.0  # [s] for which a robot is out
    pardon: bool = False  # a kick-off ends all penalties that run
    pushing: bool = False  # a robot walks into an opponent off the ball for `pushing_time`
    pushing_time: float = 3.0  # [s] in contact
    pushing_exempt: float = 0.5  # [m] the robot nearest to the ball may push for it within this distance
    keeper_pushing: bool = False  # a robot walks into the goalkeeper in its own area, with the ball or itself in it
    keeper_pushing_time: float = 1.0  # [s] in contact
    annulled_push: float = 0.5  # [s] of a push or hold after which a goal by the robot's team does not count
    annulled_time: float = 3.0  # [s] after the whistle in which the whistled team cannot score
    holding: bool = False  # a robot keeps the ball from all others for `holding_time`
    holding_time: float = 3.0  # [s]
    holding_distance: float = 0.4  # [m] of the ball within which an opponent is kept off it, assumed
    keeper_holding_time: float = 5.0  # [s] in its own area
    carrying: bool = False  # a robot carries the ball for `carrying_distance`
    carrying_distance: float = 0.5  # [m] for which a robot may carry the ball
    illegal_defender: bool = False  # a field player stays in its own penalty area for `illegal_defender_time`
    illegal_defender_time: float = 1.0  # [s] in its own penalty area
    illegal_attacker: bool = False  # a robot stays in the opponents' penalty area for `illegal_attacker_time`
    illegal_attacker_time: float = 10.0  # [s] in the opponents' penalty area while the ball is elsewhere
    leaving_field: bool = False  # a robot stands in a goal for `leaving_time`, except a goalkeeper in its own
    leaving_time: float = 5.0  # [s] in a goal
    falling: bool = False  # a robot lies for `fallen_time`
    fallen_time: float = 5.0  # [s] on the ground
    kick_off_shot: bool = False  # a kick-off scores once its team touches it again, out of the centre circle
    local_stuck: bool = False  # play stays in one place for `local_stuck_time`
    local_stuck_time: float = 30.0  # [s]
    local_stuck_radius: float = 0.5  # [m] within which play does not move on
    global_stuck: bool = False  # nobody touches the ball for `global_stuck_time`
    global_stuck_time: float = 30.0  # [s] without a touch of the ball
