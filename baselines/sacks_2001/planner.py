"""The planner: choose a behaviour for a player of sacks-2001 from its beliefs.  [Sacks 2001, 2, 4]  MS01

Once a control step it reads the XLSs (sight, belief, tracks) and chooses one behaviour, whose XLA (`actuators.py`)
commands legs and head.

    lost the ball                         search
    goalkeeper                            meet a shot  >  clear  >  guard                     goalkeeper.py
    opponents' restart, or not nearest    yield, support                                      positions.py
    attacker without the ball             approach  >  stuck?  >  back, aside or round        stuck.py, recovery.py
    in the own penalty area, not its keeper   walk out: the rules, not the paper              skills/keeping_rules.py
    whoever has the ball                  clear, the goalkeeper  >  shoot  >  pass  >  orbit  >  dribble   steering.py

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.sacks_2001.actuators import (
    glance,
    look_ahead,
    look_around,
    look_down,
    orbit,
    rotate,
    search_for_ball,
    sidestep,
    step_with_ball,
    turn_with_ball,
    walk_back,
    walk_to_ball,
)
from soccer_env.baselines.sacks_2001.ball_notes import JUST_SEEN, note_possession, note_sighting
from soccer_env.baselines.sacks_2001.goalkeeper import can_clear, guard, is_shot, may_clear, meet_shot
from soccer_env.baselines.sacks_2001.memory import (
    APPROACH,
    BACK,
    DRIBBLE,
    GUARD,
    ORBIT,
    PASS,
    ROTATE,
    SEARCH,
    SHOOT,
    SIDESTEP,
    SUPPORT,
    YIELD,
)
from soccer_env.baselines.sacks_2001.positions import choose_role, go_home, support
from soccer_env.baselines.sacks_2001.recovery import begin_recovery, go_on_recovering
from soccer_env.baselines.sacks_2001.shooting import choose_target, find_pass, may_shoot
from soccer_env.baselines.sacks_2001.steering import choose_dribble_direction, off_ahead, step_speed
from soccer_env.baselines.sacks_2001.stuck import (
    is_near,
    is_stuck,
    note_gap,
    reset_approach_counters,
    share_of_step,
    watch_approach,
)
from soccer_env.compiled import compiled
from soccer_env.geometry import atan2, wrap
from soccer_env.skills.deciding import required_ball_distance
from soccer_env.skills.keeping_rules import is_in_own_area, leave_area, may_not_enter, wait_at_area
from soccer_env.skills.kicking import aim_kick, choose_kick_side, is_blocked_ahead
from soccer_env.skills.sight import side_of

REALLY_HAS = 1.0  # [s] of one behaviour with the ball after which an approach is over, with its counters, assumed
FULL_TURN = 6.3  # [rad]
STAY_HOME = 6.0  # [s] at the own place before the search on the spot begins anew, assumed
PASS_STRENGTH = 0.3  # [1] of a kick to a team-mate: the softest, assumed
MOST_OFF = 2.8  # [rad] off the goal beyond which an orbit keeps the side it began with, assumed


@compiled
def decide(belief, tracks, memory, command, sight, k, play, elapsed):
    """Choose a behaviour and carry it out, as a command."""
    before = memory.behaviour
    note_sighting(belief, memory, k, play, elapsed)
    note_possession(belief.ball, memory, k, play, elapsed)
    note_gap(belief.ball, memory, elapsed)
    memory.behaviour = choose_behaviour(belief, tracks, memory, sight, k, play, elapsed)
    memory.clock = memory.clock + elapsed if memory.behaviour == before else 0.0
    if memory.behaviour != SEARCH:
        memory.turned = 0.0
    memory.glances = 0
    act(belief, tracks, memory, command, sight, k, play, elapsed)
    if play.keeps_out == 1 and may_not_enter(belief.situation, k) and not is_kicking(memory):
        leave_penalty_area(memory, command, sight, k, play)
    memory.winding = memory.winding + elapsed if command.kick > 0.0 else 0.0


@compiled
def leave_penalty_area(memory, command, sight, k, play):
    """Walk out of the own penalty area and leave the ball to the goalkeeper, as the rules demand."""
    in_it = is_in_own_area(sight.ball_x, sight.ball_y, k, k.ball_radius)
    if not leave_area(command, sight, k, play) and in_it and memory.behaviour == APPROACH:
        wait_at_area(command, sight, k, play)


@compiled
def choose_behaviour(belief, tracks, memory, sight, k, play, elapsed):
    """Return the player's behaviour for this control step."""
    situation, ball = belief.situation, belief.ball
    recovers = BACK <= memory.behaviour <= ROTATE
    if recovers:
        go_on_recovering(belief, tracks, memory, k, play, elapsed)
        if memory.behaviour != APPROACH:
            return memory.behaviour
    if is_kicking(memory):
        return memory.behaviour
    has_ball = memory.had_ball < play.possession_time
    unseen = memory.trusted > play.lost or ball.confidence <= 0.0
    if unseen and not has_ball and memory.kicked <= 0.0:
        return SEARCH
    choose_role(belief, memory, play, elapsed)
    waits = wait_for_ball(situation, memory, sight, k, play, has_ball)
    if waits != APPROACH:
        reset_approach_counters(memory)  # MS22
        return waits
    return choose_attack(belief, tracks, memory, sight, k, play, has_ball, elapsed)


