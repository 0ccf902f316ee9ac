"""The senses that a policy was trained with, stored in its file, and their differences from those of a match.

`senses` says what filled the beliefs of its robots ("sensors" or "ideal"), `pose` where their poses came from
("percept" or "particles"); "": unknown, or both.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, NamedTuple, get_args

from soccer_env.agents.rules_known import warn_once
from soccer_env.guards.checking import check_choice
from soccer_env.match.arguments import Pose, Senses

if TYPE_CHECKING:
    from soccer_env.agents.policy import Policy

KNOWN = {"senses": ("", *get_args(Senses)), "pose": ("", *get_args(Pose))}
IDEAL = "ideal"


class Difference(NamedTuple):
    """A setting of a match that differs from a policy's training."""

    policy: Policy
    setting: str  # "senses" or "pose"
    trained: str
    here: str


def check_trained_with(policy: Policy) -> None:
    """Raise ValueError unless a policy's senses and pose of training are known values or empty."""
    for setting, known in KNOWN.items():
        check_choice(setting, getattr(policy, setting), known)


def known_senses(senses: str | None, pose: str | None) -> dict[str, Any]:
    """Return the policy fields for the senses and pose of its training; None: unknown."""
    return {"senses": senses or "", "pose": pose or ""}


def policies_in(team: Any) -> Iterator[Policy]:
    """Yield the policy of a team, or the policies of the teams in a lineup."""
    for one in getattr(team, "teams", (team,)):
        policy: Any = getattr(one, "policy", None)
        if hasattr(policy, "made"):
            yield policy


def training_differences(team: Any, senses: str, pose: str) -> list[Difference]:
    """Return each difference between the training of a team's policies and these senses and pose."""
    differing = []
    for policy in policies_in(team):
        if policy.senses not in ("", senses):
            differing.append(Difference(policy, "senses", policy.senses, senses))
        if senses != IDEAL and policy.pose not in ("", pose):
            differing.append(Difference(policy, "pose", policy.pose, pose))
    return differing


def warn_if_observing_truth(policy: Policy) -> None:
    """Warn, once per process, if a policy observes the truth, since it then needs ideal senses."""
    if policy.observe == "truth":
        warn_once(
            f"policy {policy.name!r} observes the truth: it plays only with senses='ideal' (a command takes --senses "
            "ideal); one trained with observe='belief' plays by sensors too"
        )
