"""The kernel of policies with actions="skills": a player keeps a skill until it decides again, and carries it out.

Of the skills that apply it takes the one with the greatest output, as a learner that chooses without chance.

`k`: the league's constants.
"""

import numpy as np

from soccer_env.agents.perceptron import AT_ONCE, REPEAT, act, action_size, widest_layer
from soccer_env.compiled import compiled, scratch_records
from soccer_env.compiling.borrowing import borrow_arrays, keep_alive
from soccer_env.guards.ranges import COUNT, FLAG, ranged_record
from soccer_env.skills.choices import STAND, applies, play_skill
from soccer_env.skills.settings import MEMORY as SKILL_MEMORY
from soccer_env.skills.sight import SIGHT, fill_sight

MEMORY = ranged_record(
    [
        ("begun", "i8", FLAG),  # 1 once the episode has begun
        ("wait", "i8", COUNT),  # [control steps] until the next decision
        ("choice", "i8", COUNT),  # number of one of SKILLS; the first is to stand
        ("skill", SKILL_MEMORY),
    ]
)


@compiled
def skilled_slice(
    observations, beliefs, tracks, memory, noise, commands, players, constants, settings, first, last
):  # fmt: skip
    """Write the commands of all players of a slice of matches; memory (M, P) has a column for each of `players`.

    settings: the network's numbers, and the settings (3,) of the skills.
    """
    numbers, k = settings[0], constants[0]
    owned, play = scratch_records(1, SIGHT), settings[1][k.drive_kind]
    beliefs, tracks, memory, noise, commands = borrow_arrays((beliefs, tracks, memory, noise, commands))
    work = borrow_arrays(owned)
    scratch, values = np.empty((3, widest_layer(numbers))), np.empty(action_size(numbers))
    for m in range(first, last):
        for p in range(len(players)):
            r, kept = players[p], memory[m, p]
            if is_due(kept, numbers, k):
                act(numbers, observations[m, r], values, scratch[:2, :0], scratch)
                kept.choice = best_skill(values, beliefs[m, r], tracks[m, r], kept.skill, k, play, work[0])
            play_skill(
                kept.choice, beliefs[m, r], tracks[m, r], kept.skill, noise[m, r], commands[m, r], k, play, work[0]
            )
    keep_alive(owned)


@compiled
def is_due(kept, numbers, k):
    """Count a player's control steps until it decides, and tell whether that is now."""
    repeat = int(numbers[REPEAT])
    if kept.begun == 0:
        kept.begun = 1
        kept.wait = 0 if numbers[AT_ONCE] != 0.0 else -k.delay_steps % repeat
    due = kept.wait == 0
    kept.wait = (repeat if due else kept.wait) - 1
    return due


@compiled
def best_skill(values, belief, tracks, memory, k, play, sight):
    """Return the number of the skill with the greatest of the values (n,) among those that apply."""
    if belief.situation.active == 0 or belief.situation.placing == 1:
        return STAND
    fill_sight(sight, belief, tracks, k)
    best, greatest = STAND, -np.inf
    for choice in range(len(values)):
        if values[choice] > greatest and applies(choice, belief, sight, memory, k, play):
            best, greatest = choice, values[choice]
    return best
