"""The settings of an evaluation, and the conditions derived from them.

The help of `soccer evaluate` is the text beside each field here.
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path
from typing import Literal

from soccer_env.guards.checking import SHARE, Range
from soccer_env.leagues.league import League
from soccer_env.match.arguments import Placement, Pose
from soccer_env.train.evaluate.replays.choice import Keep
from soccer_env.train.written_settings import (
    POSES,
    SENSING,
    CommandSettings,
    command_line,
    split_players,
    split_senses,
    split_variation,
)

SIDES = ("home", "away")
FULL = "full"  # minutes: the league's own length of a match
ALL, PAIRS = "all", 5  # values of --pairs: every finished pair (and of --scene: every drill); the default
CONDITIONS = ("home", "away", "matches", "seed", "scene", "rules", "variation")  # as the settings say
RECHECKED = ("recheck", "pairs", "seed", "threads", "home", "away", "league", "scene", "json")  # usable with --recheck


@dataclass(frozen=True)
class EvaluateSettings(CommandSettings):
    """Play one team against another and say how sure the result is.

    Each of --matches/2 seeds is played twice, with sides swapped; a team against itself plays every match from its own
    seed. Results are for --home; 95 % intervals are bootstraps over the pairs of matches. The same settings give the
    same result for any --threads. To resume a run that was stopped, give the same command again.

    --recheck FOLDER plays a random sample of the matches in a folder again, compares every line bit for bit, and exits
    with code 1 if one differs. It changes no file and runs no code that the folder names: if a team, league or scene is
    MODULE:NAME, or a policy file has moved, name it again by --home, --away, --league or --scene.
    """

    BASIC = "anew"  # the last option that --help shows
    BOUNDS = {
        "matches": Range(2),
        "pairs": Range(1),
        "minutes": Range(0.0, 10_000.0, above=True, below=True),
        "at_least": SHARE,
    }
    EVEN = {"matches": "for each seed is played twice, sides swapped"}

    league: str = "legged-2001"
    """League to play in; `soccer list leagues` names them."""
    home: str = "chaser"
    """Team whose result is reported: a name of `soccer list teams`, NAME@STRENGTH as chaser@0.5, or a policy file; for
    drills also several, separated by commas."""
    away: str = "random"
    """Opponent, written like --home."""
    matches: int = 20
    """Number of matches, an even number: two for each seed. Raise --matches to add matches to a finished evaluation."""
    minutes: float | Literal["full"] | None = None
    """Minutes of play in a match, both halves together; `full` for a whole match of the league; leave out for 10 in the
    legged league, 4 in the middle size."""
    players: int | str | None = None
    """Players a side, 1 to 11; 3v5 gives --home 3 and --away 5; leave out for the league's own number."""
    seed: int = 0
    """Seed of the evaluation, 0 or more; the seeds of all matches follow from it."""
    threads: int = 1
    """Number of threads; the result does not depend on it."""
    ray: str | None = None
    """Play on a Ray cluster: --ray alone starts one on this machine, auto or HOST:PORT joins one. Its cores replace
    --threads, and the result does not depend on it."""
    senses: str | None = None
    """What fills the teams' beliefs: sensors, or ideal (the truth); home=ideal,away=sensors for one each. Leave out for
    sensors; a policy that was trained with other senses is then refused."""
    pose: Literal["particles", "percept"] | None = None
    """How robots with sensors know where they are: by a particle filter, or by a given noisy pose (percept). Leave out
    for particles; a policy that was trained with percept is then refused."""
    scene: str = "kick-off"
    """How each match starts: kick-off, scattered, or both with shares (kick-off:0.6,scattered:0.4). A drill, or all for
    every drill of the league: --home plays each --matches times, from starts that training never draws."""
    rules: str = "league"
    """Rule set: league, simple or none; league:pushing=False,holding_time=5 changes single rules."""
    placement: Literal["instant", "drive"] | None = None
    """How robots reach their places at a restart; leave out for the league's default: drive in the middle size."""
    out: Path | None = None
    """Folder for matches.jsonl, result.json, report.md and report.html; leave out to write no files."""
    anew: bool = False
    """Start afresh: remove the files of an earlier evaluation from --out."""
    variation: str = ""
    """Numbers of the league that differ from match to match, as factors: ball.mass=1:2,drive.delay=0.5:2:log."""
    sweep: str = ""
    """One such factor from value to value, as kicker.fastest=0.5:1.5:5: a curve of the points with intervals, for each
    team in --home, separated by commas. `soccer list variations` names the numbers."""
    keep: str = ""
    """Replays to keep in --out, separated by commas: best, worst (for --home), goals (a clip of every goal)."""
    keep_pages: bool = False
    """Also write every kept replay as a page for the browser."""
    picture: bool = False
    """Draw moments of the first match on one sheet: match.png in --out (needs pygame-ce)."""
    json: bool = False
    """Print the contents of result.json instead of tables."""
    at_least: float | None = None
    """Exit with code 1 if --home wins a smaller share of the points than this, 0 to 1; a draw counts half."""
    recheck: Path | None = None
    """Folder of an evaluation, finished or not, to check by playing a sample of its matches again."""
    pairs: int | Literal["all"] = PAIRS
    """Number of finished pairs that --recheck plays again, drawn at random (or by --seed); `all` for every pair."""

    def __post_init__(self) -> None:
        for side in ("home", "away"):
            if not isinstance(getattr(self, side), str):
                raise ValueError(f"{side} must be a name; evaluate(settings, teams={{name: team}}) names team objects")
        split_players(self.players, 1)
        super().__post_init__()
        if self.picture and self.out is None:
            raise ValueError("picture needs a folder: give out as well")
        if self.recheck is None and self.pairs != PAIRS:
            raise ValueError("pairs goes with recheck: give a folder")
        other = [field.name for field in fields(self) if getattr(self, field.name) != field.default]
        if self.recheck is not None and not set(other) <= set(RECHECKED):
            raise ValueError(f"{next(name for name in other if name not in RECHECKED)} does not go with recheck")
        if (Keep(self.keep).kinds_in_order or self.keep_pages) and self.out is None:
            raise ValueError("replays are kept in a folder: give out as well")
        split_senses(SENSING if self.senses is None else self.senses)
        split_variation(self.variation)


