"""The teams heinemann-2006 and weigel-2001: one kernel, two settings of its planner.

`k`: the league's constants; `play`: the team's settings.
"""

from typing import Any

from soccer_env.baselines.heinemann_2006.memory import MEMORY, SCRATCH
from soccer_env.baselines.heinemann_2006.playing import decide
from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings, settings_records
from soccer_env.compiled import compiled
from soccer_env.skills.deciding import apply_strength, keep_decision, must_decide
from soccer_env.skills.sight import fill_sight
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import per_player

FAMILIES = ("middle-size",)
EXPLAINS = "soccer_env.baselines.heinemann_2006.explaining:EXPLANATION"


def team(strength: float = 1.0, **changes: Any) -> CompiledTeam:
    """Return heinemann-2006; `changes` are settings by name. ValueError for an unknown name or an invalid value."""
    return make_variant("heinemann-2006", {"strength": strength, **changes})


def weigel(strength: float = 1.0, **changes: Any) -> CompiledTeam:
    """Return the team with the planner of Weigel et al., which treats other robots as standing still.  MH17"""
    return make_variant("weigel-2001", {"strength": strength, "planner": "static", **changes})


def make_variant(name: str, changes: dict[str, Any]) -> CompiledTeam:
    """Return a team called `name`, with some settings changed."""
    settings = HeinemannSettings().changed(changes)
    return CompiledTeam(name, KERNEL, MEMORY, settings_records(settings), FAMILIES, settings, explains=EXPLAINS)


@compiled
def act(belief, tracks, memory, noise, command, k, play, scratch):
    """Make a new decision if it is due, else repeat the last command."""
    if not must_decide(belief, memory.skill, command, k):
        return
    weakness, skills = 1.0 - play.strength, play.skills
    apply_strength(scratch.sight, memory.skill, noise, k, weakness, play.laziest, play.crookedest, play.slowest)
    wait_for_cycle(scratch.sight, memory.skill, k, play)
    fill_sight(scratch.sight, belief, tracks, k)
    decide(belief, command, memory, noise, k, play, scratch)
    command.kick *= 1.0 - weakness * (1.0 - skills.softest)
    keep_decision(memory.skill, command)


@compiled
def wait_for_cycle(sight, skill, k, play):
    """Set the wait until the next decision to one control cycle, if a cycle is longer than a control step.  MH03"""
    if play.cycle > 1.5 * k.dt:
        skill.wait = max(skill.wait, play.cycle - 0.5 * k.dt)
        sight.elapsed = max(sight.elapsed, play.cycle)


KERNEL = per_player(act, SCRATCH)
