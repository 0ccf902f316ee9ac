"""`soccer warm-up` plays every part once, and finds nothing to compile the second time."""

import pytest

from soccer_env.compiling import cache
from soccer_env.teams import NAMES
from soccer_env.train.command import warm_up
from soccer_env.train.command.command_line import main
from soccer_env.train.command.warm_up import WarmUpSettings, parts_of


def test_every_team_is_played_in_its_league() -> None:
    names = [name for name, _ in parts_of(WarmUpSettings())]
    assert len(names) == len(set(names))
    assert {name.split(", ")[1] for name in names} >= set(NAMES)
    assert "legged-2001, sacks-2001" in names and "middle-size-2006, sacks-2001" not in names
    assert {"legged-2001, a drill", "middle-size-2006, a drill"} <= set(names)
    one = [name for name, _ in parts_of(WarmUpSettings(league="legged-2001", team="still"))]
    assert one[-1] == "legged-2001, still" and len(one) == 6


def test_the_second_time_nothing_is_left(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(warm_up, "WAYS", ({"senses": "ideal", "observe": "truth"},))
    words = ["warm-up", "--league", "legged-2001", "--team", "still"]
    for _ in range(2):
        assert main(words) == 0
    said = capsys.readouterr().out.splitlines()[-1]
    assert said == f"nothing was left to compile; the cache is in {cache.folders()[0]}"


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (["--league", "legged"], "league must be one of all, legged-2001"),
        (["--team", "chasr"], "unknown team 'chasr', did you mean 'chaser'?"),
    ],
)
def test_wrong_words_are_refused(words: list[str], complaint: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["warm-up", *words]) == 2
    assert complaint in capsys.readouterr().err


def test_long_compiling_says_how_far_it_is(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    for name, value in (("functions", 7), ("began", 100.0), ("said", 100.0)):
        monkeypatch.setattr(cache.COMPILED, name, value)
    now = iter([119.0, 121.0, 122.0])
    monkeypatch.setattr(cache.time, "monotonic", lambda: next(now))
    for _ in range(3):
        cache._count()
    assert capsys.readouterr().err == "soccer_env: compiling ... 9 functions in 21 s\n"
