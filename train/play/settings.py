"""The settings of a measurement of play, and which matches are played."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from soccer_env.checking import Range
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.leagues.rules import rule_set
from soccer_env.match_settings import Placement, Pose
from soccer_env.train.written_settings import CommandSettings, split_players, split_senses


@dataclass(frozen=True)
class PlaySettings(CommandSettings):
    """Which matches are played."""

    league: str = "legged-2001"
    """League to play in; `soccer list leagues` names them."""
    home: str = "chaser"
    """The team that plays at home: a name of `soccer list teams`, one such as chaser@0.5, or a policy file."""
    away: str = "chaser"
    """The team it plays against, written like --home."""
    minutes: float = 4.0
    """Minutes of play in a match, both halves together."""
    players: int | str | None = None
    """Players a side, 1 to 11; 3v5 gives home 3 and away 5; None for the league's own number."""
    seed: int = 0
    """Seed from which the seeds of all matches follow, 0 or more."""
    senses: str = "sensors"
    """What fills the teams' beliefs: sensors, or ideal (the truth); home=ideal,away=sensors for one each."""
    pose: Literal["particles", "percept"] = "particles"
    """How robots that use their sensors know where they are: a particle filter, or a noisy pose that is given."""
    placement: Literal["instant", "drive"] | None = None
    """How robots reach their places at a restart; None for the league's choice in evaluations."""
    rules: str = "league"
    """Which rules are called: league, simple or none; league:pushing=False,holding_time=5 changes one by name."""

    def __post_init__(self) -> None:
        split_players(self.players, 1)
        super().__post_init__()
        split_senses(self.senses)


@dataclass(frozen=True)
class MeasureSettings(PlaySettings):
    """Play matches and measure how they are played; intervals (95 %) are bootstraps over the matches."""

    BOUNDS = {"matches": Range(1), "minutes": Range(0.0, 10_000.0, above=True, below=True)}

    matches: int = 32
    """Number of matches, each from a seed of its own."""
    out: Path | None = None
    """File for the results (JSON)."""
    before: Path | None = None
    """File of an earlier measurement, of another team, league or version: its figures stand beside the new ones."""


@dataclass(frozen=True)
class Conditions:
    """What decides the result of a measurement, worked out."""

    league: League
    teams: dict[str, str]  # of "home" and "away"
    players: tuple[int, int]
    minutes: float
    senses: dict[str, str]  # of "home" and "away"
    pose: Pose
    placement: Placement


def conditions_of(settings: PlaySettings) -> Conditions:
    """Fill in what the settings leave to the league."""
    league = find_league(settings.league)
    league = replace(league, rules=rule_set(league.rules, settings.rules))
    placement = settings.placement or league.evaluation_placement
    home, away = split_senses(settings.senses)
    return Conditions(
        league=league,
        teams={"home": settings.home, "away": settings.away},
        players=split_players(settings.players, league.team_size),
        minutes=settings.minutes,
        senses={"home": home, "away": away},
        pose=settings.pose,
        placement=placement,
    )
