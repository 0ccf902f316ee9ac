"""The few figures of the main README, taken from the measured tables: nothing is measured for them."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from soccer_env.train.pages.tables.heinemann import PAGE as HEINEMANN
from soccer_env.train.pages.tables.paper_page import verdict_counts
from soccer_env.train.pages.tables.sacks import PAGE as SACKS
from soccer_env.train.pages.tables.teams import PLAYERS, goals_of
from soccer_env.types import WORLD

MATCHES = (  # table, home, away, words of the row
    ("learned_2006", "learned-2006", "chaser", "middle size: the team that learned against `chaser`"),
    ("learned", "learned", "sacks-2001", "legged: the team that learned against that of the paper"),
    ("learned", "learned", "chaser", "the same against `chaser`"),
)
RULES = "league"
SPEEDS = (  # row of the benchmark, words of the row
    ("legged-2001: senses", "legged matches, 3 v 3, every robot senses and believes, one core"),
    ("middle-size-2006: senses", "the same in the middle size"),
)


class Headline(NamedTuple):
    """A row of the table and the command that measures it."""

    words: str
    value: str
    command: str


def headlines(data: dict[str, Any]) -> Iterator[Headline]:
    """Yield the rows of the headlines whose measurements are in `data`, the contents of tables.json."""
    for table, home, away, words in MATCHES:
        for row in data.get(table, {"rows": []})["rows"]:
            played = (row["home"], row["away"], row["senses"], row["players"], row.get("rules", RULES))
            if played == (home, away, "sensors", PLAYERS, RULES):
                value = f"{goals_of(row)} goals a match, {100 * row['points']['mean']:.0f} % of points"
                yield Headline(f"{words}, 3 v 3, {row['minutes']:g} minutes", value, row["command"])
    speeds = {row["name"]: row["text"] for row in data.get("speed", {"rows": []})["rows"]}
    for name, words in SPEEDS:
        if name in speeds:
            yield Headline(words, speeds[name], data["speed"]["command"])
    for page, year, command in ((SACKS, 2001, "make sacks-table"), (HEINEMANN, 2006, "make heinemann-table")):
        words = f"statements of the {year} paper, each measured on three seeds"
        yield Headline(words, verdict_counts(page.stored(), page.claims), command)


def headlines_table(data: dict[str, Any]) -> str:
    """Return the headlines in Markdown, their commands numbered below."""
    rows = list(headlines(data))
    commands = list(dict.fromkeys(row.command for row in rows))
    lines = ["| what | measured (95 % interval) | command |", "|---|---|---|"]
    lines += [f"| {row.words} | {row.value} | {commands.index(row.command) + 1} |" for row in rows]
    numbered = [f"{command}  # {number}" for number, command in enumerate(commands, 1)]
    worlds = {data[table]["about"].get("world", "1") for table, *_ in MATCHES if table in data} - {str(WORLD)}
    words = f"Some matches are of world {', '.join(sorted(worlds))}: the present world is {WORLD}."
    return "\n".join([*lines, "", *([words, ""] if worlds else []), "```bash", *numbered, "```"])
