"""Measuring played matches: the same settings give the same figures."""

import json
from pathlib import Path

import pytest

from soccer_env.leagues import find_league
from soccer_env.train.play import measures
from soccer_env.train.play.measures import MEASURES, measure
from soccer_env.train.play.report import read, screen_table, write
from soccer_env.train.play.settings import MeasureSettings, conditions_of

TINY = MeasureSettings(matches=3, minutes=0.2, seed=5, senses="ideal", players=2)


def test_figures_do_not_depend_on_how_many_matches_are_played_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = measure(TINY)
    monkeypatch.setattr(measures, "BLOCK", 2)
    assert measure(TINY).figures == whole.figures
    by_name = {found.name: found.value for found in whole.figures}
    assert 0.0 < by_name["ball in play"] <= 100.0  # type: ignore[operator]


def test_the_file_holds_settings_figures_and_what_each_means(tmp_path: Path) -> None:
    play = measure(TINY)
    write(play, tmp_path / "out" / "play.json")
    held = json.loads((tmp_path / "out" / "play.json").read_text())
    assert (held["settings"]["seed"], held["settings"]["placement"]) == (5, "instant")
    assert {found["name"] for found in held["figures"]} == held["definitions"].keys()
    assert all(len(words) > 20 for words in held["definitions"].values())
    assert screen_table(play).row_count <= len(held["figures"])


def test_figures_of_an_earlier_measurement_stand_beside_the_new_ones(tmp_path: Path) -> None:
    play = measure(TINY)
    write(play, tmp_path / "play.json")
    before = read(tmp_path / "play.json")
    assert list(before.values()) == list(play.figures)
    alone, both = screen_table(play), screen_table(play, before)
    assert [column.header for column in both.columns] == ["", "before", "95 % interval", "value", "95 % interval", ""]
    assert list(both.columns[1].cells) == list(both.columns[3].cells) == list(alone.columns[1].cells)
    (tmp_path / "play.json").write_text("{}")
    with pytest.raises(ValueError, match="before must be a file"):
        read(tmp_path / "play.json")


def test_names_of_figures_are_all_different() -> None:
    names = [figure.name for one in MEASURES for figure in one.figures]
    assert len(names) == len(set(names))


def test_rules_are_those_asked_for() -> None:
    assert conditions_of(MeasureSettings()).league == find_league("legged-2001")
    assert conditions_of(MeasureSettings(rules="simple")).league.rules.name == "simple"
    with pytest.raises(ValueError, match="known: league, simple, none"):
        conditions_of(MeasureSettings(rules="simpel"))


@pytest.mark.parametrize("wrong", [{"matches": 0}, {"minutes": 0.0}, {"players": 12}])
def test_wrong_settings_are_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(ValueError, match=f"{next(iter(wrong))} must be"):
        MeasureSettings(**wrong)  # type: ignore[arg-type]
