"""Teams that play a trained policy: the bundled teams `learned` and `learned-2006`, and the teams of policy files.

A decision is kept for `action_repeat` control steps. The walk of a legged robot is latched when a gait step ends, so
decisions come just early enough for that: the first one `first_decision_step` control steps into an episode.
Until then a robot stands. A policy with a memory keeps its states beside the decision, in a player's memory, so that
they are saved, loaded, branched and hashed with the match, and are 0 when an episode begins.

A policy with actions="skills" takes, of the skills that apply, the one with the greatest output, or draws one where it
has a temperature, and carries it out by its own belief until it decides again.

`k`: the league's constants; `play`: the numbers of the skills.
"""

from math import exp
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.agents.perceptron import (
    AT_ONCE,
    REPEAT,
    TEMPERATURE,
    act,
    action_size,
    memory_size,
    pack_policy,
    widest_layer,
)
from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import dump, load, parse
from soccer_env.agents.recurrent import MAX_MEMORY
from soccer_env.compiled import compiled, scratch_records
from soccer_env.compiling.borrowing import borrow_arrays, keep_alive
from soccer_env.guards.names import Made
from soccer_env.guards.ranges import COUNT, FLAG, NUMBER, UNIT, ranged_record
from soccer_env.leagues.league import League
from soccer_env.observations import entry_names
from soccer_env.random_numbers import draw_uniform
from soccer_env.skills.choices import STAND, applies, play_skill
from soccer_env.skills.deciding import TEAM
from soccer_env.skills.settings import MEMORY as SKILL_MEMORY
from soccer_env.skills.settings import fitted, skill_settings
from soccer_env.skills.sight import SIGHT, fill_sight
from soccer_env.teams import ObservingTeam

POLICIES = Path(__file__).parent / "policies"
BUNDLED = POLICIES / "learned.safetensors"
BUNDLED_2006 = POLICIES / "learned-2006.safetensors"
DECISION = [
    ("begun", "i8", FLAG),  # 1 once the episode has begun
    ("wait", "i8", COUNT),  # [control steps] until the next decision
    ("action", "f8", NUMBER, (7,)),  # forward, left, turn, kick, head, pan, tilt
]
MEMORY = ranged_record(DECISION)
# States of a memory and its mirror come first, or numba takes the record for a MEMORY.
STATES = ranged_record([("states", "f8", UNIT, (2, MAX_MEMORY)), *DECISION])
SKILLED = ranged_record(
    [
        ("begun", "i8", FLAG),  # 1 once the episode has begun
        ("wait", "i8", COUNT),  # [control steps] until the next decision
        ("choice", "i8", COUNT),  # number of one of SKILLS; the first is to stand
        ("skill", SKILL_MEMORY),
    ]
)
HEAD = 4  # index of the head mode in an action


class LearnedTeam(ObservingTeam):
    """A team that plays a trained policy."""

    policy: Policy

    def __reduce__(self) -> Made:
        """Pickle or copy the team as the bytes of its policy file."""
        return rebuild_team, (dump(self.policy), bool(self.settings[AT_ONCE]))

    def check_league(self, league: League) -> None:
        """Raise ValueError if the policy cannot play in this league; warn if the rules differ from the training."""
        self.policy.check_plays(league)
        self.policy.warn_of_other_rules(league)

    def settings_in(self, league: League) -> Any:
        """Return the network, which reads its inputs by their names in the league's observation; `skilled`: a pair."""
        numbers = self.settings  # itself: past selves change while a match runs
        if list(self.policy.inputs) != entry_names(league, self.policy.observe):
            numbers = pack_policy(self.policy, bool(self.settings[AT_ONCE]), self.policy.columns(league))
        return (numbers, fitted(skill_settings(), league)) if self.skilled else numbers


def team_from_policy(policy: Policy, at_once: bool = False) -> LearnedTeam:
    """Return a team that plays a policy; `at_once`: it decides in the first step of an episode."""
    skilled = policy.actions == "skills"
    kernels: list[tuple[Any, np.dtype]] = [(decide_slice, MEMORY), (remember_slice, STATES), (skilled_slice, SKILLED)]
    kernel, memory = kernels[2 if skilled else bool(policy.memory)]
    made = LearnedTeam(
        policy.name, kernel, memory, pack_policy(policy, at_once), (policy.family,), observe=policy.observe,
        skilled=skilled,
    )  # fmt: skip
    object.__setattr__(made, "policy", policy)
    return made


def rebuild_team(data: bytes, at_once: bool) -> LearnedTeam:
    """Rebuild a pickled team from the bytes of its policy file."""
    return team_from_policy(parse(data, "a pickled team"), at_once)


def from_file(path: str | Path) -> LearnedTeam:
    """Return the team of a policy file; ValueError for an invalid file."""
    policy = load(Path(path))
    return team_from_policy(policy, policy.at_once)


