"""The settings of a training run: what the command line and a TOML file give.

The help of `soccer train` is the text beside each field here.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass, make_dataclass, replace
from pathlib import Path
from typing import Annotated, Any, Literal

import tyro

from soccer_env.agents.trained_with import senses_of_run
from soccer_env.guards.names import unknown
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.leagues.rules import rule_set
from soccer_env.rewards import NAMES, PRESETS, TERMS, Rewards, find_rewards
from soccer_env.scenes import Scene, mixture, names_in
from soccer_env.train.evaluate.replays.choice import Keep
from soccer_env.train.ppo.bounds import BOUNDS, LOGS
from soccer_env.train.written_settings import (
    CommandSettings,
    command_with,
    different,
    layer_sizes,
    split_players,
    split_senses,
)

FREE = (  # may differ when a run goes on
    "out", "threads", "torch_threads", "steps", "anew", "log", "keep", "keep_pages", "device",
)  # fmt: skip


@dataclass(frozen=True)
class PlainSettings:
    """The settings of a training run but for the weights of its rewards."""

    league: str = "legged-2001"
    """League to play in: a name of `soccer list leagues`, or MODULE:NAME of your own."""
    rules: str = "league"
    """Rules to play by: league, simple, none, or a set changed by name: league:pushing=False."""
    name: str = "policy"
    """What the policy calls itself."""
    out: Path = Path("runs/train")
    """Folder of the run: checkpoints, best.safetensors, last.safetensors, logs, learning curve."""
    steps: int = 2_000_000
    """Decisions of learning robots to train for; a finished run goes on if this is raised; 0: by its teacher alone."""
    rewards: str = ""
    """MODULE:NAME of `Rewards` of your own instead of the weights below; "" for those."""
    players: str = "3v3"
    """Players a side; several, mixed in one run, with commas between them: 1v1,2v2,3v3."""
    matches: int = 128
    """Matches side by side, shared among the team sizes."""
    minutes: float = 2.0
    """Minutes of play in a training episode, both halves together."""
    scenes: str = "kick-off"
    """How episodes begin; several with shares: kick-off:0.6,my_module:SCENE:0.4. Play goes on from a drill's start."""
    opponents: str = "still,chaser@0.5,chaser"
    """Teams that play away, with commas between them: names of `soccer list teams`, policy files, or MODULE:NAME. The
    more evenly one is matched, the more often it is met."""
    past: int = 0
    """How many past selves are among the opponents, the oldest giving way to the newest."""
    past_every: int = 40
    """Rollouts between two past selves."""
    observe: Literal["belief", "percepts", "truth"] = "belief"
    """What observations are built from; the truth is for policies that play with ideal senses."""
    senses: str = "sensors"
    """What fills beliefs: sensors, or ideal (the truth); home=ideal,away=sensors for one each."""
    ideal_share: float = 0.0
    """Share of the matches, of every team size, in which all robots have ideal senses instead; it needs belief."""
    pose: Literal["particles", "percept"] = "percept"
    """How robots that use their sensors know where they are: a particle filter, or a noisy pose, which is faster."""
    action_repeat: int = 8
    """Control steps that a decision is kept; 8 is a gait step of the legged league."""
    start: str = ""
    """A policy file of the same shape that the actor begins with, instead of its teacher's lessons; "" for none."""
    teacher: str = "chaser"
    """A team whose decisions the actor is fitted to before PPO begins; "" for none."""
    teacher_steps: int = 300_000
    """Decisions of the teacher to record, over all team sizes and opponents."""
    teacher_epochs: int = 12
    """Times that the recorded decisions are gone through."""
    rounds: int = 0
    """Rounds in which the actor plays, after one of its teacher, and a teacher that knows the truth says what to do."""
    teacher_until: float = 0.0
    """Share of the steps in which the actor is still held to what was recorded, ever less; 0: not at all."""
    critic_first: int = 3
    """Rollouts in which the critic alone learns, so that it does not mislead what the teacher taught."""
    kind: Literal["slots", "attention"] = "slots"
    """How the actor takes in other players: a slot of inputs for each, or attention over them, in whatever order."""
    hidden: str = "64,64"
    """Sizes of the actor's hidden layers."""
    critic: str = "64,64"
    """Sizes of the critic's hidden layers."""
    activation: Literal["tanh", "relu"] = "tanh"
    """Activation of hidden layers."""
    mirror: bool = True
    """Make the actor the mean of a network and its left-right mirror image (observations of truth or belief)."""
    central_critic: bool = True
    """Let the critic see the whole truth of the match (`state()`) as well; the actor never does."""
    learning_rate: float = 3e-4
    """Learning rate of Adam at the start."""
    decay: bool = True
    """Let the learning rate fall linearly to a twentieth at `steps`."""
    gamma: float = 0.99
    """Discount for one decision, of the shaping too."""
    gae_lambda: float = 0.95
    """Lambda of the generalised advantage estimate."""
    clip: float = 0.2
    """How far the ratio of new to old probability may go from 1."""
    rollout: int = 64
    """Decisions of each robot between two updates."""
    batch: int = 4096
    """Decisions in a gradient step, about: a rollout is cut into equal parts, one at least."""
    epochs: int = 4
    """Times that a rollout is gone through."""
    entropy: float = 0.0
    """Weight of the entropy bonus."""
    noise: float = 0.4
    """Standard deviation of the actions at the start."""
    evaluate_every: int = 500_000
    """Steps between two evaluations of the policy, without noise; the best one is kept as best.safetensors."""
    evaluate_matches: int = 40
    """Matches of an evaluation against each of its opponents, even."""
    evaluate_minutes: float = 4.0
    """Minutes of play in them."""
    evaluate_against: str = "chaser@0.5,chaser"
    """Opponents of the evaluations, at the largest team size, as `soccer evaluate` plays: own poses by particles."""
    seed: int = 0
    """Seed of everything; the same settings and seed with one torch thread give the same weights."""
    threads: int = 1
    """Threads that share the matches; the result does not depend on them."""
    torch_threads: int = 1
    """Threads of torch; more than one helps only where cores are idle."""
    device: Literal["auto", "cpu", "cuda"] = "auto"
    """Where the networks are trained: auto takes a GPU if there is one."""
    log: str = ""
    """Further logs, with commas between them: csv, tensorboard, wandb, as stable-baselines3 writes them."""
    keep: str = ""
    """Replays to keep of best.safetensors in its evaluation: best, worst, goals (clips), with commas between them."""
    keep_pages: bool = False
    """Make of every replay that is kept a page for the browser as well."""
    anew: bool = False
    """Remove what an earlier run left in --out instead of going on with it."""


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
    """Train a policy by PPO; all robots of the home team share it, the away team is played by opponents.

    A run that was stopped, even by kill -9, goes on where its last rollout began when the same command is given again.
    --config FILE reads settings from a TOML file, or from a bundled one by its name (legged-2001); flags overrule it.
    One step is one decision of one robot.
    """

    BOUNDS = BOUNDS
    EVEN = {"evaluate_matches": "for each seed is played twice, sides swapped"}

    def __post_init__(self) -> None:
        super().__post_init__()
        if min(self.batch, self.rollout * self.matches) < 2:
            raise ValueError(f"a batch and a rollout must have 2 decisions at least, got batch={self.batch}")
        if self.out == Path() or not str(self.out).isprintable():
            raise ValueError(f"out must be a folder of the run's own with a plain name, got {str(self.out)!r}")
        if self.teacher and not (self.teacher_steps and self.teacher_epochs):
            raise ValueError("a teacher needs teacher_steps and teacher_epochs of at least 1")
        if self.rounds and not (self.teacher and self.observe == "belief"):
            raise ValueError("rounds need a teacher, and observe='belief': the teacher says what to do by beliefs too")
        if self.mirror and self.observe == "percepts":
            raise ValueError(
                "mirror needs observe='belief' or 'truth', as turning signs round mirrors no picture: give --no-mirror"
            )
        if self.kind == "attention" and self.observe == "percepts":
            raise ValueError("kind='attention' needs observe='belief' or 'truth': pictures have no slots for players")
        if self.ideal_share and self.observe != "belief":
            raise ValueError("ideal_share needs observe='belief': nothing else is observed with either senses")
        if split_senses(self.senses)[0] != "ideal" and self.observe == "truth":
            raise ValueError(
                "observe='truth' needs senses='ideal', as the policy will when it plays: give --senses ideal"
            )
        self.sizes, self.hidden_sizes, self.critic_sizes, self.opponent_names, self.judges  # noqa: B018  # check texts
        self.scene, self.paid, self.logs, Keep(self.keep)  # the same

    @property
    def sizes(self) -> tuple[tuple[int, int], ...]:
        """Return the team sizes (home, away)."""
        return tuple(split_players(part, 3) for part in different("players", self.players))

    @property
    def played(self) -> League:
        """Return the league with the rules that are played by."""
        league = find_league(self.league)
        return replace(league, rules=rule_set(league.rules, self.rules))

    @property
    def paid(self) -> Rewards:
        """Return the rewards: a user's own, or those of the weights."""
        own = {name: getattr(self, name) for name in NAMES}
        return find_rewards(self.rewards) if self.rewards else Rewards(**own)

    @property
    def named(self) -> list[str]:
        """Return what may be MODULE:NAME."""
        scenes = names_in(self.scenes)
        return [self.league, self.rewards, self.teacher, *scenes, *self.opponent_names, *self.judges]

    @property
    def scene(self) -> Scene:
        """Return how episodes begin."""
        return mixture(self.scenes)

    @property
    def kinds_of_senses(self) -> list[tuple[float, dict[str, str]]]:
        """Return the share of each kind of matches and what `Match` takes as senses for it."""
        kinds = ((1.0 - self.ideal_share, self.senses), (self.ideal_share, "ideal"))
        return [(share, senses_of(senses)) for share, senses in kinds if share > 0.0]

    @property
    def own_senses(self) -> dict[str, Any]:
        """Return what a policy file says of the senses that its robots learn by, by the fields of `Policy`."""
        own = split_senses(self.senses)[0]
        return senses_of_run({"senses": own, "ideal_share": self.ideal_share, "pose": self.pose})

    @property
    def hidden_sizes(self) -> tuple[int, ...]:
        """Return the sizes of the actor's hidden layers."""
        return layer_sizes("hidden", self.hidden)

    @property
    def critic_sizes(self) -> tuple[int, ...]:
        """Return the sizes of the critic's hidden layers."""
        return layer_sizes("critic", self.critic)

    @property
    def opponent_names(self) -> tuple[str, ...]:
        """Return the opponents' names."""
        return different("opponents", self.opponents)

    @property
    def logs(self) -> tuple[str, ...]:
        """Return the kinds of further logs; ValueError for an unknown one."""
        asked = different("log", self.log) if self.log else ()
        for kind in asked:
            if kind not in LOGS:
                raise ValueError(unknown("log", kind, LOGS))
        return asked

    @property
    def judges(self) -> tuple[str, ...]:
        """Return the names of the opponents of the evaluations."""
        return different("evaluate_against", self.evaluate_against)

    def as_dict(self) -> dict[str, Any]:
        """Return the settings as plain values."""
        return {**asdict(self), "out": str(self.out)}

    def decisive(self) -> dict[str, Any]:
        """Return what a run that goes on must have in common with its beginning."""
        return {name: value for name, value in self.as_dict().items() if name not in FREE}


def command_of(settings: TrainSettings) -> str:
    """Return the command that asks for these settings."""
    return command_with("train", settings)


def senses_of(senses: str) -> dict[str, str]:
    """Return what `Match` takes for "ideal" or "home=ideal,away=sensors"."""
    return dict(zip(("home", "away"), split_senses(senses), strict=True))
