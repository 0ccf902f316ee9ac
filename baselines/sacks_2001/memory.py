"""The memory of a player of sacks-2001 between two decisions."""

from soccer_env.guards.ranges import COUNT, ENDLESS, FLAG, LATELY, NUMBER, UNIT, Range, ranged_record

SEARCH, APPROACH, BACK, SIDESTEP, ROTATE, ORBIT, DRIBBLE, SHOOT, PASS, SUPPORT, GUARD, YIELD = range(12)
BEHAVIOURS = (
    "search", "approach", "back", "sidestep", "rotate", "orbit",
    "dribble", "shoot", "pass", "support", "guard", "yield",
)  # fmt: skip

MEMORY = ranged_record(
    [
        ("begun", "i8", FLAG),  # 0 before the first decision
        ("behaviour", "i8", Range(0, len(BEHAVIOURS) - 1)),  # the one that was chosen last
        ("clock", "f8", NUMBER),  # [s] in this behaviour
        ("wait", "f8", NUMBER),  # [s] until the next decision (strength below 1)
        ("aim_error", "f8", NUMBER),  # [rad] the same
        ("sightings", "i8", COUNT),  # of the ball in a row
        ("trusted", "f8", NUMBER),  # [s] since it was seen for certain
        ("attacks", "i8", FLAG),  # 1: attacker, 0: supporter
        ("role_clock", "f8", NUMBER),  # [s] for which the other role would have been right
        ("reading", "f8", NUMBER),  # [s] since the stuck counter was last moved
        ("stuck", "i8", LATELY),  # net readings without coming nearer  MS19
        ("unmeasured", "f8", NUMBER),  # [s] left until a ball that reappears has a velocity  MS17
        ("near", "f8", NUMBER),  # [s] near the ball  MS20
        ("tries", "i8", COUNT),  # recoveries since it last had the ball
        ("left", "f8", NUMBER),  # [s] of the present piece of a recovery
        ("side", "f8", UNIT),  # +1 left, -1 right: of a sidestep or an orbit
        ("had_ball", "f8", ENDLESS),  # [s] since the ball was last seen between the paws
        ("down", "f8", NUMBER),  # [s] since the head was last sent up
        ("glances", "i8", FLAG),  # 1: the head is sent up, away from the ball
        ("winding", "f8", NUMBER),  # [s] for which a kick has been asked for
        ("kick_side", "f8", UNIT),  # of that kick: +1 to the left, -1 right, 0 ahead
        ("kicked", "f8", NUMBER),  # [s] left of looking after a kicked ball
        ("foiled", "f8", NUMBER),  # [s] left without shooting, after a shot that something stopped at once
        ("replan", "f8", NUMBER),  # [s] until the next decision on the way
        ("way", "f8", NUMBER),  # [rad] of the dribble, team frame
        ("way_side", "f8", UNIT),  # +1 left of the goal, -1 right of it, 0 not yet  MS47
        ("changes", "i8", COUNT),  # decisions in a row that asked for the other side
        ("glance", "f8", NUMBER),  # [s] in the cycle of looking at the ball and up
        ("scan", "f8", NUMBER),  # [s] in the cycle of a searching head
        ("turned", "f8", NUMBER),  # [rad] of a search on the spot
        ("forward", "f8", NUMBER),  # the command that is repeated until the next decision
        ("aside", "f8", NUMBER),
        ("turn", "f8", NUMBER),
        ("kick", "f8", NUMBER),
    ]
)
