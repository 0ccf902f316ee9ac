"""Verdicts on claims: criteria, and the comparison of intervals with them; `EXPLANATION` of report.py defines them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np

from soccer_env.train.papers.values import mean
from soccer_env.train.statistics import CONFIDENCE, Interval, clustered_share, unit_bootstrap

REPRODUCED = "reproduced"
NOT = "not"
UNDECIDED = "undecided"
BY_CONSTRUCTION, CONTEXT = "by construction", "context"
VERDICTS = (REPRODUCED, NOT, UNDECIDED, BY_CONSTRUCTION, CONTEXT)

Samples = dict[str, np.ndarray]  # arrays by name; first axis: independent units; NaN: no value
Value = str | Callable[..., float]  # samples by name, or a function of all samples
Statistic = Callable[[Any], float]  # of an array
PER_SI = {"%": 100.0, "pp": 100.0, "cm": 100.0, "cm/s": 100.0}  # a number in SI times this is one in the unit


@dataclass(frozen=True)
class Criterion:
    """A quantity of a claim's samples and its required bounds, made by `measured`, `counted`, `exact` or `reported`."""

    text: str
    unit: str  # of estimate and bounds: "%", "cm", "" for a plain number
    interval: Callable[[Samples, float], Interval]  # of samples and confidence
    units: Callable[[Samples], int]  # number of units with a value in it
    low: float = -inf
    high: float = inf
    strict: bool = False  # the bounds themselves violate it
    decides: bool = True  # False: a number that is reported beside the criteria

    @property
    def asked(self) -> str:
        """Return the bounds in words, such as "at least 80" or "above 0"; "" for a number that is only reported."""
        low, high = (f"{bound:.3g}" for bound in (self.low, self.high))
        parts = [f"{'above' if self.strict else 'at least'} {low}"] if self.low > -inf else []
        parts += [f"{'below' if self.strict else 'at most'} {high}"] if self.high < inf else []
        return " and ".join(parts)


@dataclass(frozen=True)
class Finding:
    """The estimate and verdict of one criterion."""

    criterion: str
    unit: str
    estimate: float
    low: float
    high: float
    verdict: str
    n: int  # units with a value in it
    asked: str = ""  # its bounds in words


def measured(
    text: str, value: Value, *arguments: Any, unit: str = "", of: Statistic = mean, **bounds: float
) -> Criterion:
    """Return a criterion on a quantity of the samples (`quantity_of`); its interval is a bootstrap over units."""
    quantity = quantity_of(value, arguments, unit, of)
    return Criterion(text, unit, bootstrap_of(quantity), used_units_counter(quantity), **_bound_fields(bounds))


def counted(
    text: str, hits: str, trials: str, chosen: Callable[[Samples], Samples] = dict, **bounds: float
) -> Criterion:
    """Return a criterion on a share [%]: `hits` and `trials` name the samples with the counts (U,) of each unit.

    `chosen` derives these samples from a claim's own.
    """

    def interval(samples: Samples, level: float) -> Interval:
        derived = chosen(samples)
        share, low, high = clustered_share(derived[hits], derived[trials], confidence=level)
        return 100.0 * share, 100.0 * low, 100.0 * high

    return Criterion(
        text, "%", interval, lambda samples: int((chosen(samples)[trials] > 0).sum()), **_bound_fields(bounds)
    )


def exact(text: str, value: Value, *arguments: Any, unit: str = "", of: Statistic = mean, **bounds: float) -> Criterion:
    """Return a criterion on a number without scatter, such as arithmetic or a property of a table."""
    quantity = quantity_of(value, arguments, unit, of)

    def interval(samples: Samples, level: float) -> Interval:
        number = float(quantity(samples))
        return number, number, number

    return Criterion(text, unit, interval, used_units_counter(quantity), **_bound_fields(bounds))


def reported(text: str, value: Value, *arguments: Any, unit: str = "", of: Statistic = mean) -> Criterion:
    """Return a criterion for a number that is reported beside the others and decides nothing."""
    quantity = quantity_of(value, arguments, unit, of)
    return Criterion(text, unit, bootstrap_of(quantity), used_units_counter(quantity), decides=False)


