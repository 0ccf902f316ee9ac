"""What the tests of training, evaluation and claims share."""

import pytest


@pytest.fixture(autouse=True)
def undrawn(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave the pages of evaluations empty, whose pictures take longer than short matches; report_pages/ reads them."""
    if "report_pages" not in request.path.parts:
        monkeypatch.setattr("soccer_env.train.evaluate.evaluation.page_of", lambda *_: "")
