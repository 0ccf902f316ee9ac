"""The benchmark times live play by the same Spaces as its floors, and two checkouts in turn, each by its own code."""

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.physics.engine import reference
from soccer_env.train.bench import against, profile, worker
from soccer_env.train.bench import apis as bench_faces
from soccer_env.train.bench import benchmark as bench
from soccer_env.train.bench import loads as bench_loads
from soccer_env.train.bench import plans as bench_plans
from soccer_env.train.bench.settings import BenchSettings


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(bench_loads, "WARM_UP", 0.5)
    monkeypatch.setattr(worker, "WARM_UP", 0.5)


@pytest.mark.parametrize("league", bench.LEAGUES)
def test_the_floor_and_two_threads_play_the_same_matches(league: str) -> None:
    core, two = (bench_loads.CoreLoad(league, None, 70, threads, 3) for threads in (1, 2))
    floor = bench_loads.OwnPhysicsLoad(league, None, 70, 1, 3)
    assert core.sample(60) > floor.sample(60) > 0.0 and two.sample(60) > 0.0
    assert core.match.state_hash() == floor.match.state_hash() == two.match.state_hash()


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


def test_the_reference_scene_is_the_one_of_the_issue_and_nothing_leaves_it() -> None:
    space = reference.reference_space(np.random.default_rng(0))
    assert len(space.bodies) == len(space.static_body.shapes) == 7
    assert (space.iterations, reference.REFERENCE_SUBSTEPS) == (10, 8)
    load = bench_loads.ReferencePhysicsLoad(4, 0)
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
        "varied": [6.3e-6, 27e-6, 8.2e-6],
    }  # fmt: skip
    rows = {row.name.partition(": ")[2]: row for row in bench.core_rows("legged-2001", samples)}
    expected = {
        "random over its own scene": 1.5, "sensors and beliefs over the truth": 2.0, "random over the reference": 3.0,
        "particle filters over a given pose": 1.875, "variation of all numbers over none": 1.025,
        "chaser against chaser": 10_000, "chaser, two threads over one": 1 / 0.6,
    }  # fmt: skip
    assert {name: rows[name].value for name in expected} == pytest.approx(expected)
    assert rows["random over its own scene"].met and rows["chaser against chaser"].met
    assert rows["chaser, two threads over one"].met is False


def test_the_memory_of_a_match_is_counted_once() -> None:
    from soccer_env import Match
    from soccer_env.types import ROBOT

    least = Match("legged-2001", home=3, away=3).robots.nbytes
    assert least == 6 * ROBOT.itemsize
    assert least < bench_faces.record_bytes("legged-2001", matches=4) < 64 * 1024
    assert bench_faces.wrapper_bytes("legged-2001", 2) > 0


