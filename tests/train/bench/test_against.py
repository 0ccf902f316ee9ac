"""Two checkouts are timed in turn, each with its own code and interpreter, and a slower one is found out."""

import json
import sys
from pathlib import Path

import numpy as np
import pytest

from soccer_env.train.bench import against, worker
from soccer_env.train.bench.settings import BenchSettings
from soccer_env.train.command.command_line import main

ROOT = Path(__file__).parents[3]

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
    """Make what looks like a checkout."""
    for name in ("soccer_env/__init__.py", *files):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("WHERE = __file__\n", encoding="utf-8")
    return folder


def test_a_checkout_is_as_fast_as_itself(script: Path, tmp_path: Path) -> None:
    report = against.run(BenchSettings(quick=True, against=checkout(tmp_path / "same", "there")), script)
    assert [row["name"] for row in report["rows"]] == ["play", "load", "new"]
    for row in report["rows"]:
        assert 0.9 < row["low"] < row["value"] < row["high"] < 1.1
    assert {len(pairs) for pairs in report["pairs"].values()} == {2 * 2 * 3}, "two a repetition, in each round"


def test_rows_are_chosen_by_words(script: Path, tmp_path: Path) -> None:
    settings = BenchSettings(quick=True, against=checkout(tmp_path / "same", "there"), rows="pl ay")
    assert [row["name"] for row in against.run(settings, script)["rows"]] == ["play"]


def test_words_that_no_row_has_name_the_rows(script: Path, tmp_path: Path) -> None:
    settings = BenchSettings(quick=True, against=checkout(tmp_path / "same", "there"), rows="plat")
    with pytest.raises(ValueError, match="no row contains 'plat'; rows: play; odd; load; new"):
        against.run(settings, script)


def test_a_slower_checkout_is_found_out_and_missing_rows_are_named(script: Path, tmp_path: Path) -> None:
    out = tmp_path / "sub" / "bench.json"
    report = against.run(
        BenchSettings(quick=True, against=checkout(tmp_path / "other", "there", "slow"), out=out), script
    )
    assert [row["name"] for row in report["rows"]] == ["play", "load"]
    for row in report["rows"]:
        assert 0.75 < row["low"] < row["high"] < 0.95 and row["verdict"] == "faster", "a fifth"
    assert report["lacking"] == {"new": "only here", "odd": "not in this checkout"}
    assert json.loads(out.read_text()) == json.loads(json.dumps(report))
    table = against.screen_table(report)
    assert table.row_count == 2 and "new: only here" in str(table.caption)


def test_the_interval_of_equal_rows_holds_1_as_often_as_it_says() -> None:
    rng = np.random.default_rng(3)
    ratios = [against.ratio_of("x", list(zip(*rng.lognormal(0.0, 0.1, (2, 22)).tolist()))) for _ in range(40)]
    assert np.mean([ratio.verdict == "" for ratio in ratios]) >= 0.85, "95 % in the long run"


def test_slower_and_faster_are_said_only_where_the_interval_says_so() -> None:
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
    with against.started(other, "other", BenchSettings(against=other), script) as started:
        assert started.rows == [
            str(other / name / "__init__.py") for name in ("soccer_env", "baselines", "train")
        ]  # fmt: skip


def test_a_checkout_has_its_own_interpreter_or_the_one_that_is_given(tmp_path: Path) -> None:
    plain, own = (
        checkout(tmp_path / "plain"),
        checkout(tmp_path / "own", ".venv/bin/python", ".venv/Scripts/python.exe"),
    )
    assert against.interpreter_of(plain, BenchSettings(against=plain)) == sys.executable
    assert against.interpreter_of(plain, BenchSettings(against=plain, python=Path("/python"))) == "/python"
    assert against.interpreter_of(own, BenchSettings(against=own, python=Path("/python"))).startswith(
        str(own / ".venv")
    )


def test_what_is_no_checkout_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for words, complaint in (
        (["--against", str(tmp_path / "nowhere")], "against must be the folder of a checkout"),
        (["--against", str(tmp_path)], "is no checkout: it has no soccer_env/__init__.py"),
        (["--python", "python3"], "give against as well"),
    ):
        assert main(["bench", *words]) == 2
        assert complaint in capsys.readouterr().err


def test_a_process_that_dies_is_said(tmp_path: Path) -> None:
    (tmp_path / "script.py").write_text("raise SystemExit(3)")
    with pytest.raises(ValueError, match="the process of this checkout ended with 3"):
        against.run(BenchSettings(against=checkout(tmp_path / "other")), tmp_path / "script.py")


@pytest.mark.parametrize("name", worker.ROWS)
def test_every_row_can_be_timed(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker, "WARM_UP", 0.5)
    sample = worker.ROWS[name](2, 3)
    assert 0.0 <= sample() < 5.0 and sample() < 5.0


def test_the_rows_know_the_leagues() -> None:
    from soccer_env.leagues import find_league

    assert {name: find_league(name).control_rate for name in worker.LEAGUES} == worker.LEAGUES
