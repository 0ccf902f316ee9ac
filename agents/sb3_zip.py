"""Policies in zips of stable-baselines3: only their parameters are read, and nothing in them is ever run.

    policy.pth    torch's archive of the parameters. Its pickle may name only tensors of float32 (ALLOWED, OPCODES:
                  checked without running it), its records are copied into a new archive, which
                  torch.load(weights_only=True) reads.
    data          JSON; plain values and texts are read, the pickles behind ":serialized:" are never decoded.

MlpPolicy of the algorithms in `sb3_actor.py` can be read, with actions of 4 or 7 numbers in [-1, 1] or our discrete
actions. A zip cannot show that its observations were ours, in our order; a VecNormalize must be given as `normalise`.
"""

import os
import pickletools
import re
import zipfile
from collections.abc import Mapping
from hashlib import sha256
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.actions import DISCRETE
from soccer_env.agents.normalising import normaliser_table
from soccer_env.agents.policy import ACTIONS, ACTIVATIONS, Policy, league_fields, training_fields
from soccer_env.agents.policy_file import dump, one_line, read_limited_file, short_path, strict_json
from soccer_env.agents.rules_known import league_with_rules
from soccer_env.agents.sb3_actor import algorithm_of, is_discrete, layers_of
from soccer_env.agents.trained_with import known_senses, warn_if_observing_truth
from soccer_env.guards.checking import check_choice, short_repr
from soccer_env.guards.whole_files import write_atomically
from soccer_env.leagues import League, find_league
from soccer_env.observations import OBSERVE, entry_names

MAX_FILE = 256 * 2**20  # [bytes] most of it the optimiser's state, which is not read
MAX_MEMBER = 64 * 2**20  # [bytes] unpacked, policy.pth and its records
MAX_DATA = 16 * 2**20  # [bytes] unpacked
MAX_PICKLE = 2**18  # [bytes] the names and shapes in policy.pth
MAX_OPCODES = 4000  # in it; 8 layers need about 1500, and 200,000 nested tuples crash the process as they are hashed
MAX_MEMBERS = 1000  # of a zip and of those inside it; stable-baselines3 writes about 50
LISTED = b"PK\x01\x02"  # begins each entry of a zip's list of members
METHODS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
ALLOWED = {"collections OrderedDict", "torch._utils _rebuild_tensor_v2", "torch FloatStorage"}
OPCODES = {  # what torch.save writes for a table of tensors
    *("PROTO", "STOP", "GLOBAL", "REDUCE", "BUILD", "BINPERSID", "NONE", "NEWFALSE", "NEWTRUE", "BINUNICODE"),
    *("BININT", "BININT1", "BININT2", "LONG1", "BINPUT", "LONG_BINPUT", "BINGET", "LONG_BINGET", "MARK", "EMPTY_TUPLE"),
    *("TUPLE", "TUPLE1", "TUPLE2", "TUPLE3", "EMPTY_DICT", "SETITEM", "SETITEMS"),
}
ACTIVATION_TEXTS = {
    "<class 'torch.nn.modules.activation.Tanh'>": "tanh",
    "<class 'torch.nn.modules.activation.ReLU'>": "relu",
}
BOX_TYPE, DISCRETE_TYPE = ".box.Box'>", ".discrete.Discrete'>"  # how the classes of spaces end
FLATTEN = "<class 'stable_baselines3.common.torch_layers.FlattenExtractor'>"
HARMLESS = {  # policy_kwargs without effect on the mean action, or with one that the parameters show
    *("net_arch", "activation_fn", "ortho_init", "log_std_init", "full_std", "use_expln", "squash_output"),
    *("features_extractor_class", "features_extractor_kwargs", "share_features_extractor", "normalize_images"),
    *("optimizer_class", "optimizer_kwargs", "use_sde", "n_critics", "clip_mean"),
}
DISCRETE_SPACE = {"n": str(len(DISCRETE)), "start": "0"}


