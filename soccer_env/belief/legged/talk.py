"""Messages by loudspeaker: four bits for the distance to the ball, 1 to 15, or 0 "I do not see it".  MS06

`k`: the league's constants; `s`: settings of the sensors; `w`: settings of the memory.
"""

import numpy as np

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
from soccer_env.guards.ranges import ENDLESS, LATELY, ranged_record
from soccer_env.random_numbers import draw_uniform
from soccer_env.records.ball_words import SILENT, distance_of_word, word_for_distance
from soccer_env.records.beliefs import WORDS

WORD = ranged_record(
    [  # what a loudspeaker says
        ("frame", "i4", LATELY),  # in which it was said
        ("word", "i4", WORDS),  # range of the speaker's distance to the ball
        ("distance", "f8", ENDLESS),  # [m] of that range; inf: not seen
    ]
)
SOUND_MESSAGE = message_dtype(WORD)


@compiled
def exchange_words(percepts, beliefs, tracks, messages, noise, k, s, w, home, rows):
    """Let the robots of one match send a message of four bits each second, and hear their team-mates.  MS06

    Four bits a second: s.audio_period between two words, heard after s.audio_delay, lost with probability s.audio_loss.
    """
    pause, wait = frames_between(s.audio_period, s.audio_delay, k)
    for r in rows:
        message, frame = messages[r], np.int64(percepts[r].body.frame)
        deliver_message(message, frame)
        if percepts[r].body.active == 1 and frame % pause == 0:
            write_distance_word(message.reports[1 - message.latest], beliefs[r].ball)
            send_report(message, frame, wait, draw_uniform(noise[r], RADIO) < s.audio_loss)
            deliver_message(message, frame)
    for r in rows:
        hear_word(beliefs[r].heard, messages, r, percepts[r].body.frame, REMEMBERED * pause + wait, k, home, rows)


@compiled
def write_distance_word(report, ball):
    """Write the four-bit word for the distance to the ball into a report.  MS06"""
    seen = ball.confidence > 0.0 and ball.age < SEEN
    report.word = word_for_distance(ball.filtered_distance) if seen else SILENT
    report.distance = distance_of_word(report.word)
