"""The pictures of the pages show the match that they say, beliefs where they are believed, and each rule as it acts."""

from dataclasses import replace
from math import dist, pi

import numpy as np
import pytest

pytest.importorskip("pygame")


from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.leagues.rules import NEVER, rule_set
from soccer_env.records.beliefs import TRACK
from soccer_env.render import Area, Label, Points, Polyline
from soccer_env.render.colours import BALL_SHINE, TEAMS_LIGHT
from soccer_env.render.overlays.sight import ray_end
from soccer_env.train.pages.pictures import rules_legged, rules_middle_size
from soccer_env.train.pages.pictures.__main__ import many_matches
from soccer_env.train.pages.pictures.belief import belief_overlays, belief_picture, believed_player, field_of_view
from soccer_env.train.pages.pictures.frames import frames_picture
from soccer_env.train.pages.pictures.rules import play_to_whistle
from soccer_env.train.pages.pictures.settings import FOLDER, MOMENTS, PictureSettings
from soccer_env.types import Foul

TINY = PictureSettings(home="chaser", away="still", still_width=240, belief_time=0.5)


@pytest.mark.parametrize("row", [1, 4])
def test_who_knows_the_truth_believes_every_thing_where_it_is(row: int) -> None:
    match = Match(TINY.league, senses="ideal", controllers={"home": "chaser", "away": "chaser"}, seed=2)
    for _ in range(80):
        match.step()
    overlays = [one for one in belief_overlays(match, row, 1.0) if isinstance(one, Points)]
    rings = {colour: [one.xy[0] for one in overlays if one.colour == colour] for colour in (*TEAMS_LIGHT, BALL_SHINE)}
    assert rings[BALL_SHINE] == [pytest.approx((match.balls["x"][0], match.balls["y"][0]), abs=1e-6)]
    for team in (0, 1):
        others = [r for r in range(6) if r != row and match.robots["team"][0, r] == team]
        true = sorted((float(match.robots["x"][0, r]), float(match.robots["y"][0, r])) for r in others)
        assert sorted(rings[TEAMS_LIGHT[team]]) == [pytest.approx(place, abs=1e-6) for place in true]


def test_an_old_memory_is_tied_to_the_nearest_player_of_its_team_and_a_new_one_to_nobody() -> None:
    match = Match(TINY.league, seed=2)
    robots, track = match.robots[0], np.zeros((), TRACK)
    own = (float(robots["x"][1]), float(robots["y"][1]), 0.0)
    track["x"], track["y"] = robots["x"][4] - own[0] + 0.05, robots["y"][4] - own[1]
    (ring,) = believed_player(match, 1, own, track, 1.0)
    assert isinstance(ring, Points)
    track["age"] = 9.0
    _, line, words = believed_player(match, 1, own, track, 1.0)
    assert isinstance(line, Polyline) and isinstance(words, Label) and words.words == "9 s ago"
    place = (float(robots["x"][4]), float(robots["y"][4]))
    assert list(line.xy) == [pytest.approx(place), pytest.approx((place[0] + 0.05, place[1]))]
    track["teammate"], track["x"], track["y"] = 1, 0.0, 0.0  # where the robot itself stands
    _, line, _ = believed_player(match, 1, own, track, 1.0)
    mates = [(float(robots["x"][r]), float(robots["y"][r])) for r in (0, 2)]
    assert line.xy[0] == min(mates, key=lambda at: dist(at, own[:2]))
    track["x"] = 9.0  # beyond the pitch
    assert believed_player(match, 1, own, track, 1.0) == []


def test_the_field_of_view_is_as_wide_as_the_cameras_and_ends_at_the_boards() -> None:
    league = find_league("legged-2001")
    area = next(one for one in field_of_view(league, (0.3, 0.2, pi / 2), -0.4) if isinstance(one, Area))
    (x, y), *edge = np.asarray(area.xy)
    neck = league.sensors.neck_ahead
    assert (x, y) == pytest.approx((0.3, 0.2 + neck))
    angles = [np.arctan2(b - y, a - x) for a, b in edge]
    assert angles[-1] - angles[0] == pytest.approx(league.sensors.view_width)
    assert (angles[0] + angles[-1]) / 2 == pytest.approx(pi / 2 - 0.4)
    assert all(max(abs(a) - 1.5, abs(b) - 1.0) == pytest.approx(0.0, abs=1e-9) for a, b in edge)
    assert ray_end(league, 0.0, 0.0, pi / 2) == pytest.approx((0.0, 1.0), abs=1e-9)
    assert ray_end(league, 0.0, 0.0, pi) == pytest.approx((-1.5, 0.0), abs=1e-9)
    assert field_of_view(find_league("middle-size-2006"), (0.0, 0.0, 0.0), 0.0) == []


def test_still_pictures_have_the_width_asked_for_and_a_legend() -> None:
    for picture in (belief_picture(TINY), frames_picture(TINY)):
        assert picture.shape[1:] == (240, 3) and picture.dtype == np.uint8
        assert len(np.unique(picture[-20:].reshape(-1, 3), axis=0)) > 5  # words and signs, not an empty strip
    wide = belief_picture(replace(TINY, belief_robot=0))
    assert not np.array_equal(wide, belief_picture(TINY))


def test_the_pictures_of_the_pages_are_there_and_small() -> None:
    if not FOLDER.exists():
        pytest.skip("installed without the pictures")
    sizes = {file.name: file.stat().st_size for file in FOLDER.iterdir()}
    gallery = {moment.name for moment in MOMENTS} | {"many.png", "ruling.png"}
    sheets = {f"rules-{name}.png" for name in ("legged", "middle-size")}
    assert gallery | sheets | {"belief.png", "frames.png"} <= set(sizes)
    assert {name for name in gallery if sizes[name] > (1_000_000 if name.endswith(".gif") else 60_000)} == set()
    assert all(sizes[name] < 250_000 for name in sheets)


def test_nobody_is_sent_off_in_the_opening_film() -> None:
    (film,) = (moment for moment in MOMENTS if moment.name == "match.gif")
    start, seconds = film.shown["start"], film.shown["seconds"]
    teams = {"home": film.recorded["home"], "away": film.recorded["away"]}
    match = Match(controllers=teams, seed=film.recorded["seed"], minutes=film.recorded["minutes"], pose="particles")
    goals = []
    for step in range(round((start + seconds) * match.league.control_rate)):
        match.step()
        if step > start * match.league.control_rate:
            assert match.robots["active"].all()
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
