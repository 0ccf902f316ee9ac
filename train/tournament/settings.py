"""The settings of a tournament. The help of `soccer tournament` is the text beside each field here."""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal

from soccer_env.guards.checking import Range, raise_not_allowed
from soccer_env.train.evaluate.replays.choice import Keep
from soccer_env.train.evaluate.settings import Conditions, EvaluateSettings
from soccer_env.train.tournament.systems import SWISS, default_rounds, most_rounds
from soccer_env.train.written_settings import CommandSettings, command_line, split_distinct_names
from soccer_env.types import MAX_TEAM

PAIRINGS = "pairings"  # the folder of all pairings in the folder of a tournament
FREE = ("matches", "threads", "ray", "out", "add", "keep", "keep_pages", "half_width", "json")  # usable without --teams
SHARED = (  # with the evaluation of a pairing
    "league", "matches", "minutes", "players", "seed", "threads", "ray", "senses", "pose", "rules", "variation", "keep",
    "keep_pages",
)  # fmt: skip


@dataclass(frozen=True)
class TournamentSettings(CommandSettings):
    """Rank teams: let them play each other and rate them, with intervals.

    In each pairing every seed is played twice with sides swapped, and all pairings have the same seeds. The same
    settings give the same matches for any --threads. To resume a tournament that was stopped, give the same command
    again, or --out alone. Each pairing is an evaluation in a folder below --out: `soccer evaluate --recheck` checks it.
    """

    BASIC = "half-width"  # the last option that --help shows
    BOUNDS = {
        "matches": Range(2),
        "players": Range(1, MAX_TEAM),
        "rounds": Range(1),
        "minutes": Range(0.0, 10_000.0, above=True, below=True),
        "half_width": Range(0.0, above=True),
    }
    EVEN = {"matches": "for each seed is played twice, sides swapped"}

    teams: str = ""
    """Teams, separated by commas, the strongest first: each a name of `soccer list teams`, NAME@STRENGTH as chaser@0.5,
    a policy file, or MODULE:NAME. Leave out to go on with the tournament in --out."""
    league: str = "legged-2001"
    """League to play in; `soccer list leagues` names them."""
    system: Literal["round-robin", "swiss", "knock-out"] = "round-robin"
    """Who meets whom: everybody, neighbours in the table, or winners alone."""
    matches: int = 20
    """Number of matches of each pairing, an even number: two for each seed. Raise it to add matches."""
    minutes: float | Literal["full"] | None = None
    """Minutes of play in a match, both halves together; `full` for a whole match of the league; leave out for 10 in the
    legged league, 4 in the middle size."""
    players: int | None = None
    """Players a side, 1 to 11; leave out for the league's own number."""
    seed: int = 0
    """Seed of the tournament, 0 or more; the seeds of all matches follow from it."""
    threads: int = 1
    """Number of threads; the result does not depend on it."""
    ray: str | None = None
    """Play on a Ray cluster: --ray alone starts one on this machine, auto or HOST:PORT joins one. Its cores replace
    --threads, and the result does not depend on it."""
    out: Path | None = None
    """Folder for result.json, report.html and the pairings; leave out to write no files."""
    add: str = ""
    """Teams to add to the tournament in --out, separated by commas: the result is that of a tournament that had them
    from the start."""
    half_width: float = 50.0
    """Wanted half width of the intervals of Elo ratings: the report says how many matches that takes."""
    rounds: int | None = None
    """Rounds of a Swiss tournament; leave out for as many as leave one team unbeaten."""
    senses: Literal["sensors", "ideal"] | None = None
    """What fills the teams' beliefs: sensors, or ideal (the truth). Leave out for sensors; a policy that was trained
    with other senses is then refused."""
    pose: Literal["particles", "percept"] | None = None
    """How robots with sensors know where they are: by a particle filter, or by a given noisy pose (percept). Leave out
    for particles; a policy that was trained with percept is then refused."""
    rules: str = "league"
    """Rule set: league, simple or none; league:pushing=False,holding_time=5 changes single rules."""
    variation: str = ""
    """Numbers of the league that differ from match to match, as factors: ball.mass=1:2,drive.delay=0.5:2:log."""
    anew: bool = False
    """Start afresh: remove the files of an earlier tournament from --out."""
    keep: str = ""
    """Replays to keep of each pairing, separated by commas: best, worst (for the team named first), goals."""
    keep_pages: bool = False
    """Also write every kept replay as a page for the browser."""
    json: bool = False
    """Print the contents of result.json instead of tables."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if (Keep(self.keep).kinds_in_order or self.keep_pages) and self.out is None:
            raise ValueError("replays are kept in a folder: give out as well")
        if self.teams:
            if self.add:
                raise ValueError(
                    "give teams, with the added one last; or add alone, which no tournament with code takes"
                )
            if len(self.names) < 2:
                raise_not_allowed("teams", "two names or more with commas between them", self.teams)
            if self.rounds is not None and self.system != SWISS:
                raise ValueError(f"rounds goes with --system swiss, got {self.system}")
            most = most_rounds(len(self.names))
            if self.system == SWISS and self.swiss_rounds > most:
                raise_not_allowed(
                    "rounds", f"1 to {most} for {len(self.names)} teams, for no two teams meet twice", self.rounds
                )
            return
        if self.out is None:
            raise ValueError(
                "teams must be two names or more with commas between them; or give the out of a tournament"
            )
        others = [x.name for x in fields(self) if x.name not in FREE and getattr(self, x.name) != x.default]
        if others:
            raise ValueError(f"{others[0]} goes with teams alone: the tournament in {self.out} has its own settings")

    @property
    def names(self) -> tuple[str, ...]:
        """Return the names of the teams."""
        return split_distinct_names("teams", self.teams)

    @property
    def swiss_rounds(self) -> int:
        """Return the number of rounds of a Swiss tournament."""
        return self.rounds or default_rounds(len(self.names))

    def pairing(self, first: int, second: int) -> EvaluateSettings:
        """Return the settings of the evaluation of two teams."""
        home, away = self.names[first], self.names[second]
        out = None if self.out is None else self.out / pairing_folder(first, second, home, away)
        return EvaluateSettings(home=home, away=away, out=out, **{name: getattr(self, name) for name in SHARED})


def pairing_folder(first: int, second: int, home: str, away: str) -> str:
    """Return the folder of a pairing in the folder of its tournament, such as "pairings/1-chaser-3-random"."""
    plain = ["".join(x if x.isalnum() or x in "@._" else "-" for x in Path(name).name)[:40] for name in (home, away)]
    return f"{PAIRINGS}/{first + 1}-{plain[0]}-{second + 1}-{plain[1]}"


def conditions_of(settings: TournamentSettings, pairing: Conditions) -> dict[str, Any]:
    """Return the settings that decide the result, with every default filled in; `pairing`: those of any pairing."""
    return {
        "teams": list(settings.names), "system": settings.system, "rounds": settings.rounds,
        "matches": settings.matches, "league": pairing.league, "minutes": pairing.minutes,
        "players": pairing.players[0], "seed": settings.seed, "senses": pairing.senses[0], "pose": pairing.pose,
        "rules": settings.rules, "variation": settings.variation,
    }  # fmt: skip


def command_of(settings: TournamentSettings) -> str:
    """Return the command line of `soccer tournament` that has these settings."""
    return command_line("tournament", settings, always=("teams", "league", "matches", "seed"))
