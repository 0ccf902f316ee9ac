"""The pictures of the pages show the match that they say, beliefs where they are believed, and each rule as it acts."""

import numpy as np
import pytest

pytest.importorskip("pygame")


from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.rules import NEVER, rule_set
from soccer_env.train.pages.pictures import rules_legged, rules_middle_size
from soccer_env.train.pages.pictures.__main__ import many_matches
from soccer_env.train.pages.pictures.belief import belief_picture
from soccer_env.train.pages.pictures.frames import frames_picture
from soccer_env.train.pages.pictures.rules import play_to_whistle
from soccer_env.train.pages.pictures.settings import FOLDER, MOMENTS
from soccer_env.types import Foul


def test_still_pictures_have_the_width_asked_for_and_a_legend() -> None:
    for picture in (belief_picture(240, 0.5), frames_picture(240)):
        assert picture.shape[1:] == (240, 3) and picture.dtype == np.uint8
        assert len(np.unique(picture[-20:].reshape(-1, 3), axis=0)) > 5  # words and signs, not an empty strip


def test_the_pictures_of_the_pages_are_there_and_small() -> None:
    if not FOLDER.exists():
        pytest.skip("installed without the pictures")
    sizes = {file.name: file.stat().st_size for file in FOLDER.iterdir()}
    gallery = {moment.name for moment in MOMENTS} | {"many.png", "ruling.png"}
    sheets = {f"rules-{name}.png" for name in ("legged", "middle-size")}
    assert gallery | sheets | {"belief.png", "frames.png"} <= set(sizes)
    assert {name for name in gallery if sizes[name] > (1_000_000 if name.endswith(".gif") else 60_000)} == set()
    assert all(sizes[name] < 250_000 for name in sheets)


def test_nobody_is_whistled_in_the_opening_film() -> None:
    (film,) = (moment for moment in MOMENTS if moment.name == "match.gif")
    start, seconds = film.shown["start"], film.shown["seconds"]
    teams = {"home": film.recorded["home"], "away": film.recorded["away"]}
    size, play = film.recorded["players"], {name: film.recorded[name] for name in ("league", "seed", "minutes")}
    match = Match(**play, home=size, away=size, controllers=teams, pose="particles")
    goals = []
    for step in range(round((start + seconds) * match.league.control_rate)):
        match.step()
        if step > start * match.league.control_rate:
            assert match.robots["active"].all() and not match.robot_events["foul"].any()
            goals.append(int(match.events["goal"][0]))
    assert goals.count(0) == 1 and goals.count(1) == 0  # one goal, of home


def test_many_matches_are_a_sheet_of_pitches_that_differ() -> None:
    sheet = many_matches()
    rows, columns = sheet.shape[0] // 3, sheet.shape[1] // 4
    assert not np.array_equal(sheet[:rows, :columns], sheet[:rows, columns : 2 * columns])


RULINGS = rules_legged.RULINGS + rules_middle_size.RULINGS
NUMBERS = {
    "pushing": "pushing_time", "goalkeeper pushing": "keeper_pushing_time", "ball holding": "holding_time",
    "ball holding, goalkeeper": "keeper_holding_time", "carrying (of 2008)": "carrying_distance",
    "illegal defender": "illegal_defender_time", "illegal attacker (off)": "illegal_attacker_time",
    "leaving the field": "leaving_time", "falling": "fallen_time", "local game stuck": "local_stuck_time",
    "global game stuck": "global_stuck_time", "dropped ball": "stuck_time", "pulled apart": "contact_time",
    "second touch": "taking_distance", "distance": "distance_time", "charging": "charging_time",
    "charging, hard": "charging_hard", "ball handling": "handling_back",
    "dribbling (later years)": "dribble_distance", "own goal area": "area_time", "penalty area": "area_time",
    "timed cards (off)": "card_time",
}  # of a rule, by its picture  # fmt: skip


@pytest.mark.parametrize("ruling", rules_legged.RULINGS, ids=lambda ruling: ruling.rule)
def test_each_rule_of_the_legged_league_is_whistled_in_its_picture(ruling) -> None:
    match, before = play_to_whistle(ruling)
    rules = find_league("legged-2001").rules
    others = "".join(f":{name}=True" for name in ruling.switches if not getattr(rules, name))  # that are off
    assert ruling.stage()[0].settings.league.rules == rule_set(rules, f"league{others}")
    goes_out = ruling.foul not in (Foul.NONE, Foul.FALLEN, Foul.GAME_STUCK) and ruling.row != 0
    assert match.robots["penalty"].max() == (30.0 if goes_out else 0.0)
    robots = np.hypot(match.robots["x"] - before[2]["x"], match.robots["y"] - before[2]["y"]).max()
    ball = np.hypot(match.balls["x"] - before[1]["x"], match.balls["y"] - before[1]["y"]).max()
    assert max(robots, ball) > 0.2  # somebody was taken out or put back, or the ball lies elsewhere


@pytest.mark.parametrize("ruling", rules_middle_size.RULINGS, ids=lambda ruling: ruling.rule)
def test_each_rule_of_the_middle_size_is_whistled_in_its_picture(ruling) -> None:
    match, _ = play_to_whistle(ruling)
    assert match.settings.league.name == "middle-size-2006"
    if ruling.foul:
        assert [int(foul) for foul in match.robot_events["foul"][0] if foul] == [ruling.foul]
    else:
        assert match.events["foul"][0] == 0
        assert match.events["restart"][0] > 0 or match.robot_events["returned"][0, ruling.row] == 1


@pytest.mark.parametrize("ruling", [one for one in RULINGS if len(one.switches) in (1, 2)], ids=lambda one: one.rule)
def test_with_its_rule_off_a_situation_is_none(ruling) -> None:
    def stage():
        match, actions = ruling.stage()
        for name in ruling.switches:
            match.batch.constants[f"rules_{name}"] = NEVER if name == "contact_time" else 0
        return match, actions

    with pytest.raises(ValueError, match="nobody whistled"):
        play_to_whistle(ruling._replace(stage=stage))


def test_a_situation_in_which_nobody_whistles_is_an_error() -> None:
    ruling = rules_legged.RULINGS[0]._replace(longest=0.5)
    with pytest.raises(ValueError, match="nobody whistled for pushing"):
        play_to_whistle(ruling)


@pytest.mark.parametrize("rule", NUMBERS)
def test_twice_the_number_of_a_rule_is_not_reached_when_the_number_is(rule) -> None:
    ruling = next(one for one in RULINGS if one.rule == rule)
    whistled, _ = play_to_whistle(ruling)

    def stage():
        match, actions = ruling.stage()
        match.batch.constants[f"rules_{NUMBERS[rule]}"] *= 2.0
        return match, actions

    with pytest.raises(ValueError, match="nobody whistled"):
        play_to_whistle(ruling._replace(stage=stage, longest=whistled.matches["step"][0] * whistled.league.dt))
