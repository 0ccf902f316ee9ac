"""The senses that a policy was trained with, kept in its file, and how those of a match differ from them.

`senses` says what filled the beliefs of its robots ("sensors" or "ideal"), `pose` how they knew where they were
("percept" or "particles"); "": nothing is known, or it was trained with both. Files that `soccer train` wrote before
these were fields say it among the settings of their run.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, get_args

from soccer_env.agents.rules_known import warn_once
from soccer_env.guards.checking import one_of
from soccer_env.match.arguments import Pose, Senses

if TYPE_CHECKING:
    from soccer_env.agents.policy import Policy

KNOWN = {"senses": ("", *get_args(Senses)), "pose": ("", *get_args(Pose))}
IDEAL = "ideal"


class Difference(NamedTuple):
    """A setting that a policy was trained with otherwise."""

    policy: Policy
    setting: str  # "senses" or "pose"
    trained: str
    here: str


def check_trained_with(policy: Policy) -> None:
    """Raise ValueError unless a policy says of its senses and its pose what there is, or nothing."""
    for setting, known in KNOWN.items():
        one_of(setting, getattr(policy, setting), known)


def known_senses(senses: str | None, pose: str | None) -> dict[str, Any]:
    """Return the fields of a policy for what a caller says of its training; None: nothing."""
    return {"senses": senses or "", "pose": pose or ""}


def senses_of_run(settings: Mapping[str, Any]) -> dict[str, Any]:
    """Return the fields of a policy for the settings of a run of `soccer train`; "" for what it met both ways."""
    share = settings.get("ideal_share", 0.0)
    senses = IDEAL if share == 1.0 else str(settings.get("senses", ""))
    if senses not in KNOWN["senses"]:
        senses = ""
    pose = settings.get("pose", "")
    felt = pose if senses != IDEAL and pose in KNOWN["pose"] else ""  # who is told the truth needs none
    return {"senses": senses if share in (0.0, 1.0) else "", "pose": felt}


def trained_with(policy: Policy) -> dict[str, str]:
    """Return the senses and the pose that a policy was trained with, by its fields or by what its run left in it."""
    fields = {setting: getattr(policy, setting) for setting in KNOWN}
    if any(fields.values()):
        return fields
    try:
        settings = json.loads(policy.made.get("settings", ""))
    except (ValueError, RecursionError):
        return fields
    return senses_of_run(settings) if isinstance(settings, dict) else fields


def policies_in(team: Any) -> Iterator[Policy]:
    """Yield the policies that a team plays: its own, or those of the teams of a lineup."""
    for one in getattr(team, "teams", (team,)):
        policy: Any = getattr(one, "policy", None)
        if hasattr(policy, "made"):
            yield policy


def differences(team: Any, senses: str, pose: str) -> list[Difference]:
    """Return what the policies of a team were trained with and would meet otherwise with some senses and a pose."""
    differing = []
    for policy in policies_in(team):
        known = trained_with(policy)
        if known["senses"] not in ("", senses):
            differing.append(Difference(policy, "senses", known["senses"], senses))
        if senses != IDEAL and known["pose"] not in ("", pose):
            differing.append(Difference(policy, "pose", known["pose"], pose))
    return differing


def tell_of_truth(policy: Policy) -> None:
    """Warn, once in a process, that a policy that observes the truth plays with ideal senses alone."""
    if policy.observe == "truth":
        warn_once(
            f"policy {policy.name!r} observes the truth: it plays only with senses='ideal' (a command takes --senses "
            "ideal); one trained with observe='belief' plays by sensors too"
        )
