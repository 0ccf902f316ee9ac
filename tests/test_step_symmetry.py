"""Left and right, home and away: every stage treats them alike, to the last bits (TRUST 4)."""

from typing import Any

import numpy as np
import pytest
from staging import LEAGUES, scatter, set_phase
from symmetry import assert_same, differences, mirror, turn

from soccer_env import Match
from soccer_env.types import Phase

EXACT, NEARLY = 1e-12, 1e-9
FLIPPED = ("_y", "_vy", "_left", "_turn", "_sin", "pan")  # endings of observations that are odd under the mirror


def pair(league: str, size: int, matches: int = 40, **settings: Any) -> tuple[Match, Match]:
    """Return twice the same matches in play, everybody scattered and walking, nobody near anybody."""
    made = []
    for _ in range(2):
        match = Match(league, home=size, away=size, matches=matches, seed=5, **settings)
        set_phase(match, Phase.PLAY)
        rng = np.random.default_rng(2)
        scatter(match, rng)
        limits = match.league.drive
        for field, top in (("vx", limits.forward), ("vy", limits.forward), ("omega", limits.turn)):
            match.robots[field] = 0.5 * top * rng.uniform(-1.0, 1.0, match.robots.shape)
        match.balls["vx"], match.balls["vy"] = rng.uniform(-1.0, 1.0, (2, matches))
        match.reseat()
        made.append(match)
    return made[0], made[1]


def odd(names: list[str]) -> np.ndarray:
    """Return -1 for the observations that a mirror turns round, 1 for the others."""
    return np.array([-1.0 if name.endswith(FLIPPED) and name not in ("gait_sin", "time_left") else 1.0 for name in names])


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("size", [1, 3])
def test_a_mirrored_match_is_the_mirror_of_the_match_until_bodies_touch(league: str, size: int) -> None:
    match, image = pair(league, size)
    mirror(image)
    rng = np.random.default_rng(0)
    signs = odd(match.observation_names)
    free = np.ones(match.count, bool)
    for _ in range(12):
        actions = rng.uniform(-1.0, 1.0, (match.count, 2 * size, 4))
        match.step(actions)
        image.step(actions * [1.0, -1.0, -1.0, 1.0])
        free &= ~touched(match)
        np.testing.assert_allclose(image.rewards[free], match.rewards[free], atol=EXACT)
        np.testing.assert_allclose(image.observations[free], match.observations[free] * signs, atol=1e-6)
    mirror(image)
    assert free.sum() > match.count / 2
    keep(match, free)
    keep(image, free)
    assert_same(match, image, EXACT)


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("size", [1, 3])
def test_a_turned_match_with_swapped_teams_is_the_same_until_bodies_touch(league: str, size: int) -> None:
    match, image = pair(league, size)
    turn(image)
    rng = np.random.default_rng(0)
    order = np.r_[size : 2 * size, 0:size]
    free = np.ones(match.count, bool)
    for _ in range(12):
        actions = rng.uniform(-1.0, 1.0, (match.count, 2 * size, 4))
        match.step(actions)
        image.step(actions[:, order])
        free &= ~touched(match)
        np.testing.assert_allclose(image.rewards[free][:, order], match.rewards[free], atol=NEARLY)
        np.testing.assert_allclose(image.observations[free][:, order], match.observations[free], atol=1e-6)
    turn(image)
    assert free.sum() > match.count / 2
    keep(match, free)
    keep(image, free)
    image.events["touch_team"] = match.events["touch_team"]
    assert_same(match, image, NEARLY)


def touched(match: Match) -> np.ndarray:
    """Return the matches (M,) in which bodies touched, or in which anything was called."""
    own = match.robot_events["touch"] | match.robot_events["collision"]
    near_board = np.abs(match.balls["y"]) > match.league.pitch.width / 2 - 3 * match.league.ball.radius
    far_x = np.abs(match.balls["x"]) > match.league.pitch.length / 2 - 3 * match.league.ball.radius
    edge = np.abs(match.robots["y"]).max(axis=1) > match.league.pitch.width / 2 - 1.1 * match.league.body.reach
    end = np.abs(match.robots["x"]).max(axis=1) > match.league.pitch.length / 2 - 1.1 * match.league.body.reach
    found: np.ndarray = own.any(axis=1) | near_board | far_x | edge | end
    return found


