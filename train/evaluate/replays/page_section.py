"""The section about kept replays in a report page."""

from collections.abc import Sequence

from soccer_env.train.evaluate.replays import Kept
from soccer_env.train.report.page import ReportPage

HEAD = ("", "match", "score", "home, away", "from", "length", "a minute", "files")
WORDS = {"best": "best match", "worst": "worst match", "goals": "goal {}"}
VERIFIED = (
    "`soccer replay FILE --verify` plays a replay again and proves every step; `soccer watch FILE` shows it, and "
    "`soccer export FILE --out match.html` makes a page of it. Scores are the first team's first."
)


def add_replays(page: ReportPage, kept: Sequence[Kept]) -> None:
    """Add a section of replays with links to their files to a page; nothing if no replays were kept."""
    if not kept:
        return
    page.section("Replays")
    page.links(HEAD, [(row_of(one), links_of(one)) for one in kept])
    page.say(f"{summary(kept)} {VERIFIED}")


def row_of(kept: Kept) -> list[str]:
    """Return the texts of a replay's table row."""
    what, score = WORDS.get(kept.kind, kept.kind).format(kept.number), f"{kept.goals_for} : {kept.goals_against}"
    minutes, seconds = divmod(round(kept.start), 60)
    times = [f"{minutes}:{seconds:02d}", f"{kept.seconds:.0f} s", f"{kept.rate / 1e3:.0f} kB"]
    return [what, f"{kept.match}", score, f"{kept.home}, {kept.away}", *times]


def links_of(kept: Kept) -> list[tuple[str, str]]:
    """Return (words, file) for each link to a replay's files."""
    return [("watch", kept.page), ("file", kept.file)] if kept.page else [("file", kept.file)]


def summary(kept: Sequence[Kept]) -> str:
    """Return the number, total length and total size of replays in words."""
    size, minutes = sum(one.bytes for one in kept), sum(one.seconds for one in kept) / 60.0
    rate = size / 1e3 / max(minutes, 1e-9)
    return f"{len(kept)} replays, {minutes:.1f} minutes of play, {size / 1e6:.2f} MB: {rate:.0f} kB a minute."
