"""What team-mates tell each other: words of four bits by loudspeaker, or reports by radio.  MS06, MH05

Everybody speaks in the same frames; what was said arrives a while later at all team-mates, or is lost for all. One
message of a robot is on its way at a time: it does not speak before the last one has arrived.

    legged        exchange: 0 "I do not see the ball", or 1 to 15: how far it is (soccer_env/words.py)
    middle size   exchange_radio: own pose, ball, number; `reports.py` makes and uses them

Rows below `home` are team-mates of each other, as are those from it on; only `rows` take part.
"""

from __future__ import annotations

from math import inf

import numpy as np

from soccer_env.belief.reports import adopt_ball, place_teammates, write_report
from soccer_env.compiled import compiled
from soccer_env.random_numbers import uniform
from soccer_env.types import RobotStream
from soccer_env.words import SILENT, distance_of, word_for

RADIO = int(RobotStream.RADIO)
SEEN = 0.5  # [s] a ball that was seen so recently is "seen": pictures miss one now and then, assumed
REMEMBERED = 2.0  # periods for which a word that arrived counts

WORD = np.dtype(
    [  # what a loudspeaker says
        ("frame", "i4"),  # in which it was said
        ("word", "i4"),  # range of the speaker's distance to the ball
        ("distance", "f8"),  # [m] of that range; inf: not seen
    ]
)
REPORT = np.dtype(
    [
        ("frame", "i4"),  # in which it was said
        ("word", "i2"),  # range of the speaker's distance to the ball
        ("number", "i1"),  # of the speaker
        ("keeper", "i1"),  # 1: it is the goalkeeper
        ("distance", "f8"),  # [m] of the speaker to the ball, as far as it tells; inf: not seen
        ("x", "f8"),  # [m] team frame: the speaker
        ("y", "f8"),  # [m]
        ("heading", "f8"),  # [rad] team frame
        ("vx", "f8"),  # [m/s] team frame
        ("vy", "f8"),  # [m/s]
        ("confidence", "f8"),  # [0, 100] in this pose
        ("ball_x", "f8"),  # [m] team frame
        ("ball_y", "f8"),  # [m]
        ("ball_vx", "f8"),  # [m/s] team frame
        ("ball_vy", "f8"),  # [m/s]
        ("ball_age", "f8"),  # [s] since the speaker saw it
        ("ball_confidence", "f8"),  # [0, 100] in where it is on the field; 0: no ball is known
    ]
)


def message_of(kind: np.dtype) -> np.dtype:
    """Return the record of what a robot says, in words or reports."""
    return np.dtype(
        [
            ("reports", kind, (2,)),  # the last one that arrived, and the one on its way
            ("latest", "i2"),  # which of the two arrived last
            ("known", "i2"),  # 1: one has arrived
            ("fresh", "i2"),  # 1: it arrived in this frame
            ("flying", "i2"),  # 1: the other is on its way
            ("due", "i8"),  # frame in which that one arrives
        ]
    )


SOUND_MESSAGE = message_of(WORD)
RADIO_MESSAGE = message_of(REPORT)


@compiled
def exchange(percepts, beliefs, tracks, messages, noise, k, s, home, rows):
    """Let the robots of one match say a word of four bits each second, and hear their team-mates.  MS06

    Four bits a second: s.audio_period between two words, heard after s.audio_delay, lost with probability s.audio_loss.
    """
    pause, wait = frames_between(s.audio_period, s.audio_delay, k)
    for r in rows:
        message, frame = messages[r], np.int64(percepts[r].body.frame)
        deliver(message, frame)
        if percepts[r].body.active == 1 and frame % pause == 0:
            say_word(message.reports[1 - message.latest], beliefs[r].ball)
            send(message, frame, wait, uniform(noise[r], RADIO) < s.audio_loss)
            deliver(message, frame)
    for r in rows:
        hear(beliefs[r].heard, messages, r, percepts[r].body.frame, REMEMBERED * pause + wait, k, home, rows)


@compiled
def exchange_radio(percepts, beliefs, tracks, messages, noise, k, s, w, home, rows):
    """Let the robots of one match report by radio, and fill in for what they do not see themselves.  MH05

    Every s.radio_period, delivered s.radio_delay later, lost with probability s.radio_loss; `shared` False: no radio.
    """
    if w.shared == 0:
        return
    pause, wait = frames_between(s.radio_period, s.radio_delay, k)
    fresh = False
    for r in rows:
        message, frame = messages[r], np.int64(percepts[r].body.frame)
        message.fresh = 0
        deliver(message, frame)
        if percepts[r].body.active == 1 and frame % pause == 0:
            say_report(message.reports[1 - message.latest], beliefs[r])
            send(message, frame, wait, uniform(noise[r], RADIO) < s.radio_loss)
            deliver(message, frame)
        fresh = fresh or message.fresh == 1
    room = np.empty((max(beliefs.shape[0], tracks.shape[1]) if fresh else 0, 4))
    for r in rows:
        frame = np.int64(percepts[r].body.frame)
        if fresh:
            place_teammates(beliefs[r].own, tracks[r], messages, r, frame, room, k, w, home, rows)
        if beliefs[r].ball.age >= w.shared_age:
            adopt_ball(beliefs[r], messages, r, frame, k, w, home, rows)
        hear(beliefs[r].heard, messages, r, frame, REMEMBERED * pause + wait, k, home, rows)


@compiled
def frames_between(period, delay, k):
    """Return the frames between two messages of a robot, and those that one is on its way."""
    wait = int(delay / k.dt + 0.5)
    return max(int(period / k.dt + 0.5), wait, 1), wait


@compiled
def deliver(message, frame):
    """Let the message that is on its way arrive when it is due."""
    if message.flying == 1 and frame >= message.due:
        message.latest = 1 - message.latest
        message.known = message.fresh = 1
        message.flying = 0


@compiled
def send(message, frame, wait, lost):
    """Send what was written into the free report, or lose it."""
    message.reports[1 - message.latest].frame = frame
    message.flying, message.due = 0 if lost else 1, frame + wait


@compiled
def say_word(report, ball):
    """Write the word for the distance to the ball, and nothing more.  MS06"""
    seen = ball.confidence > 0.0 and ball.age < SEEN
    report.word = word_for(ball.filtered_distance) if seen else SILENT
    report.distance = distance_of(report.word)


@compiled
def say_report(report, belief):
    """Write all that a robot tells by radio.  MH05"""
    ball = belief.ball
    seen = ball.confidence > 0.0 and ball.age < SEEN
    report.distance = ball.filtered_distance if seen else inf
    report.word = word_for(report.distance)
    write_report(report, belief)


@compiled
def hear(heard, messages, r, frame, frames, k, home, rows):
    """Fill in what the team-mate says that is nearest to the ball, of messages not older than some frames; the newest.

    Team-mates that are equally near and equally recent say the same, so that it does not matter whose word is taken.
    """
    heard.word, heard.distance, heard.age = SILENT, inf, inf
    for other in rows:
        message = messages[other]
        if other == r or (other < home) != (r < home) or message.known == 0:
            continue
        report = message.reports[message.latest]
        age = (frame - report.frame) * k.dt
        if report.word == SILENT or frame - report.frame > frames:
            continue
        if report.distance < heard.distance or (report.distance == heard.distance and age < heard.age):
            heard.word, heard.distance, heard.age = report.word, report.distance, age
