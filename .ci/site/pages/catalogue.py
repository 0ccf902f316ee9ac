"""The catalogue: all available names, from the lists that `soccer list` prints."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from pages.markdown import code, table
from soccer_env.leagues import find_league
from soccer_env.match import truth_state
from soccer_env.observations import OBSERVE, Entry
from soccer_env.observations.scales import scale_in_numbers
from soccer_env.train.command import listing

MAIN = ("legged-2001", "middle-size-2006")  # of the variants the numbers differ, not the names
PLAYERS = 1  # a side, of the state that is shown: it has the same entries for each
LISTS = {
    "leagues": "Leagues",
    "teams": "Teams",
    "settings": "Settings of teams",
    "actions": "Actions",
    "rewards": "Rewards",
    "scenes": "Scenes and drills",
    "statistics": "Statistics of play",
}
NOTES = {
    "rewards": "Potentials pay gamma times the potential after an action, less the one before it. A sum is weighted by "
    "`rewards=`: a name at the head of a column, or `Rewards(goal=10.0, effort=0.0)`; "
    "[terms of your own](../soccer_env/README.md#your-own) stand beside these.",
    "scenes": 'A match begins in a scene, `scene="NAME"`; with `episode="drill"` its test ends the episode. Several '
    'scenes in turn are `scene=soccer_env.scenes.mixture("kick-off:0.6,scattered:0.4")`. Rules go on in drills: those '
    "in the column of rules, so a ball that nobody plays is dropped elsewhere and robots are moved for it where that "
    "rule is on. [Drills](../soccer_env/scenes/README.md) has a picture of each, and starts that training never draws.",
    "actions": 'Finite numbers outside [-1, 1] are clipped. `actions="box"` has the first four, `"full"` all seven, '
    '`"discrete"` one of the twelve below, `"multi"` a choice for each of forward, left, turn and kick, '
    '`"skills"` one of the skills. What a 1 is '
    "in numbers: [leagues](leagues.md).",
}


def cells(found: listing.Table) -> str:
    """Return a list as a table of Markdown; names are code."""
    rows = [(code(row[0]), *row[1:]) if found.columns[0] else (row[0], code(row[1]), *row[2:]) for row in found.rows]
    return f"## {found.title}\n\n{table([column or '#' for column in found.columns], rows)}"


def page(title: str, note: str, tables: Iterable[listing.Table]) -> str:
    """Return a page of lists."""
    return "\n".join([f"# {title}\n", *([f"{note}\n"] if note else []), *map(cells, tables)])


def observations(league: str) -> str:
    """Return the page of the observations of a league, and of its state."""
    note = (
        f'Every number of every layout in `{league}`. All lie in [-1, 1]. The column "1 is" has what a 1 stands for, '
        "or the formula of a soft scale; a mirror (left for right) changes the sign of some, and of rows of things the "
        f"place. `soccer list observations --league {league} --observe belief --json` prints the same."
    )
    tables = [found for observe in OBSERVE for found in listing.observations(league, observe)]
    return page(f"Observations, {league}", note, [*tables, *states(league)])


def states(league: str) -> Iterator[listing.Table]:
    """Yield the entries of `state()`, from the field's side and from a team's."""
    found = find_league(league)
    for side in ("field", "home"):
        entries: list[Entry] = truth_state.entries(PLAYERS, side)
        rows = [
            (f"{i}", x.name, x.meaning, scale_in_numbers(x, found), listing.frame_of(x)) for i, x in enumerate(entries)
        ]
        title = f'state("{side}") of 1 v 1; every further player has the same entries'
        yield listing.Table(title, ("", "name", "meaning", "1 is", "frame"), rows)


def pages() -> dict[str, str]:
    """Return every page of the catalogue by its path."""
    found = {f"observations-{league}": observations(league) for league in MAIN}
    for name, title in LISTS.items():
        found[name] = page(title, NOTES.get(name, ""), listing.list_tables(listing.ListSettings(name)))
    for name, title in (("rules", "Rules"), ("sensors", "Sensors and memory")):
        every = [x for league in MAIN for x in listing.list_tables(listing.ListSettings(name, league=league))]
        found[name] = page(title, "", every)
    return {f"catalogue/{name}.md": text for name, text in found.items()}


def navigation() -> list[object]:
    """Return the section of the catalogue."""
    section: list[object] = [{f"Observations, {league}": f"catalogue/observations-{league}.md"} for league in MAIN]
    section += [{title: f"catalogue/{name}.md"} for name, title in LISTS.items()]
    return [{"Catalogue": [*section, {"Rules": "catalogue/rules.md"}, {"Sensors": "catalogue/sensors.md"}]}]
