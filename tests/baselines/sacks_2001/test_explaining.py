"""What sacks-2001 shows people of its potential field is the force that it would dribble by, wherever it stood."""

from math import cos, pi, sin

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.explaining import forces, plan
from soccer_env.baselines.sacks_2001.memory import APPROACH, DRIBBLE
from soccer_env.leagues.constants import constants_of
from soccer_env.teams import DecisionInputs as Shown
from tests.scenes.sacks_mind import LEAGUE, Mind

HEADING = 0.4  # [rad]
PLAYER, RANGED = (0.9, 0.35), (0.5, -0.4)  # [m] in the team frame
PLACES = [(0.1, 0.2), (0.45, -0.1), (0.7, 0.1), (0.2, 0.8), (0.1, -0.85)]


def standing(x: float, y: float) -> Mind:
    """Return a mind that believes to stand there, a player and the ranger's obstacle at their places."""
    mind = Mind()
    mind.stand_at(x, y, HEADING)
    ahead = [np.array([[cos(HEADING), sin(HEADING)], [-sin(HEADING), cos(HEADING)]]) @ (np.array(p) - (x, y))
             for p in (PLAYER, RANGED)]  # fmt: skip
    track, obstacle = mind.tracks[0, 0, 2], mind.belief["obstacle"]
    track["present"], track["age"], (track["x"], track["y"]) = 1, 0.0, ahead[0]
    obstacle["distance"], obstacle["bearing"] = np.hypot(*ahead[1]), np.arctan2(*ahead[1][::-1])
    return mind


def shown(mind: Mind) -> Shown:
    """Return a mind as people are shown it."""
    noise = np.zeros((1, 1), np.uint64)
    return Shown(mind.beliefs[0], mind.tracks[0], mind._memory[0], noise, constants_of(LEAGUE), mind.team.settings)


def field(mind: Mind, *points: tuple[float, float]) -> np.ndarray:
    """Return the force (P, 2) that is shown at points."""
    return forces(shown(mind), np.zeros(2), np.array(points))


def test_the_field_at_a_place_is_the_force_on_who_stands_there() -> None:
    drawn = field(standing(*PLACES[0]), *PLACES)
    for place, force in zip(PLACES, drawn, strict=True):
        np.testing.assert_allclose(force, field(standing(*place), place)[0], atol=1e-5)  # of single precision


@pytest.mark.parametrize("way", [0.0, pi / 3.0])
def test_the_way_leads_to_the_ball_or_half_a_metre_along_the_dribble(way: float) -> None:
    mind = standing(0.2, -0.1)
    mind.see_ball(0.6, 0.3)
    mind.memory["behaviour"] = APPROACH
    place, end = plan(shown(mind))
    assert place == pytest.approx([0.2, -0.1])
    assert end - place == pytest.approx([0.6 * cos(HEADING + 0.3), 0.6 * sin(HEADING + 0.3)])
    mind.memory["behaviour"], mind.memory["way"] = DRIBBLE, way
    place, end = plan(shown(mind))
    assert end - place == pytest.approx([0.5 * cos(way), 0.5 * sin(way)])
    mind.memory["behaviour"] = 0
    assert plan(shown(mind)).shape == (0, 2)
