"""When a scripted player decides, how its strength limits it, and how far it stays from the opponents' restart.

A team's memory has `wait` and `aim_error`, and `forward`, `aside`, `turn` and `kick` for the command that is repeated.

`k`: the league's constants.
"""

from soccer_env.compiled import compiled
from soccer_env.random_numbers import draw_normal
from soccer_env.skills.moves import stand
from soccer_env.types import Phase, RobotStream

PLAY, KICK_OFF = int(Phase.PLAY), int(Phase.KICK_OFF)
TEAM = int(RobotStream.TEAM)
MARGIN = 0.05  # [m] beyond the rules' distance at the opponents' restart, assumed


@compiled
def must_decide(belief, memory, command, k):
    """Tell whether the player has to decide now; until then it repeats its last decision, or stands if sent off."""
    stand(command)
    memory.wait -= k.dt
    if belief.situation.active == 0:
        return False
    if memory.wait > 0.0:
        command.forward, command.left, command.turn = memory.forward, memory.aside, memory.turn
        command.kick = memory.kick
        return False
    return True


@compiled
def apply_strength(sight, memory, noise, k, weakness, wait, aim, pace):
    """Set how long this decision lasts, the error of its aim, and the player's top speed.

    `weakness` is 0 to 1; at 1 a player waits `wait` [s], has an aiming error of deviation `aim` [rad], and moves at
    most at `pace` [1] times its top speed.
    """
    memory.wait = weakness * wait
    memory.aim_error = weakness * aim * draw_normal(noise, TEAM)
    sight.elapsed = max(k.dt, memory.wait)
    sight.pace = 1.0 - weakness * (1.0 - pace)


@compiled
def keep_decision(memory, command):
    """Remember the command, to repeat it."""
    memory.forward, memory.aside, memory.turn = command.forward, command.left, command.turn
    memory.kick = command.kick


@compiled
def required_ball_distance(situation, k):
    """Return the distance [m] from the ball that the rules demand of a player now; 0 in play and at the own restart."""
    if situation.phase == PLAY or situation.ours >= 0.0:
        return 0.0
    far = k.rules_kick_off_distance if situation.phase == KICK_OFF else k.rules_restart_distance
    return far + k.body_reach + MARGIN
