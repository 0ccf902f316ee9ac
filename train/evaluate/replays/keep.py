"""Replays in the folder of a run: files named by kind, match and seed, and a list of these files.

replays/best-match-4-seed-6213.replay     best, worst: whole matches       .html beside it: its page
replays/goal-2-match-7-seed-9921.replay   the second goal of match 7, and the seconds before it
replays/kept.json                         the list
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path

from soccer_env.guards.whole_files import read_regular_file, write_atomically
from soccer_env.replay import Recorder, Replay, Thoughts
from soccer_env.replay.clips import Clips
from soccer_env.shows.browser import write_page
from soccer_env.train.evaluate.contest import Contest
from soccer_env.train.evaluate.recording import NOTE_EVERY, shown_memory_fields
from soccer_env.train.evaluate.replays.choice import GOALS, KINDS, Keep
from soccer_env.train.evaluate.results import KEPT, REPLAYS, MatchLine
from soccer_env.train.files import LARGEST
from soccer_env.train.progress import Progress
from soccer_env.train.report.page import ReportPage
from soccer_env.types import NO_TEAM

BEFORE, AFTER = 8.0, 1.5  # [s] that a clip shows before (at least) and after a goal


@dataclass(frozen=True)
class Kept:
    """A replay in the folder of a run; goals are counted from the first team's side."""

    kind: str  # of `choice.KINDS`
    file: str  # relative to the run's folder
    number: int  # of a goal in its match, 1 and more; else 0
    match: int
    seed: int  # of the match
    home: str
    away: str
    goals_for: int  # of the match
    goals_against: int
    start: float  # [s] of the match at which the replay begins
    seconds: float  # length of the replay
    bytes: int
    page: str  # page for the browser; "" without one
    state: str  # of the match at its end

    @property
    def rate(self) -> float:
        """Return the file size per minute of play [bytes/min]."""
        return 60.0 * self.bytes / max(self.seconds, 1e-9)


def keep_replays(contest: Contest, lines: Sequence[MatchLine], keep: Keep, folder: Path) -> list[Kept]:
    """Write replays of finished matches to a run's folder; return the list of them.

    Replays that exist are not played again. The folder keeps the kinds of earlier calls, too. A replay is removed when
    more matches have changed, for example, which match is the best. ValueError if a match ends in another state;
    OSError.
    """
    earlier_keep, earlier = read_kept_list(folder)
    keep = keep.joined_with(earlier_keep)
    if not keep.kinds_in_order:
        return []
    (folder / REPLAYS).mkdir(parents=True, exist_ok=True)
    wanted = keep.matches_to_keep(lines)
    ready = [one for one in earlier if any(is_replay_of(one, *each) for each in wanted) and is_complete(folder, one)]
    missing = [(kind, line) for kind, line in wanted if not any(is_replay_of(one, kind, line) for one in ready)]
    for one in earlier:
        if one not in ready:
            for name in filter(None, (one.file, one.page)):
                (folder / name).unlink(missing_ok=True)
    kept = ready + play_missing_replays(contest, missing, folder)
    if keep.pages:
        kept = [add_page(folder, one) for one in kept]
    kept.sort(key=lambda one: (KINDS.index(one.kind), one.match, one.number))
    record = {"asked": asdict(keep), "replays": [asdict(one) for one in kept]}
    write_atomically(folder / REPLAYS / KEPT, json.dumps(record, indent=1) + "\n")
    return kept


def kept_in(folder: Path) -> list[Kept]:
    """Return the replays that a folder lists; none if the list is missing or damaged."""
    return read_kept_list(folder)[1]


def read_kept_list(folder: Path) -> tuple[Keep, list[Kept]]:
    """Return the kinds of replays that a folder keeps so far, and the replays listed there."""
    try:
        record = json.loads(read_regular_file(folder / REPLAYS / KEPT, LARGEST))
        keep, kept = Keep(**record["asked"]), [Kept(**one) for one in record["replays"]]
    except (OSError, ValueError, TypeError, KeyError, AttributeError, RecursionError):
        return Keep(), []
    return (keep, kept) if all(map(is_valid_entry, kept)) else (Keep(), [])


def is_valid_entry(kept: Kept) -> bool:
    """Tell whether an entry of kept.json has fields of the right types, and files only in the folder `replays`."""
    values = ((getattr(kept, field.name), getattr(EXAMPLE, field.name)) for field in fields(Kept))
    if not all(isinstance(value, (type(example), int)) for value, example in values):
        return False
    return kept.kind in KINDS and all(
        Path(name).parent == Path(REPLAYS) for name in (kept.file, kept.page or kept.file)
    )


EXAMPLE = Kept("", "", 0, 0, 0, "", "", 0, 0, 0.0, 0.0, 0, "", "")


def is_replay_of(kept: Kept, kind: str, line: MatchLine) -> bool:
    """Tell whether a replay is of this kind and shows the match of a result line, up to its final state."""
    return (kept.kind, kept.match, kept.state) == (kind, line.match, line.state)


