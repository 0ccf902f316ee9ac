"""Messages between team-mates, by loudspeaker or by radio, which are delayed and can be lost.  MS06, MH05

All robots speak in the same frames; a message arrives a while later at all team-mates, or is lost for all. A robot has
one message on its way at a time: it does not speak before the last one has arrived.

    legged/talk.py   words of four bits by loudspeaker        omni/radio.py   reports of pose, ball and number

Rows below `home` are one team, the others the other team; only `rows` take part.

`k`: the league's constants.
"""

from math import inf

import numpy as np

from soccer_env.compiled import compiled
from soccer_env.guards.ranges import FLAG, LATELY, ranged_record
from soccer_env.records.ball_words import SILENT
from soccer_env.types import RobotStream

RADIO = int(RobotStream.RADIO)
SEEN = 0.5  # [s] a ball that was seen so recently is "seen": pictures miss one now and then, assumed
REMEMBERED = 2.0  # periods for which a word counts after its arrival


def message_dtype(kind: np.dtype) -> np.dtype:
    """Return the dtype of a robot's messages, for one `kind` of report: words or radio reports."""
    return ranged_record(
        [
            ("reports", kind, (2,)),  # the last one that arrived, and the one on its way
            ("latest", "i2", FLAG),  # which of the two arrived last
            ("known", "i2", FLAG),  # 1: one has arrived
            ("fresh", "i2", FLAG),  # 1: it arrived in this frame
            ("flying", "i2", FLAG),  # 1: the other is on its way
            ("due", "i8", LATELY),  # frame in which that one arrives
        ]
    )


@compiled
def frames_between(period, delay, k):
    """Return the number of frames between two messages of a robot, and the number of frames of a message's delay."""
    wait = int(delay / k.dt + 0.5)
    return max(int(period / k.dt + 0.5), wait, 1), wait


@compiled
def deliver_message(message, frame):
    """Mark a robot's message as arrived, if it is due in this frame."""
    if message.flying == 1 and frame >= message.due:
        message.latest = 1 - message.latest
        message.known = message.fresh = 1
        message.flying = 0


@compiled
def send_report(message, frame, wait, lost):
    """Send the written report, which arrives `wait` frames later unless it is lost."""
    message.reports[1 - message.latest].frame = frame
    message.flying, message.due = 0 if lost else 1, frame + wait


@compiled
def hear_word(heard, messages, r, frame, frames, k, home, rows):
    """Write the word heard from the team-mate nearest to the ball, of messages at most `frames` frames old.

    Team-mates with equal distances and equally old messages say the same word, so that either may be taken.
    """
    heard.word = SILENT
    heard.distance = inf
    heard.age = inf
    for other in rows:
        message = messages[other]
        if other == r or (other < home) != (r < home) or message.known == 0:
            continue
        report = message.reports[message.latest]
        age = (frame - report.frame) * k.dt
        if report.word == SILENT or frame - report.frame > frames:
            continue
        if report.distance < heard.distance or (report.distance == heard.distance and age < heard.age):
            heard.word = report.word
            heard.distance = report.distance
            heard.age = age
