"""Two timers of a player: since a certain sighting of the ball, and since possession of the ball.  MS27

`k`: the league's constants; `play`: the team's settings.
"""

from soccer_env.baselines.sacks_2001.memory import PASS, SHOOT
from soccer_env.compiled import compiled
from soccer_env.geometry import cosine_and_sine, point_of_frame

NEVER = 1e9  # [s]
JUST_NOW, JUST_SEEN = 0.01, 0.15  # [s]
FOUND = 2  # sightings that make a ball certain, assumed
OUTSIDE, OUTSIDE_SHARE = 0.10, 0.10  # [m], [1] of its distance, that a ball may seem to lie behind the boards, assumed
GAP = 0.5  # [s] unseen that ends a row of sightings, assumed
LOOK_DOWN = 0.8  # [s] of lowering the head and looking down, after which an unseen ball is not there, assumed
AFTER_KICK = 1.0  # [s] for which a robot looks after the ball that it kicked, assumed


@compiled
def note_sighting(belief, memory, k, play, elapsed):
    """Update the time since the ball was surely seen, that is in several frames in a row and on the field.

    A glimpse may show anything orange, such as the patches behind the boards.
    """
    ball = belief.ball
    if ball.age > GAP or ball.confidence <= 0.0 or is_ball_outside(belief, k, play):
        memory.sightings = 0
    elif ball.age < JUST_NOW:
        memory.sightings += 1
    memory.trusted = 0.0 if memory.sightings >= FOUND else memory.trusted + elapsed


@compiled
def is_ball_outside(belief, k, play):
    """Tell whether the ball is believed to lie behind the boards, clearly, by a robot that is sure of its pose."""
    own, ball = belief.own, belief.ball
    if own.confidence < play.unsure:
        return False
    cosine, sine = cosine_and_sine(own.heading)
    x, y = point_of_frame(own.x, own.y, ball.x, ball.y, cosine, sine)
    room = OUTSIDE + OUTSIDE_SHARE * ball.distance
    return abs(x) > 0.5 * k.pitch_length + room or abs(y) > 0.5 * k.pitch_width + room


@compiled
def note_possession(ball, memory, k, play, elapsed):
    """Update the time since the ball was between the paws; a look down that shows no ball ends possession.  MS27

    A kick ends the possession too: the robot then looks after the ball.
    """
    memory.had_ball += elapsed
    memory.down = memory.down + elapsed if memory.glances == 0 else 0.0
    memory.kicked = max(memory.kicked - elapsed, 0.0)
    memory.foiled = max(memory.foiled - elapsed, 0.0)
    if ball.held == 1 and ball.age <= JUST_SEEN:
        memory.had_ball = 0.0
        if 0.0 < memory.kicked < AFTER_KICK - JUST_SEEN:
            memory.foiled = play.foiled_time
    elif memory.down > LOOK_DOWN and memory.had_ball > LOOK_DOWN:
        memory.had_ball = NEVER
    if (memory.behaviour == SHOOT or memory.behaviour == PASS) and memory.winding > k.kicker_wind_up + 2.0 * k.dt:
        memory.had_ball = NEVER
        memory.kicked = AFTER_KICK
        memory.winding = 0.0
