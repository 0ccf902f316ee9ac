"""Stored results still hold: claims ask the questions that their rows answer; test_claim_staging.py measures again."""

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.train.pages.tables.paper_page import claim_entry
from soccer_env.train.papers import replays
from soccer_env.train.papers.claim import NO_MATCH, Batch
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.replays import changed_rows, question_hash, samples_hash
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.results import FOLDERS, read_stored
from soccer_env.train.papers.settings import ReproduceSettings
from soccer_env.train.papers.verdicts import measured
from soccer_env.train.provenance import play_facts
from tests.train.papers.staged_claims import KNOWN, draw, mean, run


@pytest.mark.parametrize("folder", FOLDERS.values(), ids=lambda folder: folder.name)
def test_claims_ask_what_their_stored_rows_answer(folder: Path) -> None:
    assert changed_rows(read_stored(folder), all_claims(), longest=0.0) == []


def stored_row() -> dict[str, Any]:
    (result,) = run("A1", seeds=(4, 5))
    return claim_entry(result, play_facts())


def test_a_row_keeps_its_world_its_question_and_its_first_batch() -> None:
    row = stored_row()
    assert row["about"] == play_facts() and row["asks"] == question_hash(KNOWN["A1"])
    assert row["sample"] == samples_hash(KNOWN["A1"].measure(Batch("A1", 4, 0, 1, "particles", NO_MATCH)))
    assert changed_rows({"A1": row}, KNOWN) == []


@pytest.mark.parametrize(
    "change",
    [
        {"criteria": (measured("mean above 0", mean, unit="cm", above=0.1),)}, {"batches": 9},
        {"method": "Draws 20."}, {"rules": ("league",)},
    ],
)  # fmt: skip
def test_another_question_is_found_and_other_words_are_none(change: dict[str, Any]) -> None:
    row = stored_row()
    (told,) = changed_rows({"A1": row}, {"A1": dataclasses.replace(KNOWN["A1"], **change)})
    assert told == "A1 asks another question than its stored row answers"
    reworded = dataclasses.replace(KNOWN["A1"], method="Draws numbers.", statement="A1 says it so.")
    assert changed_rows({"A1": row}, {"A1": reworded}) == []


def test_other_samples_are_found_unless_the_batch_is_too_long_or_of_another_machine_or_world(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    row = stored_row()
    monkeypatch.setattr(replays, "NUMBERS", replays.numbers_hash())  # as on the processors that measured the rows
    other = {"A1": dataclasses.replace(KNOWN["A1"], measure=lambda batch: draw(batch, 3.001))}
    (told,) = changed_rows({"A1": row}, other)
    assert told.startswith("A1: its first batch has other samples")
    assert changed_rows({"A1": row}, other, longest=1.0) == [], "a batch of the claim takes 3 s"
    for name in ("machine", "world", "pymunk"):
        assert changed_rows({"A1": row | {"about": row["about"] | {name: "x"}}}, other) == []
    monkeypatch.setattr(replays, "NUMBERS", "those of another processor")
    assert changed_rows({"A1": row}, other) == []


def test_computing_times_have_no_hash() -> None:
    assert {name for name, claim in all_claims().items() if claim.timed} == {"S42", "H02", "H15"}
    timed = dataclasses.replace(KNOWN["A1"], timed=True)
    (result,) = reproduce(ReproduceSettings(claims=("A1",), quick=True), known={"A1": timed})
    assert result.sample == "" and result.asks == stored_row()["asks"]


def test_samples_are_the_same_to_seven_digits() -> None:
    one = {"x": np.array([1.0, np.nan, 3.0])}
    assert samples_hash(one) == samples_hash({"x": one["x"] * (1.0 + 1e-12)})
    assert samples_hash(one) != samples_hash({"x": one["x"] * (1.0 + 1e-6)})
    assert samples_hash(one) != samples_hash({"y": one["x"]}) != samples_hash({"y": one["x"][None]})
