"""What several tests of this folder begin with."""

import pytest

from tests.statistics.counted_steps import Steps


@pytest.fixture
def steps() -> Steps:
    """Return three robots a side whose steps are counted."""
    return Steps()
