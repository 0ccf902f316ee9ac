"""Claims that draw numbers instead of playing, for tests of the bench: what they were asked is noted."""

import dataclasses

import numpy as np

from soccer_env.train.papers.claim import NO_MATCH, Ablation, Batch, Claim, Curve, Figure
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.results import ClaimResult
from soccer_env.train.papers.settings import ReproduceSettings
from soccer_env.train.papers.verdicts import Criterion, Samples, counted, measured, reported

CALLS: list[tuple[str, int]] = []  # claim, batch
POSES: list[str] = []  # of the same batches


def draw(batch: Batch, mean: float = 0.0, count: int = 20) -> Samples:
    CALLS.append((batch.claim, batch.index))
    POSES.append(batch.pose)
    return {"x": batch.rng().normal(mean, 1.0, count), "one": np.ones(count), "up": batch.rng().random(count) < 0.9}


def mean(samples: Samples) -> float:
    return float(samples["x"].mean())


def plot(samples: Samples) -> tuple[Figure, ...]:
    return (Figure("A title", "place [m]", "value", (Curve("a", [0.0, 1.0], [mean(samples), np.nan]),), rules=(0.5,)),)


def claim(name: str, expected: float, *criteria: Criterion, **changes: object) -> Claim:
    made = Claim(
        id=name, section="0", statement=f"What {name} says.", method="Draws.",
        rules=NO_MATCH, criteria=criteria or (measured("mean above 0", mean, unit="cm", above=0.0),),
        measure=lambda batch: draw(batch, expected), batches=8, figures=plot,
    )  # fmt: skip
    return dataclasses.replace(made, **changes)  # type: ignore[arg-type]


KNOWN = {
    made.id: made
    for made in (
        claim("A1", 3.0),
        claim("A2", -3.0),
        claim("A3", 0.0, measured("mean above -0.01", mean, above=-0.01)),
        claim("A4", 3.0, without=Ablation("the shift", lambda batch: draw(batch, -3.0))),
        claim("A5", 0.0, reported("mean", mean)),
        claim("A6", 0.0, counted("at least 60 %", "up", "one", at_least=60.0), measured("mean < -1", mean, below=-1.0)),
        claim("look", 0.0, study=True),
        claim("lost", 0.0, study=True, pose="particles"),
    )
}


def run(*names: str, **settings: object) -> list[ClaimResult]:
    return reproduce(ReproduceSettings(claims=names, **{"seeds": (0,), **settings}), known=KNOWN)  # type: ignore[arg-type]