def is_complete(folder: Path, kept: Kept) -> bool:
    """Tell whether the file of a replay exists with its full size."""
    path = folder / kept.file
    return path.is_file() and path.stat().st_size == kept.bytes


def play_missing_replays(contest: Contest, missing: list[tuple[str, MatchLine]], folder: Path) -> list[Kept]:
    """Play the matches of missing replays, each match only once, and write the replays."""
    lines = {line.match: line for _, line in missing}
    kept: list[Kept] = []
    with Progress("replays to keep", float(sum(line.steps for line in lines.values()))) as bar:
        for number, line in lines.items():
            kinds = [kind for kind, one in missing if one.match == number]
            again = play_match_again(contest, line, GOALS in kinds, bar.advance)
            for kind in kinds:
                kept += write_replays(contest, line, kind, again, folder)
            bar.note(f"{len(kept)} written")
    return kept


def write_replays(contest: Contest, line: MatchLine, kind: str, again: ReplayedMatch, folder: Path) -> list[Kept]:
    """Write the replays of one kind (a whole match, or clips of goals) from one match, and return them."""
    conditions, rate = contest.conditions, contest.league.control_rate
    parts = again.goals if kind == GOALS else [(0, again.whole)]
    teams = (conditions.home, conditions.away)[:: 1 if line.side == "home" else -1]
    kept = []
    for number, (first, replay) in enumerate(parts, 1):
        name = f"goal-{number}" if kind == GOALS else kind
        file = f"{REPLAYS}/{name}-match-{line.match}-seed-{line.seed}.replay"
        size = replay.write(folder / file).stat().st_size
        entry = Kept(
            kind=kind, file=file, number=number if kind == GOALS else 0, match=line.match, seed=line.seed,
            home=teams[0], away=teams[1], goals_for=line.goals_for, goals_against=line.goals_against,
            start=first / rate, seconds=len(replay) / rate, bytes=size, page="", state=line.state,
        )  # fmt: skip
        kept.append(entry)
    return kept


def add_page(folder: Path, kept: Kept) -> Kept:
    """Write the browser page of a replay unless it exists; return the entry of the replay with its page."""
    page = str(Path(kept.file).with_suffix(".html"))
    if not kept.page or not (folder / page).is_file():
        write_page(Replay.read(folder / kept.file), folder / page, anew=True)
    return replace(kept, page=page)


@dataclass(frozen=True)
class ReplayedMatch:
    """A match that was played again; `goals`: a clip of each goal, with its first control step."""

    whole: Replay
    goals: list[tuple[int, Replay]]


def play_match_again(contest: Contest, line: MatchLine, goals: bool, advance: Callable[[float], None]) -> ReplayedMatch:
    """Play a match of a contest again; ValueError if it ends in another state than the result line says.

    `goals`: cut clips of goals as well. `advance` gets the number of control steps played.
    """
    match = contest.start(line.side, [line.seed])
    try:
        recorder = Recorder(match, Thoughts(match, shown_memory_fields()))
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
                f"match {line.match} (seed {line.seed}) cannot be kept: played again, it ended differently; a user's "
                "team must decide from its arguments alone"
            )
    finally:
        match.close()
    return ReplayedMatch(whole, clips.cut(whole))


HEAD = ("", "match", "score", "home, away", "from", "length", "a minute", "files")
WORDS = {"best": "best match", "worst": "worst match", "goals": "goal {}"}
VERIFIED = (
    "`soccer replay FILE --verify` plays a replay again and proves every step; `soccer watch FILE` shows it, and "
    "`soccer export FILE --out match.html` makes a page of it. Scores are the first team's first."
)


def add_replays(page: ReportPage, kept: Sequence[Kept]) -> None:
    """Add the section of replays, with links to files beside the page; nothing without replays."""
    if not kept:
        return
    page.section("Replays")
    links = [[*([("watch", one.page)] if one.page else []), ("file", one.file)] for one in kept]
    page.links(HEAD, zip(map(row_of, kept), links, strict=True))
    page.say(f"{summary(kept)} {VERIFIED}")


def row_of(kept: Kept) -> list[str]:
    """Return the texts of a replay's row in the table."""
    what, score = WORDS.get(kept.kind, kept.kind).format(kept.number), f"{kept.goals_for} : {kept.goals_against}"
    minutes, seconds = divmod(round(kept.start), 60)
    times = [f"{minutes}:{seconds:02d}", f"{kept.seconds:.0f} s", f"{kept.rate / 1e3:.0f} kB"]
    return [what, f"{kept.match}", score, f"{kept.home}, {kept.away}", *times]


def summary(kept: Sequence[Kept]) -> str:
    """Return the number, total length and total size of replays in words."""
    size, minutes = sum(one.bytes for one in kept), sum(one.seconds for one in kept) / 60.0
    rate = size / 1e3 / max(minutes, 1e-9)
    return f"{len(kept)} replays, {minutes:.1f} minutes of play, {size / 1e6:.2f} MB: {rate:.0f} kB a minute."
