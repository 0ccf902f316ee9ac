"""What staging shows of a running match is the match's own: what is written there is what the match plays with."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.sacks_2001.memory import DRIBBLE, SHOOT
from soccer_env.match import staging
from tests.scenes.staging import play


def sacks(**settings: object) -> Match:
    sides = {"home": "sacks-2001", "away": "still"}
    return Match("legged-2001", home=2, away=2, matches=2, seed=4, controllers=sides, pose="percept", **settings)


def test_a_players_memory_is_its_teams_record_of_that_robot() -> None:
    match = sacks()
    staging.memory_of(match, 0)["behaviour"], staging.memory_of(match, 1)["behaviour"] = DRIBBLE, [SHOOT, DRIBBLE]
    assert match.squads[0].memory["behaviour"].tolist() == [[DRIBBLE, SHOOT], [DRIBBLE, DRIBBLE]]
    staging.memory_of(match, 3)["unused"] = 7
    assert match.squads[1].memory["unused"].tolist() == [[0, 7], [0, 7]]
    assert staging.team_settings_of(match, 1) is match.squads[0].team.settings  # type: ignore[attr-defined]


def test_a_match_without_sensors_has_no_settings_of_them_nor_a_robot_from_outside_a_memory() -> None:
    for settings_of in (staging.sensors_of, staging.memory_settings_of):
        with pytest.raises(ValueError, match="nobody in this match uses its sensors"):
            settings_of(sacks(senses="ideal"))
    with pytest.raises(ValueError, match="robot 0 is played from outside"):
        staging.memory_of(Match("legged-2001", home=1, away=1, opponents="still"), 0)


@pytest.mark.parametrize("missed", [0.0, 1.0])
def test_sensors_read_the_settings_that_are_changed(missed: float) -> None:
    match = Match("middle-size-2006", home=1, away=1, matches=2, seed=4, controllers={"home": "chaser"}, pose="percept")
    staging.put(match, 0, 0.0, 0.0)
    staging.put_ball(match, 1.5, 0.0)
    staging.begin_scene(match)
    staging.sensors_of(match)["ball_miss"], staging.sensors_of(match)["false_balls"] = missed, 0.0
    play(match, steps=50)
    assert (match.beliefs["ball"]["confidence"][:, 0] > 0.0).all() == (missed == 0.0)


def test_a_scene_begins_with_robots_that_know_where_they_are_or_not() -> None:
    known, lost = sacks(), sacks()
    for match, placed in ((known, True), (lost, False)):
        staging.put(match, 0, 0.4, -0.3, 1.0)
        staging.begin_scene(match, placed=placed)
    assert np.hypot(known.beliefs["own"]["x"][:, 0] - 0.4, known.beliefs["own"]["y"][:, 0] + 0.3).max() < 0.3
    assert (lost.beliefs["ball"]["confidence"] == 0.0).all()
