"""The settings of a match, each declared once: signatures, checks, help and errors of all APIs are generated from them.

    MatchSettings      how a match is played
      MatchSetup       and which teams play
        MatchArguments     soccer_env.Match
        EnvArguments       soccer_v0.parallel_env, env and raw_env
        SoloArguments      gymnasium.make
        VectorArguments    gymnasium.make_vec

`takes_fields_of` gives a function the signature and the help of such a class, for people and for type checkers.
"""

from __future__ import annotations

import functools
import inspect
import textwrap
from collections.abc import Callable, Mapping
from dataclasses import Field, dataclass, field, fields
from typing import TYPE_CHECKING, Any, Concatenate, Literal, ParamSpec, TypeVar

from soccer_env.guards.checking import CheckedFields, Range, check_names
from soccer_env.guards.names import Made
from soccer_env.leagues.rules import MINUTES
from soccer_env.types import MAX_TEAM

if TYPE_CHECKING:
    from gymnasium.vector import AutoresetMode

    from soccer_env.actions import ActionKind
    from soccer_env.leagues.league import League
    from soccer_env.leagues.options import Options
    from soccer_env.leagues.rules import Rules
    from soccer_env.match.variation import Variation
    from soccer_env.observations import Observation
    from soccer_env.rewards import Rewards
    from soccer_env.scenes import Scene

P = ParamSpec("P")
T = TypeVar("T")
A = TypeVar("A")

TEAM_SIZE = Range(1, MAX_TEAM)
THREADS = Range(1, 256)
STEPS = Range(1, 2**40)
Senses = Literal["ideal", "sensors"]
Pose = Literal["percept", "particles"]
Placement = Literal["instant", "drive"]
Starts = Literal["all", "training", "held-out"]
InfoKind = Literal["flat", "full", "nested", "none"]
StateSide = Literal["field", "home", "away"]
SIDE_BY_SIDE = Range(1, 1 << 20)
INFOS = '"flat" numbers, "full" (with statistics of play), "nested" dicts in words, or "none" (False), the fastest'


def declare_setting(
    default: Any, text: str, bounds: Range | None = None, *, free: bool = False, replayed: bool = False, part: str = ""
) -> Any:
    """Return a dataclass field that declares a setting: its default and one line of help.

    free: the match's future does not depend on the setting. replayed: a replay needs the setting. part: the field of
    `Settings` into which this setting is merged. bounds: the allowed numbers.
    """
    facts = {"text": text, "free": free, "replayed": replayed, "part": part}
    return field(default=default, metadata={**facts, **({} if bounds is None else {"bounds": bounds})})


@dataclass(frozen=True, kw_only=True)
class MatchSettings(CheckedFields):
    """How a match is played: the settings that do not name teams."""

    TITLED = False

    league: str | League = declare_setting("legged-2001", "a name of `soccer list leagues`, or a League")
    home: int | None = declare_setting(None, "home robots; None: the league's team size", TEAM_SIZE, replayed=True)
    away: int | None = declare_setting(None, "away robots; None: the league's team size", TEAM_SIZE, replayed=True)
    max_players: int | None = declare_setting(
        None, "array rows for each team, unused rows are inactive; None: as many as play", TEAM_SIZE, replayed=True
    )
    observe: Literal["truth", "percepts", "belief"] | Observation = declare_setting(
        "truth",
        '"truth", "percepts", "belief", or an object with `names` or `entries` that is called with the Match',
        free=True,
    )
    senses: Senses | Mapping[str, str] | tuple[str, str] = declare_setting(
        "sensors", 'source of beliefs: "sensors" or "ideal" (the truth), or {"home": ..., "away": ...}'
    )
    pose: Pose = declare_setting(
        "percept", 'own pose of robots with sensors: "percept", a given noisy pose, or "particles", a particle filter'
    )
    sensors: Mapping[str, Any] | Options | None = declare_setting(
        None, "{name: value}, changes to the league's sensors, or an object of their class", part="league"
    )
    memory: Mapping[str, Any] | Options | None = declare_setting(
        None, "{name: value}, changes to the league's memory of percepts, or an object of its class", part="league"
    )
    state_side: StateSide = declare_setting(
        "field",
        'frame of `state()`: that of "home" or "away", which then always attacks +x, or of the "field"',
        free=True,
    )
    actions: Literal["box", "full", "discrete", "multi", "skills"] | ActionKind = declare_setting(
        "box",
        'kind: "box" (4 numbers), "full" (7, with the head), or with masks: "discrete", "multi", or "skills" by name',
        free=True,
    )
    scene: str | Scene = declare_setting(
        "kick-off",
        'a name of `soccer list scenes`, several as "a:0.6,b:0.4", saved ones as "states:FILE", or a Scene',
    )
    starts: Starts = declare_setting("all", 'of a drill: "all", those for "training", or the "held-out" tenth')
    episode: Literal["match", "goal", "drill"] = declare_setting(
        "match", 'it ends by the clock ("match"), at the first "goal", or by the test of a "drill"', replayed=True
    )
    rules: str | Rules | None = declare_setting(
        None,
        '"league", "simple", "none", "league:pushing=False", or Rules; None: "league", or the rules of the drill',
        part="league",
    )
    variation: Mapping[str, tuple[Any, ...]] | Variation | None = declare_setting(
        None,
        "{name: (low, high, distribution)}: factors of the league's numbers for each episode: match/variation.py",
    )
    rewards: Literal["default", "sparse", "training"] | Rewards = declare_setting(
        "default", "a name of `soccer list rewards`, or Rewards", free=True
    )
    placement: Placement = declare_setting(
        "instant", 'robots reach their places at a restart at once ("instant"), or they "drive"', replayed=True
    )
    keeper: int = declare_setting(0, "number of the goalkeeper, in teams of two or more", replayed=True)
    minutes: float | None = declare_setting(
        None, "minutes of play, both halves together; None: the league's own", MINUTES, replayed=True
    )
    action_repeat: int = declare_setting(1, "control steps for which an action is kept", Range(1, 1000), free=True)
    max_cycles: int | None = declare_setting(None, "steps until an episode is truncated; None: never", STEPS, free=True)


