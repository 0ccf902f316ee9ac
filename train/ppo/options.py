"""The options of a training run, without the weights of its rewards, and the ranges of the numeric ones.

The help of `soccer train` is the text beside each field here.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from soccer_env.agents.recurrent import MAX_MEMORY
from soccer_env.guards.checking import FROM_ZERO, Range
from soccer_env.rewards import NAMES

LOGS = ("csv", "tensorboard", "wandb")  # further logs, each in a folder of that name
MAX_SEED = 2**32 - 1  # of numpy's global generator
SHARE = Range(0.0, 1.0, above=True)
MINUTES = Range(0.0, 10_000.0, above=True, below=True)
SECONDS = Range(0.0, 86_400.0, above=True)
MOST = 65_536
BOUNDS: dict[str, tuple[Any, ...]] = {
    **dict.fromkeys(("action_repeat", "batch", "epochs", "evaluate_every", "past_every", "stage_steps"), Range(1)),
    **dict.fromkeys(("rollout", "matches"), Range(1, MOST)),
    **dict.fromkeys(("steps", "past", "critic_first"), FROM_ZERO),
    **dict.fromkeys(("learning_rate", "target_kl", "stage_share"), SHARE),
    **dict.fromkeys(("discount_half_life", "advantage_half_life"), SECONDS),
    **dict.fromkeys(("minutes", "evaluate_minutes"), MINUTES),
    **dict.fromkeys(NAMES, Range(0.0, 1e9)),
    "evaluate_matches": Range(1),
    "memory": Range(0, MAX_MEMORY),
    "torch_threads": Range(1, 256),
    "noise": Range(0.0, 10.0, above=True),
    "seed": Range(0, MAX_SEED),
}


@dataclass(frozen=True)
class PlainSettings:
    """The settings of a training run, without the weights of its rewards; the basic settings come first."""

    league: str = "legged-2001"
    """League: a name of `soccer list leagues`, or MODULE:NAME of your own."""
    players: str = "3v3"
    """Players a side, 3 or 1v3; several team sizes, trained together, are separated by commas: 1v1,2v2,3v3. Stages of
    the run are separated by semicolons: 1v1;1v1,2v2;2v2,3v3."""
    opponents: str = "still,chaser@0.5,chaser"
    """Away teams, separated by commas: names of `soccer list teams`, policy files, or MODULE:NAME. Evenly matched
    opponents are drawn more often. One list for all stages, or one for each, separated by semicolons."""
    steps: int = 2_000_000
    """Training length in decisions of learning robots. Raise it to train a finished run further."""
    actions: Literal["box", "skills"] = "box"
    """What a decision is: box, how to walk and kick, or skills, which of the skills of the scripted players to use."""
    action_repeat: int = 8
    """Control steps for which a decision is kept; 8 are one gait step of the legged league."""
    out: Path = Path("runs/train")
    """Folder of the run: checkpoints, best.safetensors, last.safetensors, logs, learning curve."""
    seed: int = 0
    """Seed of the run; the same settings and seed give the same weights, with one torch thread."""
    threads: int = 1
    """Number of threads that play matches; the result does not depend on it."""
    ray: str | None = None
    """Play on a Ray cluster: --ray alone starts one on this machine, auto or HOST:PORT joins one. Its cores replace
    --threads, a core for each 64 matches, and the result does not depend on it."""
    anew: bool = False
    """Start afresh: remove an earlier run from --out."""
    rules: str = "league"
    """Rule set: league, simple or none; league:pushing=False changes single rules."""
    name: str = "policy"
    """Name of the policy."""
    rewards: str = ""
    """Rewards of your own, as MODULE:NAME; "" for the terms weighted by the options below."""
    stage_share: float = 0.75
    """Share of the goals in recent training episodes that the run must have scored at every team size of its stage, to
    move on to the next stage."""
    stage_steps: int = 10_000_000
    """Decisions after which a run moves on to the next stage in any case."""
    matches: int = 128
    """Matches played side by side. Each team size of a stage has as many robots as the others, so larger teams have
    fewer matches."""
    minutes: float = 2.0
    """Minutes of play in a training episode. It is a half that is cut off before half-time, so that its last state
    keeps its value."""
    scenes: str = "kick-off"
    """How episodes begin; several scenes take shares: kick-off:0.6,states:FILE:0.4. Play goes on after a drill's
    start."""
    past: int = 0
    """Number of past selves among the opponents; the newest replaces the oldest."""
    past_every: int = 40
    """Number of rollouts after which the present policy becomes a past self."""
    observe: Literal["belief", "percepts", "truth"] = "belief"
    """Source of the observations; truth is for policies that play with ideal senses."""
    senses: str = "sensors"
    """What fills beliefs: sensors, or ideal (the truth); home=ideal,away=sensors for one each."""
    pose: Literal["particles", "percept"] = "percept"
    """How robots with sensors know where they are: by a particle filter, or by a given noisy pose (percept), which is
    faster."""
    variation: str = ""
    """Numbers of the league that differ from episode to episode, as factors: ball.mass=1:2,drive.delay=0.5:2:log."""
    start: str = ""
    """Policy file of the same shape to start from, or the folder of another run, whose critic and noise are taken over
    too; "" to start from nothing."""
    critic_first: int = 3
    """Number of first rollouts in which only the critic learns: an untrained critic would spoil a trained actor."""
    memory: int = 0
    """Units of a recurrent memory (GRU) before the actor's layers, 0 to 128; 0 for none."""
    hidden: str = "64,64"
    """Sizes of the actor's hidden layers, separated by commas."""
    critic: str = "64,64"
    """Sizes of the critic's hidden layers, separated by commas."""
    activation: Literal["tanh", "relu"] = "tanh"
    """Activation of hidden layers."""
    mirror: bool = True
    """Average the actor with its left-right mirror image; needs --observe truth or belief."""
    central_critic: bool = True
    """Give the critic the whole truth of the match (`state()`) too; the actor never sees it."""
    learning_rate: float = 7e-4
    """Learning rate of Adam; the actor's follows the divergence from here on, see target_kl."""
    target_kl: float = 0.01
    """Divergence (KL) between the policies before and after a gradient step. The actor's learning rate is divided by
    1.5 where it is twice as large, and multiplied by 1.5 where it is half as large."""
    discount_half_life: float = 30.0
    """Time [s] after which a reward counts half: the discount of a decision is 0.5^(its duration / this), also in the
    reward shaping."""
    advantage_half_life: float = 3.0
    """Time [s] after which a temporal difference counts half in the generalised advantage estimate, in addition to the
    discount: lambda is 0.5^(duration of a decision / this)."""
    rollout: int = 64
    """Length of a rollout: decisions of each robot between two updates."""
    batch: int = 4096
    """Approximate number of decisions in a gradient step; a rollout is cut into equal parts."""
    epochs: int = 4
    """Epochs of an update: passes over a rollout."""
    noise: float = 0.5
    """Initial standard deviation of the actions."""
    evaluate_every: int = 500_000
    """Steps between two evaluations, which play without noise; the best policy is kept as best.safetensors."""
    evaluate_matches: int = 40
    """Matches per opponent in an evaluation; an even number."""
    evaluate_minutes: float = 4.0
    """Minutes of play in a match of an evaluation."""
    evaluate_against: str = "chaser@0.5,chaser"
    """Opponents of the evaluations, separated by commas, played at every team size of the run with own poses by
    particles."""
    torch_threads: int = 1
    """Threads of torch in an update; more than one helps only on idle cores."""
    device: Literal["auto", "cpu", "cuda"] = "auto"
    """Device that trains the networks; auto uses a GPU if there is one."""
    log: str = ""
    """Optional logs in the format of stable-baselines3, separated by commas: csv, tensorboard, wandb."""
