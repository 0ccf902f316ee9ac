"""The goalkeeper of sacks-2001: where it stands, steps to, and when it blocks."""

from typing import Any

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.memory import GUARD
from soccer_env.leagues import find_league
from tests.scenes.sacks_mind import FORWARD, KICK, LEAGUE, LEFT, Mind

BLOCKING = find_league("legged-2001-block")


def keeper(**settings: Any) -> Mind:
    """Return a goalkeeper before whom a shot comes straight ahead, its bearing growing: it will pass on the left."""
    mind = Mind(**settings)
    mind.belief["situation"]["keeper"] = 1
    mind.stand_at(-1.3, 0.0)
    mind.see_ball(1.0, radial=-0.8)
    mind.belief["ball"]["angular"] = 0.2
    return mind


def test_ms53_the_goalkeeper_steps_to_where_the_ball_will_pass() -> None:
    mind, bearing = keeper(), keeper(angular_keeper=False)
    assert mind.think()[-1, LEFT] > 0.5 and bearing.think()[-1, LEFT] == 0.0
    assert mind.memory["behaviour"] == bearing.memory["behaviour"] == GUARD


def shot_at(distance: float, aside: float, speed: float = 0.6, **settings: Any) -> bool:
    """Tell whether a goalkeeper asks for a block for a ball that comes and will pass so far to its left [m]."""
    mind = keeper(**{"keeper_blocks": True, "keeper_speed": True, **settings})
    mind.league = BLOCKING
    mind.see_ball(distance)
    across, ball = aside * speed / distance, mind.belief["ball"]
    ball["vx"], ball["angular"], ball["radial"] = -speed, across / distance, -np.sqrt(speed**2 - across**2)
    return bool(mind.think()[-1, KICK] > 0.0)


def test_ms53_the_goalkeeper_blocks_what_passes_within_the_reach_of_its_legs() -> None:
    """MS53: where the ball will pass follows from its angular velocity; without it the bearing says that it comes."""
    reach = BLOCKING.block.paw_y + BLOCKING.body.tip_radius + BLOCKING.ball.radius
    for side in (1.0, -1.0):
        assert shot_at(0.5, side * (reach - 0.01)) and not shot_at(0.5, side * (reach + 0.01))
        assert shot_at(0.5, side * (reach + 0.01), angular_keeper=False)
    assert not shot_at(0.5, 0.0, keeper_blocks=False)
    mind = keeper(keeper_blocks=True)  # in a league without a block
    mind.see_ball(0.4, radial=-0.8)
    assert mind.think()[-1, KICK] == 0.0


def test_ms53_the_goalkeeper_blocks_so_that_the_ball_comes_while_its_legs_are_spread() -> None:
    """MS53: by the time in which it comes; by its distance alone where reactions do not depend on its speed."""
    block = BLOCKING.block
    time = block.raise_time + 0.5 * block.hold_time
    for speed in (0.65, 0.95):
        far = block.paw_x + speed * time
        assert shot_at(far - 0.01, 0.0, speed) and not shot_at(far + 0.01, 0.0, speed)
    assert shot_at(block.paw_x + 0.59 * time, 0.0, 0.4, keeper_speed=False)
    assert not shot_at(block.paw_x + 0.61 * time, 0.0, 0.9, keeper_speed=False)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_ms53_the_goalkeeper_stands_on_the_line_from_its_goal_to_the_ball(side: float) -> None:
    goal, ball, heading = complex(-LEAGUE.pitch.length / 2.0, 0.0), complex(0.0, 0.9 * side), 0.3 * side
    out = (ball - goal) / abs(ball - goal)
    for turned_by, walks in ((out, 0.0), (out.conjugate(), -side)):  # at its place; at the mirrored one
        mind = Mind()
        mind.belief["situation"]["keeper"] = 1
        place = goal + float(mind.team.settings["keeper_out"][0]) * turned_by  # type: ignore[attr-defined]
        mind.stand_at(place.real, place.imag, heading)
        seen = (ball - place) * np.exp(-1j * heading)
        mind.see_ball(abs(seen), float(np.angle(seen)))
        command = mind.think()[-1]
        walk = complex(command[FORWARD], command[LEFT]) * np.exp(1j * heading)
        assert mind.memory["behaviour"] == GUARD
        assert np.sign(walk.imag.round(9)) == -walks and (walks != 0.0 or abs(walk) < 1e-9)
