"""Scenes: how an episode begins, and for drills what counts as success.

`kick-off` is a match. The drills are named starts with a success test and a time limit; more come with the teams
that need them.

    scene.py          what a scene is
    drills.py         drills of every league
    drills_legged.py  drills of the legged league
    drills_alone.py   one legged robot, the ball and the goal
    judging.py        what counts as success
"""

from __future__ import annotations

from soccer_env.checking import check_names
from soccer_env.scenes.drills import DRILLS
from soccer_env.scenes.drills_alone import DRILLS_ALONE
from soccer_env.scenes.drills_legged import DRILLS_LEGGED
from soccer_env.scenes.judging import SUCCESS, judge_drill
from soccer_env.scenes.scene import Draw, Place, Scene, put, send_away

KICK_OFF = Scene("kick-off", "a match from the kick-off on")
SCENES = {scene.name: scene for scene in (KICK_OFF, *DRILLS, *DRILLS_LEGGED, *DRILLS_ALONE)}


def find_scene(scene: str | Scene) -> Scene:
    """Return the scene of that name, or the object itself; ValueError says which names exist."""
    if isinstance(scene, Scene):
        return scene
    check_names("scene", [scene], SCENES)
    return SCENES[scene]


__all__ = ["SCENES", "SUCCESS", "Draw", "Place", "Scene", "find_scene", "judge_drill", "put", "send_away"]
