"""The flags that choose the overlays of a picture, and their robot."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

from soccer_env.guards.checking import CheckedFields, check_names, raise_not_allowed

AT_BALL = "ball"
NUMBERED = re.compile(r"(home|away|red|blue)[ _-]?(\d+)")


@dataclass(frozen=True, kw_only=True)
class OverlayFlags(CheckedFields):
    """The overlays of pictures, films and windows."""

    TITLED = False

    belief: bool = False
    """Beliefs of one robot beside the truth: its pose and particles, the ball, players, with confidence and age."""
    sight: bool = False
    """Field of view of the robot, with the blobs or sightings in it."""
    field: bool = False
    """Potential field that the robot computes from its beliefs, as arrows. Browser pages hold the field of every robot
    once a second, and that of --robot five times a second for another 36 kB a minute."""
    path: bool = False
    """Planned and travelled path of the robot."""
    roles: bool = False
    """Role, behaviour and recovery state of every robot."""
    infrared: bool = False
    """Beam and reading of every robot's infrared ranger."""
    trail: bool = False
    """Trail of the ball over the last seconds."""
    robot: str = AT_BALL
    """Robot whose belief, sight, field and path are shown: home_1 or blue 2, or ball for the robot nearest to it."""

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.robot != AT_BALL and not NUMBERED.fullmatch(self.robot):
            raise_not_allowed("robot", "an agent, as home_1 or blue 2, or ball", self.robot)

    @property
    def any(self) -> bool:
        """Tell whether any overlay is on."""
        return any(getattr(self, name) for name in FLAGS)

    @property
    def need_groups(self) -> bool:
        """Tell whether an overlay needs percepts of the camera or plans: `thoughts.groups`."""
        return self.sight or self.field or self.path or self.infrared

    @property
    def agent(self) -> str | None:
        """Return the agent that `robot` names, None for the robot nearest to the ball."""
        numbered = NUMBERED.fullmatch(self.robot)
        if numbered is None:
            return None
        side = {"red": "home", "blue": "away"}.get(numbered[1], numbered[1])
        return f"{side}_{int(numbered[2])}"

    def turned(self, name: str) -> OverlayFlags:
        """Return the flags with one flag inverted."""
        changed: dict[str, Any] = {name: not getattr(self, name)}
        return replace(self, **changed)


FLAGS = tuple(item.name for item in fields(OverlayFlags) if item.type == "bool")


def parse_flags(overlays: OverlayFlags | Mapping[str, Any] | str | None) -> OverlayFlags:
    """Return the flags of OverlayFlags, a mapping, names as in "belief,trail", or None (no overlay).

    ValueError names an unknown overlay.
    """
    if overlays is None:
        return OverlayFlags()
    if isinstance(overlays, str):
        names = [name.strip() for name in overlays.split(",") if name.strip()]
        check_names("overlay", names, FLAGS)
        overlays = dict.fromkeys(names, True)
    if isinstance(overlays, Mapping):
        check_names("overlay", overlays, (*FLAGS, "robot"))
        return OverlayFlags(**overlays)
    if not isinstance(overlays, OverlayFlags):
        raise_not_allowed("overlays", f"names of {', '.join(FLAGS)}, a mapping of them or OverlayFlags", overlays)
    return overlays


def select_flags(settings: OverlayFlags) -> OverlayFlags:
    """Return only the overlay flags among the fields of larger settings."""
    return OverlayFlags(**{item.name: getattr(settings, item.name) for item in fields(OverlayFlags)})
