"""Multi-agent robot soccer after two published teams: physics by pymunk, play by policies and scripted teams."""

from __future__ import annotations

from typing import Any

from soccer_env.gymnasium_envs import register as _register

__version__ = "0.1.0"
__all__ = ["Match", "League", "OwnTerm", "Rewards", "Scene", "Team", "make_team", "soccer_v0"]

_WHERE = {  # resolved at first use, so that importing the package stays quick
    "Match": "soccer_env.match",
    "League": "soccer_env.leagues",
    "OwnTerm": "soccer_env.rewards",
    "Rewards": "soccer_env.rewards",
    "Scene": "soccer_env.scenes",
    "Team": "soccer_env.teams",
    "make_team": "soccer_env.teams",
}


def __getattr__(name: str) -> Any:
    """Import a public name when it is first asked for."""
    from importlib import import_module

    if name == "soccer_v0":
        return import_module("soccer_env.soccer_v0")
    if name in _WHERE:
        return getattr(import_module(_WHERE[name]), name)
    raise AttributeError(f"module 'soccer_env' has no attribute {name!r}")


_register()
