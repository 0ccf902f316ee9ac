"""Examine one claim: batch by batch of each seed, until the interval decides or the cap is reached.

Every batch follows from a seed, the claim's id and the batch's number alone, so no result depends on threads, on other
claims, or on interruptions of a run. The verdict is that of the samples of all seeds together; the verdict of each seed
alone is reported beside it. A claim is tested after its least number of batches of each seed, twice that, four times
that, and so on; these looks share the 5 % of the interval (Bonferroni), so that stopping early does not make verdicts
bolder. The examination ends when all seeds together decide the claim and each seed alone does too; if a seed leaves it
open, it ends at a third of the cap, where three seeds together have as many samples as one seed at its cap.
"""

from collections.abc import Callable
from typing import NamedTuple

from soccer_env.train.papers import verdicts
from soccer_env.train.papers.claim import LEAGUE, Batch, Claim, as_plain, join_batches, none_or_float
from soccer_env.train.papers.replays import question_hash, samples_hash
from soccer_env.train.papers.results import FROM_CLAIM, ClaimResult, as_record
from soccer_env.train.papers.settings import ReproduceSettings, command_of
from soccer_env.train.statistics import CONFIDENCE

ENOUGH = 1.0 / 3.0  # of the cap, after which the verdict of all seeds together suffices


def examine(
    claim: Claim, settings: ReproduceSettings, cap: int, settings_hash: str,
    advance: Callable[[float], None] = lambda seconds: None,
) -> ClaimResult:  # fmt: skip
    """Measure batches of a claim, at most `cap` for each seed, until the claim is decided; return the result.

    `advance` is called with the seconds of finished work, in total the seconds of `cap` batches of each seed.
    """
    looks = examination_points(cap, claim.least)
    confidence = 1.0 - (1.0 - CONFIDENCE) / len(looks)
    taken: list[list[verdicts.Samples]] = [[] for _ in settings.seeds]
    findings: list[verdicts.Finding] = []
    alone: list[list[verdicts.Finding]] = []
    for index in range(cap):
        for batches, seed in zip(taken, settings.seeds, strict=True):
            batches.append(claim.measure(batch_of(claim, settings, seed, index)))
            advance(claim.seconds)
        if index + 1 in looks:
            findings = judge_criteria(claim, join_all_samples(taken), confidence)
            alone = [judge_criteria(claim, join_batches(batches), confidence) for batches in taken]
            if is_decided(findings, alone, (index + 1) / cap):
                break
    count = len(taken[0])
    advance((cap - count) * claim.seconds * len(taken))
    without: list[verdicts.Finding] = []
    if claim.without is not None:
        indices = ((seed, index) for seed in settings.seeds for index in range(count))
        off = [claim.without.measure(batch_of(claim, settings, *where)) for where in indices]
        without = judge_criteria(claim, join_batches(off), confidence)
    found = ClaimFindings(findings, without, alone, cap / count, "" if claim.timed else samples_hash(taken[0][0]))
    return result_of(claim, settings, join_all_samples(taken), found, settings_hash)


def is_decided(findings: list[verdicts.Finding], alone: list[list[verdicts.Finding]], share: float) -> bool:
    """Tell whether all seeds decide a claim, and each seed alone does too or the share ENOUGH of the cap is taken."""
    if verdicts.combine(findings) in (verdicts.UNDECIDED, verdicts.CONTEXT):
        return False
    return share >= ENOUGH or all(verdicts.combine(found) != verdicts.UNDECIDED for found in alone)


def batch_of(claim: Claim, settings: ReproduceSettings, seed: int, index: int) -> Batch:
    """Return the batch of a claim for one seed, by its index."""
    return Batch(claim.id, seed, index, settings.threads, claim.pose or settings.pose, rules_of(claim, settings))


def rules_of(claim: Claim, settings: ReproduceSettings) -> tuple[str, ...]:
    """Return the rule sets of a claim's matches, with the run's --rules in place of the league's rules."""
    return tuple(settings.rules if rules == LEAGUE else rules for rules in claim.rules)


def judge_criteria(claim: Claim, samples: verdicts.Samples, confidence: float) -> list[verdicts.Finding]:
    """Compare samples with each criterion of a claim and return the findings."""
    count = sum(criterion.decides for criterion in claim.criteria)
    return [verdicts.judge_criterion(criterion, samples, confidence, count) for criterion in claim.criteria]


def join_all_samples(taken: list[list[verdicts.Samples]]) -> verdicts.Samples:
    """Concatenate the samples of all seeds and batches."""
    return join_batches([batch for batches in taken for batch in batches])


def examination_points(cap: int, least: int = 1) -> list[int]:
    """Return the numbers of batches after which a claim is tested: `least` times 1, 2, 4 and so on, and the cap."""
    return [*(least * 2**i for i in range(cap.bit_length()) if least * 2**i < cap), cap]


class ClaimFindings(NamedTuple):
    """The findings about the criteria of a claim, and the share of the cap."""

    findings: list[verdicts.Finding]  # of the samples of all seeds
    without: list[verdicts.Finding]  # of all seeds without the ingredient
    alone: list[list[verdicts.Finding]]  # of each seed's samples alone
    share: float  # cap over batches taken
    sample: str  # hash of the first batch


def result_of(
    claim: Claim, settings: ReproduceSettings, samples: verdicts.Samples, found: ClaimFindings, settings_hash: str
) -> ClaimResult:
    """Return the result of a claim from its samples and findings."""
    verdict, main = verdicts.combine(found.findings), verdicts.deciding_finding(found.findings)
    if claim.without is not None and verdict == verdicts.REPRODUCED:
        verdict = verdicts.BY_CONSTRUCTION
    units = len(next(iter(samples.values()))) if samples else 0
    note = claim.note if isinstance(claim.note, str) else claim.note(samples)
    return ClaimResult(
        **{name: getattr(claim, name) for name in FROM_CLAIM},
        verdict=verdict,
        quick=settings.quick,
        pose=claim.pose or settings.pose,
        rules=list(rules_of(claim, settings)),
        estimate=none_or_float(main.estimate) if main else None,
        low=none_or_float(main.low) if main else None,
        high=none_or_float(main.high) if main else None,
        criterion=main.criterion if main else "",
        n=units,
        n_used=main.n if main else units,
        cap=round(units * found.share),
        seeds=list(settings.seeds),
        by_seed=[verdicts.combine(findings) for findings in found.alone],
        command=command_of(settings, claim.id),
        ingredients=list(claim.ingredients),
        note=note,
        findings=[as_record(finding) for finding in found.findings],
        without=claim.without.ingredient if claim.without else "",
        without_findings=[as_record(finding) for finding in found.without],
        figures=[as_plain(figure) for figure in claim.figures(samples)],
        asks=question_hash(claim),
        sample=found.sample,
        settings=settings_hash,
    )
