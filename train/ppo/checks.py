"""Check that a training run can be played, before any file is written."""

import datetime
import hashlib
import json
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from itertools import product
from math import ceil
from pathlib import Path

from soccer_env.agents.policy import Policy
from soccer_env.agents.policy_file import load
from soccer_env.agents.recurrent import memory_units
from soccer_env.guards.checking import short_repr
from soccer_env.train.cluster import Workers
from soccer_env.train.ppo.curriculum import Curriculum
from soccer_env.train.ppo.learner import check_device
from soccer_env.train.ppo.match_blocks import split_matches
from soccer_env.train.ppo.networks import blank_policy, widened_policy
from soccer_env.train.ppo.reporting.loggers import check_packages
from soccer_env.train.ppo.reports import policy_contest
from soccer_env.train.ppo.settings import TrainSettings, command_of, senses_of
from soccer_env.train.ppo.stages import Sizes
from soccer_env.train.ppo.updating.matches import Matches, open_matches
from soccer_env.train.provenance import commit, version_of
from soccer_env.train.written_settings import split_variation

TRAINING_SEED = 3_000_017  # added to the run's seed: a policy is not evaluated on matches that it was trained on


def check_playable(settings: TrainSettings) -> None:
    """Raise ValueError, with the setting's name, for teams, sizes or times with which a run cannot be played."""
    check_device(settings.device)
    check_packages(settings.logs)
    league = settings.played
    blank = blank_policy(settings, league)
    check_start(settings, blank)
    policy = replace(blank, made=policy_origin(settings, 0))
    with name_setting_in_error("opponents"):
        curriculum = make_curriculum(settings)
        for sizes in settings.sizes:
            make_matches(replace(settings, matches=1), curriculum, [sizes]).close()
    if ceil(60.0 * settings.minutes * league.control_rate - 0.5) % settings.action_repeat:
        least = settings.action_repeat / (60.0 * league.control_rate)  # [min]
        whole = least * max(1, round(settings.minutes / least))
        raise ValueError(
            f"minutes must make whole decisions of {settings.action_repeat} control steps, got {settings.minutes:g}; "
            f"try {whole:.4g}"
        )
    for stage in settings.stages:
        split_matches(stage.sizes, settings.matches)
    with name_setting_in_error("evaluate_against"):
        for sizes, opponent in product(settings.sizes, settings.judges):
            contest = policy_contest(policy, opponent, settings, sizes)
            contest.start("home", [0]).close()
            contest.start("away", [0]).close()


def check_start(settings: TrainSettings, blank: Policy) -> None:
    """Raise ValueError unless the policy file `start`, if given, has the shape of the policy to train (`blank`)."""
    if settings.start_file is None:
        return
    with name_setting_in_error("start"):
        policy = widened_policy(load(settings.start_file), blank.inputs)
        for what in ("family", "control_rate", "observe", "actions", "action_repeat", "activation", "mirror"):
            own, other = getattr(blank, what), getattr(policy, what)
            if own != other:
                told = f"{what} is {short_repr(other)}, the run's {short_repr(own)}"
                raise ValueError(f"policy file {settings.start!r} is of another shape: {told}")
        units = [memory_units(one.memory) for one in (blank, policy)]
        if units[0] != units[1]:
            raise ValueError(f"policy file {settings.start!r} has a memory of {units[1]}, the run {units[0]}")
        shapes = [[weight.shape for weight in one.weights] for one in (blank, policy)]
        if shapes[0] != shapes[1]:
            sizes = ",".join(str(len(bias)) for bias in policy.biases[:-1])
            raise ValueError(f"policy file {settings.start!r} has hidden layers of {sizes}, the run {settings.hidden}")


@contextmanager
def name_setting_in_error(setting: str) -> Iterator[None]:
    """Prefix the message of any ValueError in a `with` block with the name of a setting."""
    try:
        yield
    except ValueError as error:
        raise ValueError(f"{setting}: {error}") from error


@cache
def digest(path: str) -> str:
    """Return the SHA-256 of a file at the first call, since the file may move during a run."""
    return hashlib.sha256(Path(path).read_bytes()).hexdigest()


def policy_origin(settings: TrainSettings, step: int) -> dict[str, str]:
    """Return the origin of a policy for its file: command, settings, versions, without the user's folders."""
    begun = {} if settings.start_file is None else {"start": digest(str(settings.start_file))}
    start = Path(settings.start).name if settings.start else ""
    settings = replace(settings, out=TrainSettings.out, ray=None, start=start)
    return {
        "command": command_of(settings),
        "settings": json.dumps({**settings.decisive(), "steps": settings.steps}, sort_keys=True),  # defaults may change
        **begun,
        "date": datetime.datetime.now(datetime.timezone.utc).date().isoformat(),
        "commit": commit(),
        "seed": str(settings.seed),
        "step": str(step),
        **{name: version_of(name) for name in ("soccer_env", "torch", "stable_baselines3", "pymunk", "numba")},
    }


def make_curriculum(settings: TrainSettings) -> Curriculum:
    """Make the curriculum of a run; a team that stands still fills the places of past selves until there is one."""
    curriculum = Curriculum(settings.opponent_names, settings.past, blank_policy(settings, settings.played))
    curriculum.begin_stage(settings.stages[0].opponents)
    return curriculum


def make_matches(
    settings: TrainSettings, curriculum: Curriculum, sizes: Sequence[Sizes], workers: Workers = 1
) -> Matches:
    """Make the training environment of a stage, in which matches are played at these team sizes.

    Episodes are cut off a decision before half-time: for the learner a match has no end, so that the potential of its
    last state is not paid back and its value is estimated.
    """
    decisions = round(60.0 * settings.minutes / settings.decision_time)
    given = dict(
        league=settings.played, scene=settings.scene, players=sizes, matches=settings.matches,
        opponents=curriculum.lineup, action_repeat=settings.action_repeat, rewards=settings.paid,
        gamma=settings.gamma, state=settings.critic_room, stagger=True, seed=settings.seed + TRAINING_SEED,
        observe=settings.observe, senses=senses_of(settings.senses), pose=settings.pose, actions=settings.actions,
        minutes=2.0 * settings.minutes, max_cycles=max(decisions - 1, 1),
        variation=split_variation(settings.variation),
    )  # fmt: skip
    return open_matches(workers, curriculum, given)
