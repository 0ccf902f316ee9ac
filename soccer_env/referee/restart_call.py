"""Note a restart that the referee calls; `restarts` carries it out."""

from soccer_env.compiled import compiled
from soccer_env.types import AWAY, HOME, NO_TEAM


@compiled
def call_restart(match, events, phase, team, x, y):
    """Note a restart: its phase, the team that takes it, and the place of the ball [m, field frame]."""
    match.phase = phase
    match.phase_clock = 0.0
    match.restart_team = team
    match.restart_x, match.restart_y = x, y
    match.still_x = x
    match.still_y = y
    match.still_clock = 0.0
    match.last_touch_team = NO_TEAM
    match.last_touch_robot = match.taker = -1
    match.taker_clock = 0.0
    match.indirect = 0
    events.restart = phase
    events.restart_team = team


@compiled
def other_team(team):
    """Return the opponents of a team."""
    return AWAY if team == HOME else HOME
