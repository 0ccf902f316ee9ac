"""Stages of a run: as written, over by goals or by decisions, with the networks of the stage before."""

from pathlib import Path

import pytest

from soccer_env.train.ppo.match_blocks import Result
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.stages import DOUBT, Stage, StageClock, parse_stages
from tests.train.ppo.staged_training import records, tiny_settings, train_plainly


def episodes(sizes: tuple[int, int], scored: int, conceded: int, count: int = 1) -> list[Result]:
    return [Result(sizes, "still", scored, conceded)] * count


def test_a_list_of_one_stage_holds_for_all() -> None:
    still, both = ("still",), ("still", "chaser:a=1,b=2")
    assert parse_stages("1v1;1v1,2v2", "still") == (Stage(((1, 1),), still), Stage(((1, 1), (2, 2)), still))
    assert parse_stages("2", "still;still,chaser:a=1,b=2") == (Stage(((2, 2),), still), Stage(((2, 2),), both))
    made = TrainSettings(players="1v1;2v2,1v3", opponents="still;still,chaser")
    assert made.sizes == ((1, 1), (2, 2), (1, 3)) and made.opponent_names == ("still", "chaser")
    assert made.critic_room == 5 and TrainSettings(players="1v1;7v7").critic_room == 7


def clock(most: int = 1000) -> StageClock:
    return StageClock(parse_stages("1v1;1v1,2v2;3v3", "still"), 0.75, most)


def test_a_stage_is_over_when_every_size_has_its_share_of_the_goals() -> None:
    made = clock()
    assert made.shares() == {(1, 1): 0.5} and not made.move_on(1)
    made.take(episodes((1, 1), 2, 0, 4))
    assert made.shares()[1, 1] == pytest.approx((8 + DOUBT) / (8 + 2 * DOUBT), rel=1e-2) and not made.move_on(2)
    made.take(episodes((1, 1), 2, 0, 40))
    assert made.move_on(3) and made.stage.sizes == ((1, 1), (2, 2))
    made.take(episodes((1, 1), 2, 0, 99))
    assert not made.move_on(4), "2 v 2 is still even"
    made.take(episodes((2, 2), 3, 1, 1000))
    assert made.shares()[2, 2] < 0.75 and not made.move_on(5)
    made.take(episodes((2, 2), 4, 1, 1000))
    assert made.move_on(6) and not made.move_on(10**9), "the last stage has no end"


def test_a_stage_is_over_after_its_decisions_and_a_checkpoint_keeps_the_count() -> None:
    made, other = clock(), clock()
    assert not made.move_on(999) and made.move_on(1000) and not made.move_on(1999)
    made.take(episodes((2, 2), 1, 0))
    other.restore(made.state())
    assert other.shares() == made.shares() and other.move_on(2000) and other.number == 2


def test_a_run_goes_on_to_its_next_stage_and_is_judged_at_all_sizes(tmp_path: Path) -> None:
    changes = {"players": "1v1;2v2", "opponents": "still;still,chaser", "stage_steps": 60, "past": 0}
    train_plainly(tiny_settings(tmp_path, steps=150, matches=2, **changes))
    lines = records(tmp_path / "log.jsonl")
    assert [line["stage"] for line in lines] == [1, 1, 1, 2, 2]
    assert [line["step"] for line in lines] == [24, 48, 72, 120, 168], "twice as many robots"
    assert [set(line["minute"]) for line in lines] == [{"1v1"}] * 3 + [{"2v2"}] * 2
    assert {name.split()[1] for line in lines[:3] for name in line["goals"]} <= {"still"}
    found = records(tmp_path / "evaluations.jsonl")
    assert all([row["players"] for row in one["rows"]] == ["1v1", "2v2"] for one in found)
