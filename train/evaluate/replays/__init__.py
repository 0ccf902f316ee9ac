"""Keep replays of finished matches: the best match, the worst match, and every goal as a clip.

    contest = contest_of(conditions, league, {})
    kept = keep_replays(contest, lines, Keep("best,goals"), Path("runs/match"))

Evaluations record nothing: a match follows from its seed, so the few matches worth keeping are played once more. Each
must end in the state of its line, and its file proves every control step.

choice.py        choose the matches to keep
keep.py          `keep_replays`: play a match once more, with its goals as clips; kept.json lists the files, and a
                 section of a report's page
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.evaluate.replays.choice import Keep
    from soccer_env.train.evaluate.replays.keep import Kept, keep_replays, kept_in

__all__ = ["Keep", "Kept", "keep_replays", "kept_in"]
__getattr__, __dir__ = lazy_names(
    __name__, {"Keep": "choice", "Kept": "keep", "keep_replays": "keep", "kept_in": "keep"}
)
