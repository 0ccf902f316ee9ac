"""Whether stored results still hold: the question of each claim by a hash, and its first batch measured again.

Each row of a claims.json carries a hash of the claim's question, a hash of the samples of its first batch, and the
world, versions and machine in which they were measured. Rows of another world are not replayed: the pages name it.
Versions of numpy and numba do not count: all rows of 2026-11-27 were measured with others than the lock file's, on a
processor of another make, and gave the same samples. Claims use numpy's arc tangents and exponentials, whose last bits
are others on processors with AVX-512: there three claims have other samples, which do not count.
`make tables-check` and a test of each claim replay all rows.
"""

import hashlib
import json
import re
from collections.abc import Mapping
from math import inf
from typing import Any

import numpy as np

from soccer_env.train.papers.claim import Batch, Claim
from soccer_env.train.papers.verdicts import Samples
from soccer_env.train.provenance import DIGITS, digest, play_facts

SAME = ("machine", "pymunk")  # of the facts of a row, where its samples should be the same
NUMBERS = "a6a1a51a848a"  # `numbers_hash` where the rows were measured
NUMBER = re.compile(r"\d+(?:\.\d+)?")


def question_hash(claim: Claim) -> str:
    """Return a hash of a claim's settings: criteria that decide, rules, batches, own pose, numbers of its method."""
    criteria = [(one.text, one.unit, one.asked) for one in claim.criteria if one.decides]
    numbers = NUMBER.findall(claim.method)
    return digest(json.dumps([criteria, numbers, claim.rules, claim.batches, claim.least, claim.pose]))


def samples_hash(samples: Samples) -> str:
    """Return a hash of samples to the seven digits of a single float, which sums in another order leave alone."""
    parts = hashlib.sha256()
    for name, values in samples.items():
        parts.update(f"{name} {values.shape}".encode() + np.asarray(values, np.float32).tobytes())
    return parts.hexdigest()[:DIGITS]


def numbers_hash() -> str:
    """Return a hash of numpy's arc tangents and exponentials on this processor."""
    numbers = np.linspace(-3.0, 3.0, 1001)
    return hashlib.sha256(np.arctan2(numbers, 1.0).tobytes() + np.exp(numbers).tobytes()).hexdigest()[:DIGITS]


def as_stored(samples: Samples, row: Mapping[str, Any]) -> bool:
    """Tell whether samples are those of a stored row; others do not count where numpy computes otherwise."""
    return samples_hash(samples) == row["sample"] or numbers_hash() != NUMBERS


def changed_rows(rows: Mapping[str, Mapping[str, Any]], known: Mapping[str, Claim], longest: float = inf) -> list[str]:
    """Return a sentence for each stored row whose claim asks another question, or whose first batch has other samples.

    Only batches of at most `longest` seconds are measured, and only rows of this world, kind of machine and engine.
    """
    changed, here = [], play_facts()
    for name, row in rows.items():
        claim, about = known[name], row["about"]
        if about.get("world") != here["world"]:
            continue
        if row["asks"] != question_hash(claim):
            changed.append(f"{name} asks another question than its stored row answers")
        elif row["sample"] and claim.seconds <= longest and all(about.get(fact) == here[fact] for fact in SAME):
            batch = Batch(name, row["seeds"][0], 0, 1, row["pose"], tuple(row["rules"]))
            if not as_stored(claim.measure(batch), row):
                changed.append(f"{name}: its first batch has other samples than when its stored row was measured")
    return changed
