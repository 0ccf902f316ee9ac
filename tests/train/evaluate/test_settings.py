"""Settings of an evaluation: what they mean, what is refused, and the command that repeats them."""

import shlex
from pathlib import Path

import pytest

from soccer_env.leagues import find_league
from soccer_env.train.command.parsing import read_settings
from soccer_env.train.evaluate.settings import EvaluateSettings, command_of, conditions_of

LEGGED, MIDDLE = find_league("legged-2001"), find_league("middle-size-2006")


def test_what_is_left_open_comes_from_the_league() -> None:
    legged, middle = conditions_of(EvaluateSettings(), LEGGED), conditions_of(EvaluateSettings(), MIDDLE)
    assert (legged.minutes, legged.players, legged.placement) == (10.0, (3, 3), "instant")
    assert (middle.minutes, middle.players, middle.placement) == (4.0, (5, 5), "drive")


def test_full_is_both_halves() -> None:
    assert conditions_of(EvaluateSettings(minutes="full"), LEGGED).minutes == 2 * LEGGED.rules.half_minutes


def test_team_sizes_may_differ() -> None:
    assert conditions_of(EvaluateSettings(players="3v5"), LEGGED).players == (3, 5)
    assert conditions_of(EvaluateSettings(players=4), LEGGED).players == (4, 4)


def test_senses_for_one_team_each() -> None:
    both = conditions_of(EvaluateSettings(senses="home=ideal,away=sensors"), LEGGED)
    assert both.senses == ("ideal", "sensors")
    assert both.senses_text == "home=ideal,away=sensors"
    assert conditions_of(EvaluateSettings(senses="ideal"), LEGGED).senses_text == "ideal"


@pytest.mark.parametrize(
    "wrong",
    [
        {"matches": 3},
        {"matches": 0},
        {"matches": 2.0},
        {"matches": True},
        {"seed": -1},
        {"threads": 0},
        {"minutes": 0},
        {"minutes": float("nan")},
        {"minutes": float("inf")},
        {"minutes": "half"},
        {"minutes": -4.0},
        {"players": 0},
        {"players": 12},
        {"players": "3v"},
        {"players": "v"},
        {"players": "1v2v3"},
        {"players": True},
        {"senses": "eyes"},
        {"senses": "home=ideal,away=eyes"},
        {"senses": ""},
        {"pose": "compass"},
        {"placement": "walk"},
        {"at_least": 95},
        {"picture": True},
    ],
)
def test_wrong_settings_are_refused_by_name(wrong: dict) -> None:
    with pytest.raises(ValueError, match=next(iter(wrong))):
        EvaluateSettings(**wrong)


@pytest.mark.parametrize(
    "settings",
    [
        EvaluateSettings(),
        EvaluateSettings(home="chaser@0.5", minutes=2.5, players="3v5", threads=2, out=Path("runs/a b"), picture=True),
        EvaluateSettings(minutes="full", senses="home=ideal,away=sensors", placement="drive", at_least=0.95, seed=7),
    ],
)
def test_the_command_of_settings_gives_these_settings(settings: EvaluateSettings) -> None:
    program, name, *words = shlex.split(command_of(settings))
    assert (program, name) == ("soccer", "evaluate")
    again = read_settings(EvaluateSettings, words, "evaluate")
    assert again == settings


def test_the_command_of_a_report_never_throws_matches_away() -> None:
    assert "anew" not in command_of(EvaluateSettings(anew=True, out=Path("x")))