@dataclass(frozen=True, kw_only=True)
class MatchSetup(MatchSettings):
    """How a match is played, and which teams play the robots."""

    opponents: Any = declare_setting(None, "the team that plays away; learners then play home robots only")
    teammates: Any = declare_setting(None, "the team that plays all home robots but the last")
    controllers: Mapping[str, Any] | None = declare_setting(None, "{agent or side: team}, for some robots or sides")


@dataclass(frozen=True, kw_only=True)
class MatchArguments(MatchSetup):
    """The arguments of the constructor of `Match`."""

    league: str | League = field(
        default="legged-2001", metadata=MatchSettings.__dataclass_fields__["league"].metadata, kw_only=False
    )
    matches: int = declare_setting(1, "number of matches side by side", SIDE_BY_SIDE)
    threads: int = declare_setting(1, "threads that step the matches; results do not depend on them", THREADS)
    seed: int | None = declare_setting(None, "seed of all matches; None: drawn from the system")
    seeds: Any = declare_setting(None, "seeds of the matches (M,), in place of `seed`")
    autoreset: Literal["next_step", "same_step", "off"] = declare_setting(
        "off", "when an ended match begins a new episode"
    )
    backend: Literal["c", "batch"] | None = declare_setting(
        None, 'code of the physics: "c" (compiled) or "batch"; None: the faster one'
    )


@dataclass(frozen=True, kw_only=True)
class EnvArguments(MatchSetup):
    """The arguments of a PettingZoo environment."""

    render_mode: Literal["rgb_array", "human"] | None = declare_setting(
        None, '"rgb_array" for frames, "human" for a window'
    )
    infos: InfoKind | bool = declare_setting("flat", INFOS)
    overlays: Any = declare_setting(
        None, 'drawn over frames: names as "belief,trail", or a mapping that also names a robot'
    )


@dataclass(frozen=True, kw_only=True)
class LearnerSetup(MatchSetup):
    """The settings and teams of a match with a single learner."""

    opponents: Any = declare_setting("chaser", "the team that plays away")
    teammates: Any = declare_setting("chaser", "the team that plays the other home robots")
    agent: str | None = declare_setting(None, "the learner; None: home's last robot")
    render_mode: Literal["rgb_array", "human"] | None = declare_setting(
        None, '"rgb_array" for frames, "human" for a window'
    )
    infos: InfoKind | bool = declare_setting("flat", INFOS)


@dataclass(frozen=True, kw_only=True)
class SoloArguments(LearnerSetup):
    """The arguments of a Gymnasium `Env`, in which one learner plays one match."""

    overlays: Any = declare_setting(
        None, 'drawn over frames: names as "belief,trail", or a mapping that also names a robot'
    )