def load_sb3(
    path: str | os.PathLike[str], *, league: str | League, observe: str, action_repeat: int = 1,
    name: str | None = None, activation: str | None = None, at_once: bool = False, normalise: Any = None,
    pose: str | None = None, senses: str | None = None, rules: str | None = None,
) -> Policy:  # fmt: skip
    """Return the policy of a stable-baselines3 zip that was trained in a league on the observation `observe`.

    `name`: default the file's name. `activation`: for zips of users' own policy classes that do not name theirs; None:
    from the zip, else from the algorithm. `normalise`: the VecNormalize of the training, see
    `normalising.normaliser_table`. `at_once`, `pose`, `senses`, `rules`: of the training, see `Policy`; rules None:
    unknown. ValueError names the file and the reason; ImportError without torch.
    """
    preset = find_league(league) if rules is None else league_with_rules(league, rules)
    check_choice("observe", observe, OBSERVE)
    if activation is not None:
        check_choice("activation", activation, ACTIVATIONS)
    content = read_limited_file(path, MAX_FILE)
    try:
        read = _network_fields(content, activation)
        inputs = entry_names(preset, observe)
        if read["weights"][0].shape[1] != len(inputs):
            taken = read["weights"][0].shape[1]
            fitting = [kind for kind in OBSERVE if len(entry_names(preset, kind)) == taken]
            other = "was it trained in another league, by another version, or with state=True?"
            hint = f"give observe={fitting[0]}" if fitting else other
            raise ValueError(f"takes {taken} inputs, {observe!r} of {preset.name!r} has {len(inputs)}: {hint}")
        return Policy(
            **read, **(league_fields if rules is None else training_fields)(preset),
            name=_policy_name(path) if name is None else name,
            observe=observe, inputs=tuple(inputs), action_repeat=action_repeat, mirror=False,
            at_once=at_once, normalise=normaliser_table(normalise), **known_senses(senses, pose),
        )  # fmt: skip
    except ValueError as error:
        raise ValueError(f"policy file {short_path(path)!r}: {one_line(error)}") from None


def convert_sb3(path: str | os.PathLike[str], out: str | os.PathLike[str], **settings: Any) -> Policy:
    """Write the policy of a stable-baselines3 zip as a policy file and return it, with the settings of `load_sb3`.

    Unlike in `load_sb3`, `at_once` is True by default.
    """
    if Path(out).suffix != ".safetensors":
        raise ValueError(f"a policy file must end in .safetensors, got {os.fspath(out)!r}")
    policy = load_sb3(path, **{"at_once": True, **settings})
    write_atomically(Path(out), dump(policy))
    warn_if_observing_truth(policy)
    return policy


def _network_fields(content: bytes, activation: str | None) -> dict[str, Any]:
    """Return the fields of a policy stored in its zip: the network, the kind of actions, and the origin."""
    settings = _read_run_settings(content)
    state = _read_parameters(_read_member(content, "policy.pth", MAX_MEMBER))
    algorithm = algorithm_of(state)
    weights, biases = layers_of(algorithm, state)
    discrete = is_discrete(algorithm, state)
    if discrete != (settings["action_space"][":type:"].endswith(DISCRETE_TYPE)):
        raise ValueError("its action_space is not of the kind that its network gives")
    kwargs = settings["policy_kwargs"]
    known = {key: str(settings[key]) for key in ("num_timesteps", "seed") if type(settings.get(key)) is int}
    return {
        "actions": "discrete" if discrete else _action_kind(len(biases[-1])),
        "activation": _activation_name(kwargs, activation, algorithm.activation),
        "squash": algorithm.squash or (str(kwargs.get("squash_output", False)) == "True" and not discrete),
        "weights": weights,
        "biases": biases,
        "made": {"from": "stable-baselines3", "sha256": sha256(content).hexdigest(), **known},
    }


def _read_member(content: bytes, name: str, limit: int) -> bytes:
    """Return one member of a zip, unpacked in memory after its size is checked."""
    return _read_members(content, lambda member: member == name, limit, f"member {name!r}")[name]


