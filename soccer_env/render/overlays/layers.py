"""From flags and a moment to overlays; a flag that has nothing to show says why in a corner of the picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from soccer_env.render.colours import TEAM_NAMES
from soccer_env.render.overlays.belief import belief_overlays, belief_words
from soccer_env.render.overlays.cast import Cast, Snapshot
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.render.overlays.forces import force_arrows, force_target, has_forces
from soccer_env.render.overlays.panels import CameraPicture, TextPanel
from soccer_env.render.overlays.paths import ball_trail, plan_overlays, planned_path, travelled_path_overlay
from soccer_env.render.overlays.roles import ranger_beams, role_labels, selection_ring
from soccer_env.render.overlays.shapes import Overlay
from soccer_env.render.overlays.sight import sight_overlays
from soccer_env.thoughts.thought import Thought

LEAST_UNIT = 0.7  # of sizes in a picture of 960 px: letters stay legible in smaller ones


class LayerInput(NamedTuple):
    """The input of a layer: one moment, and the selected robot."""

    cast: Cast
    shot: Snapshot
    past: Sequence[Snapshot]  # the latest last, `shot` not among them
    row: int  # of the selected robot
    thought: Thought | None  # of that robot
    unit: float  # [1] scale of lines and letters

    @property
    def name(self) -> str:
        """Return the robot's name for people, such as "red 1"."""
        robot = self.shot.robots[self.row]
        return f"{TEAM_NAMES[int(robot['team'])]} {int(robot['number'])}"


def make_overlays(
    flags: OverlayFlags, cast: Cast, shot: Snapshot, past: Sequence[Snapshot], width: int
) -> list[Overlay]:
    """Return the overlays of the flags in the order of drawing; the picture's `width` [px] scales them."""
    if not flags.any:
        return []
    row = cast.selected_row(flags, shot)
    look = LayerInput(cast, shot, past, row, cast.thought(shot, row), max(LEAST_UNIT, width / 960.0))
    overlays: list[Overlay] = []
    words: list[str] = []
    for name, layer in LAYERS.items():
        if getattr(flags, name):
            drawn, lines = layer(look)
            overlays += drawn
            words += lines
    if flags.belief or flags.sight or flags.field or flags.path:
        overlays.insert(0, selection_ring(look))
    if flags.sight and cast.camera is not None and look.thought is not None and "head" in look.thought.groups:
        overlays.append(CameraPicture(look))
    if words:
        overlays.append(TextPanel(tuple(dict.fromkeys(words)), look.unit, not shot.robots["active"].all()))
    return overlays


Drawn = tuple[list[Overlay], list[str]]


def why_thoughts_unknown(look: LayerInput) -> str:
    """Return why the robot's thoughts are unknown, "" if they are known."""
    if look.cast.reader is None or look.shot.note is None:
        return look.cast.why_no_notes
    if look.thought is None or not look.thought.knows:
        return f"{look.name} believes nothing"
    return ""


def show_belief(look: LayerInput) -> Drawn:
    """Return overlays of the beliefs of the selected robot and a line of text, or the reason why there are none."""
    why = why_thoughts_unknown(look)
    if why or look.thought is None:
        return [], [f"belief: {why}"]
    return belief_overlays(look.cast, look.shot, look.row, look.thought, look.unit), [
        belief_words(look.name, look.thought)
    ]


def show_sight(look: LayerInput) -> Drawn:
    """Return overlays of the percepts of the selected robot's camera, or the reason why there are none."""
    groups = {} if look.thought is None else look.thought.groups
    by_head = "head" in groups and look.cast.camera is not None
    if not (by_head or (groups and look.cast.rays)):
        known = look.cast.reader is not None and look.shot.note is not None
        return [], [f"sight: {'no camera was played or noted' if known else look.cast.why_no_notes}"]
    return sight_overlays(look.cast, look.shot, look.row, groups, look.unit), []


def show_field(look: LayerInput) -> Drawn:
    """Return overlays of the potential field of the selected robot's team, or the reason why there are none."""
    part = look.cast.parts.get(look.row)
    if part is None or not has_forces(part):
        who = "a learner" if part is None else part.name
        return [], [f"field: {who} computes no forces"]
    why = why_thoughts_unknown(look)
    if why or look.thought is None:
        return [], [f"field: {why}"]
    target = force_target(part, look.thought)
    if target is None:
        return [], [f"field: {look.name} plans no way now"]
    return force_arrows(look.cast, look.shot, look.row, look.thought, target, look.unit), []


def show_path(look: LayerInput) -> Drawn:
    """Return overlays of the selected robot's planned and travelled paths, or the reason why there is no plan."""
    overlays = travelled_path_overlay(look.past, look.shot, look.row, look.cast.league.control_rate, look.unit)
    part = look.cast.parts.get(look.row)
    if part is None or part.explanation is None or part.explanation.plan is None:
        return overlays, [f"path: {'a learner' if part is None else part.name} plans no ways; travelled only"]
    why = why_thoughts_unknown(look)
    if why or look.thought is None:
        return overlays, [f"path: {why}"]
    if "plan" not in look.thought.groups:
        return overlays, ["path: no plans were noted"]
    return overlays + plan_overlays(planned_path(look.thought), look.unit), []


def show_roles(look: LayerInput) -> Drawn:
    """Return labels for the activity of every robot, or the reason why there are none."""
    overlays = role_labels(look.cast, look.shot, look.unit)
    if overlays:
        return overlays, []
    known = look.cast.reader is not None and look.shot.note is not None
    return [], [f"roles: {'these teams tell none' if known else look.cast.why_no_notes}"]


def show_infrared(look: LayerInput) -> Drawn:
    """Return overlays of the beams of the infrared rangers, or the reason why there are none."""
    if not look.cast.ranger:
        return [], [f"infrared: robots of {look.cast.league.name} have no ranger"]
    if look.cast.reader is None or look.shot.note is None:
        return [], [f"infrared: {look.cast.why_no_notes}"]
    return ranger_beams(look.cast, look.shot, look.unit), []


def show_trail(look: LayerInput) -> Drawn:
    """Return overlays of the trail of the ball."""
    return ball_trail(look.past, look.shot, look.cast.league.control_rate, look.unit), []


LAYERS = {
    "field": show_field, "sight": show_sight, "trail": show_trail, "path": show_path, "infrared": show_infrared,
    "belief": show_belief, "roles": show_roles,
}  # fmt: skip
