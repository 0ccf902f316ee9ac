"""ONNX files play as our own inference does, and what cannot play is refused in one line."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import Match, make_team
from soccer_env.agents import save_onnx
from soccer_env.agents.learned import team_from_policy
from soccer_env.agents.policy_file import dump
from tests.agents.staged_onnx import exported
from tests.agents.staged_policies import random_policy, random_recurrent_policy
from tests.scenes.staging import refused

pytest.importorskip("onnx")
pytest.importorskip("onnxruntime")


CASES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "box": ({}, {}),
    "full": ({"actions": "full"}, {}),
    "values of discrete actions": ({"actions": "discrete"}, {}),
    "values of the choices of multi": ({"actions": "multi"}, {}),
    "a chosen discrete action": ({"actions": "discrete"}, {"chosen": True}),
    "one robot at a time": ({}, {"batch": 1}),
    "double precision": ({}, {"double": True}),
}


@pytest.mark.parametrize("case", CASES)
def test_it_plays_as_our_own_inference(case: str, tmp_path: Path) -> None:
    fields, written = CASES[case]
    policy = random_policy(16, 12, **fields)
    path = exported(policy, tmp_path / "mine.onnx", **written)
    settings: dict[str, Any] = {"home": 2, "away": 2, "matches": 3, "seed": 1}
    theirs = Match(controllers={"home": f"{path}:observe=belief", "away": "chaser"}, **settings)
    ours = Match(controllers={"home": team_from_policy(policy, at_once=True), "away": "chaser"}, **settings)
    for _ in range(40):
        theirs.step()
        ours.step()
        for name in ("forward", "left", "turn", "kick", "head", "pan", "tilt"):
            gap = np.abs(theirs.robots["command"][name] - ours.robots["command"][name])
            assert gap.max() < 1e-3, name
    assert len(np.unique(ours.robots["command"]["forward"])) > 2


NORMALISED = {"mean": [0.1] * 100, "deviation": [0.5] * 100, "limit": 1.5}
WRITTEN: dict[str, Any] = {
    "plain": random_policy(16, 12),
    "mirrored": random_policy(16, mirror=True),
    "relu": random_policy(16, activation="relu"),
    "squashed": random_policy(16, squash=True),
    "values of discrete actions": random_policy(16, actions="discrete"),
    "normalised": random_policy(16, normalise=NORMALISED),
    "memory": random_recurrent_policy(16, units=8),
    "memory and mirror": random_recurrent_policy(16, units=8, mirror=True, normalise=NORMALISED),
}


@pytest.mark.parametrize("case", WRITTEN)
def test_a_policy_that_is_written_plays_as_before(case: str, tmp_path: Path) -> None:
    """Also with robots that are sent off, whose memory begins anew."""
    policy = replace(WRITTEN[case], action_repeat=2)
    (tmp_path / "mine.safetensors").write_bytes(dump(policy))
    save_onnx(tmp_path / "mine.safetensors", tmp_path / "mine.onnx")
    path = f"{tmp_path / 'mine.onnx'}:observe=belief,action_repeat=2,at_once=False"
    settings: dict[str, Any] = {"home": 2, "away": 2, "matches": 3, "seed": 1}
    both = [
        Match(controllers={"home": team, "away": "chaser"}, **settings) for team in (path, team_from_policy(policy))
    ]
    for step in range(60):
        for match in both:
            if step == 30:
                match.robots["active"][1, 0], match.robots["penalty"][1, 0] = 0, 1.0
            match.step()
        for name in ("forward", "left", "turn", "kick"):
            gap = np.abs(both[0].robots["command"][name] - both[1].robots["command"][name])
            assert gap.max() < 1e-3, (step, name)
    assert len(np.unique(both[1].robots["command"]["forward"])) > 2
    if policy.memory:
        units = 8 * (1 + policy.mirror)
        theirs, ours = (match.squads[0].memory for match in both)
        states = ours["states"][..., :8].reshape(3, 2, 16)[..., :units]
        assert np.abs(theirs["own"] - states).max() < 1e-3 and np.abs(states).max() > 0.1
        again = Match(controllers={"home": path, "away": "chaser"}, **settings)
        again.load(both[0].save())
        again.step(), both[0].step()
        assert again.state_hash() == both[0].state_hash()


def test_what_cannot_play_is_refused_in_one_line(tmp_path: Path) -> None:
    (tmp_path / "bad.onnx").write_bytes(b"nonsense")
    with pytest.raises(ValueError, match="policy file '.*bad.onnx': .*") as error:
        make_team(str(tmp_path / "bad.onnx"))
    assert "\n" not in str(error.value)
    with pytest.raises(ValueError, match=r"policy file '.*none.onnx': No such file"):
        make_team(str(tmp_path / "none.onnx"))
    path = exported(random_policy(8, observe="truth"), tmp_path / "truth.onnx")
    match = Match(home=1, away=1, opponents=path, seed=1)
    with refused(match, "takes 73 inputs, the observation has 100: give observe= as in its training"):
        match.step(np.zeros((1, 2, 4)))
    for setting, said in (("observe=all", "observe must be one of truth, percepts, belief, got 'all'"),
                          ("repeat=3", "has no setting 'repeat'")):  # fmt: skip
        with pytest.raises(ValueError, match=said):
            make_team(f"{path}:{setting}")


def test_without_onnxruntime_the_message_says_what_to_install(tmp_path: Path) -> None:
    path = exported(random_policy(8), tmp_path / "mine.onnx")
    code = f"import sys; sys.modules['onnxruntime'] = None\nfrom soccer_env import make_team; make_team({path!r})"
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "ImportError: an ONNX file plays by onnxruntime and onnx: pip install soccer_env[onnx]" in ran.stderr
