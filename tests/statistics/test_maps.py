"""Where players are and how they move, the map of shots and the matrix of passes."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from soccer_env.random_numbers import seeds_for
from soccer_env.statistics.maps import BALL, maps_of_team, sum_maps
from soccer_env.statistics.players import MAKES, STUCK, WANTS
from soccer_env.statistics.records import CELLS_LONG, CELLS_WIDE, LOOK, SHOTS
from soccer_env.types import AWAY, HOME, Phase
from tests.statistics.counted_steps import KEEPER, KICKER, MATE, SECOND, THEIR_KEEPER, THEIR_PLAYER, Steps, shoot
from tests.statistics.recorded_play import MINUTES, Recording, chasers, recording_of, running

ROWS = (3, 3)


def shots(steps: Steps, team: int = HOME) -> list[Any]:
    return maps_of_team(steps.tally[0], team, ROWS)["shots_for"]


@pytest.mark.parametrize("direction", [1.0, -1.0])
def test_a_shot_is_noted_where_the_ball_was_played(direction: float) -> None:
    steps = Steps(direction=direction)
    shoot(steps, x=1.0, y=direction * 0.1)
    assert shots(steps) == [[1, KICKER, "off_target", 1.0, 0.1]] and shots(steps, AWAY) == []
    assert maps_of_team(steps.tally[0], AWAY, ROWS)["shots_against"] == shots(steps)


@pytest.mark.parametrize(("y", "touches", "outcome"), [
    (0.0, [], "off_target"), (0.4, [], "off_target"), (0.0, [THEIR_KEEPER], "saved"), (0.0, [THEIR_PLAYER], "blocked"),
    (0.0, [MATE], "blocked"), (0.4, [THEIR_KEEPER], "blocked"), (0.0, [THEIR_PLAYER, THEIR_KEEPER], "blocked"),
    (0.0, [THEIR_KEEPER, THEIR_PLAYER], "saved"), (0.0, [KEEPER], "blocked"),
])  # fmt: skip
def test_who_touches_a_shot_first_saves_or_blocks_it(steps: Steps, y: float, touches: list[int], outcome: str) -> None:
    shoot(steps, y=y)
    for row in touches:
        steps.count(touch=row)
    steps.count(steps=6 * SECOND)
    assert [shot[2] for shot in shots(steps)] == [outcome]
    assert steps.of("saves") == [0, int(outcome == "saved")]


def test_a_kick_that_is_in_before_it_could_be_judged_is_on_the_map_and_a_goal_after_a_shot_does_not_change_it() -> None:
    """It would not have rolled there, the physics says otherwise: the shot that `shots` counts has a place too."""
    steps, later = Steps(), Steps()
    shoot(steps, x=1.4, vx=0.3)
    assert shots(steps) == []
    steps.score(HOME)
    assert shots(steps) == [[2, KICKER, "goal", 1.4, 0.0]] and steps.of("shots") == [1, 0]
    shoot(later)
    later.count(touch=THEIR_KEEPER)
    later.count(steps=6 * SECOND)
    later.count(touch=THEIR_PLAYER)
    later.score(HOME)
    assert [shot[2] for shot in shots(later)] == ["saved"]


def test_shots_beyond_the_first_64_are_counted_only_and_passes_noted_from_player_to_player(steps: Steps) -> None:
    for _ in range(SHOTS + 3):
        shoot(steps)
        steps.count(touch=THEIR_KEEPER)
        steps.count(steps=6 * SECOND, restart=Phase.DROP_BALL)
    assert steps.of("shots") == [SHOTS + 3, 0]
    assert [shot[2] for shot in shots(steps)] == ["saved"] * SHOTS
    for sender, receiver in ((KICKER, MATE), (MATE, KICKER), (KICKER, THEIR_PLAYER), (THEIR_PLAYER, THEIR_KEEPER)):
        steps.ball(0.0, 0.0)
        steps.count(touch=sender)
        steps.count(steps=SECOND)
        steps.ball(0.5, 0.0)
        steps.count(touch=receiver)
        steps.count(restart=Phase.DROP_BALL)
    found = maps_of_team(steps.tally[0], HOME, ROWS)
    assert found["passes_for"] == [[0, 0, 0], [0, 0, 1], [0, 1, 0]]
    assert found["passes_against"] == [[0, 0, 0], [1, 0, 0], [0, 0, 0]]
    assert [steps.of(name) for name in ("passes", "interceptions")] == [[2, 1], [0, 1]]


@pytest.fixture(scope="module", params=["legged-2001", "middle-size-2006"])
def played(request: pytest.FixtureRequest) -> tuple[Match, Recording, np.ndarray]:
    """Return finished matches with their recording, and who was put somewhere in each step (T, M, R)."""
    match = chasers(request.param, seeds=seeds_for(5, 3).tolist())
    moments, placed = [], []
    for moment in running(match):
        moments.append(moment)
        placed.append(match.robots["placed"].copy())
    return match, recording_of(match, moments), np.stack(placed)


def test_maps_and_counts_tell_the_same(played: Any) -> None:
    match = played[0]
    look = LOOK * match.league.dt
    for record in match.statistics:
        mine, theirs = (maps_of_team(record, team, match.settings.rows) for team in (HOME, AWAY))
        assert np.sum(mine["heat_ball"]) == pytest.approx(record["in_play"] / look, rel=0.05)
        assert mine["heat_ball"] == np.array(theirs["heat_ball"])[::-1, ::-1].tolist()
        for team, side in ((HOME, "for"), (AWAY, "against")):
            other = "against" if side == "for" else "for"
            assert all(mine[f"{name}_{side}"] == theirs[f"{name}_{other}"] for name in ("heat", "passes", "shots"))
            assert np.sum(mine[f"heat_{side}"]) == pytest.approx(record["present"][team] / look, rel=0.05)
            assert np.sum(mine[f"heat_{side}"]) == pytest.approx(np.sum(mine[f"players_{side}"], axis=0)[2] / look)
            assert np.sum(mine[f"passes_{side}"]) == record["passes"][team]
            outcomes = [shot[2] for shot in mine[f"shots_{side}"]]
            assert len(outcomes) == record["shots"][team]
            assert outcomes.count("saved") == record["saves"][1 - team]
    total = sum_maps([maps_of_team(record, HOME, match.settings.rows) for record in match.statistics])
    assert np.sum(total["heat_ball"]) == match.statistics["maps"]["heat"][:, 2].sum()
    assert len(total["shots_for"]) == match.statistics["shots"][:, HOME].sum()


@pytest.mark.parametrize("name", [*MINUTES])
def test_a_match_among_others_has_the_maps_that_it_has_alone(name: str) -> None:
    seeds = seeds_for(8, 4).tolist()
    together, alone = chasers(name, seeds=seeds, minutes=0.5), chasers(name, seeds=seeds[2:3], minutes=0.5)
    for match in (together, alone):
        while not match.terminated.all():
            match.step()
    assert together.statistics[2].tobytes() == alone.statistics[0].tobytes()


each_direction = pytest.mark.parametrize("direction", [1.0, -1.0])
TOP = find_league("legged-2001").drive.forward  # [m/s]
LONG, PAUSE = 24, 8  # steps: 1.5 s and half a second, of 16 a second


def walk(steps: Steps, count: int, pace: float = 0.01) -> None:
    """Let home's player go on by a pace [m] before each of some steps."""
    for _ in range(count):
        steps.match.robots["x"][0, KICKER] += 0.6 * pace
        steps.match.robots["y"][0, KICKER] += 0.8 * pace
        steps.count()


