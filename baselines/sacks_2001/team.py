"""The teams sacks-2001 and sacks-2001-future, as kernels that decide for all their players in a slice of matches."""

from __future__ import annotations

from typing import Any

from soccer_env.baselines.deciding import apply_strength, keep_decision, must_decide
from soccer_env.baselines.sacks_2001.memory import MEMORY
from soccer_env.baselines.sacks_2001.planner import decide
from soccer_env.baselines.sacks_2001.settings import SacksSettings
from soccer_env.baselines.sacks_2001.sightings import NEVER
from soccer_env.baselines.sight import SIGHT, look
from soccer_env.compiled import compiled, records
from soccer_env.teams import CompiledTeam

LEAGUES = ("legged",)
TUNED = {"step_length": 0.06, "back_steps": 3, "side_steps": 3}
FUTURE = {"passes": True, "keeper_speed": True, "free_side": True, "decisive": True}


def team(strength: float = 1.0, **changes: Any) -> CompiledTeam:
    """Return the team; `changes` are settings by name, ValueError for one that does not exist or cannot be."""
    settings = SacksSettings().changed({"strength": strength, **changes})
    return CompiledTeam("sacks-2001", play, MEMORY, settings.record(), LEAGUES, settings)


def future(strength: float = 1.0, **changes: Any) -> CompiledTeam:
    """Return the team with what the paper leaves to the future: passes, better goalkeeper, sidesteps and decisions."""
    settings = SacksSettings().changed({"strength": strength, **FUTURE, **changes})
    return CompiledTeam("sacks-2001-future", play, MEMORY, settings.record(), LEAGUES, settings)


def tuned(strength: float = 1.0, **changes: Any) -> CompiledTeam:
    """Return the team with other numbers than the paper's: what plays better here, see README.md beside this file."""
    settings = SacksSettings().changed({"strength": strength, **TUNED, **changes})
    return CompiledTeam("sacks-2001-tuned", play, MEMORY, settings.record(), LEAGUES, settings)


@compiled
def play(beliefs, tracks, memory, noise, commands, players, constants, settings, first, last):
    """Command every player of a slice of matches; memory (M, P) is by place in `players`."""
    sight = records(1, SIGHT)
    k, own = constants[0], settings[0]
    for m in range(first, last):
        for p in range(len(players)):
            r = players[p]
            command_player(beliefs[m, r], tracks[m, r], memory[m, p], noise[m, r], commands[m, r], k, own, sight[0])


@compiled
def command_player(belief, tracks, memory, noise, command, k, play, sight):
    """Decide, or repeat the last decision until it is time for the next."""
    if memory.begun == 0:
        memory.begun, memory.had_ball, memory.role_clock = 1, NEVER, -1.0
    if not must_decide(belief, memory, command, k):
        return
    apply_strength(sight, memory, noise, k, 1.0 - play.strength, play.weak_wait, play.weak_aim, play.weak_pace)
    look(sight, belief, tracks, k)
    decide(belief, tracks, memory, command, sight, k, play, sight.elapsed)
    keep_decision(memory, command)
