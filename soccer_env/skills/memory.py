"""What a player of these skills remembers between two decisions; a team saves it with the match."""

from soccer_env.guards.ranges import NUMBER, UNIT, ranged_record
from soccer_env.types import PLAYERS

MEMORY = ranged_record(
    [
        ("wait", "f8", NUMBER),  # [s] until the next decision
        ("rank", "i8", PLAYERS),  # field team-mates nearer to the ball: 0 the attacker
        ("rank_age", "f8", NUMBER),  # [s] for which another rank has been right
        ("side", "f8", UNIT),  # +1 supports on the left of the ball, -1 on its right, 0 undecided
        ("way", "f8", UNIT),  # +1 goes round the ball counter-clockwise, -1 clockwise
        ("aim_error", "f8", NUMBER),  # [rad]
        ("stuck", "f8", NUMBER),  # [s] that the ball at my feet has not moved
        ("patience", "f8", NUMBER),  # [s] of being stuck until it is worked out
        ("wriggle", "f8", NUMBER),  # [s] left of working it out
        ("wriggle_side", "f8", UNIT),  # +1 turning left, -1 right
        ("set_piece", "f8", NUMBER),  # [s] left of remembering our restart: above 0 as its taker, below 0 its mate
        ("sweep", "f8", NUMBER),  # [s] left of sweeping it out of a corner
        ("sweep_way", "f8", NUMBER),  # [rad] in which it is swept, team frame
        ("sweep_side", "f8", UNIT),  # +1 turning left, -1 right
        ("pressed", "f8", NUMBER),  # [s] for which the robot has walked into an opponent
        ("back_off", "f8", NUMBER),  # [s] left of stepping back from it
        ("off_x", "f8", NUMBER),  # unit vector away from it, team frame
        ("off_y", "f8", NUMBER),
        ("search_side", "f8", UNIT),  # +1 searches turning left, -1 right, 0 knows the ball
        ("turned", "f8", NUMBER),  # [rad] since it began to turn on the spot
        ("search_clock", "f8", NUMBER),  # [s] on the way to a lookout
        ("lookout", "f8", NUMBER),  # [m] x of it, team frame
        ("look_side", "f8", UNIT),  # +1 the head began to search on the left, -1 right, 0 knows the ball
        ("look_clock", "f8", NUMBER),  # [s] in the head's two sweeps
        ("phantom", "f8", NUMBER),  # [s] for which the ball was seen only where it cannot be
        ("glance", "f8", NUMBER),  # [s] left of looking up from the ball; below 0 until the next look
        ("glance_side", "f8", UNIT),  # +1 the next look begins on the right, -1 on the left, 0 none yet
        ("forward", "f8", NUMBER),  # the command that is repeated until the next decision
        ("aside", "f8", NUMBER),
        ("turn", "f8", NUMBER),
        ("kick", "f8", NUMBER),
        ("kicking", "f8", NUMBER),  # [s] for which a kick has been commanded with the ball at the feet
        ("kick_side", "f8", UNIT),  # of that kick: +1 to the left, -1 right, 0 ahead
    ]
)
