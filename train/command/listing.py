"""`soccer list`: tables of leagues, teams, team settings, scenes, observations and more."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields
from functools import reduce
from math import isfinite
from typing import TYPE_CHECKING, Any, Literal

import tyro

if TYPE_CHECKING:
    from rich.table import Table as Drawn

    from soccer_env.leagues.options import Options
    from soccer_env.observations import Entry

What = Literal[
    "leagues", "teams", "settings", "scenes", "observations", "sensors", "rules", "actions", "rewards", "statistics",
    "claims", "variations",
]  # fmt: skip
MIRRORED = {1: "", -1: "sign", None: "place"}  # by the mirror of an entry: what a left-right mirror changes


@dataclass(frozen=True)
class ListSettings:
    """Print the available names with a short description of each."""

    what: tyro.conf.Positional[What]
    """What to list."""
    league: str = "legged-2001"
    """League whose observations, sensors, rules or variations are listed."""
    observe: Literal["truth", "percepts", "belief"] = "truth"
    """Source of the listed observations."""
    json: bool = False
    """Print JSON: a list of tables, each with a title and rows keyed by column."""


@dataclass(frozen=True)
class Table:
    """A table of text rows under named columns; a column without a name numbers the rows."""

    title: str
    columns: tuple[str, ...]
    rows: Sequence[tuple[str, ...]]

    def drawn(self) -> Drawn:
        """Return the table as a terminal table."""
        from rich.table import Table as Drawn

        drawn = Drawn(title=self.title, title_justify="left")
        for index, column in enumerate(self.columns):
            drawn.add_column(column, overflow="fold", no_wrap=index == 0)
        for row in self.rows:
            drawn.add_row(*row)
        return drawn

    def as_dict(self) -> dict[str, Any]:
        """Return the table as plain values for JSON."""
        names = [column or "index" for column in self.columns]
        return {"title": self.title, "rows": [dict(zip(names, row, strict=True)) for row in self.rows]}


def list_tables(settings: ListSettings) -> Iterator[Table]:
    """Yield the tables that `settings.what` asks for."""
    what = settings.what
    lists: dict[str, Callable[[], Iterator[Table]]] = {
        "leagues": leagues, "teams": teams, "settings": settings_of_teams, "scenes": scenes, "actions": actions,
        "rewards": rewards, "statistics": statistics, "claims": claims,
    }  # fmt: skip
    if what == "observations":
        return observations(settings.league, settings.observe)
    if what in ("sensors", "rules", "variations"):
        return {"sensors": sensors, "rules": rules, "variations": variations}[what](settings.league)
    return lists[what]()


def variations(league: str) -> Iterator[Table]:
    """Yield the table of a league's numbers that `variation=` can change."""
    from soccer_env.leagues import find_league
    from soccer_env.match.variation import THEMSELVES, names_of

    played = find_league(league)
    usual = {name: f"{reduce(getattr, name.split('.'), played):g}" for name in names_of(played)}
    rows = [(name, of, "the number" if name in THEMSELVES else "a factor") for name, of in usual.items()]
    yield Table(f"Numbers of {played.name}: --variation NAME=LOW:HIGH, LOW:HIGH:log", ("name", "usual", "drawn"), rows)


def leagues() -> Iterator[Table]:
    """Yield the table of leagues with their main numbers, then each league's table of contacts between materials."""
    from soccer_env.leagues import LEAGUES

    columns = ("name", "family", "pitch", "robots", "time", "source")
    rows = []
    for name, league in LEAGUES.items():
        pitch, drive, minutes = league.pitch, league.drive, 2.0 * league.rules.half_minutes
        evaluated = f"evaluated {league.evaluation_minutes:g} min, {league.evaluation_placement} placement"
        rows.append(
            (
                name,
                league.family,
                f"{pitch.length:g} x {pitch.width:g} m, {'boards' if pitch.walled else 'lines'}",
                f"{league.team_size} a side, {drive.kind}, {drive.forward:g} m/s, kicks {league.kicker.fastest:g} m/s",
                f"{league.control_rate} steps/s, match {minutes:g} min, {evaluated}",
                league.source,
            )
        )
    yield Table("Leagues", columns, rows)
    pairs = {name: league.materials.pairs() for name, league in LEAGUES.items()}
    heads = ("name", *(pair.replace("_", ", ") for pair in next(iter(pairs.values()))))
    texts = [(name, *(pair.text() for pair in contacts.values())) for name, contacts in pairs.items()]
    yield Table("Materials: elasticity/friction of each pair that meets", heads, texts)


