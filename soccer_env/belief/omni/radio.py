"""Reports by radio with own pose, ball and number; `reports.py` writes and uses them.  MH05

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

from math import inf

import numpy as np

from soccer_env.belief.omni.reports import adopt_reported_ball, place_teammates, write_report
from soccer_env.belief.talk import (
    RADIO,
    REMEMBERED,
    SEEN,
    deliver_message,
    frames_between,
    hear_word,
    message_dtype,
    send_report,
)
from soccer_env.compiled import compiled
from soccer_env.guards.ranges import CONFIDENCE, ENDLESS, FLAG, LATELY, NUMBER, ranged_record
from soccer_env.random_numbers import draw_uniform
from soccer_env.records.ball_words import word_for_distance
from soccer_env.records.beliefs import PLAYER_OR_UNKNOWN, WORDS

REPORT = ranged_record(
    [
        ("frame", "i4", LATELY),  # in which it was said
        ("word", "i2", WORDS),  # range of the speaker's distance to the ball
        ("number", "i1", PLAYER_OR_UNKNOWN),  # of the speaker
        ("keeper", "i1", FLAG),  # 1: it is the goalkeeper
        ("distance", "f8", ENDLESS),  # [m] of the speaker to the ball, as far as it tells; inf: not seen
        ("x", "f8", NUMBER),  # [m] team frame: the speaker
        ("y", "f8", NUMBER),  # [m]
        ("heading", "f8", NUMBER),  # [rad] team frame
        ("vx", "f8", NUMBER),  # [m/s] team frame
        ("vy", "f8", NUMBER),  # [m/s]
        ("confidence", "f8", CONFIDENCE),  # [0, 100] in this pose
        ("ball_x", "f8", NUMBER),  # [m] team frame
        ("ball_y", "f8", NUMBER),  # [m]
        ("ball_vx", "f8", NUMBER),  # [m/s] team frame
        ("ball_vy", "f8", NUMBER),  # [m/s]
        ("ball_age", "f8", ENDLESS),  # [s] since the speaker saw it
        ("ball_confidence", "f8", CONFIDENCE),  # [0, 100] in where it is on the field; 0: no ball is known
    ]
)
RADIO_MESSAGE = message_dtype(REPORT)


@compiled
def exchange_radio(percepts, beliefs, tracks, messages, noise, k, s, w, home, rows):
    """Let the robots of one match report by radio, and add the reported team-mates and ball to the beliefs.  MH05

    A robot reports every s.radio_period; a report arrives s.radio_delay later, or is lost with probability
    s.radio_loss. `shared` False: no radio.
    """
    if w.shared == 0:
        return
    pause, wait = frames_between(s.radio_period, s.radio_delay, k)
    fresh = False
    for r in rows:
        message, frame = messages[r], np.int64(percepts[r].body.frame)
        message.fresh = 0
        deliver_message(message, frame)
        if percepts[r].body.active == 1 and frame % pause == 0:
            write_radio_report(message.reports[1 - message.latest], beliefs[r])
            send_report(message, frame, wait, draw_uniform(noise[r], RADIO) < s.radio_loss)
            deliver_message(message, frame)
        fresh = fresh or message.fresh == 1
    scratch = np.empty((max(beliefs.shape[0], tracks.shape[1]) if fresh else 0, 4))
    for r in rows:
        frame = np.int64(percepts[r].body.frame)
        if fresh:
            place_teammates(beliefs[r].own, tracks[r], messages, r, frame, scratch, k, w, home, rows)
        if beliefs[r].ball.age >= w.shared_age:
            adopt_reported_ball(beliefs[r], messages, r, frame, k, w, home, rows)
        hear_word(beliefs[r].heard, messages, r, frame, REMEMBERED * pause + wait, k, home, rows)


@compiled
def write_radio_report(report, belief):
    """Write the report that a robot sends by radio.  MH05"""
    ball = belief.ball
    seen = ball.confidence > 0.0 and ball.age < SEEN
    report.distance = ball.filtered_distance if seen else inf
    report.word = word_for_distance(report.distance)
    write_report(report, belief)
