"""Long work says how far it is: a bar on a terminal, a plain line now and then elsewhere."""

import pytest

from soccer_env.train import progress
from soccer_env.train.progress import EVERY, Progress


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    now = [100.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])
    return now


def test_without_a_terminal_a_plain_line_appears_now_and_then(
    clock: list[float], capsys: pytest.CaptureFixture[str]
) -> None:
    with Progress("reproduce", 40.0) as work:
        work.note("S05, 0 of 2 done")
        for _ in range(40):
            clock[0] += 1.0
            work.advance(1.0)
    assert capsys.readouterr().err.splitlines() == [
        f"reproduce: {100 * EVERY / 40:.0f} %, S05, 0 of 2 done",
        f"reproduce: {200 * EVERY / 40:.0f} %, S05, 0 of 2 done",
    ]


def test_short_work_and_no_work_say_nothing(clock: list[float], capsys: pytest.CaptureFixture[str]) -> None:
    with Progress("bench", 3.0) as work:
        clock[0] += 0.5 * EVERY
        work.advance(3.0)
    with Progress("reproduce", 0.0) as work:
        clock[0] += 2 * EVERY
        work.note("nothing")
    assert capsys.readouterr().err == ""
