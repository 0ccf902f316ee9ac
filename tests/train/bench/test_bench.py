"""The benchmark times live play: the floors step the same Spaces as the core, and the arithmetic is right."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.physics.engine import reference
from soccer_env.train.bench import apis as bench_faces
from soccer_env.train.bench import benchmark as bench
from soccer_env.train.bench import loads as bench_loads
from soccer_env.train.bench import plans as bench_plans
from soccer_env.train.bench.settings import BenchSettings


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench_loads, "WARM_UP", 0.5)
    monkeypatch.setattr(bench_faces, "WARM_UP", 0.5)


@pytest.mark.parametrize("league", bench.LEAGUES)
def test_the_floor_plays_the_same_matches(league: str) -> None:
    core, floor = (kind(league, None, 70, 1, 3) for kind in (bench_loads.CoreLoad, bench_loads.OwnFloor))
    assert core.sample(60) > floor.sample(60) > 0.0
    assert core.match.state_hash() == floor.match.state_hash()


def test_two_threads_play_the_same_matches() -> None:
    one, two = (bench_loads.CoreLoad("middle-size-2006", None, 70, threads, 3) for threads in (1, 2))
    one.sample(60), two.sample(60)
    assert one.match.state_hash() == two.match.state_hash()


def test_play_is_live_and_spread_over_time() -> None:
    """Robots move, the ball is touched, and clocks differ; a match that ends is replaced."""
    load = bench_loads.CoreLoad("middle-size-2006", None, 64, 1, 0)
    clocks = load.match.matches["clock"]
    assert np.ptp(clocks) > 0.8 * load.match.settings.half_length
    load.match.matches["half"], load.match.matches["clock"] = 1, load.match.settings.half_length
    load.run(5)
    assert (load.match.matches["episode"] == 1).all()
    assert not load.match.matches["over"].any()
    load.run(100)
    assert np.abs(load.match.robots["vx"]).mean() > 0.1


def test_the_reference_scene_is_the_one_of_the_issue() -> None:
    space = reference.reference_space(np.random.default_rng(0))
    assert len(space.bodies) == 7
    assert len(space.static_body.shapes) == 7
    assert space.iterations == 10
    assert reference.REFERENCE_SUBSTEPS == 8


def test_nothing_leaves_the_reference_scene() -> None:
    load = bench_loads.ReferenceFloor(4, 0)
    assert load.sample(1000) > 0.0
    reference.read_slice(load.batch.links, 0, 4)
    assert np.abs(load.batch.bodies[:, :7, :2]).max() < 4.6


def test_the_planner_is_timed_over_5_metres_past_nine_obstacles_that_leave_it_room() -> None:
    places, others = bench_plans.draw_scene(np.random.default_rng(1))
    x, y, to_x, to_y = places
    assert np.hypot(to_x - x, to_y - y) == pytest.approx(5.0) and len(others) == 9
    for at in (places[:2], places[2:]):
        assert np.hypot(others["x"] - at[0], others["y"] - at[1]).min() >= 0.6
    assert 0.0 < np.hypot(others["vx"], others["vy"]).max() <= 2.0
    passes, plans = bench_plans.PlanLoad(0).sample(20)
    assert len(passes) == len(plans) == 20 and min(passes + plans) > 0.0
    rows = list(bench.plan_rows(BenchSettings(quick=True)))
    assert [row.target for row in rows] == ["<= 25", "<= 60", "<= 1000"]
    assert rows[1].value <= rows[2].value


def test_rows_compare_within_each_repetition() -> None:
    samples = {
        "reference": [1e-6, 3e-6, 1e-6], "random floor": [2e-6, 6e-6, 2e-6], "random": [3e-6, 9e-6, 4e-6],
        "random, 2 threads": [1.5e-6, 5e-6, 2e-6], "chaser floor": [1e-5] * 3, "chaser": [1e-4] * 3,
        "chaser, 2 threads": [6e-5] * 3, "senses": [6e-6, 27e-6, 8e-6], "particles": [1.5e-5] * 3,
    }  # fmt: skip
    rows = {row.name.partition(": ")[2]: row for row in bench.core_rows("legged-2001", samples)}
    assert rows["random over its own scene"].value == pytest.approx(1.5)
    assert rows["random over its own scene"].met
    assert rows["sensors and beliefs over the truth"].value == pytest.approx(2.0)
    assert rows["particle filters over a given pose"].value == pytest.approx(1.875)
    assert rows["random over the reference"].value == pytest.approx(3.0)
    assert rows["chaser against chaser"].value == pytest.approx(10_000)
    assert rows["chaser against chaser"].met
    assert rows["chaser, two threads over one"].value == pytest.approx(1 / 0.6)
    assert rows["chaser, two threads over one"].met is False


def test_the_memory_of_a_match_is_counted_once() -> None:
    from soccer_env import Match
    from soccer_env.types import ROBOT

    least = Match("legged-2001", home=3, away=3).robots.nbytes
    assert least == 6 * ROBOT.itemsize
    assert least < bench_faces.record_bytes("legged-2001", matches=4) < 64 * 1024
    assert bench_faces.wrapper_bytes("legged-2001", 2) > 0


def test_a_start_that_fails_says_why() -> None:
    with pytest.raises(RuntimeError, match="no such luck"):
        bench_faces.start_time("raise SystemExit('no such luck')", 1)


@pytest.mark.slow
def test_a_small_bench_ends_in_a_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("soccer_env.baselines.chaser")
    small: dict[str, Any] = {"matches": 4, "repetitions": 2, "steps": 4}
    for name, value in small.items():
        monkeypatch.setattr(BenchSettings, name, property(lambda _, value=value: value))
    monkeypatch.setattr(bench, "START_TIMES", {"soccer --help": bench.START_TIMES["soccer --help"]})
    report = bench.run(BenchSettings(quick=True, out=tmp_path / "sub" / "bench.json"))
    assert json.loads((tmp_path / "sub" / "bench.json").read_text())["rows"] == report["rows"]
    table = bench.screen_table(report)
    assert table.row_count == len(report["rows"]) > 20
    assert {"processor", "cores", "commit", "pymunk"} <= set(report["machine"])


def test_the_team_of_2006_is_timed_as_it_decides_and_plays() -> None:
    load = bench_plans.TeamLoad(0, matches=2)
    before = [squad.memory.copy() for squad in load.match.squads]
    assert load.match.robots.shape == (2, 10) and load.decide(2) > 0.0
    assert all((squad.memory == old).all() for squad, old in zip(load.match.squads, before, strict=True))
    assert load.run(2) > 0.0