@dataclass(frozen=True, kw_only=True)
class VectorArguments(LearnerSetup):
    """The arguments of a Gymnasium `VectorEnv`, in which one learner plays many matches at once."""

    num_envs: int = field(default=1, metadata={"text": "matches side by side", "bounds": SIDE_BY_SIDE}, kw_only=False)
    max_episode_steps: int | None = declare_setting(
        None, "Gymnasium's name for max_cycles; the lower limit counts", STEPS
    )
    autoreset_mode: Literal["NextStep", "SameStep", "next_step", "same_step"] | AutoresetMode = declare_setting(
        "NextStep", '"NextStep", "SameStep" or Gymnasium\'s AutoresetMode'
    )
    threads: int = declare_setting(1, "threads that step the matches", THREADS)


FREE = tuple(item.name for item in fields(MatchSettings) if item.metadata["free"])
REPLAYED = tuple(item.name for item in fields(MatchSettings) if item.metadata["replayed"])


def select_fields(arguments: MatchSettings, kind: type[MatchSettings]) -> dict[str, Any]:
    """Select the arguments that are fields of the dataclass `kind`; return them as a dict by name."""
    return {item.name: getattr(arguments, item.name) for item in fields(kind)}


# Functions that take such arguments


def takes_fields_of(kind: Callable[P, A]) -> Callable[[Callable[[A], T]], Callable[P, T]]:
    """Return a decorator: callers pass the fields of `kind` by name, the decorated function gets a `kind` object."""

    def decorate(function: Callable[[A], T]) -> Callable[P, T]:
        @functools.wraps(function)
        def call(*values: P.args, **named: P.kwargs) -> T:
            return function(gather_arguments(kind, values, named))

        document_signature(call, kind)
        return call

    return decorate


def init_takes_fields_of(
    kind: Callable[P, A],
) -> Callable[[Callable[[Any, A], None]], Callable[Concatenate[Any, P], None]]:
    """Return a decorator like `takes_fields_of`, for an `__init__` that takes one object of class `kind`."""

    def decorate(function: Callable[[Any, A], None]) -> Callable[Concatenate[Any, P], None]:
        @functools.wraps(function)
        def call(self: Any, /, *values: P.args, **named: P.kwargs) -> None:
            function(self, gather_arguments(kind, values, named))

        document_signature(call, kind, inspect.Parameter("self", inspect.Parameter.POSITIONAL_ONLY))
        return call

    return decorate


def gather_arguments(kind: Any, values: tuple[Any, ...], named: dict[str, Any]) -> Any:
    """Collect the positional and named arguments of a call into an instance of the dataclass `kind`."""
    check_names("setting", named, [item.name for item in fields(kind)], TypeError)
    return kind(*values, **named)


def document_signature(call: Any, kind: Any, *first: inspect.Parameter) -> None:
    """Give a function the signature of the dataclass `kind`, and a line of help for each field."""
    parameters = inspect.signature(kind).parameters.values()
    returned = call.__annotations__.get("return")
    call.__signature__ = inspect.Signature([*first, *parameters], return_annotation=returned)
    lines = [line for item in fields(kind) for line in setting_help(item)]
    call.__doc__ = "\n".join([inspect.cleandoc(call.__doc__ or kind.__doc__ or ""), "", *lines])


def setting_help(item: Field[Any]) -> list[str]:
    """Return the help text of one setting, as lines."""
    text = f"{item.name} = {item.default!r}: {item.metadata['text']}."
    return textwrap.wrap(text, 100, subsequent_indent="    ")


# Copies by settings alone, as by Gymnasium's EzPickle: the copy needs a reset and draws a new seed


def reduce_by_settings(make: Callable[..., Any], settings: dict[str, Any]) -> Made:
    """Return the value of `__reduce__` that pickles an object as the call `make(**settings)`."""
    return rebuild_from_settings, (version(), make, settings)


def rebuild_from_settings(made_by: str, make: Callable[..., Any], settings: dict[str, Any]) -> Any:
    """Rebuild a pickled object; on failure ValueError names the package version that pickled the object."""
    try:
        return make(**settings)
    except (TypeError, ValueError) as error:
        if made_by == version():
            raise
        raise ValueError(f"this was pickled by soccer_env {made_by}, and this is {version()}: {error}") from error


def version() -> str:
    """Return the version of the package."""
    from soccer_env import __version__

    return __version__