@compiled
def wait_for_ball(situation, memory, sight, k, play, has_ball):
    """Return the behaviour of a player that leaves the ball to others, or APPROACH if it should go for the ball."""
    if situation.keeper == 1 and not (has_ball or may_clear(sight, play, k)):
        return GUARD
    if required_ball_distance(situation, k) > 0.0:
        return YIELD
    if situation.keeper == 0 and memory.attacks == 0 and not has_ball:
        return SUPPORT
    return APPROACH


@compiled
def is_kicking(memory):
    """Tell whether the leg is winding up for a kick, which can no longer be cancelled."""
    return (memory.behaviour == SHOOT or memory.behaviour == PASS) and memory.winding > 0.0


@compiled
def choose_attack(belief, tracks, memory, sight, k, play, has_ball, elapsed):
    """Choose an attacker's behaviour: approach the ball, recover when stuck, or play the ball.  MS22, MS26"""
    aside = play.plays_aside == 1 and sight.held == 1 and (memory.foiled > 0.0 or is_blocked_ahead(sight, k))
    memory.kick_side = choose_kick_side(sight, k) if aside else 0.0
    if memory.kick_side == 0.0 and (not has_ball or is_ball_contested(belief, tracks, play)):
        watch_approach(belief.ball, memory, k, play, elapsed)
        if play.recovery == 1 and is_stuck(belief.ball, memory, k, play):
            begin_recovery(memory, k, play)
            return BACK
        return APPROACH
    if memory.clock >= REALLY_HAS:
        reset_approach_counters(memory)
    memory.tries = 0
    off = wrap(choose_aim(sight, memory, k, play) - sight.heading)
    shoots = may_shoot(belief, tracks, sight, memory, k, play)
    clears = memory.foiled <= 0.0 and can_clear(belief.situation, sight, k, play)
    if memory.kick_side != 0.0 or clears or (shoots and abs(off) < play.orbit_until):
        return SHOOT
    if play.passes == 1 and memory.foiled <= 0.0 and find_pass(sight, k, play) >= 0:
        return PASS
    if memory.behaviour == ORBIT and abs(off) > play.orbit_until:
        return ORBIT
    faces_first = play.avoidance == 0 or (shoots and play.choose_shots == 0)
    if faces_first and abs(off) > play.orbit_until:
        return ORBIT
    return ORBIT if abs(off) > play.orbit_beyond else DRIBBLE


@compiled
def is_ball_contested(belief, tracks, play):
    """Tell whether an opponent is so near ahead that the ball may be between its paws as well.  MS27"""
    obstacle = belief.obstacle
    if 0.0 < obstacle.distance < play.contested_range and abs(obstacle.bearing) < play.contested_angle:
        return True
    for slot in range(tracks.shape[0]):
        track = tracks[slot]
        opponent = track.present == 1 and track.teammate == 0 and track.age <= play.player_age
        if opponent and track.distance < play.contested_range and abs(track.bearing) < play.contested_angle:
            return True
    return False


@compiled
def choose_aim(sight, memory, k, play):
    """Return the direction [rad], team frame, from the ball to its target in the goal, plus the aiming error."""
    ux, uy = choose_target(sight, k, play)
    return wrap(atan2(uy, ux) + memory.aim_error)


