"""A claim of a paper: its statement, its measurement, and the samples and figures that the measurement returns."""

import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from soccer_env.match.arguments import Pose
from soccer_env.match.staging import PATIENT
from soccer_env.train.papers.verdicts import Criterion, Samples

SACKS, HEINEMANN = "Sacks 2001", "Heinemann et al. 2006"
PAPERS = {"S": SACKS, "H": HEINEMANN}  # by the first letter of a claim's id
# Rule sets of a claim's matches: the claim is judged from play, from play and staged scenes, or from staged scenes
LEAGUE = "league"
PLAYED, PLAYED_AND_STAGED, STAGED, NO_MATCH = (LEAGUE,), (LEAGUE, PATIENT), (PATIENT,), ()


@dataclass(frozen=True)
class Batch:
    """One batch of a claim's samples: everything in it must follow from its seeds."""

    claim: str
    seed: int  # one of the run's seeds
    index: int  # 0, 1, ...
    threads: int = 1  # to share the work; no result depends on it
    pose: Pose = "particles"  # how robots know where they are: "particles" or "percept"
    rules: tuple[str, ...] = PLAYED_AND_STAGED  # rule sets that its matches may use

    @property
    def play_rules(self) -> str:
        """Return the rule set of play; ValueError for a claim without one."""
        for rules in self.rules:
            if rules != PATIENT:
                return rules
        raise ValueError(f"claim {self.claim} is judged from play, and states no rules of play: {self.rules}")

    def sequence(self) -> np.random.SeedSequence:
        """Return the seed sequence of this batch, which no other batch or claim shares."""
        return np.random.SeedSequence([self.seed, zlib.crc32(self.claim.encode()), self.index])

    def seeds(self, matches: int) -> np.ndarray:
        """Return seeds (matches,) for a Match: the same for every variant, which pairs them."""
        return self.sequence().generate_state(matches, np.uint64)

    def rng(self, purpose: int = 0) -> np.random.Generator:
        """Return a generator for draws outside matches, such as starting places."""
        return np.random.default_rng(np.random.SeedSequence([*self.sequence().entropy, 1 + purpose]))  # type: ignore[misc]


@dataclass(frozen=True)
class Curve:
    """Points of a figure, with optional intervals."""

    name: str
    x: Sequence[float]
    y: Sequence[float]
    low: Sequence[float] = ()
    high: Sequence[float] = ()


@dataclass(frozen=True)
class Arrows:
    """Arrows over a field: their origins and components."""

    x: Sequence[float]
    y: Sequence[float]
    along_x: Sequence[float]
    along_y: Sequence[float]


@dataclass(frozen=True)
class Figure:
    """Plain data that the report draws, or prints as a table."""

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    rules: tuple[float, ...] = ()  # heights of dashed lines: the bounds of the criterion
    rule: str = ""  # the meaning of these lines, if they are no bounds
    arrows: Arrows | None = None  # a picture of the field: both axes have one scale


@dataclass(frozen=True)
class Without:
    """The ingredient of a claim by construction, and the measurement without it."""

    ingredient: str
    measure: Callable[[Batch], Samples]


def no_figures(samples: Samples) -> Sequence[Figure]:
    """Return nothing to draw."""
    return ()


@dataclass(frozen=True)
class Claim:
    """A claim and its measurement.

    `measure` returns the samples of one batch: arrays of equal length whose first axis is independent units (runs,
    matches). For every seed, `least` to `batches` (--quick: `quick`) batches are measured, until the verdict on all
    seeds together is decided, and the verdict on each seed if it comes early.
    """

    id: str  # the letter of its paper, see PAPERS, and a number; or the name of a study
    section: str
    statement: str  # what the paper says
    method: str  # how it is measured
    criteria: tuple[Criterion, ...]  # none that decides: context
    rules: tuple[str, ...]  # rule sets of its matches: PLAYED, PLAYED_AND_STAGED, STAGED or NO_MATCH
    measure: Callable[[Batch], Samples]
    batches: int = 16
    least: int = 1  # batches of a seed before the first verdict; more than 1 where few units of a batch count
    quick: int = 1
    seconds: float = 3.0  # [s] of one batch on one core, compiled: --minutes derives the number of batches from it
    ingredients: tuple[str, ...] = ()  # settings and models that the result depends on
    without: Without | None = None  # by construction
    figures: Callable[[Samples], Sequence[Figure]] = no_figures
    note: str | Callable[[Samples], str] = ""  # for readers of the result
    pose: Literal["", "percept", "particles"] = ""  # the localisation that the claim is about; "": the run's --pose
    study: bool = False  # no claim of a paper: measured only by name, not by --all

    @property
    def paper(self) -> str:
        """Return the paper of a claim; for a study, the leagues that it studies."""
        return PAPERS.get(self.id[0], "both leagues")


def joined(batches: Sequence[Samples]) -> Samples:
    """Return the samples of several batches as one."""
    return {name: np.concatenate([batch[name] for batch in batches]) for name in batches[0]}


def as_plain(figure: Figure) -> dict[str, Any]:
    """Return a figure as plain data for JSON."""
    curves = [
        {name: [none_or_float(v) for v in getattr(curve, name)] for name in ("x", "y", "low", "high")}
        | {"name": curve.name}
        for curve in figure.curves
    ]
    words = {name: getattr(figure, name) for name in ("title", "x_label", "y_label")}
    plain = {**words, "curves": curves, "rules": [float(rule) for rule in figure.rules]}
    if figure.rule:
        plain["rule"] = figure.rule
    if figure.arrows is not None:
        plain["arrows"] = {name: [float(v) for v in values] for name, values in vars(figure.arrows).items()}
    return plain


def none_or_float(value: Any) -> float | None:
    """Return a finite number as a float, None for NaN and infinity."""
    return float(value) if np.isfinite(value) else None
