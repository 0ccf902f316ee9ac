"""What SoccerVecEnv says where stable-baselines3 is not installed."""

import importlib
import sys

import pytest


def test_rows_say_what_installs_stable_baselines(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.partition(".")[0] == "stable_baselines3"]:
        monkeypatch.setitem(sys.modules, name, None)  # as if it were not there
    monkeypatch.setitem(sys.modules, "stable_baselines3", None)
    monkeypatch.delitem(sys.modules, "soccer_env.train.ppo.vec_env", raising=False)
    with pytest.raises(ImportError, match=r'needs stable-baselines3: pip install "soccer_env\[train\]"'):
        importlib.import_module("soccer_env.train.ppo.vec_env")
