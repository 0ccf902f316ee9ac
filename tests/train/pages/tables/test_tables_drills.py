"""The table of teams over drills: who plays what, and what it shows."""

from soccer_env.scenes import SCENES
from soccer_env.scenes.drills import DRILLS
from soccer_env.scenes.drills_attacks import ATTACKS
from soccer_env.teams import make_team
from soccer_env.train.casting import controllers_of
from soccer_env.train.evaluate.drills import drills_of
from soccer_env.train.pages.tables.drills import TEAMS, drills_table


def test_every_drill_is_played_in_every_league_that_it_is_for() -> None:
    middle = {"far-post-shot", "near-post-shot", "receive-pass", "challenge-2003", "three-v-one", "counter-attack"}
    middle |= {"corner-kick", "free-kick"}
    every = {name for name, scene in SCENES.items() if scene.success != "none"}
    everybody = {"ball-at-board", "ball-in-corner"} | {scene.name for scene in (*DRILLS, *ATTACKS)} - middle
    assert {scene.name for scene in drills_of("legged-2001")} == every - middle > everybody
    assert {scene.name for scene in drills_of("middle-size-2006")} == middle | everybody
    assert len(every) >= 32 and len(everybody) >= 13


def test_every_scripted_team_plays_every_drill() -> None:
    assert {"still", "walker", "chaser", "sacks-2001"} <= set(TEAMS["legged-2001"])
    for teams in TEAMS.values():
        for team in teams:
            make_team(team)


def test_a_save_is_the_business_of_aways_goalkeeper_and_all_else_of_homes_robot() -> None:
    assert controllers_of(SCENES["shot-at-keeper"], "chaser") == {"home": "still", "away": "chaser"}
    assert controllers_of(SCENES["gap-500"], "chaser") == {"home": "chaser", "away_0": "still", "away_1": "still"}


def test_a_table_has_a_row_a_drill_and_a_column_a_team() -> None:
    row = {"league": "legged-2001", "drill": "facing-wall", "rules": "simple", "runs": 100}
    rows = [row | {"team": "still", "successes": 0}, row | {"team": "chaser", "successes": 97}]
    other = rows[1] | {"league": "middle-size-2006", "drill": "empty-goal"}
    text = drills_table({"seed": 1, "rows": [*rows, other]})
    assert "| legged-2001 [%] | `still` | `chaser` |\n|---|---|---|\n| `facing-wall` | 0 | 97 |\n\n" in text
    assert "| middle-size-2006 [%] | `chaser` |\n|---|---|\n| `empty-goal` | 97 |\n\n" in text
    end = "100 runs each by sensors, seed 1; 95 % intervals (Wilson) are at most 5 points to either side."
    assert text.endswith(end)
