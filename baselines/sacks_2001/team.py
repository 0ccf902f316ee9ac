"""The teams sacks-2001, sacks-2001-future and sacks-2001-tuned: one kernel, three sets of settings.

`k`: the league's constants; `play`: the team's settings.
"""

from typing import Any

from soccer_env.baselines.sacks_2001.ball_notes import NEVER
from soccer_env.baselines.sacks_2001.memory import MEMORY
from soccer_env.baselines.sacks_2001.planner import decide
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.compiled import compiled
from soccer_env.skills.deciding import apply_strength, keep_decision, must_decide
from soccer_env.skills.sight import SIGHT, fill_sight
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import per_player

FAMILIES = ("legged",)
EXPLAINS = "soccer_env.baselines.sacks_2001.explaining:EXPLANATION"
TUNED = {"step_length": 0.06, "near_step": 1.0, "choose_shots": True}
FUTURE = {"passes": True, "keeper_speed": True, "keeper_blocks": True, "free_side": True, "decisive": True}


def team(strength: float = 1.0, **changes: Any) -> CompiledTeam:
    """Return sacks-2001; `changes` are settings by name. ValueError for an unknown name or an invalid value."""
    settings = SacksSettings().changed({"strength": strength, **changes})
    return CompiledTeam("sacks-2001", KERNEL, MEMORY, settings.record(), FAMILIES, settings, explains=EXPLAINS)


def team_with_future_work(strength: float = 1.0, **changes: Any) -> CompiledTeam:
    """Return the team with the paper's future work: passes, better goalkeeper, sidesteps and decisions."""
    settings = SacksSettings().changed({"strength": strength, **FUTURE, **changes})
    return CompiledTeam("sacks-2001-future", KERNEL, MEMORY, settings.record(), FAMILIES, settings, explains=EXPLAINS)


def tuned(strength: float = 1.0, **changes: Any) -> CompiledTeam:
    """Return the team with numbers that play better here than the paper's (the team's page lists them)."""
    settings = SacksSettings().changed({"strength": strength, **TUNED, **changes})
    return CompiledTeam("sacks-2001-tuned", KERNEL, MEMORY, settings.record(), FAMILIES, settings, explains=EXPLAINS)


@compiled
def act(belief, tracks, memory, noise, command, k, play, sight):
    """Make a new decision if it is due, else repeat the last command."""
    if memory.begun == 0:
        memory.begun = 1
        memory.had_ball = NEVER
        memory.role_clock = -1.0
    if not must_decide(belief, memory, command, k):
        return
    apply_strength(sight, memory, noise, k, 1.0 - play.strength, play.weak_wait, play.weak_aim, play.weak_pace)
    fill_sight(sight, belief, tracks, k)
    decide(belief, tracks, memory, command, sight, k, play, sight.elapsed)
    keep_decision(memory, command)


KERNEL = per_player(act, SIGHT)