@pytest.mark.slow
def test_a_small_bench_ends_in_a_table(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("soccer_env.baselines.chaser")
    small: dict[str, Any] = {"matches": 4, "repetitions": 2, "steps": 4}
    for name, value in small.items():
        monkeypatch.setattr(BenchSettings, name, property(lambda _, value=value: value))
    monkeypatch.setattr(bench, "START_TIMES", {"soccer --help": bench.START_TIMES["soccer --help"]})
    report = bench.run_benchmark(BenchSettings(quick=True, out=tmp_path / "sub" / "bench.json"))
    assert json.loads((tmp_path / "sub" / "bench.json").read_text())["rows"] == report["rows"]
    table = bench.screen_table(report)
    assert table.row_count == len(report["rows"]) > 20
    assert {"processor", "cores", "commit", "pymunk"} <= set(report["machine"])


def test_the_team_of_2006_is_timed_as_it_decides_and_plays() -> None:
    load = bench_plans.TeamLoad(0, matches=2)
    before = [squad.memory.copy() for squad in load.match.squads]
    assert load.match.robots.shape == (2, 10) and load.decide(2) > 0.0
    assert all((squad.memory == old).all() for squad, old in zip(load.match.squads, before, strict=True))
    assert load.sample(2) > 0.0


# A worker whose times are drawn, with the noise of a busy machine; what they are follows from files of the checkout.
PRETENDED = """
import random, runpy, sys
from pathlib import Path

serve = runpy.run_path({worker!r})["serve"]
with open(Path(__file__).with_name("there" if Path("there").exists() else "here"), "a") as starts:
    print("started", file=starts)
    draw = random.Random(f"{{starts.name[-5:]}} {{starts.tell()}}")  # other noise at each start
slow = 1.2 if Path("slow").exists() else 1.0

def maker(matches, steps):
    print("what a checkout says while it starts")
    return lambda: slow * 1e-3 * draw.lognormvariate(0.0, 0.05)

def broken(matches, steps):
    raise KeyError("no such setting")

rows = {{"play": maker, "odd": broken if slow == 1.0 else maker, "load": maker}}
if slow == 1.0:
    rows["new"] = maker
serve(rows, *map(int, sys.argv[1:]))
"""


@pytest.fixture
def script(tmp_path: Path) -> Path:
    (tmp_path / "script.py").write_text(PRETENDED.format(worker=worker.__file__), encoding="utf-8")
    return tmp_path / "script.py"


def checkout(folder: Path, *files: str) -> Path:
    for name in ("soccer_env/__init__.py", *files):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("WHERE = __file__\n", encoding="utf-8")
    return folder


def test_a_checkout_is_as_fast_as_itself(script: Path, tmp_path: Path) -> None:
    report = against.compare_checkouts(BenchSettings(quick=True, against=checkout(tmp_path / "same", "there")), script)
    assert [row["name"] for row in report["rows"]] == ["play", "load", "new"]
    for row in report["rows"]:
        assert 0.9 < row["low"] < row["value"] < row["high"] < 1.1
    assert {len(pairs) for pairs in report["pairs"].values()} == {2 * 2 * 3}, "two a repetition, in each round"


def test_rows_are_chosen_by_words_and_words_that_no_row_has_name_the_rows(script: Path, tmp_path: Path) -> None:
    settings = BenchSettings(quick=True, against=checkout(tmp_path / "same", "there"), rows="pl ay")
    assert [row["name"] for row in against.compare_checkouts(settings, script)["rows"]] == ["play"]
    with pytest.raises(ValueError, match="no row contains 'plat'; rows: play; odd; load; new"):
        against.compare_checkouts(replace(settings, rows="plat"), script)


def test_a_slower_checkout_is_found_out_and_missing_rows_are_named(script: Path, tmp_path: Path) -> None:
    out = tmp_path / "sub" / "bench.json"
    other = checkout(tmp_path / "other", "there", "slow")
    report = against.compare_checkouts(BenchSettings(quick=True, against=other, out=out), script)
    assert [row["name"] for row in report["rows"]] == ["play", "load"]
    for row in report["rows"]:
        assert 0.75 < row["low"] < row["high"] < 0.95 and row["verdict"] == "faster", "a fifth"
    assert report["lacking"] == {"new": "only here", "odd": "not in this checkout"}
    assert json.loads(out.read_text()) == json.loads(json.dumps(report))
    table = against.screen_table(report)
    assert table.row_count == 2 and "new: only here" in str(table.caption)


def test_slower_and_faster_are_said_only_where_the_interval_says_so_which_holds_1_for_equal_rows() -> None:
    rng = np.random.default_rng(3)
    ratios = [against.ratio_of("x", list(zip(*rng.lognormal(0.0, 0.1, (2, 22)).tolist()))) for _ in range(40)]
    assert np.mean([ratio.verdict == "" for ratio in ratios]) >= 0.85, "95 % in the long run"
    sure = [(1.2 + 0.01 * n, 1.0 + 0.01 * n) for n in range(9)]
    assert against.ratio_of("x", sure).verdict == "slower"
    assert against.ratio_of("x", [(b, a) for a, b in sure]).verdict == "faster"
    assert against.ratio_of("x", [(1.0, 1.1), (1.2, 1.0), (1.1, 1.2)]).verdict == ""
    assert against.ratio_of("x", sure).value == pytest.approx(1.24 / 1.04)


def test_each_checkout_runs_its_own_code_wherever_its_folders_stand(tmp_path: Path) -> None:
    other = checkout(tmp_path / "other", "soccer_env/match/match.py", "baselines/__init__.py", "train/__init__.py")
    script = tmp_path / "script.py"
    script.write_text(
        "import json, sys\nimport soccer_env.baselines, soccer_env.train\nfrom pathlib import Path\n"
        "found = [soccer_env.__file__, soccer_env.baselines.__file__, soccer_env.train.__file__]\n"
        "print(json.dumps({'rows': [str(Path(file).resolve()) for file in found]}))\n"
    )
    with against.start_worker(other, "other", BenchSettings(against=other), script) as started:
        assert started.rows == [str(other / name / "__init__.py") for name in ("soccer_env", "baselines", "train")]


def test_a_checkout_has_its_own_interpreter_or_the_present_one(tmp_path: Path) -> None:
    own = checkout(tmp_path / "own", ".venv/bin/python", ".venv/Scripts/python.exe")
    assert against.interpreter_of(checkout(tmp_path / "plain")) == sys.executable
    assert against.interpreter_of(own).startswith(str(own / ".venv"))


def test_what_is_no_checkout_is_refused(tmp_path: Path, soccer: Any) -> None:
    for words, complaint in (
        (["--against", str(tmp_path / "nowhere")], "against must be the folder of a checkout"),
        (["--against", str(tmp_path)], "is no checkout: it has no soccer_env/__init__.py"),
        (["--rows", "chaser"], "give against as well"),
    ):
        assert complaint in soccer("bench", *words, code=2)


@pytest.mark.parametrize("name", worker.ROWS)
def test_every_row_can_be_timed(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker, "WARM_UP", 0.5)
    sample = worker.ROWS[name](2, 3)
    assert 0.0 <= sample() < 5.0 and sample() < 5.0


def test_the_profile_times_every_stage_and_the_stages_play_as_the_match_does() -> None:
    """Timing a stage does not change play, and the loops of single mechanisms are those of the names in the table."""
    staged = profile.StagedLoad("legged-2001", 2, 0)
    plain = bench_loads.CoreLoad("legged-2001", "chaser", 2, 1, 0, "particles")
    times = staged.stages(5)
    plain.run(5)
    assert [*times] == [*profile.STAGES] and min(times.values()) > 0.0
    assert staged.match.state_hash() == plain.match.state_hash()
    with pytest.raises(ValueError, match="one at a time"):
        BenchSettings(profile=True, against=Path("."))
