"""Keep replays of matches that were played: the best, the worst, every goal as a clip.

    contest = contest_of(conditions, league, {})
    kept = keep_replays(contest, lines, Keep("best,goals"), Path("runs/match"))

Nothing is recorded as matches are played: a match follows from its seed, so the few that are worth keeping are played
once more. Each has to end in the state that its line tells, and its file proves every control step.

choice.py        which matches are asked for
keep.py          `keep_replays`: a match once more, with its goals as clips; kept.json lists the files
page_section.py  kept replays as a part of a report's page
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.evaluate.replays.choice import Keep
    from soccer_env.train.evaluate.replays.keep import Kept, keep_replays, kept_in

__all__ = ["Keep", "Kept", "keep_replays", "kept_in"]
__getattr__, __dir__ = lazy_names(
    __name__,
    {
        "Keep": "soccer_env.train.evaluate.replays.choice",
        "Kept": "soccer_env.train.evaluate.replays.keep",
        "keep_replays": "soccer_env.train.evaluate.replays.keep",
        "kept_in": "soccer_env.train.evaluate.replays.keep",
    },
)