def quantity_of(value: Value, arguments: Sequence[Any], unit: str, of: Statistic) -> Callable[[Samples], float]:
    """Return a quantity as a function of the samples.

    `value`: a function of samples and `arguments`; or the name of samples in SI, whose statistic `of` is converted to
    the unit: of all of them or, with indices of the last axis as `arguments`, of some columns.
    """
    if isinstance(value, str):
        return lambda samples: PER_SI.get(unit, 1.0) * of(samples[value][(..., *arguments)])
    return lambda samples: value(samples, *arguments)


def bootstrap_of(value: Callable[[Samples], float]) -> Callable[[Samples, float], Interval]:
    """Return a function of samples and confidence that gives the bootstrap interval of a quantity."""
    return lambda samples, level: unit_bootstrap(samples, value, confidence=level)


class ReadTracker(dict[str, np.ndarray]):
    """Samples that record which of their arrays are read."""

    def __init__(self, samples: Samples) -> None:
        super().__init__(samples)
        self.read: set[str] = set()

    def __getitem__(self, name: str) -> np.ndarray:
        self.read.add(name)
        return super().__getitem__(name)


def used_units_counter(value: Callable[[Samples], float]) -> Callable[[Samples], int]:
    """Return a function that counts the units of a quantity: the fewest with a value among the arrays that it reads."""

    def count(samples: Samples) -> int:
        watched = ReadTracker(samples)
        value(watched)
        return min((units_with_value(samples[name]) for name in watched.read or samples), default=0)

    return count


def units_with_value(array: np.ndarray) -> int:
    """Return the number of units (first axis) of an array that have at least one value other than NaN."""
    if array.dtype.kind != "f":
        return len(array)
    return int(np.isfinite(array.reshape(len(array), -1)).any(axis=1).sum())


def _bound_fields(bounds: dict[str, float]) -> dict[str, Any]:
    """Convert the bounds at_least, at_most, above or below to the fields low, high and strict of a Criterion."""
    unknown = set(bounds) - {"at_least", "at_most", "above", "below"}
    strict = bool({"above", "below"} & set(bounds))
    if unknown or not bounds or (strict and {"at_least", "at_most"} & set(bounds)):
        raise ValueError(f"bounds are at_least and at_most, or above and below, got {bounds}")
    low = bounds.get("at_least", bounds.get("above", -inf))
    high = bounds.get("at_most", bounds.get("below", inf))
    return {"low": low, "high": high, "strict": strict}


def judge_criterion(
    criterion: Criterion, samples: Samples, confidence: float = CONFIDENCE, criteria: int = 1
) -> Finding:
    """Compare samples with one of `criteria` criteria of a claim at a confidence, and return the finding.

    All criteria have to hold, so each is tested at the whole error rate; one that fails refutes the claim, so they
    share the error rate of that (Bonferroni).
    """
    estimate, low, high = criterion.interval(samples, confidence)
    verdict = judge(criterion, low, high)
    if verdict == NOT and criteria > 1:
        verdict = judge(criterion, *criterion.interval(samples, 1.0 - (1.0 - confidence) / criteria)[1:])
    return Finding(
        criterion.text, criterion.unit, estimate, low, high, verdict, criterion.units(samples), criterion.asked
    )


def judge(criterion: Criterion, low: float, high: float) -> str:
    """Return the verdict on one criterion from the interval [low, high]."""
    if not criterion.decides:
        return CONTEXT
    if criterion.strict:
        inside = criterion.low < low and high < criterion.high
        outside = high <= criterion.low or criterion.high <= low
    else:
        inside = criterion.low <= low and high <= criterion.high
        outside = high < criterion.low or criterion.high < low
    return REPRODUCED if inside else NOT if outside else UNDECIDED


def combine(findings: Sequence[Finding]) -> str:
    """Combine the findings about a claim's criteria into its verdict: all criteria must hold."""
    verdicts = {finding.verdict for finding in findings} - {CONTEXT}
    for verdict in (NOT, UNDECIDED, REPRODUCED):
        if verdict in verdicts:
            return verdict
    return CONTEXT


def deciding_finding(findings: Sequence[Finding]) -> Finding | None:
    """Return the finding that decides a claim: the first finding with the claim's verdict."""
    verdict = combine(findings)
    return next((finding for finding in findings if finding.verdict == verdict), None)