def teams() -> Iterator[Table]:
    """Yield the table of teams, with the families of leagues in which each can play."""
    from soccer_env.teams import NAMES, make_team, registered_teams
    from soccer_env.teams.explaining import team_description

    rows = []
    for name, where in registered_teams().items():
        if name not in NAMES:  # to describe it would import, and so run, its package
            rows.append((name, "", "from an installed package, which is imported when the team is used", where))
            continue
        try:
            played = ", ".join(getattr(make_team(name), "families", ())) or "all"
        except (ImportError, AttributeError) as error:
            played = f"cannot be loaded: {error}"
        rows.append((name, played, team_description(where), where))
    title = "Teams: NAME, NAME@0.5 for half its strength, NAME:switch=value,... (see `soccer list settings`)"
    yield Table(title, ("name", "family", "what it is", "made by"), rows)


def settings_of_teams() -> Iterator[Table]:
    """Yield a table of settings for each team, such as sacks-2001:recovery=False; of variants the differences."""
    from soccer_env.teams import NAMES, make_team

    for name in NAMES:
        try:
            options = getattr(make_team(name), "options", None)
        except (ImportError, AttributeError):
            continue
        if options is not None:
            usual = type(options)()
            differing = {row[0] for row, other in zip(options.rows(), usual.rows(), strict=True) if row[1] != other[1]}
            rows = [row for row in option_rows(options) if not differing or row[0] in differing]
            title = f"Settings of {name}; changed by {name}:name=value,name=value"
            yield Table(title, ("name", "value", "allowed", "unit and source"), rows)


def option_rows(options: Options) -> list[tuple[str, str, str, str]]:
    """Return a table row for each setting: name, value, allowed values, unit and source."""
    return [
        (name, f"{value:g}" if isinstance(value, float) else str(value), allowed, note)
        for name, value, allowed, note in options.rows()
    ]


def scenes() -> Iterator[Table]:
    """Yield the table of scenes."""
    from soccer_env.scenes import SCENES

    rows = [
        (
            x.name,
            x.description,
            "none: a match" if x.success == "none" else str(x.success),
            f"{x.time_limit:g} s" if isfinite(x.time_limit) else "none",
            x.meant_for,
            x.rules,
            ", ".join(x.families) or "all",
        )
        for x in SCENES.values()
    ]
    columns = ("name", "what it is", "success", "time limit", "players", "rules", "family")
    yield Table("Scenes; those with a success test are drills, played so with episode=drill", columns, rows)


def observations(league: str, observe: str) -> Iterator[Table]:
    """Yield the table of all numbers in one robot's observation."""
    from soccer_env.leagues import find_league
    from soccer_env.observations import layout
    from soccer_env.observations.scales import scale_in_numbers

    named = find_league(league)
    entries = layout(named, observe)
    title = f"Observation of a robot in {league}, observe={observe}: {len(entries)} numbers (float32) in [-1, 1]"
    rows = [
        (f"{index}", x.name, x.meaning, x.scale, scale_in_numbers(x, named), frame_of(x), MIRRORED[x.mirror])
        for index, x in enumerate(entries)
    ]
    yield Table(title, ("", "name", "meaning", "of", "1 is", "frame", "mirror changes"), rows)


def frame_of(entry: Entry) -> str:
    """Return the coordinate frame and axis of an observation entry, as text for a table."""
    return "" if entry.frame in (None, "none") else f"{entry.frame} {entry.axis}".strip()


def sensors(league: str) -> Iterator[Table]:
    """Yield the table of settings of a league's sensors and of the robots' memory."""
    from soccer_env.leagues import find_league

    named = find_league(league)
    for name, options in (("sensors", named.sensors), ("memory", named.memory)):
        rows = option_rows(options)
        title = f"{type(options).__name__} of {league}; changed by {name}={{name: value}}"
        yield Table(title, ("name", "value", "allowed", "unit and source"), rows)


def rules(league: str) -> Iterator[Table]:
    """Yield the table of a league's rules, with each rule's value in each rule set."""
    from soccer_env.leagues import find_league
    from soccer_env.leagues.options import field_comments
    from soccer_env.leagues.rules import SETS, Rules, rule_set

    sets = [rule_set(find_league(league).rules, name) for name in SETS]
    notes = field_comments(Rules)
    rows = [
        (item.name, *(rule_in_words(getattr(rules, item.name)) for rules in sets), notes.get(item.name, ""))
        for item in fields(Rules)
        if item.name != "name"
    ]
    yield Table(f"Rules of {league}; changed by rules=SET:rule=value,...", ("rule", *SETS, "unit and meaning"), rows)


