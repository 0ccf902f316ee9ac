"""A claim of a paper: its statement, its measurement, and the samples and figures that the measurement returns."""

import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache, wraps
from typing import Any, Literal, TypeVar

import numpy as np

from soccer_env.match.arguments import Pose
from soccer_env.match.staging import PATIENT
from soccer_env.train.papers.verdicts import Criterion, Samples

SACKS, HEINEMANN = "Sacks 2001", "Heinemann et al. 2006"
PAPERS = {"S": SACKS, "H": HEINEMANN}  # by the first letter of a claim's id
# Rule sets of a claim's matches: the claim is judged from play, from play and staged scenes, or from staged scenes
LEAGUE = "league"
T = TypeVar("T")
PLAYED, PLAYED_AND_STAGED, STAGED, NO_MATCH = (LEAGUE,), (LEAGUE, PATIENT), (PATIENT,), ()


@dataclass(frozen=True)
class Batch:
    """Identity of one batch of a claim's samples: seeds derived from it determine all random numbers of the batch."""

    claim: str
    seed: int  # one of the run's seeds
    index: int  # 0, 1, ...
    threads: int = 1  # to share the work; no result depends on it
    pose: Pose = "particles"  # how robots know where they are: "particles" or "percept"
    rules: tuple[str, ...] = PLAYED_AND_STAGED  # rule sets that its matches may use

    @property
    def play_rules(self) -> str:
        """Return the claim's first rule set other than PATIENT, for whole games; ValueError if it states none."""
        for rules in self.rules:
            if rules != PATIENT:
                return rules
        raise ValueError(f"claim {self.claim} is judged from play, and states no rules of play: {self.rules}")

    def sequence(self) -> np.random.SeedSequence:
        """Return the seed sequence of this batch, which no other batch or claim shares."""
        return np.random.SeedSequence([self.seed, zlib.crc32(self.claim.encode()), self.index])

    def seeds(self, matches: int) -> np.ndarray:
        """Return seeds (matches,) for a Match, identical for all variants of a measurement, which pairs variants."""
        return self.sequence().generate_state(matches, np.uint64)

    def rng(self, purpose: int = 0) -> np.random.Generator:
        """Return a generator for draws outside matches, such as starting places."""
        return np.random.default_rng(np.random.SeedSequence([*self.sequence().entropy, 1 + purpose]))  # type: ignore[misc]


FIRST = "{variant} {sample}"  # form of the names of samples that begin with the variant
SHARED: list[Any] = []  # the caches of scenes that claims share


def shared(scenes: str, most: int = 128, **fields: Any) -> Callable[[Callable[..., T]], Callable[..., T]]:
    """Let claims share a measurement: batches count as those of `scenes`, with `fields`; `most` results are kept."""

    def decorate(measure: Callable[..., T]) -> Callable[..., T]:
        kept = lru_cache(maxsize=most)(measure)
        SHARED.append(kept)

        @wraps(measure)
        def measure_once(batch: Batch, **settings: Any) -> T:
            return kept(replace(batch, claim=scenes, **fields), **settings)

        return measure_once

    return decorate


@dataclass(frozen=True)
class Curve:
    """A named curve of a figure: points (x, y), with optional intervals (low, high) of y."""

    name: str
    x: Sequence[float]
    y: Sequence[float]
    low: Sequence[float] = ()
    high: Sequence[float] = ()


@dataclass(frozen=True)
class Arrows:
    """Arrows drawn over a picture of the field: origins (x, y) and components (along_x, along_y)."""

    x: Sequence[float]
    y: Sequence[float]
    along_x: Sequence[float]
    along_y: Sequence[float]


@dataclass(frozen=True)
class Figure:
    """Plain data of a figure, which the report plots or prints as a table."""

    title: str
    x_label: str
    y_label: str
    curves: tuple[Curve, ...]
    rules: tuple[float, ...] = ()  # heights of dashed lines: the bounds of the criterion
    rule: str = ""  # the meaning of these lines, if they are no bounds
    arrows: Arrows | None = None  # a picture of the field: both axes have one scale


@dataclass(frozen=True)
class Ablation:
    """An ingredient that makes a claim hold by construction, and the measurement with this ingredient removed."""

    ingredient: str
    measure: Callable[[Batch], Samples]


@dataclass(frozen=True)
class Claim:
    """A claim and its measurement.

    `measure` returns the samples of one batch: arrays of equal length whose first axis is independent units (runs,
    matches). For every seed, at least `least` and at most `batches` (with --quick: `quick`) batches are measured, until
    all seeds together decide the claim, and each seed alone does too or a third of the cap is reached.
    """

    id: str  # the letter of its paper, see PAPERS, and a number; or the name of a study
    section: str
    statement: str  # what the paper says
    method: str  # how it is measured
    criteria: tuple[Criterion, ...]  # none that decides: context
    measure: Callable[[Batch], Samples]
    rules: tuple[str, ...] = STAGED  # rule sets of its matches: PLAYED, PLAYED_AND_STAGED, STAGED or NO_MATCH
    batches: int = 16
    least: int = 1  # batches of a seed before the first verdict; more than 1 where few units of a batch count
    quick: int = 1
    seconds: float = 3.0  # [s] of one batch on one core, compiled: --minutes derives the number of batches from it
    condition: str = ""  # that the verdict names: "reproduced, with ..."
    ingredients: tuple[str, ...] = ()  # settings and models that the result depends on
    without: Ablation | None = None  # by construction
    figures: Callable[[Samples], Sequence[Figure]] = lambda samples: ()
    note: str | Callable[[Samples], str] = ""  # for readers of the result
    pose: Literal["", "percept", "particles"] = ""  # the localisation that the claim is about; "": the run's --pose
    timed: bool = False  # its samples are computing times, which no run repeats
    study: bool = False  # no claim of a paper: measured only by name, not by --all

    @property
    def paper(self) -> str:
        """Return the name of the claim's paper; for a study, "both leagues"."""
        return PAPERS.get(self.id[0], "both leagues")


def claim(id: str, section: str, statement: str, method: str, *criteria: Criterion, **fields: Any) -> Claim:
    """Return a claim with these criteria; `fields`: the others of `Claim`, of which `measure` is needed."""
    return Claim(id, section, statement, method, criteria, **fields)


def join_batches(batches: Sequence[Samples]) -> Samples:
    """Concatenate the sample arrays of several batches, name by name."""
    return {name: np.concatenate([batch[name] for batch in batches]) for name in batches[0]}


def compare(
    variants: Mapping[str, Any], measure: Callable[[Any], Samples], form: str = "{sample} {variant}"
) -> Samples:
    """Measure each of the variants; return all samples, named by `form`: "error new" for the error of "new"."""
    return {
        form.format(sample=sample, variant=variant): values
        for variant, settings in variants.items()
        for sample, values in measure(settings).items()
    }


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