@compiled
def act(belief, tracks, memory, command, sight, k, play, elapsed):
    """Command legs, kicker and head according to the chosen behaviour."""
    chosen = memory.behaviour
    if chosen == SEARCH:
        look_for_ball(belief, memory, command, sight, k, play, elapsed)
    elif chosen == APPROACH and memory.kicked > 0.0 and belief.ball.age > JUST_SEEN:
        look_ahead(command, k)
        command.forward = sight.pace
    elif chosen == APPROACH:
        share = share_of_step(belief.ball, k, play)  # MS21
        if memory.had_ball < play.possession_time:
            share = 1.0
        walk_to_ball(command, sight, k, play, share * k.drive_forward)
    elif chosen == BACK:
        walk_back(command, sight)
    elif chosen == SIDESTEP:
        sidestep(command, sight, memory.side)
    elif chosen == ROTATE:
        rotate(command, sight, k, play, sight.bearing)
    elif chosen == GUARD:
        if is_shot(belief.ball, play):
            meet_shot(command, sight, belief.ball, k, play)
        else:
            guard(command, sight, k, play)
    elif chosen in (SUPPORT, YIELD):
        support(command, sight, memory, belief.situation, k, play, required_ball_distance(belief.situation, k))
    else:
        play_ball(belief, tracks, memory, command, sight, k, play, elapsed)
    if has_time_to_look(belief, memory, k, play):
        look_around(command, memory, k, belief.ball.bearing, elapsed)


@compiled
def has_time_to_look(belief, memory, k, play):
    """Tell whether a player unsure of its pose may look for landmarks now, because the ball is not near."""
    chosen = memory.behaviour
    if belief.own.confidence > play.unsure or is_near(belief.ball, k, play):
        return False
    return chosen in (SUPPORT, YIELD, BACK, SIDESTEP, APPROACH)


@compiled
def play_ball(belief, tracks, memory, command, sight, k, play, elapsed):
    """Play the ball at the paws: shoot, pass, orbit or dribble."""
    chosen = memory.behaviour
    look_down(command, k)
    off = wrap(choose_aim(sight, memory, k, play) - sight.heading)
    if chosen == SHOOT:
        command.kick = 1.0
        command.forward = sight.pace * 0.5
        aim_kick(command, k, memory.kick_side)
    elif chosen == PASS:
        pass_ball(command, memory, sight, k, play)
    elif chosen == ORBIT:
        if memory.clock == 0.0 or abs(off) < MOST_OFF:
            memory.side = side_of(off)
        if memory.clock < play.orbit_time:
            orbit(command, sight, k, play, off, memory.side)
        else:
            turn_with_ball(command, sight, k, play, off)
    else:
        dribble(belief, tracks, memory, command, sight, k, play, elapsed)


@compiled
def dribble(belief, tracks, memory, command, sight, k, play, elapsed):
    """Push the ball in the direction of the potential field, computed anew every play.replan.  MS45"""
    memory.replan -= elapsed
    if memory.clock == 0.0 or memory.replan <= 0.0:
        choose_dribble_direction(belief, tracks, memory, k, play)
        memory.replan += (
            play.replan if memory.clock > 0.0 and memory.replan > -play.replan else play.replan - memory.replan
        )
    off = off_ahead(belief, tracks, memory, k, play)
    goal = wrap(choose_aim(sight, memory, k, play) - sight.heading)
    step_with_ball(command, sight, k, play, off, step_speed(k, play), goal)
    glance(command, memory, belief.own, k, play, off, elapsed)


@compiled
def pass_ball(command, memory, sight, k, play):
    """Turn with the ball towards a team-mate and kick softly.  [Sacks 2001, 5]"""
    if is_kicking(memory):
        command.kick = PASS_STRENGTH
        return
    mate = find_pass(sight, k, play)
    if mate < 0:
        return
    to_x, to_y = sight.other_x[mate] - sight.ball_x, sight.other_y[mate] - sight.ball_y
    off = wrap(atan2(to_y, to_x) + memory.aim_error - sight.heading)
    if abs(off) < play.orbit_until:
        command.kick = PASS_STRENGTH
        command.forward = 0.5 * sight.pace
    else:
        orbit(command, sight, k, play, off, side_of(off))


@compiled
def look_for_ball(belief, memory, command, sight, k, play, elapsed):
    """Turn a full circle on the spot to find the ball; then walk to the player's own position and look again."""
    if memory.turned < FULL_TURN:
        search_for_ball(command, sight, memory, k, play, belief.ball.bearing, elapsed)
        return
    go_home(command, sight, belief.situation, k, play)
    memory.turned += elapsed * FULL_TURN / STAY_HOME
    if memory.turned > 2.0 * FULL_TURN:
        memory.turned, memory.side = 0.0, -memory.side
