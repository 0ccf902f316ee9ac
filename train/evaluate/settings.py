"""The settings of an evaluation: what the command line reads, and the conditions that follow from them.

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
    command_with,
    split_players,
    split_senses,
)

FULL = "full"  # minutes: the league's own length of a match
ALL, PAIRS = "all", 5  # pairs to play again: every finished one; unless another number is asked for
RECHECKED = ("recheck", "pairs", "seed", "threads", "home", "away", "league", "scene", "json")  # what goes together


@dataclass(frozen=True)
class EvaluateSettings(CommandSettings):
    """Play one team against another and say how sure the result is.

    Half as many seeds as matches are drawn; each is played twice, the teams changing sides. Results are from the side
    of --home; intervals (95 %) are bootstraps over the pairs. The same settings give the same result, match by match,
    whatever --threads is. A run that was stopped goes on where it was when the same command is given again.

    --recheck FOLDER plays a random sample of what a folder holds again instead, compares every line bit for bit, and
    ends with exit code 1 if one differs. No file is changed, and no code that the folder names is run: --home, --away,
    --league and --scene name what is MODULE:NAME once more, or say where a policy file lies now.
    """

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
    """The team whose result this is: a name of `soccer list teams`, one such as chaser@0.5, or a policy file."""
    away: str = "random"
    """The team it plays against, written like --home."""
    matches: int = 20
    """Number of matches, even: one pair for each seed. With a larger number than an evaluation in --out had, what it
    lacks is played."""
    minutes: float | Literal["full"] | None = None
    """Minutes of play in a match, both halves together; `full` for the league's own, None for 10 (legged) or 4."""
    players: int | str | None = None
    """Players a side, 1 to 11; 3v5 gives --home 3 and --away 5; None for the league's own number."""
    seed: int = 0
    """Seed from which the seeds of all matches follow, 0 or more."""
    threads: int = 1
    """Threads that share the matches; the result does not depend on them."""
    senses: str | None = None
    """What fills the teams' beliefs: sensors, or ideal (the truth); home=ideal,away=sensors for one each. None for
    sensors; a policy that was trained with other senses is then refused."""
    pose: Literal["particles", "percept"] | None = None
    """How robots that use their sensors know where they are: a particle filter, or a noisy pose that is given. None
    for particles; a policy that was trained with the other pose is then refused."""
    scene: str = "kick-off"
    """Start of each match: kick-off, scattered, or both with shares (kick-off:0.6,scattered:0.4); no drill."""
    rules: str = "league"
    """Which rules are called: league, simple or none; league:pushing=False,holding_time=5 changes one by name."""
    placement: Literal["instant", "drive"] | None = None
    """How robots reach their places at a restart; None for the league's choice in evaluations."""
    out: Path | None = None
    """Folder for matches.jsonl, result.json, report.md and report.html; without it nothing is written."""
    anew: bool = False
    """Remove the files that an earlier evaluation left in --out, instead of going on with it or refusing."""
    keep: str = ""
    """Replays to keep in --out, with commas between them: best, worst (for --home), goals (a clip of every goal)."""
    keep_pages: bool = False
    """Make of every replay that is kept a page for the browser as well."""
    picture: bool = False
    """Draw the first match as a sheet of pictures, match.png in --out (needs pygame-ce)."""
    json: bool = False
    """Print what result.json holds, as JSON, instead of tables."""
    at_least: float | None = None
    """End with exit code 1 if --home's points (draws count half) are below this share of the matches, 0 to 1."""
    recheck: Path | None = None
    """Folder of an evaluation, finished or not, of which a sample is played again and compared; nothing is written."""
    pairs: int | Literal["all"] = PAIRS
    """Pairs that --recheck plays, drawn at random (or by --seed) from those that are finished; `all` for every one."""

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
        if (Keep(self.keep).each or self.keep_pages) and self.out is None:
            raise ValueError("replays are kept in a folder: give out as well")
        split_senses(SENSING if self.senses is None else self.senses)


@dataclass(frozen=True)
class Conditions:
    """What decides the result of an evaluation, worked out: no None, no names of defaults."""

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

    @property
    def sizes(self) -> str:
        """Return the team sizes as "3v3"."""
        return f"{self.players[0]}v{self.players[1]}"

    @property
    def senses_text(self) -> str:
        """Return the senses as the settings write them."""
        first, second = self.senses
        return first if first == second else f"home={first},away={second}"


def command_of(settings: EvaluateSettings) -> str:
    """Return the command that asks for these settings."""
    return command_with("evaluate", settings, always=("league", "home", "away", "matches", "seed"))


def conditions_of(settings: EvaluateSettings, league: League) -> Conditions:
    """Fill in what the settings leave to the league."""
    minutes = settings.minutes
    if minutes is None:
        minutes = league.evaluation_minutes
    elif minutes == FULL:
        minutes = 2.0 * league.rules.half_minutes
    return Conditions(
        league=league.name,
        home=settings.home,
        away=settings.away,
        matches=settings.matches,
        minutes=float(minutes),
        players=split_players(settings.players, league.team_size),
        seed=settings.seed,
        senses=split_senses(SENSING if settings.senses is None else settings.senses),
        pose=settings.pose or POSES[0],
        scene=settings.scene,
        rules=settings.rules,
        placement=settings.placement or league.evaluation_placement,
    )
