"""Teams, drills and policies go by a league's family, not by its name; and its constants are what kernels read."""

import ast
from collections.abc import Iterator
from dataclasses import Field, fields, is_dataclass, replace
from pathlib import Path
from typing import Any, get_type_hints

import pytest

from soccer_env import Match
from soccer_env.leagues import LEAGUES, League, find_league
from soccer_env.leagues.checks import PYTHON_ONLY
from soccer_env.leagues.constants import CONSTANTS, NUMBERS, constants_of
from soccer_env.leagues.robot import DRIVE_KINDS
from soccer_env.scenes import SCENES
from soccer_env.teams import make_team, registered_teams
from tests.agents.staged_policies import random_policy, team_from_disk

LEGGED, MIDDLE = find_league("legged-2001"), find_league("middle-size-2006")
ICY = replace(  # as in the README
    LEGGED, name="legged-icy", ball=replace(LEGGED.ball, rolling=0.05), drive=replace(LEGGED.drive, slip=0.25)
)
VARIANTS = [ICY, replace(LEGGED, name="icy"), replace(LEGGED, name="middle-size-2006")]


def walks(league: League, team: Any) -> bool:
    """Tell whether a team's robot asks its body to go anywhere within two seconds of play."""
    match = Match(league, home=1, away=1, seed=3, controllers={"home": team, "away": "still"}, senses="ideal")
    asked = 0.0
    for _ in range(2 * league.control_rate):
        match.step()
        command = match.robots["command"][0, 0]
        asked = max(asked, abs(command["forward"]), abs(command["left"]))
    return asked > 0.0


@pytest.mark.parametrize("league", VARIANTS, ids=lambda league: league.name)
@pytest.mark.parametrize("team", ["sacks-2001", "chaser", "learned"])
def test_a_team_of_the_family_plays_whatever_the_league_is_called(league: League, team: str) -> None:
    assert walks(league, team)


def test_a_policy_file_plays_in_a_league_of_ones_own(tmp_path: Path) -> None:
    team = team_from_disk(random_policy(), tmp_path)
    assert walks(replace(LEGGED, name="of-my-own"), team)
    mine = team_from_disk(random_policy(league="middle-size-2006"), tmp_path)
    assert walks(replace(MIDDLE, name="of-my-own", ball=replace(MIDDLE.ball, rolling=0.2)), mine)


@pytest.mark.parametrize("scene", SCENES)
def test_every_scene_begins_in_a_league_of_its_family(scene: str) -> None:
    family = (SCENES[scene].families or ("legged",))[0]
    own = replace(next(league for league in LEAGUES.values() if league.family == family), name="of-my-own")
    away = max(2, len(SCENES[scene].opponents))
    match = Match(own, home=2, away=away, scene=scene, seed=1, controllers={"home": "still", "away": "still"})
    match.step()
    assert match.matches["over"].tolist() == [0]


@pytest.mark.parametrize("name", ["sacks-2001", "sacks-2001-tuned", "sacks-2001-future", "learned"])
def test_a_league_of_another_family_is_refused_although_it_has_the_name(name: str) -> None:
    cats = replace(LEGGED, family="cats")
    with pytest.raises(ValueError, match=f"{name}.* legged.*, 'legged-2001' is .*cats"):
        Match(cats, controllers={"home": name}, seed=1)
    with pytest.raises(ValueError, match="scene 'gap-500' is for legged leagues, 'legged-2001' is cats"):
        Match(cats, scene="gap-500", home=1, away=2, seed=1)
    Match(cats, home=1, away=1, controllers={"home": "chaser", "away": "walker"}, seed=1).step()


def test_a_policy_is_refused_at_another_control_rate_where_scripted_teams_play() -> None:
    faster = replace(LEGGED, control_rate=20)
    with pytest.raises(ValueError, match="policy 'learned' .* of control rate 16, .* control rate 20"):
        Match(faster, controllers={"home": "learned"}, seed=1)
    assert walks(faster, "sacks-2001")


def test_families_of_teams_and_scenes_are_those_that_leagues_have() -> None:
    known = {league.family for league in LEAGUES.values()}
    assert known == {"legged", "middle-size"}
    asked = [getattr(make_team(name), "families", ()) for name in registered_teams()]
    asked += [scene.families for scene in SCENES.values()]
    assert {family for families in asked for family in families} <= known
    assert any(asked), "or else the line above says nothing"


ROOT = Path(__file__).parents[2]
PARTS = {name: kind for name, kind in get_type_hints(League).items() if is_dataclass(kind)}


def numbers() -> Iterator[tuple[str, Field[Any]]]:
    """Yield every number of every part of a league that is no whole one."""
    for part, kind in PARTS.items():
        yield from ((part, field) for field in fields(kind) if str(field.type) == "float")


def reads() -> tuple[set[str], set[str]]:
    """Return the names that product code reads as k.NAME or constants[0].NAME, and as NAME of anything else."""
    of_constants, of_others = set(), set()
    for folder in ("soccer_env", "baselines", "agents", "train"):
        for file in (ROOT / folder).rglob("*.py"):
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
                if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load):
                    record = ast.unparse(node.value).rpartition(".")[2] in ("k", "constants[0]")
                    (of_constants if record else of_others).add(node.attr)
    return of_constants, of_others


@pytest.mark.parametrize("name", LEAGUES)
def test_each_number_stands_under_the_name_of_its_part(name: str) -> None:
    league = LEAGUES[name]
    record = constants_of(league)[0]
    assert len(NUMBERS) > 60
    for part, field in numbers():
        if field.metadata != PYTHON_ONLY:
            assert record[f"{part}_{field.name}"] == getattr(getattr(league, part), field.name), (part, field.name)
    assert record["drive_kind"] == DRIVE_KINDS[league.drive.kind]
    assert record["corners"] == len(league.body.corners)
    assert [(x, y) for x, y in zip(record["corner_x"], record["corner_y"]) if x != 0.0] == [*league.body.corners]
    assert record["teammate_slots"] == league.slots.teammates and record["walled"] == league.pitch.walled
    assert not any(record[of_a_match] for of_a_match in ("placement_by_driving", "end_at_goal", "drill", "drill_time"))


def test_every_constant_is_read_and_what_no_kernel_reads_is_none() -> None:
    of_constants, of_others = reads()
    assert set(CONSTANTS.names or ()) <= of_constants, "declare it with metadata=PYTHON_ONLY"
    python_only = {(part, field.name) for part, field in numbers() if field.metadata == PYTHON_ONLY}
    assert not {f"{part}_{name}" for part, name in python_only} & set(CONSTANTS.names or ())
    assert {name for _, name in python_only} <= of_others
