"""Cards: yellow for a hard foul or for every third, and a robot with two is out.

FIFA's Laws 5 and 12 of 2005: two yellow cards are a red one, for the rest of the match; that they were so in the middle
size of 2006, and that a robot was out for 90 s in later years (the switch `timed_cards`), is remembered. How many fouls
are too many is assumed. Nobody takes the place of a goalkeeper that is sent off.

`k`: the league's constants.
"""

from math import inf

from soccer_env.compiled import compiled
from soccer_env.referee.fouls.penalties import send_off

YELLOW, OUT = 1, 2


@compiled
def book(robots, robot_events, r, hard, k):
    """Count a foul of robot r; tell whether it is sent off for it."""
    if k.rules_cards == 0:
        return False
    robots[r].fouls += 1
    if not hard and robots[r].fouls % k.rules_card_fouls != 0.0:
        return False
    robots[r].yellow += 1
    robot_events[r].card = YELLOW
    if robots[r].yellow % 2 == 1:
        return False
    robot_events[r].card = OUT
    send_off(robots, r, k.rules_card_time if k.rules_timed_cards == 1 else inf)
    return True