def _read_members(content: bytes, wanted: Any, limit: int, what: str) -> dict[str, bytes]:
    """Return the members of a zip with the names `wanted`: at least one, none twice, at most `limit` bytes in total."""
    if content.count(LISTED) > MAX_MEMBERS:
        raise ValueError(f"lists more than {MAX_MEMBERS} members")
    try:
        with zipfile.ZipFile(BytesIO(content)) as archive:
            entries = [entry for entry in archive.infolist() if wanted(entry.filename)]
            if not entries or len({entry.filename for entry in entries}) < len(entries):
                raise ValueError(f"the zip has the {what} twice" if entries else f"the zip lacks the {what}")
            if any(entry.compress_type not in METHODS or entry.flag_bits & 1 for entry in entries):
                raise ValueError(f"the {what} is encrypted or packed in a way that stable-baselines3 does not use")
            size = sum(entry.file_size for entry in entries)
            if size > limit:
                raise ValueError(f"the {what} would unpack to {size} bytes, the limit is {limit}")
            return {entry.filename: archive.read(entry) for entry in entries}
    except ValueError:
        raise
    except Exception as error:  # zipfile raises a dozen types of error for broken files
        raise ValueError(f"is no sound zip: {one_line(error) or type(error).__name__}") from None


def _read_run_settings(content: bytes) -> dict[str, Any]:
    """Return the settings of the training run in a zip; ValueError for an unsupported policy."""
    settings = strict_json(_read_member(content, "data", MAX_DATA), "data", finite=False)
    if not isinstance(settings, dict):
        raise ValueError("data must be a JSON object")
    for key, kinds in (("observation_space", (BOX_TYPE,)), ("action_space", (BOX_TYPE, DISCRETE_TYPE))):
        space = settings.get(key)
        kind = space.get(":type:") if isinstance(space, dict) else None
        if not (isinstance(kind, str) and kind.endswith(kinds)):
            raise ValueError(
                f"its {key} must be a Box{' or Discrete' if len(kinds) > 1 else ''}, got {short_repr(kind)}"
            )
    _check_actions(settings["action_space"])
    kwargs = settings.get("policy_kwargs")
    if not isinstance(kwargs, dict):
        raise ValueError("data says no policy_kwargs: it is no model of an algorithm that is known")
    for key in kwargs.keys() - {":type:", ":serialized:"} - HARMLESS:
        raise ValueError(f"policy_kwargs has {short_repr(key)}, which is not supported")
    if kwargs.get("features_extractor_class", FLATTEN) != FLATTEN:
        raise ValueError(
            f"its features are made by {short_repr(kwargs['features_extractor_class'])}, not only flattened"
        )
    return settings


def _check_actions(space: Mapping[str, Any]) -> None:
    """Raise ValueError unless an action space belongs to this package: discrete, or numbers in [-1, 1]."""
    if space[":type:"].endswith(DISCRETE_TYPE):
        for key, wanted in DISCRETE_SPACE.items():
            if str(space.get(key)) != wanted:
                raise ValueError(
                    f"its discrete actions must be {len(DISCRETE)} from 0, got {key} {short_repr(space.get(key))}"
                )
        return
    for bound, text in (("low", "-1."), ("high", "1.")):
        words = space.get(bound)
        if isinstance(words, str) and set(words.strip("[] ").split()) != {text}:
            raise ValueError(f"its actions must lie in [-1, 1], got {bound} {short_repr(words)}")


def _activation_name(kwargs: Any, given: str | None, default: str) -> str:
    """Return the activation named in plain text in the zip, else the given activation, else the algorithm's."""
    text = kwargs.get("activation_fn")
    if text is None:
        return given or default
    if not isinstance(text, str) or text not in ACTIVATION_TEXTS:
        raise ValueError(f"activation_fn must be Tanh or ReLU, got {short_repr(text)}")
    named = ACTIVATION_TEXTS[text]
    if given not in (None, named):
        raise ValueError(f"its activation is {named}, not {given}")
    return named