@dataclass(frozen=True)
class Conditions:
    """The settings that determine the result of an evaluation, with every default filled in."""

    league: str
    home: str
    away: str
    matches: int
    minutes: float  # of play, both halves together
    players: tuple[int, int]  # of the first team (home), of the second (away)
    seed: int
    senses: tuple[str, str]  # of the first team, of the second
    pose: Pose  # of robots that use their sensors
    scene: str
    rules: str
    placement: Placement
    variation: str = ""

    @property
    def sizes(self) -> str:
        """Return the team sizes in the form "3v3"."""
        return f"{self.players[0]}v{self.players[1]}"

    @property
    def senses_text(self) -> str:
        """Return the senses as a text for the option --senses."""
        first, second = self.senses
        return first if first == second else f"home={first},away={second}"

    @property
    def self_play(self) -> bool:
        """Tell whether a team plays itself under equal conditions, so that swapped sides give the same match again."""
        return self.home == self.away and self.players[0] == self.players[1] and self.senses[0] == self.senses[1]

    def first_team_side(self, number: int) -> str:
        """Return the side on which the first team plays match `number`: in turn, but always home in self-play."""
        return SIDES[0 if self.self_play else number % 2]


def command_of(settings: EvaluateSettings) -> str:
    """Return the command line of `soccer evaluate` that has these settings."""
    return command_line("evaluate", settings, always=("league", "home", "away", "matches", "seed"))


def conditions_of(settings: EvaluateSettings, league: League) -> Conditions:
    """Return the conditions derived from settings, with the league's defaults filled in."""
    minutes = settings.minutes
    if minutes is None:
        minutes = league.evaluation_minutes
    elif minutes == FULL:
        minutes = 2.0 * league.rules.half_minutes
    return Conditions(
        league=league.name,
        minutes=float(minutes),
        players=split_players(settings.players, league.team_size),
        senses=split_senses(SENSING if settings.senses is None else settings.senses),
        pose=settings.pose or POSES[0],
        placement=settings.placement or league.evaluation_placement,
        **{name: getattr(settings, name) for name in CONDITIONS},
    )
