"""Growth finds the order of a cost, and a soak finds what grows while matches are played."""

from pathlib import Path
from typing import Any

import pytest

from soccer_env.train.bench import growth, loads, soak, worker
from soccer_env.train.bench.benchmark import screen_table
from soccer_env.train.bench.growth import Curve
from soccer_env.train.bench.settings import BenchSettings

pytestmark = pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="reads the memory from /proc")


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (loads, worker):
        monkeypatch.setattr(module, "WARM_UP", 0.5)
    for name, value in {
        "ROBOTS": (1, 2, 3),
        "MATCHES": (1, 2, 4, 8, 16),
        "LENGTHS": (60, 120, 240),
        "LEAGUES": ("legged-2001",),
    }.items():
        monkeypatch.setattr(growth, name, value)
    for name, value in {"CROWD": 2, "HELD": 8, "TIMED": 16, "APPENDED": 20}.items():
        monkeypatch.setattr(growth, name, value)


def test_the_order_is_that_of_the_large_sizes_and_above_the_needed_one_it_misses() -> None:
    sizes = (1, 10, 100, 1000)
    linear = Curve(
        "step", "matches", 1.0, sizes, [1e-3 + 1e-6 * size for size in sizes[:1]] + [2e-6 * size for size in sizes[1:]]
    )
    assert linear.order == pytest.approx(1.0) and linear.row("league").met
    pairs = Curve("step", "robots", 1.0, sizes, [1e-6 * size**2 for size in sizes])
    assert pairs.order == pytest.approx(2.0) and pairs.row("league").met is False
    assert pairs.row("league").text == "1 us to 1 s, order 2.00"


@pytest.mark.slow
def test_a_small_growth_measures_every_curve_and_draws_them(tmp_path: Path) -> None:
    report = growth.measure_growth(BenchSettings(growth=True, quick=True, out=tmp_path / "growth.json"))
    assert screen_table(report).row_count == len(report["rows"])
    for curves in report["curves"].values():
        assert {curve["axis"] for curve in curves} == {"robots", "players to see", "matches", "control steps"}
        assert all(len(curve["sizes"]) == len(curve["costs"]) >= 3 and min(curve["costs"]) > 0 for curve in curves)
        file = next(curve["costs"] for curve in curves if curve["name"] == "file")
        assert file[0] < file[1] < file[2], "a longer replay is a longer file"
    pytest.importorskip("matplotlib")
    assert (tmp_path / "growth.png").read_bytes().startswith(b"\x89PNG")


def small_soak(tmp_path: Path) -> dict[str, Any]:
    """Soak for a few thousand match steps; return whether each row was met."""
    report = soak.measure_soak(BenchSettings(soak=0.02, quick=True, out=tmp_path / "soak.json"))
    assert 20_000 <= report["laps"][-1]["steps"] < 60_000
    return {row["name"]: row["met"] for row in report["rows"] if row["target"]}


@pytest.mark.slow
def test_play_and_recordings_keep_memory_and_files_flat(tmp_path: Path) -> None:
    met = small_soak(tmp_path)
    assert met["memory, last third over first"] and met["files opened and not closed"]


@pytest.mark.slow
def test_a_soak_finds_memory_and_files_that_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept: list[Any] = []
    record = soak.Mixture.record

    def leaking(mixture: soak.Mixture, path: Path) -> int:
        kept.extend((b"x" * (soak.resident_bytes() // 20), path.parent.joinpath("kept").open("w")))
        return record(mixture, path)

    monkeypatch.setattr(soak.Mixture, "record", leaking)
    met = small_soak(tmp_path)
    for thing in kept[1::2]:
        thing.close()
    assert not met["memory, last third over first"] and not met["files opened and not closed"]


def test_what_cannot_be_measured_together_or_is_no_number_is_refused(soccer: Any) -> None:
    assert "one at a time" in soccer("bench", "--growth", "--soak", "1", code=2)
    assert "million match steps" in soccer("bench", "--soak", "-1", code=2)
