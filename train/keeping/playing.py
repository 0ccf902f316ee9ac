"""Play a match once more, from its seed, and write it down: the whole of it, and its goals as clips."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.replay.clips import Clips
from soccer_env.train.evaluate.contest import Contest
from soccer_env.train.evaluate.recording import NOTE_EVERY, shown_of_memory
from soccer_env.train.evaluate.results import MatchLine
from soccer_env.types import NO_TEAM

BEFORE, AFTER = 8.0, 1.5  # [s] that a clip shows of what led to a goal, at least, and of what came of it


@dataclass(frozen=True)
class Again:
    """A match that was played once more; `goals`: the first control step of each clip, and the clip."""

    whole: Replay
    goals: list[tuple[int, Replay]]


def play_again(contest: Contest, line: MatchLine, goals: bool, advance: Callable[[float], None]) -> Again:
    """Play a match of a contest once more; ValueError if it ends in another state than its line says.

    `goals`: clips of them as well. `advance` is told of control steps.
    """
    match = contest.start(line.side, [line.seed])
    try:
        recorder = Recorder(match, Thoughts(match, shown_of_memory()))
        clips = Clips(match, recorder, BEFORE, AFTER)
        for step in range(line.steps):
            if goals:
                clips.note()
            match.step(None)
            if goals and match.events["goal"][0] != NO_TEAM:
                clips.mark()
            if step % NOTE_EVERY == 0:
                advance(NOTE_EVERY)
        whole = recorder.stop()
        if match.state_hash(0) != line.state:
            raise ValueError(
                f"match {line.match} (seed {line.seed}) cannot be kept: played again, it ended differently; a team of "
                "its own must decide from what it is given alone"
            )
    finally:
        match.close()
    return Again(whole, clips.cut(whole))