def from_zip(
    path: str | Path, league: str | League = "legged-2001", observe: str = "truth", action_repeat: int = 1,
    activation: str | None = None, at_once: bool = True, pose: str | None = None, senses: str | None = None,
    rules: str | None = None,
) -> LearnedTeam:  # fmt: skip
    """Return the team of a stable-baselines3 zip whose policy was trained through this package with these settings.

    at_once: episodes began with a decision, as in the APIs; False for `train.vec_env.SoccerVecEnv`. pose, senses,
    rules: of the training; None: unknown, and evaluations then set neither pose nor senses.
    """
    from soccer_env.agents.sb3_zip import load_sb3

    policy = load_sb3(
        path, league=league, observe=observe, action_repeat=action_repeat, activation=activation, pose=pose,
        senses=senses, rules=rules,
    )  # fmt: skip
    return team_from_policy(policy, at_once)


def team(strength: float = 1.0) -> LearnedTeam:
    """Return the bundled team of the legged league; ValueError for a strength, since a learned team has none."""
    return bundled_team("learned", BUNDLED, strength)


def team_2006(strength: float = 1.0) -> LearnedTeam:
    """Return the bundled team of the middle size; ValueError for a strength, since a learned team has none."""
    return bundled_team("learned-2006", BUNDLED_2006, strength)


def bundled_team(name: str, file: Path, strength: float) -> LearnedTeam:
    """Return the team of a bundled policy file."""
    if strength != 1.0:
        raise ValueError(f"team {name!r} has no strength, got {strength:g}")
    return from_file(file)


def first_decision_step(delay_steps: int, repeat: int) -> int:
    """Return the control steps before the first decision, so that its delayed motion begins a gait step."""
    return -delay_steps % repeat


@compiled
def decide_slice(observations, memory, commands, players, constants, numbers, first, last):
    """Write the commands of all players of a slice of matches; memory (M, P) has a column for each of `players`."""
    scratch = np.empty((3, widest_layer(numbers)))
    for m in range(first, last):
        for p in range(len(players)):
            kept, states = memory[m, p], scratch[:2, :0]
            decide(numbers, observations[m, players[p]], kept, states, constants[0], scratch)
            write_action(commands[m, players[p]], kept.action)


@compiled
def remember_slice(observations, memory, commands, players, constants, numbers, first, last):
    """Write the commands of all players of a slice of matches, as `decide_slice`, by a policy with a memory."""
    scratch, units = np.empty((3, widest_layer(numbers))), memory_size(numbers)
    for m in range(first, last):
        for p in range(len(players)):
            kept = memory[m, p]
            decide(numbers, observations[m, players[p]], kept, kept.states[:, :units], constants[0], scratch)
            write_action(commands[m, players[p]], kept.action)


@compiled
def decide(numbers, observation, kept, states, k, scratch):
    """Let one player wait, or decide and update the states (2, units) of its policy's memory."""
    if kept.begun == 0:
        kept.action[HEAD] = -1.0
    if is_due(kept, numbers, k):
        act(numbers, observation, kept.action[: action_size(numbers)], states, scratch)


@compiled
def write_action(command, action):
    """Write an action of the policy into a robot's command."""
    command.forward, command.left, command.turn = action[0], action[1], action[2]
    command.kick = action[3]
    command.head = action[HEAD]
    command.pan = action[5]
    command.tilt = action[6]


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
                weigh_skills(values, numbers[TEMPERATURE], beliefs[m, r], tracks[m, r], kept.skill, k, play, work[0])
                kept.choice = choose_skill(values, noise[m, r])
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
def weigh_skills(values, temperature, belief, tracks, memory, k, play, sight):
    """Turn a network's values (n,) into weights: exp(value / temperature), or 1 for the greatest value alone.

    Skills that do not apply have the weight 0.
    """
    fill_sight(sight, belief, tracks, k)
    plays = belief.situation.active == 1 and belief.situation.placing == 0
    best, greatest = STAND, -np.inf
    for choice in range(len(values)):
        if not (plays and applies(choice, belief, sight, memory, k, play)):
            values[choice] = -np.inf
        elif values[choice] > greatest:
            best, greatest = choice, values[choice]
    for choice in range(len(values)):
        if temperature > 0.0 and plays:
            values[choice] = exp((values[choice] - greatest) / temperature)
        else:
            values[choice] = 1.0 if choice == best else 0.0


@compiled
def choose_skill(weights, noise):
    """Return the number of a skill drawn by weights (n,); a weight that stands alone costs no random number."""
    total = weights.sum()
    left = draw_uniform(noise, TEAM) * total if total > weights.max() else 0.0
    for choice in range(len(weights)):
        left -= weights[choice]
        if left < 0.0:
            return choice
    return int(np.argmax(weights))
