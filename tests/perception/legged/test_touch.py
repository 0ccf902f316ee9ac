"""What the touch sensors of a legged robot feel: at head, chin, back and feet, and nowhere else."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.scenes.staging import LEGGED, place, play, robot_actions, stage, stand

SWITCHES = ("head", "chin", "back", "feet")


def feeling(**settings: object) -> Match:
    """Return a match of two legged robots far apart, the ball in the pocket of robot 0."""
    league = find_league(LEGGED)
    pocket = (league.body.front + league.ball.radius, 0.0)
    return stage(LEGGED, ball=pocket, robots={0: (0.0, 0.0), 1: (1.0, 0.5)}, observe="percepts", **settings)


def felt(match: Match, r: int = 0) -> tuple[int, ...]:
    """Return what the switches of robot r say."""
    return tuple(int(match.percepts["touch"][name][0, r]) for name in SWITCHES)


def test_ms06_a_collision_presses_no_touch_sensor() -> None:
    """MS06: who runs into another robot, and who has the ball between its paws, feel no more than one alone."""
    match = feeling()
    place(match, robots={1: (-0.4, 0.0)})
    actions = robot_actions(match, 1, forward=1.0)
    collided, touched, pressed = False, False, set()
    for _ in range(64):
        match.step(actions)
        collided |= bool(match.robot_events["collision"].all())
        touched |= bool(match.robot_events["touch"].any())
        pressed |= {felt(match, r)[:3] for r in (0, 1)}
    assert collided and touched and pressed == {(0, 0, 0)}


def test_ms06_paws_feel_the_ground_and_not_what_stands_before_them() -> None:
    """MS06: all four of a robot that stands, two of one that trots, none of one that has fallen."""
    match = feeling()
    match.step(stand(match))
    assert felt(match)[3] == 4
    play(match, actions=robot_actions(match, forward=1.0), steps=12)
    assert felt(match)[3] == 2
    match.robots["fallen"][0, 0] = 1.0
    match.step(stand(match))
    assert felt(match)[3] == 0


def test_ms06_who_puts_a_robot_down_starts_it_by_its_back() -> None:
    """MS06: pressed in the one frame in which the robot is told where it stands."""
    match = Match(LEGGED, observe="percepts", seed=1)
    match.reset(seeds=[1])
    assert (match.percepts["touch"]["back"] == 1).all()
    match.step(stand(match))
    assert not match.percepts["touch"]["back"].any()


@pytest.mark.parametrize(("neck", "pressed"), [(0.155, False), (0.07, True)])
def test_ms06_a_ball_presses_the_chin_if_the_neck_lets_it_down(neck: float, pressed: bool) -> None:
    """MS06: the mouth of an ERS-210 stays above a ball on the ground; that of one that crouches would not."""
    match = feeling(sensors={"neck_height": neck})
    chin = []
    for tilt in np.linspace(0.0, match.league.head.tilt_low, 12):
        match.robots["tilt"][0, 0] = match.robots["gaze"]["tilt"][0, 0] = tilt
        match.step(stand(match))
        chin.append(felt(match)[1])
    assert any(chin) == pressed


def test_ms06_they_are_percepts_and_nothing_else_tells_of_contacts() -> None:
    """MS06: observe="percepts" has the four of them, and no entry for the outline."""
    match = feeling()
    names = [name for name in match.observation_names if "touch" in name or "collision" in name]
    assert names == [f"touch_{name}" for name in SWITCHES]
    match.step(stand(match))
    assert match.observations[0, 0, match.observation_names.index("touch_feet")] == 1.0
