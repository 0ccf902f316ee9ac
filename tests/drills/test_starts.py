"""Starts are held out from training and follow from the seed; a drill of one's own, in one file, works everywhere."""

import re
import sys
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest

from soccer_env import Match, Scene, soccer_v0
from soccer_env.scenes.scene import HELD_OUT, SCENE
from soccer_env.train.evaluate import EvaluateSettings, evaluate, evaluate_drills
from soccer_env.train.evaluate.drills import run_drill
from soccer_env.train.statistics import wilson_interval

ROOT = Path(__file__).parents[2]
SIZES: dict[str, Any] = {"home": 1, "away": 1}
DRAWN: list[int] = []  # numbers of the starts that `noted` has placed


def noted(league: Any, ball: Any, robots: Any, draw: Any) -> None:
    """Note the number of a start, and place the ball by it."""
    DRAWN.append(int(draw.noise[SCENE]))
    ball["x"] = draw.between(-1.0, 1.0)


NOTED = Scene("noted", "the ball anywhere", noted, "home scores", 5.0, in_play=True)


def begun(starts: str, scene: Any = "empty-goal", matches: int = 200, **more: Any) -> Match:
    return Match(scene=scene, matches=matches, seed=3, starts=starts, **{**SIZES, **more})


def test_training_draws_no_held_out_start_in_10_000_resets() -> None:
    pytest.importorskip("stable_baselines3")
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

    env = SoccerVecEnv(players=[(1, 1)], matches=500, opponents="still", scene=NOTED, minutes=0.1)
    DRAWN.clear()
    for seed in range(20):
        env.seed(seed)
        env.reset()
    assert len(DRAWN) == 10_000 == len(set(DRAWN)) and not any(number % HELD_OUT == 0 for number in DRAWN)
    DRAWN.clear()
    begun("held-out", NOTED)
    assert len(DRAWN) == 200 and all(number % HELD_OUT == 0 for number in DRAWN)


def test_every_seed_has_a_start_of_each_kind_and_all_of_them_are_one_or_the_other() -> None:
    every, training, held_out = (begun(starts).balls["x"] for starts in ("all", "training", "held-out"))
    assert ((every == training) != (every == held_out)).all()
    assert 0.04 < (every == held_out).mean() < 0.17
    assert (np.abs(np.mean(training) - np.mean(held_out)) < 0.05).all(), "held-out starts are no corner of the others"


@pytest.mark.parametrize("starts", ["all", "training", "held-out"])
def test_starts_follow_from_the_seed_alone_and_a_saved_match_keeps_them(starts: str) -> None:
    many = begun(starts, matches=12)
    one = Match(scene="empty-goal", seeds=[many.seeds[7]], starts=starts, **SIZES)
    saved = many.save()
    other = begun(starts, matches=12)
    other.reset(seed=8)
    other.load(saved)
    for match in (many, one, other):
        match.reset()
    assert one.balls[0] == many.balls[7] and (other.balls == many.balls).all()
    with pytest.raises(ValueError, match=f"starts '{starts}' there, '(all|training)' here"):
        begun("training" if starts == "all" else "all", matches=12).load(saved)


def test_unknown_starts_are_refused() -> None:
    with pytest.raises(ValueError, match="starts must be one of all, training, held-out, got 'some'"):
        begun("some")


def test_a_row_for_each_drill_and_team_and_saves_are_aways() -> None:
    settings = EvaluateSettings(scene="shot-at-keeper", home="still,chaser", matches=20, seed=2, pose="percept")
    still, chaser = evaluate_drills(settings)
    assert (still.drill, still.team, chaser.team, still.runs) == ("shot-at-keeper", "still", "chaser", 20)
    assert still.successes == run_drill("legged-2001", "shot-at-keeper", "still", 20, seed=2)
    ends = dict(zip(("share", "low", "high"), wilson_interval(still.successes, 20), strict=True))
    assert still.as_dict() == asdict(still) | ends
    for wrong, said in (
        ({"away": "chaser"}, "away goes with matches alone"), ({"home": "still,still"}, "home must be different"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=said):
            evaluate_drills(EvaluateSettings(**{"scene": "all", **wrong}))
    with pytest.raises(ValueError, match="'empty-goal' is no start of a match: `soccer evaluate --scene empty-goal`"):
        evaluate(EvaluateSettings(scene="empty-goal"))


def test_a_drill_takes_a_variation() -> None:
    asked = EvaluateSettings(scene="empty-goal", home="chaser", matches=20, seed=2, pose="percept")
    (usual,), (lame,) = evaluate_drills(asked), evaluate_drills(replace(asked, variation="drive.forward=0.1"))
    assert lame.successes < usual.successes


@pytest.fixture
def own_drill(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """Write the drill of the page of the environment into a file of its own; return MODULE:NAME."""
    page = (ROOT / "soccer_env/README.md").read_text(encoding="utf-8")
    found = re.search(r"```python\n(from soccer_env import Match, Scene\n.*?\n\)\n)controllers", page, re.DOTALL)
    assert found is not None and len(found[1].splitlines()) <= 20
    (tmp_path / "drill_of_mine.py").write_text(found[1], encoding="utf-8")
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "drill_of_mine", raising=False)
    return "drill_of_mine:corner"


def test_a_drill_of_ones_own_works_everywhere(own_drill: str) -> None:
    pytest.importorskip("stable_baselines3")
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

    drill: dict[str, Any] = {"scene": own_drill, "episode": "drill", **SIZES}
    parallel = soccer_v0.parallel_env(**drill)
    solo = gymnasium.make("soccer_env/Legged2001-1v1-v0", **drill)
    vector = gymnasium.make_vec("soccer_env/Legged2001-1v1-v0", num_envs=2, **drill)
    for env in (parallel, solo, vector):
        env.reset(seed=1)  # type: ignore[attr-defined]
    training = SoccerVecEnv(players=[(1, 1)], matches=2, opponents="still", scene=own_drill, minutes=0.1)
    training.reset()
    solo_match, vector_match = solo.unwrapped.match, vector.match  # type: ignore[attr-defined]
    for match in (Match(seed=1, **drill), parallel.match, solo_match, vector_match, *training.matches):
        assert match.settings.scene.name == "corner" and np.allclose(np.abs(match.balls["y"]), 0.6)
    (row,) = evaluate_drills(EvaluateSettings(scene=own_drill, home="still", matches=2))
    assert (row.drill, row.successes) == ("corner", 0)
