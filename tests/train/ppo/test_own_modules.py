"""A training in a league, with rewards, scenes and opponents that stand in a module of a user's own."""

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from soccer_env.agents.policy_file import load
from soccer_env.compiling import sources as stamps
from tests.train.ppo.staged_training import ROLLOUT, plainly, tiny

pytest.importorskip("stable_baselines3")

MINE = """
from dataclasses import replace
import numpy as np
from soccer_env import OwnTerm, Rewards, Scene, team_of_function
from soccer_env.leagues import find_league

legged = find_league("legged-2001")
ICY = replace(legged, name="icy", ball=replace(legged.ball, rolling=0.05))
asked = []


def touched(match):
    asked.append("reward")
    return match.robot_events["touch"].astype(float)


def beside(league, ball, robots, draw):
    asked.append("scene")
    ball["x"] = 0.5


def ahead(observations):
    asked.append("team")
    actions = np.zeros((*observations.shape[:2], 4))
    actions[..., 0] = 1.0
    return actions


PAID = Rewards.only(goal=3.0, extra={"touch": touched})
BESIDE = Scene("beside", "the ball ahead", place=beside, in_play=True)
team = team_of_function(ahead, action_repeat=4, fingerprint="1")
"""
OWN = {
    "league": "own_parts:ICY", "rewards": "own_parts:PAID", "scenes": "kick-off:0.5,own_parts:BESIDE:0.5",
    "opponents": "still,own_parts:team", "evaluate_against": "own_parts:team", "teacher": "own_parts:team",
}  # fmt: skip


@pytest.fixture
def mine(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Go to a folder with a module of a user's own."""
    (tmp_path / "own_parts.py").write_text(MINE)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    yield tmp_path
    sys.modules.pop("own_parts", None)


def test_all_parts_of_ones_own_are_trained_with(mine: Path) -> None:
    result = plainly(tiny(mine / "run", **OWN, steps=2 * ROLLOUT))
    asked = sys.modules["own_parts"].asked
    assert {"reward", "scene", "team"} == set(asked)
    assert result.steps >= 2 * ROLLOUT
    assert load(mine / "run" / "last.safetensors").league == "icy"
    assert result.evaluations[-1]["rows"][0]["opponent"] == "own_parts:team"
    (mine / "own_parts.py").write_text(MINE.replace("rolling=0.05", "rolling=0.0625"))
    for kept in (stamps.sources, stamps._read):  # once per process, and this is to be the next
        kept.cache_clear()
    with pytest.raises(ValueError, match="own_parts"):
        plainly(tiny(mine / "run", **OWN, steps=3 * ROLLOUT))


@pytest.mark.usefixtures("mine")
@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"league": "own_parts:ICE"}, "unknown league 'ICE' in module 'own_parts', did you mean 'ICY'?"),
        ({"rewards": "own_parts:ICY"}, "rewards 'own_parts:ICY' must be a Rewards, got <League icy"),
        ({"scenes": "own_parts:BESIDES:0.5"}, "unknown scene 'BESIDES' in module 'own_parts', did you mean 'BESIDE'?"),
        ({"opponents": "own_parts:tem"}, "opponents: unknown team 'tem' in module 'own_parts', did you mean 'team'?"),
        (
            {"teacher": "own_parts:team", "rounds": 1},
            "teacher: rounds=0 is needed for 'own_parts:team': a team in Python plays, but cannot advise",
        ),
    ],
)
def test_what_is_not_there_is_named_before_a_folder_is_made(changes: dict[str, str], message: str) -> None:
    with pytest.raises(ValueError) as error:
        plainly(tiny(Path("run"), **changes))
    assert message in str(error.value)
    assert not Path("run").exists()
