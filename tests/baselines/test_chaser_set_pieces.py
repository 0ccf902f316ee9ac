"""The chaser's floor at strength 1 with ideal senses, never to be weakened; and how it takes restarts, by a pass."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.baselines.chaser.team import MEMORY, team
from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.match.staging import begin_scene, put_ball
from soccer_env.records.beliefs import BELIEF
from soccer_env.skills import set_pieces
from soccer_env.skills.moves import KEPT_OFF, brake_before_robots
from soccer_env.skills.set_pieces import KEPT, PASSES_BY, note_set_piece, should_block_opponent, waypoint_round_ball
from soccer_env.skills.sight import SIGHT
from soccer_env.types import Foul, Phase
from tests.scenes.staging import MIDDLE, endless, place

LEAGUE = find_league(MIDDLE)
K = constants_of(LEAGUE)[0]


@pytest.mark.parametrize(("far", "arrival"), [(1.0, 0.0), (2.0, 0.8), (4.0, 3.0)])
def test_a_kick_of_that_strength_rolls_past_the_distance_at_the_speed(far, arrival):
    match = Match(endless(MIDDLE), home=1, away=1, seed=1)
    speed = set_pieces.kick_strength_for(K, far, arrival) * LEAGUE.kicker.fastest
    match.matches["phase"] = Phase.PLAY
    place(match, ball=(0.0, 0.0, speed, 0.0, False), robots={0: (-50.0, 0.0), 1: (50.0, 0.0)})
    slide = (speed**2 - (0.6 * speed) ** 2) / (2.0 * LEAGUE.ball.sliding)  # [m] on which it slides
    left = 0.0
    for _ in range(1000):
        match.step(np.zeros((1, 2, 4)))
        if match.balls["x"][0] - slide <= far:
            left = match.balls["vx"][0]
    assert left == pytest.approx(arrival, abs=0.1)


class Player:
    """What a player sees and remembers at a restart of its own team."""

    def __init__(self, rank: int = 0, phase: Phase = Phase.THROW_IN, ours: float = 1.0) -> None:
        self.belief, self.sight, self.memory = (np.zeros(1, dtype)[0] for dtype in (BELIEF, SIGHT, MEMORY))
        self.memory["rank"], self.sight["touch"], self.sight["elapsed"] = rank, 0.29, 0.02
        self.sight["distance"] = 0.5
        self.note(phase, ours)

    def note(self, phase: Phase = Phase.PLAY, ours: float = 0.0) -> float:
        """Return what the player remembers of the restart, a step later."""
        self.belief["situation"]["phase"], self.belief["situation"]["ours"] = phase, ours
        note_set_piece(self.belief["situation"], self.sight, self.memory, K)
        return float(self.memory["set_piece"])


def test_the_nearest_player_is_the_taker_and_leaves_the_ball_until_somebody_else_has_it():
    assert Player(0).memory["set_piece"] == KEPT and Player(1).memory["set_piece"] == -KEPT
    assert Player(0, ours=-1.0).memory["set_piece"] == 0.0
    player = Player()
    assert player.note() == pytest.approx(KEPT - 0.02)
    player.sight["others"], player.sight["other_x"][0] = 1, 0.5
    assert player.note() > 0.0
    player.sight["other_x"][0] = 0.4
    assert player.note() == 0.0


def test_it_forgets_in_time_and_at_once_at_a_penalty_kick_and_a_mate_that_comes_to_the_ball_may_play_on():
    player, mate = Player(), Player(1)
    for _ in range(int(KEPT / 0.02) + 1):
        player.note()
    assert player.memory["set_piece"] == Player(phase=Phase.PENALTY_KICK).memory["set_piece"] == 0.0
    assert mate.note() < 0.0
    mate.sight["distance"] = 0.4
    assert mate.note() == 0.0


@pytest.mark.parametrize(("x", "y", "place"), [(-5.0, 1.0, -4.21), (-4.0, 1.0, -4.0), (-5.0, 3.0, -5.0)])
def test_supporters_stay_out_of_their_own_penalty_area(x, y, place):
    found_x, found_y = set_pieces.move_out_of_area(np.zeros(1, SIGHT)[0], K, x, y, 0.0)
    assert found_x == pytest.approx(place, abs=0.01) and found_y == y


def sees(x: float, y: float, mate: int = 0, field: int = 1) -> np.void:
    """Return what a player at the centre spot sees of one other robot, the ball far away."""
    sight = np.zeros(1, SIGHT)[0]
    sight["others"], sight["mate"][0], sight["field"][0] = 1, mate, field
    sight["other_x"][0], sight["other_y"][0] = x, y
    sight["ball_x"], sight["distance"] = 3.0, 3.0
    return sight


@pytest.mark.parametrize("gap", [0.02, 0.2, 0.5])
def test_it_drives_at_another_robot_only_as_fast_as_it_can_brake(gap):
    sight, play = sees(2.0 * K["body_reach"] + KEPT_OFF + gap, 0.0), team().settings[int(K["drive_kind"])]
    x, y, speed = brake_before_robots(sight, K, play, 1.0, 0.0, 2.6, False)
    assert (x, y) == pytest.approx((1.0, 0.0)) and speed == pytest.approx(min(gap / 0.25, np.sqrt(5.6 * gap)))
    assert brake_before_robots(sight, K, play, 0.0, 1.0, 2.6, False) == (0.0, 1.0, 2.6)
    assert brake_before_robots(sight, K, play, -1.0, 0.0, 2.6, False) == (-1.0, 0.0, 2.6)


@pytest.mark.parametrize(("fights", "field", "held_back"), [(True, 1, False), (False, 1, True), (True, 0, True)])
def test_who_fights_for_the_ball_may_drive_at_who_has_it_but_not_at_a_goalkeeper(fights, field, held_back):
    sight, play = sees(0.6, 0.0, field=field), team().settings[int(K["drive_kind"])]
    sight["ball_x"] = 0.3
    assert (brake_before_robots(sight, K, play, 1.0, 0.0, 2.6, fights)[2] < 2.6) == held_back


@pytest.mark.parametrize(("away", "mate", "ball_x", "holds"), [
    (0.44, 0, 0.0, True), (0.46, 0, 0.0, False), (0.44, 1, 0.0, False), (0.44, 0, -3.1, False),
])  # fmt: skip
def test_it_stands_in_the_way_of_an_opponent_that_has_the_ball_but_not_before_its_own_goal(away, mate, ball_x, holds):
    sight = sees(ball_x, away, mate)
    sight["ball_x"], sight["distance"] = ball_x, 1.0
    assert should_block_opponent(sight, K) == holds
    sight["distance"] = away + 0.09  # as near itself
    assert not should_block_opponent(sight, K)


def test_it_takes_a_throw_in_without_a_foul_and_a_mate_plays_on():
    match = Match(MIDDLE, home=3, away=3, seed=2, controllers={"home": "chaser", "away": "still"}, senses="ideal")
    match.matches["phase"], match.matches["restart_team"] = Phase.PLAY, -1
    match.matches["last_touch_team"] = 1
    put_ball(match, 1.0, 4.2)
    begin_scene(match)
    taken, takers, touched, fouls = [], set(), set(), []
    for _ in range(400):
        match.step()
        taken.append(int(match.events["in_play"][0]))
        takers |= {int(match.matches["taker"][0])} if taken[-1] else set()
        if sum(taken):
            touched |= set(np.flatnonzero(match.robot_events["touch"][0]).tolist())
        fouls.append(int(match.events["foul"][0]))
    assert sum(taken) >= 1 and taken.index(1) < 250 and touched - takers
    assert Foul.SECOND_TOUCH not in fouls


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_supporter_that_runs_back_goes_round_the_ball_on_its_nearer_side(side):
    sight = np.zeros(1, SIGHT)[0]
    sight["ball_x"], sight["ball_y"] = -1.0, 0.1 * side
    x, y = waypoint_round_ball(sight, K, -3.0, 0.0)
    room = LEAGUE.body.reach + LEAGUE.ball.radius + PASSES_BY
    assert x == pytest.approx(-1.0) and y == pytest.approx((0.1 - room) * side)


@pytest.mark.parametrize(("ball_x", "ball_y"), [(1.0, 0.0), (-4.0, 0.0), (-1.0, 0.6), (-1.0, -0.6)])
def test_a_ball_that_is_not_in_its_way_does_not_turn_it_aside(ball_x, ball_y):
    sight = np.zeros(1, SIGHT)[0]
    sight["ball_x"], sight["ball_y"] = ball_x, ball_y
    assert waypoint_round_ball(sight, K, -3.0, 0.0) == (-3.0, 0.0)


def finish(match: Match) -> Match:
    """Play matches to their end."""
    while not (match.terminated | match.truncated).all():
        match.step()
    match.close()
    return match


def score(league: str, home: str, away: str, matches: int, minutes: float, seed: int = 11,
          placement: str = "instant") -> np.ndarray:  # fmt: skip
    """Return the scores (M, 2) of 3 v 3 matches; in half of them the first team starts as away."""
    scores = []
    for swapped in (False, True):
        teams = {"home": away, "away": home} if swapped else {"home": home, "away": away}
        match = Match(
            league, home=3, away=3, matches=matches // 2, threads=2, seed=seed, minutes=minutes, controllers=teams,
            placement=placement, senses="ideal",
        )  # fmt: skip
        scores.append(finish(match).matches["score"][:, :: -1 if swapped else 1])
    return np.concatenate(scores)


def points(scores: np.ndarray) -> float:
    """Return the share of points of the first team; a draw is half."""
    ours, theirs = scores.T
    return float(((ours > theirs) + 0.5 * (ours == theirs)).mean())


def drill(league: str, scene: str, home: str, away: str, matches: int) -> float:
    """Return the share of drills that succeed."""
    match = Match(
        league, home=3, away=3, matches=matches, threads=2, seed=3, scene=scene, episode="drill",
        controllers={"home": home, "away": away}, senses="ideal",
    )  # fmt: skip
    succeeded = np.zeros(matches, bool)
    while not (match.terminated | match.truncated).all():
        match.step()
        succeeded |= match.events["drill"] == 1
    match.close()
    return float(succeeded.mean())


@pytest.mark.parametrize(("league", "minutes"), [("legged-2001", 5.0), ("middle-size-2006", 2.0)])
def test_it_beats_random_players_and_without_strength_loses_to_itself(league: str, minutes: float) -> None:
    assert points(score(league, "chaser", "random", 20, minutes)) >= 0.95
    placement = find_league(league).evaluation_placement
    assert points(score(league, "chaser@0", "chaser", 60, minutes, 1, placement)) < 0.42
