"""Scenes: the start of an episode, and the success test of a drill.

`kick-off` is a match. Drills are named starts with a success test and a time limit.

    scene.py          Scene, and the functions that place robots and the ball
    drills.py         drills of every league
    drills_legged.py  drills of the legged league
    drills_middle.py  drills of the middle-size league
    drills_alone.py   one robot, the ball and the goal
    drills_attacks.py attacks of several robots
    scattered.py      a start in the middle of play
    mixture.py        a scene drawn for each episode
    saved_states.py   starts drawn from the matches of a save
    judging.py        the success tests
"""

import re

from soccer_env.guards.checking import check_names
from soccer_env.guards.names import MODULE_PATH, object_in_module
from soccer_env.scenes.drills import DRILLS
from soccer_env.scenes.drills_alone import DRILLS_ALONE
from soccer_env.scenes.drills_attacks import ATTACKS
from soccer_env.scenes.drills_legged import DRILLS_LEGGED
from soccer_env.scenes.drills_middle import DRILLS_MIDDLE
from soccer_env.scenes.judging import SUCCESS, judge_drill
from soccer_env.scenes.mixture import Mixture
from soccer_env.scenes.saved_states import BEGINS, SavedStates, read_states
from soccer_env.scenes.scattered import SCATTERED
from soccer_env.scenes.scene import Place, Scene, SceneRandom, put_robot, send_away

SHARE = re.compile(rf"({BEGINS}.+):([0-9.]+(?:[eE][+-]?[0-9]+)?)")
KICK_OFF = Scene("kick-off", "a match from the kick-off on")
ALL = (KICK_OFF, SCATTERED, *DRILLS, *ATTACKS, *DRILLS_ALONE, *DRILLS_LEGGED, *DRILLS_MIDDLE)
SCENES = {scene.name: scene for scene in ALL}


def find_scene(scene: str | Scene) -> Scene:
    """Return the scene that a text names, or a given Scene unchanged; ValueError lists the known names."""
    if isinstance(scene, str) and scene.startswith(BEGINS) and split_name_and_share(scene)[0] == scene:
        return read_states(scene)
    chosen = object_in_module("scene", scene, Scene) or scene
    if isinstance(chosen, Scene):
        return chosen
    if isinstance(chosen, str) and not {",", ":"}.isdisjoint(chosen):
        return mixture(chosen)
    check_names("scene", [chosen], SCENES, more="states:FILE")
    return SCENES[chosen]


def is_user_scene(scene: Scene) -> bool:
    """Tell whether a scene, or a part of a mixture, was written by a user."""
    parts = scene.parts if isinstance(scene, Mixture) else (scene,)
    return any(SCENES.get(part.name) != part and not isinstance(part, SavedStates) for part in parts)


def mixture(text: str) -> Scene:
    """Return the mixture of scenes for a text such as "kick-off:0.6,MODULE:NAME:0.4"; a share left out is 1."""
    parts = [split_name_and_share(part.strip()) for part in text.split(",")]
    scenes = tuple(find_scene(name) for name, _ in parts)
    if len({name for name, _ in parts}) < len(parts):
        raise ValueError(f"scenes must be different, got {text!r}")
    try:
        shares = tuple(float(share) for _, share in parts)
    except ValueError:
        raise ValueError(f"scenes must be written as NAME:share,NAME:share, got {text!r}") from None
    return scenes[0] if len(scenes) == 1 else Mixture(text, "one of several scenes", parts=scenes, shares=shares)


def scene_names(text: str) -> list[str]:
    """Return the names, or MODULE:NAME, of the scenes in a text such as "kick-off:0.6,MODULE:NAME:0.4"."""
    return [split_name_and_share(part.strip())[0] for part in text.split(",")]


def split_name_and_share(part: str) -> tuple[str, str]:
    """Split NAME:SHARE, NAME, MODULE:NAME:SHARE or states:FILE:SHARE into the scene's name and its share."""
    if part.startswith(BEGINS):
        found = SHARE.fullmatch(part)
        return (found[1], found[2]) if found else (part, "1")
    if MODULE_PATH.fullmatch(part) and part.partition(":")[0] not in SCENES:
        return part, "1"
    name, colon, share = part.rpartition(":")
    return (name, share) if colon else (share, "1")


__all__ = [
    "SCENES", "SUCCESS", "SceneRandom", "Mixture", "Place", "Scene", "find_scene", "is_user_scene", "judge_drill",
    "mixture",
    "scene_names", "put_robot", "send_away", "split_name_and_share",
]  # fmt: skip