def rule_in_words(value: bool | float) -> str:
    """Return the value of a rule in words, as text for a table."""
    from soccer_env.leagues.rules import NEVER

    if isinstance(value, bool):
        return "on" if value else "off"
    return "never" if value >= NEVER else f"{value:g}"


def actions() -> Iterator[Table]:
    """Yield the tables of action kinds: continuous actions, the discrete set, the choices of multi, and the skills."""
    from soccer_env.actions import BOX, DISCRETE, KICKS, LEVELS, MEANINGS
    from soccer_env.skills.choices import MEANINGS as SKILL_MEANINGS
    from soccer_env.skills.choices import SKILLS

    rows = [(name, meaning, "box, full" if name in BOX else "full") for name, meaning in MEANINGS.items()]
    yield Table("Actions: numbers in [-1, 1]", ("name", "meaning", "in"), rows)
    sets = [(f"{n}", name, *(f"{number:g}" for number in row)) for n, (name, row) in enumerate(DISCRETE.items())]
    yield Table("Actions: discrete", ("", "name", *BOX), sets)
    rows = [(f"{n}", f"{level:g}", kick) for n, (level, kick) in enumerate(zip(LEVELS, KICKS, strict=True))]
    yield Table("Actions: multi, four indices", ("", "forward, left, turn", "kick"), rows)
    rows = [(f"{n}", name, SKILL_MEANINGS[kind]) for n, (name, (kind, *_)) in enumerate(SKILLS.items())]
    yield Table("Actions: skills", ("", "name", "meaning"), rows)


def rewards() -> Iterator[Table]:
    """Yield the tables of reward terms: their weights in each preset, and earnings a minute by formula."""
    from soccer_env.rewards import KINDS_OF_PLAYERS, PRESETS, TERMS, earnings

    rows = [(x.name, x.kind, x.text, *(f"{getattr(y, x.name):g}" for y in PRESETS.values())) for x in TERMS]
    yield Table("Reward terms and their weights", ("term", "kind", "meaning", *PRESETS), rows)
    shaping = "discount of the potentials; a learner with this discount keeps its best policies"
    gammas = [("gamma", shaping, *(f"{y.gamma:g}" for y in PRESETS.values()))]
    yield Table("Discount of one action", ("name", "meaning", *PRESETS), gammas)
    title = "Earnings a minute by formula, without potentials: stands; walks at top speed; wins by 0.2 goals (assumed)"
    players = [(name, player) for name in PRESETS for player in KINDS_OF_PLAYERS]
    paid = [earnings(PRESETS[name], player) for name, player in players]
    rows = [(term, *(f"{sums[term]:g}" for sums in paid)) for term in paid[0]]
    yield Table(title, ("term", *map(": ".join, players)), rows)


def statistics() -> Iterator[Table]:
    """Yield the tables of statistics of play, with their definitions."""
    from soccer_env.statistics.figures import FIGURES, SHARE
    from soccer_env.statistics.maps import MAP_TEXTS

    rows = [
        (
            f"{x.name}_for, _against" if x.team else x.name,
            x.unit,
            f"share of {x.whole}" if x.kind == SHARE else {"rate": "a minute"}.get(x.kind, x.kind),
            x.text,
        )
        for x in FIGURES
    ]
    title = "Statistics of play: matches.jsonl and infos hold each match's, reports combine matches"
    yield Table(title, ("name", "unit", "in reports", "definition"), rows)
    yield Table("Maps: result.json and final nested infos hold them", ("name", "definition"), list(MAP_TEXTS.items()))


def claims() -> Iterator[Table]:
    """Yield the tables of claims of the papers that `soccer reproduce` measures."""
    from soccer_env.match.staging import PATIENT
    from soccer_env.train.papers.claims import all_claims
    from soccer_env.train.papers.results import rules_in_words

    rows = [
        (x.id, x.statement, f"{x.paper}, {x.section}".rstrip(", "), rules_in_words(x.rules),
         "\n".join(c.text for c in x.criteria if c.decides))
        for x in all_claims().values()
    ]  # fmt: skip
    title = f"Claims; rules: of whole matches (`soccer reproduce --rules`), staged: {PATIENT}"
    yield Table(title, ("id", "what the paper says", "where", "rules", "counts as reproduced"), rows)