def _read_parameters(pth: bytes) -> dict[str, np.ndarray]:
    """Return the parameters in policy.pth as numpy arrays that share torch's memory."""
    copied = _copy_checked_records(pth)
    try:
        import torch
    except ImportError:
        raise ImportError("reading a stable-baselines3 zip needs torch: pip install soccer_env[train]") from None
    try:
        state = torch.load(BytesIO(copied), map_location="cpu", weights_only=True)
        if not isinstance(state, dict):
            raise TypeError(f"it must be a table of parameters, not {type(state).__name__}")
        parameters = dict(dict.items(state))  # dict.items: a pickle can hide state.items behind a value of its own
        for key, tensor in parameters.items():
            if not isinstance(key, str) or not isinstance(tensor, torch.Tensor):
                raise TypeError(f"it must hold tensors with names, got {short_repr(key)}")
        return {key: tensor.detach().numpy() for key, tensor in parameters.items()}
    except Exception as error:  # torch raises many types of error for broken archives
        raise ValueError(f"policy.pth cannot be read: {one_line(error)[:150]}") from None


def _copy_checked_records(pth: bytes) -> bytes:
    """Return policy.pth as a new archive that holds only the checked records."""
    if not pth.startswith(b"PK\x03\x04"):
        raise ValueError("policy.pth is not an archive of torch 1.6 or later")
    record = re.compile(r"[A-Za-z0-9_.-]{1,100}/(data\.pkl|version|byteorder|data/[0-9]{1,6})")
    records = _read_members(pth, record.fullmatch, MAX_MEMBER, "tensors of policy.pth")
    pickles = [name for name in records if name.endswith("/data.pkl")]
    if len(pickles) != 1 or len({name.split("/")[0] for name in records}) > 1:
        raise ValueError("policy.pth must hold one data.pkl and its records in one folder")
    _check_pickle(records[pickles[0]])
    copy = BytesIO()
    with zipfile.ZipFile(copy, "w", zipfile.ZIP_STORED) as archive:
        for name, content in records.items():
            archive.writestr(zipfile.ZipInfo(name), content)
    return copy.getvalue()


def _check_pickle(content: bytes) -> None:
    """Raise ValueError unless a pickle contains only tensors; the pickle is scanned, never run."""
    if len(content) > MAX_PICKLE:
        raise ValueError(f"data.pkl of policy.pth has {len(content)} bytes, the limit is {MAX_PICKLE}")
    try:
        opcodes = [(opcode.name, argument) for opcode, argument, _ in pickletools.genops(content)]
    except Exception as error:  # pickletools reads numbers and texts without checking them
        raise ValueError(f"data.pkl of policy.pth is broken: {one_line(error)[:150]}") from None
    if len(opcodes) > MAX_OPCODES:
        raise ValueError(f"data.pkl of policy.pth has {len(opcodes)} instructions, the limit is {MAX_OPCODES}")
    for opcode, argument in opcodes:
        if opcode == "GLOBAL" and argument not in ALLOWED:
            raise ValueError(f"policy.pth names {short_repr(argument)}, which is no tensor of float32")
        if opcode not in OPCODES:
            raise ValueError(f"policy.pth is no table of tensors: its pickle has {opcode}")


def _policy_name(path: str | os.PathLike[str]) -> str:
    """Return a name for the policy, derived from the name of its file."""
    return re.sub(r"[^A-Za-z0-9 ._+-]", "-", Path(path).stem).lstrip(" ._+-")[:64] or "sb3"


def _action_kind(size: int) -> str:
    """Return the kind of actions that consist of `size` numbers."""
    kinds = {ACTIONS[kind]: kind for kind in ("box", "full")}
    if size not in kinds:
        raise ValueError(f"gives {size} numbers as actions, must be one of {', '.join(map(str, kinds))}")
    return kinds[size]