def keep(match: Match, rows: np.ndarray) -> None:
    """Copy a kept match over all others, so that only kept ones are compared."""
    first = int(np.argmax(rows))
    for name in ("matches", "balls", "robots", "events", "robot_events"):
        records = getattr(match, name)
        records[~rows] = records[first]


@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("change", [mirror, turn])
def test_beliefs_and_tracks_of_an_image_are_images(league: str, change: Any) -> None:
    match, image = pair(league, 3)
    change(image)
    order = np.r_[3:6, 0:3] if change is turn else np.arange(6)
    belief, seen = match.beliefs.copy(), image.beliefs[:, order].copy()
    track, tracked = match.tracks.copy(), image.tracks[:, order].copy()
    if change is mirror:
        for part, names in (("own", ("y", "heading", "left", "turn")),
                            ("ball", ("y", "vy", "bearing", "filtered_bearing", "angular"))):  # fmt: skip
            for name in names:
                seen[part][name] *= -1.0
        for name in ("y", "vy", "bearing", "heading"):
            tracked[name] *= -1.0
    tolerance = EXACT if change is mirror else NEARLY
    assert max(differences(belief, seen).values()) <= tolerance * 100  # bearings near a ball amplify the last bit
    assert max(differences(track, tracked).values()) <= tolerance * 100


OUT = [
    (1, 0.3, 1.02),
    (1, -0.4, -1.02),
    (1, 1.02, 0.7),
    (0, 1.02, -0.7),
    (0, -1.02, 0.6),
    (1, -1.02, -0.9),
    (0, 1.02, 0.05),
]


@pytest.mark.parametrize("change", [mirror, turn])
@pytest.mark.parametrize("league", LEAGUES)
@pytest.mark.parametrize("half", [0, 1])
def test_calls_and_restarts_of_an_image_are_images(league: str, change: Any, half: int) -> None:
    match, image = pair(league, 3, matches=len(OUT))
    pitch = match.league.pitch
    for made in (match, image):
        made.matches["half"], made.matches["home_direction"] = half, 1 - 2 * half
        made.robots["vx"] = made.robots["vy"] = made.robots["omega"] = 0.0
        last, x, y = np.transpose(OUT)
        made.matches["last_touch_team"] = last
        made.matches["last_touch_robot"] = 3 * last
        made.balls["x"] = np.where(np.abs(x) > 1, np.sign(x) * (pitch.length / 2 + 1.2 * made.league.ball.radius), x)
        made.balls["y"] = np.where(np.abs(y) > 1, np.sign(y) * (pitch.width / 2 + 1.2 * made.league.ball.radius), y)
        made.balls["y"] = np.where(np.abs(x) > 1, y * pitch.goal_width, made.balls["y"])
        made.balls["vx"] = made.balls["vy"] = 0.0
        made.reseat()
    change(image)
    if pitch.walled:  # the ball can only be out in a goal there
        for made in (match, image):
            made.balls["y"][np.abs(made.balls["x"]) < pitch.length / 2] *= 0.5
            made.balls["y"][np.abs(made.balls["x"]) > pitch.length / 2] *= 0.2
            made.reseat()
    match.step(np.zeros((match.count, 6, 4)))
    image.step(np.zeros((match.count, 6, 4)))
    assert match.events["restart"].any()
    np.testing.assert_array_equal(match.events["restart"], image.events["restart"])
    scorer = image.events["goal"]
    if change is turn:
        scorer = np.where(scorer >= 0, 1 - scorer, -1)
    np.testing.assert_array_equal(match.events["goal"], scorer)
    change(image)
    for field in ("x", "y", "heading"):
        gap = differences(match.robots[[field]], image.robots[[field]])[field]
        assert gap <= NEARLY, field
    for field in ("x", "y", "vx", "vy"):
        np.testing.assert_allclose(image.balls[field], match.balls[field], atol=NEARLY)


@pytest.mark.parametrize("league", LEAGUES)
def test_a_team_against_itself_is_as_good_at_home_as_away(league: str) -> None:
    matches, minutes = (400, 0.5) if league == "middle-size-2006" else (400, 2.0)
    match = Match(league, home=2, away=2, matches=matches, threads=2, seed=3, minutes=minutes,
                  controllers={"home": "chaser", "away": "chaser"})  # fmt: skip
    while not match.terminated.all():
        match.step()
    gap = match.matches["score"][:, 0] - match.matches["score"][:, 1]
    assert np.abs(gap).sum() > 20, "too few goals to tell"
    assert abs(gap.mean()) < 2.6 * gap.std() / np.sqrt(matches)  # 99 %
