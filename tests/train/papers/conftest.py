"""What the tests of claims share."""

from collections.abc import Iterator
from typing import Any

import pytest

from soccer_env import Match
from soccer_env.train.papers.claim import SHARED


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> Iterator[set[str]]:
    """Record the rule sets of all matches that a test makes, moments of play that are kept from other tests too."""
    names: set[str] = set()
    make = Match.__init__

    def record(match: Match, *values: Any, **settings: Any) -> None:
        make(match, *values, **settings)
        names.add(match.league.rules.name)

    monkeypatch.setattr(Match, "__init__", record)
    for cached in SHARED:
        cached.cache_clear()
    yield names