def aim(steps: Steps, wanted: float, made: float) -> None:
    """Let home's player aim at a speed and make another [m/s]; all others want nothing."""
    for name in ("forward", "left"):
        steps.match.robots["target"][name] = 0.0
    steps.match.robots["target"]["forward"][0, KICKER] = wanted
    steps.set(KICKER, vx=0.0, vy=made)


def test_distance_is_the_way_from_step_to_step(steps: Steps) -> None:
    steps.set(KICKER, placed=0)
    steps.count()
    walk(steps, 10)
    assert steps.of("distance") == pytest.approx([0.1, 0.0])


def test_nobody_covers_a_distance_as_he_is_put_somewhere_or_while_the_ball_is_out_of_play(steps: Steps) -> None:
    steps.count()
    steps.set(KICKER, placed=1)
    walk(steps, 1, 0.5)
    steps.set(KICKER, placed=0)
    steps.match.matches["phase"] = Phase.THROW_IN
    walk(steps, 3, 0.5)
    steps.match.matches["phase"] = Phase.PLAY
    walk(steps, 1, 0.5)
    assert steps.of("distance") == [0.0, 0.0]
    walk(steps, 1, 0.5)
    assert steps.of("distance") == pytest.approx([0.5, 0.0])


def test_a_robot_that_is_sent_off_covers_nothing_and_is_not_present(steps: Steps) -> None:
    steps.count()
    steps.set(KICKER, active=0)
    walk(steps, SECOND)
    steps.set(KICKER, active=1)
    walk(steps, 1)
    assert steps.of("distance") == [0.0, 0.0]
    assert steps.of("present") == pytest.approx([2 * 18 / SECOND + 2 / SECOND, 3 * 18 / SECOND])


