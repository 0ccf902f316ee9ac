"""How goals fell, as a table for the terminal and as lines of JSON."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

from soccer_env.statistics.figures import FIGURES
from soccer_env.statistics.records import GoalKind
from soccer_env.train.play.goals.settings import GoalSettings
from soccer_env.train.play.goals.watching import BEFORE, SIDES, SeenGoals
from soccer_env.whole_files import write_whole

if TYPE_CHECKING:
    from rich.table import Table

TEXTS = {figure.name: figure.text for figure in FIGURES}


def counts_of(seen: SeenGoals) -> dict[str, int]:
    """Return how many goals are of each kind, which statistics of goals count them, and what was called before them.

    A call counts once a goal, however often the referee made it.
    """
    found = Counter({f"goals_{kind.name.lower()}": 0 for kind in GoalKind})
    for goal in seen.goals:
        found[f"goals_{goal.kind.name.lower()}"] += 1
        found.update(name for name, counts in goal.before.items() if counts)
        found[f"scored by {SIDES[goal.team]}"] += 1
        found.update({f"{BEFORE:g} s before: {words}" for _, words in goal.calls})
    kinds = [name for name in found if name in TEXTS]
    return {name: found[name] for name in (*kinds, *sorted(name for name in found if name not in TEXTS))}


def goals_table(seen: SeenGoals, settings: GoalSettings) -> Table:
    """Return the table of a look at goals."""
    from rich.table import Table

    total, minutes = len(seen.goals), seen.matches * settings.minutes
    drawn = Table(
        title=f"{total} goals of {settings.home} against {settings.away}, {seen.league.name}; {seen.fallen} fell in "
        f"{seen.matches} x {settings.minutes:g} min ({seen.fallen / minutes:.2f} a minute), seed {settings.seed}"
    )
    drawn.add_column("")
    drawn.add_column("goals", justify="right")
    drawn.add_column("share [%]", justify="right")
    drawn.add_column("what they are")
    for name, count in counts_of(seen).items():
        share = f"{100.0 * count / total:.0f}" if total else ""
        drawn.add_row(name, str(count), share, TEXTS.get(name, ""))
    return drawn


def write(seen: SeenGoals, folder: Path) -> None:
    """Write goals.jsonl, a line for each goal."""
    folder.mkdir(parents=True, exist_ok=True)
    lines = [json.dumps(goal.as_dict()) for goal in seen.goals]
    write_whole(folder / "goals.jsonl", "".join(f"{line}\n" for line in lines).encode())
