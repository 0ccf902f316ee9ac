"""The settings of a training run, from the command line and a TOML file, and what follows from them."""

from __future__ import annotations

from dataclasses import asdict, dataclass, make_dataclass, replace
from pathlib import Path
from typing import Annotated, Any

import tyro

from soccer_env.agents.trained_with import IDEAL, known_senses
from soccer_env.guards.names import unknown
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.leagues.rules import rule_set
from soccer_env.rewards import NAMES, PRESETS, TERMS, Rewards, find_rewards
from soccer_env.scenes import Scene, mixture, scene_names
from soccer_env.train.ppo.options import BOUNDS, LOGS, PlainSettings
from soccer_env.train.ppo.stages import Sizes, Stage, parse_stages
from soccer_env.train.written_settings import (
    CommandSettings,
    command_line,
    layer_sizes,
    split_distinct_names,
    split_senses,
)

FREE = (  # settings that may differ when a run is resumed
    "out", "threads", "ray", "torch_threads", "steps", "anew", "log", "device",
)  # fmt: skip

LAST = "last.safetensors"  # of a run's folder
CRITIC_ROOM = 5  # robots a side for which any critic has room, so that it may go on with larger teams


Weights: Any = make_dataclass(
    "Weights",
    [
        (
            x.name,
            Annotated[float, tyro.conf.arg(help=f"Weight of a reward: {x.text}.")],
            getattr(PRESETS["training"], x.name),
        )
        for x in TERMS
    ],
    frozen=True,
)


@dataclass(frozen=True)
class TrainSettings(Weights, PlainSettings, CommandSettings):  # type: ignore[misc]  # its weights follow from the table of rewards
    """Train a policy by PPO: all robots of the home team share it, other teams play away.

    To resume a run that was stopped, even by kill -9, give the same command again. --config FILE reads settings from a
    TOML file, or from a bundled one by its name (first-win); flags override it. One step is one decision of one
    robot.
    """

    BASIC = "anew"  # the last option that --help shows
    BOUNDS = BOUNDS
    EVEN = {"evaluate_matches": "for each seed is played twice, sides swapped"}

    def __post_init__(self) -> None:
        super().__post_init__()
        if min(self.batch, self.rollout * self.matches) < 2:
            raise ValueError(f"a batch and a rollout must have 2 decisions at least, got batch={self.batch}")
        if self.out == Path() or not str(self.out).isprintable():
            raise ValueError(f"out must be a folder of the run's own with a plain name, got {str(self.out)!r}")
        if self.mirror and self.observe == "percepts":
            raise ValueError(
                "mirror needs observe='belief' or 'truth', as turning signs round mirrors no picture: give --no-mirror"
            )
        if self.actions == "skills" and self.memory:
            raise ValueError("actions='skills' can have no memory of the policy's own: give --memory 0")
        if split_senses(self.senses)[0] != "ideal" and self.observe == "truth":
            raise ValueError(
                "observe='truth' needs senses='ideal', as the policy will when it plays: give --senses ideal"
            )
        self.sizes, self.hidden_sizes, self.critic_sizes, self.opponent_names, self.judges  # noqa: B018  # check texts
        self.scene, self.paid, self.logs  # noqa: B018  # the same

    @property
    def stages(self) -> tuple[Stage, ...]:
        """Return the stages of the run."""
        return parse_stages(self.players, self.opponents)

    @property
    def sizes(self) -> tuple[Sizes, ...]:
        """Return the team sizes (home, away) of all stages."""
        return tuple(dict.fromkeys(sizes for stage in self.stages for sizes in stage.sizes))

    @property
    def opponent_names(self) -> tuple[str, ...]:
        """Return the names of the opponents in training, of all stages."""
        return tuple(dict.fromkeys(name for stage in self.stages for name in stage.opponents))

    @property
    def critic_room(self) -> int:
        """Return the robots a side for which the critic's state has room, 0 without a state."""
        return max(CRITIC_ROOM, *(max(sizes) for sizes in self.sizes)) if self.central_critic else 0

    @property
    def decision_time(self) -> float:
        """Return the duration [s] of a decision."""
        return self.action_repeat / self.played.control_rate

    @property
    def gamma(self) -> float:
        """Return the discount factor of a decision."""
        return half_life_factor(self.decision_time, self.discount_half_life)

    @property
    def gae_lambda(self) -> float:
        """Return the lambda of the generalised advantage estimate for a decision."""
        return half_life_factor(self.decision_time, self.advantage_half_life)

    @property
    def played(self) -> League:
        """Return the league with the rules under which the run plays."""
        league = find_league(self.league)
        return replace(league, rules=rule_set(league.rules, self.rules))

    @property
    def paid(self) -> Rewards:
        """Return the rewards of the run: a user's own, or the built-in terms with the weights of the settings."""
        own = {name: getattr(self, name) for name in NAMES}
        return find_rewards(self.rewards) if self.rewards else Rewards(**own)

    @property
    def named(self) -> list[str]:
        """Return the values of all settings that may name code as MODULE:NAME."""
        scenes = scene_names(self.scenes)
        return [self.league, self.rewards, *scenes, *self.opponent_names, *self.judges]

    @property
    def scene(self) -> Scene:
        """Return the scene, or mixture of scenes, in which episodes begin."""
        return mixture(self.scenes)

    @property
    def start_file(self) -> Path | None:
        """Return the policy file to start from, the last one of a run's folder; None: from nothing."""
        if not self.start:
            return None
        return Path(self.start) / LAST if Path(self.start).is_dir() else Path(self.start)

    @property
    def own_senses(self) -> dict[str, Any]:
        """Return the fields of `Policy` that record the senses and pose used in training."""
        senses, _ = split_senses(self.senses)
        return known_senses(senses, None if senses == IDEAL else self.pose)  # ideal senses need no pose

    @property
    def hidden_sizes(self) -> tuple[int, ...]:
        """Return the sizes of the actor's hidden layers."""
        return layer_sizes("hidden", self.hidden)

    @property
    def critic_sizes(self) -> tuple[int, ...]:
        """Return the sizes of the critic's hidden layers."""
        return layer_sizes("critic", self.critic)

    @property
    def logs(self) -> tuple[str, ...]:
        """Return the names of the optional logs; ValueError for an unknown log."""
        asked = split_distinct_names("log", self.log) if self.log else ()
        for kind in asked:
            if kind not in LOGS:
                raise ValueError(unknown("log", kind, LOGS))
        return asked

    @property
    def judges(self) -> tuple[str, ...]:
        """Return the names of the opponents in evaluations."""
        return split_distinct_names("evaluate_against", self.evaluate_against)

    def as_dict(self) -> dict[str, Any]:
        """Return the settings as plain values."""
        return {**asdict(self), "out": str(self.out)}

    def decisive(self) -> dict[str, Any]:
        """Return the settings that must be equal when a run is resumed."""
        return {name: value for name, value in self.as_dict().items() if name not in FREE}


def half_life_factor(duration: float, half_life: float) -> float:
    """Return the factor per `duration` that halves a weight after each `half_life`: 0.5^(duration / half_life)."""
    return float(0.5 ** (duration / half_life))


def command_of(settings: TrainSettings) -> str:
    """Return the command line of `soccer train` that has these settings."""
    return command_line("train", settings)


def senses_of(senses: str) -> dict[str, str]:
    """Convert a text such as "ideal" or "home=ideal,away=sensors" to the argument `senses` of `Match`."""
    return dict(zip(("home", "away"), split_senses(senses), strict=True))