@pytest.mark.parametrize(("count", "seconds"), [(LONG - 1, 0.0), (LONG, STUCK), (LONG + 5, STUCK + 5 / SECOND)])
def test_who_is_stopped_for_long_is_stuck_from_the_first_moment(steps: Steps, count: int, seconds: float) -> None:
    aim(steps, TOP, 0.0)
    steps.count(steps=count)
    assert steps.of("stuck") == pytest.approx([seconds, 0.0])


@pytest.mark.parametrize(("pause", "seconds"), [(PAUSE, (20 + PAUSE + 10) / SECOND), (PAUSE + 1, 0.0)])
def test_a_short_break_does_not_end_it(steps: Steps, pause: int, seconds: float) -> None:
    aim(steps, TOP, 0.0)
    steps.count(steps=20)
    aim(steps, TOP, TOP)
    steps.count(steps=pause)
    aim(steps, TOP, 0.0)
    steps.count(steps=10)
    assert steps.of("stuck") == pytest.approx([seconds, 0.0])


@pytest.mark.parametrize(("wanted", "made", "stuck"), [
    (WANTS * TOP * 1.01, 0.0, True), (WANTS * TOP * 0.99, 0.0, False), (TOP, MAKES * TOP * 0.99, True),
    (TOP, MAKES * TOP * 1.01, False),
])  # fmt: skip
def test_who_wants_little_or_gets_on_is_not_stuck(steps: Steps, wanted: float, made: float, stuck: bool) -> None:
    aim(steps, wanted, made)
    steps.count(steps=2 * LONG)
    assert (steps.of("stuck")[HOME] > 0.0) == stuck


@pytest.mark.parametrize("field", ["kick_clock", "fallen"])
def test_who_winds_up_a_kick_or_lies_on_the_ground_is_not_stuck(steps: Steps, field: str) -> None:
    aim(steps, TOP, 0.0)
    steps.set(KICKER, **{field: 1.0})
    steps.count(steps=2 * LONG)
    assert steps.of("stuck") == [0.0, 0.0]


@each_direction
@pytest.mark.parametrize(("x", "y", "column", "row"), [
    (-1.49, -0.99, 0, 0), (1.49, 0.99, CELLS_LONG - 1, CELLS_WIDE - 1), (0.01, 0.01, CELLS_LONG // 2, CELLS_WIDE // 2),
    (-0.01, -0.01, CELLS_LONG // 2 - 1, CELLS_WIDE // 2 - 1), (1.6, -1.2, CELLS_LONG - 1, 0),
])  # fmt: skip
def test_the_heat_map_is_that_of_a_team_that_attacks_to_the_right(direction, x, y, column, row) -> None:
    """A ball that is beyond a line counts in the cell at the line."""
    steps = Steps(direction=direction)
    steps.ball(x, direction * y)
    steps.count(steps=3 * LOOK)
    heat = steps.tally["maps"]["heat"][0]
    assert heat[BALL].sum() == heat[BALL, row, column] == 3
    assert heat[:BALL].sum(axis=(1, 2)).tolist() == [9, 9]
    steps.match.matches["phase"] = Phase.CORNER_KICK
    steps.count(steps=3 * LOOK)
    assert heat[BALL].sum() == 3, "it rests while the ball is out of play"


def test_the_mean_place_of_a_player_is_that_in_play() -> None:
    steps = Steps(direction=-1.0)
    steps.put(KICKER, 1.0, 0.25)
    steps.count(steps=SECOND)
    steps.put(KICKER, 0.0, 0.25)
    steps.count(steps=SECOND)
    maps = steps.tally["maps"][0]
    x, y, seconds = maps["places"][KICKER]
    assert seconds == 2.0
    assert np.array([x, y]) / seconds == pytest.approx([0.5, -0.25])
