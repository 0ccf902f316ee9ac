"""Zips of stable-baselines3, read through their parameters only: nothing in them is ever run.

    policy.pth    torch's archive of the parameters. Its pickle may name nothing but tensors of float32 (ALLOWED,
                  OPCODES: looked through without running it), its records are copied into an archive of our own, and
                  torch.load(weights_only=True) reads that one.
    data          JSON; plain values and plain texts of it are read, the pickles behind ":serialized:" never decoded.

PPO and A2C with MlpPolicy and continuous actions of 4 or 7 numbers in [-1, 1] can be read. What a zip does not hold
cannot be checked: the observations must have been ours, in our order, and not rescaled by VecNormalize.
"""

from __future__ import annotations

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

from soccer_env.agents.policy import ACTIONS, ACTIVATIONS, MAX_INPUTS, Policy, league_of
from soccer_env.agents.policy_file import file_name, one_line, read_plain, strict_json
from soccer_env.checking import brief
from soccer_env.leagues import League, find_league
from soccer_env.observations import OBSERVE, names_of

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
DEFAULT_ACTIVATION = "tanh"  # of MlpPolicy
FLATTEN = "<class 'stable_baselines3.common.torch_layers.FlattenExtractor'>"
HARMLESS = {  # policy_kwargs without effect on the mean action, or with one that the parameters show
    *("net_arch", "activation_fn", "ortho_init", "log_std_init", "full_std", "use_expln", "squash_output"),
    *("features_extractor_class", "features_extractor_kwargs", "share_features_extractor", "normalize_images"),
    *("optimizer_class", "optimizer_kwargs"),
}
LAYER = re.compile(r"mlp_extractor\.policy_net\.([0-9]{1,3})\.(weight|bias)")
UNUSED = re.compile(r"log_std|value_net\.(weight|bias)|mlp_extractor\.value_net\.[0-9]{1,3}\.(weight|bias)")


def load_sb3(
    path: str | os.PathLike[str],
    *,
    league: str | League,
    observe: str,
    action_repeat: int = 1,
    name: str | None = None,
    activation: str | None = None,
) -> Policy:
    """Return the policy of a stable-baselines3 zip (PPO or A2C, MlpPolicy) trained in a league on `observe`.

    `name` is the file's own unless given. `activation` is for zips of a user's own policy classes that do not name
    theirs; None: what the zip says, else tanh. ValueError names the file and the reason; without torch it is an
    ImportError.
    """
    preset = find_league(league)
    if observe not in OBSERVE:
        raise ValueError(f"observe must be one of {', '.join(OBSERVE)}, got {brief(observe)}")
    if activation not in (None, *ACTIVATIONS):
        raise ValueError(f"activation must be one of {', '.join(ACTIVATIONS)} or None, got {brief(activation)}")
    content = read_plain(path, MAX_FILE)
    try:
        said = _plain_data(content)
        weights, biases = _layers(_parameters(_member(content, "policy.pth", MAX_MEMBER)))
        inputs = names_of(preset, observe)
        if weights[0].shape[1] != len(inputs):
            raise ValueError(f"takes {weights[0].shape[1]} inputs, {observe!r} of {preset.name!r} has {len(inputs)}")
        return Policy(
            name=_stem(path) if name is None else name,
            **league_of(preset),
            observe=observe,
            inputs=tuple(inputs),
            actions=_actions(len(biases[-1])),
            action_repeat=action_repeat,
            kind="slots",
            activation=_activation(said.get("policy_kwargs"), activation),
            mirror=False,
            weights=weights,
            biases=biases,
            made=_made(said, content),
        )
    except ValueError as error:
        raise ValueError(f"policy file {file_name(path)!r}: {one_line(error)}") from None


def _member(content: bytes, name: str, limit: int) -> bytes:
    """Return one member of a zip, unpacked in memory, after its size was checked."""
    return _members(content, lambda member: member == name, limit, f"member {name!r}")[name]


def _members(content: bytes, wanted: Any, limit: int, what: str) -> dict[str, bytes]:
    """Return the members of a zip whose names are wanted: at least one, each once, at most `limit` bytes together."""
    if content.count(LISTED) > MAX_MEMBERS:
        raise ValueError(f"lists more than {MAX_MEMBERS} members")
    try:
        with zipfile.ZipFile(BytesIO(content)) as archive:
            found = [entry for entry in archive.infolist() if wanted(entry.filename)]
            if not found or len({entry.filename for entry in found}) < len(found):
                raise ValueError(f"the zip has the {what} twice" if found else f"the zip lacks the {what}")
            if any(entry.compress_type not in METHODS or entry.flag_bits & 1 for entry in found):
                raise ValueError(f"the {what} is encrypted or packed in a way that stable-baselines3 does not use")
            size = sum(entry.file_size for entry in found)
            if size > limit:
                raise ValueError(f"the {what} would unpack to {size} bytes, the limit is {limit}")
            return {entry.filename: archive.read(entry) for entry in found}
    except ValueError:
        raise
    except Exception as error:  # zipfile raises a dozen types of error for broken files
        raise ValueError(f"is no sound zip: {one_line(error) or type(error).__name__}") from None


def _plain_data(content: bytes) -> dict[str, Any]:
    """Return the settings of the run; ValueError if they describe a policy that is not supported."""
    said = strict_json(_member(content, "data", MAX_DATA), "data", finite=False)
    if not isinstance(said, dict):
        raise ValueError("data must be a JSON object")
    for key in ("observation_space", "action_space"):
        space = said.get(key)
        kind = space.get(":type:") if isinstance(space, dict) else None
        if not isinstance(kind, str) or not kind.endswith(".box.Box'>"):
            raise ValueError(f"its {key} must be a Box, got {brief(kind)}")
    for bound, text in (("low", "-1."), ("high", "1.")):
        words = said["action_space"].get(bound)
        if isinstance(words, str) and set(words.strip("[] ").split()) != {text}:
            raise ValueError(f"its actions must lie in [-1, 1], got {bound} {brief(words)}")
    kwargs = said.get("policy_kwargs")
    if not isinstance(kwargs, dict):
        raise ValueError("data says no policy_kwargs: no PPO or A2C")
    for key in kwargs.keys() - {":type:", ":serialized:"} - HARMLESS:
        raise ValueError(f"policy_kwargs has {brief(key)}, which is not supported")
    if str(kwargs.get("squash_output", False)) != "False":
        raise ValueError("its actions are squashed (squash_output), which is not supported")
    if kwargs.get("features_extractor_class", FLATTEN) != FLATTEN:
        raise ValueError(f"its features are made by {brief(kwargs['features_extractor_class'])}, not only flattened")
    return said


def _activation(kwargs: Any, given: str | None) -> str:
    """Return the activation that the zip says in plain text, else the given one, else the default."""
    text = kwargs.get("activation_fn")
    if text is None:
        return given or DEFAULT_ACTIVATION
    if not isinstance(text, str) or text not in ACTIVATION_TEXTS:
        raise ValueError(f"activation_fn must be Tanh or ReLU, got {brief(text)}")
    said = ACTIVATION_TEXTS[text]
    if given not in (None, said):
        raise ValueError(f"its activation is {said}, not {given}")
    return said


def _parameters(pth: bytes) -> dict[str, np.ndarray]:
    """Return the parameters in policy.pth as arrays that share torch's memory."""
    copied = _copied(pth)
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
                raise TypeError(f"it must hold tensors with names, got {brief(key)}")
        return {key: tensor.detach().numpy() for key, tensor in parameters.items()}
    except Exception as error:  # torch raises many types of error for broken archives
        raise ValueError(f"policy.pth cannot be read: {one_line(error)[:150]}") from None


def _copied(pth: bytes) -> bytes:
    """Return policy.pth as a new archive that holds nothing but the records that were looked at."""
    if not pth.startswith(b"PK\x03\x04"):
        raise ValueError("policy.pth is not an archive of torch 1.6 or later")
    record = re.compile(r"[A-Za-z0-9_.-]{1,100}/(data\.pkl|version|byteorder|data/[0-9]{1,6})")
    records = _members(pth, record.fullmatch, MAX_MEMBER, "tensors of policy.pth")
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
    """Raise ValueError unless a pickle names nothing but tensors; it is looked through, never run."""
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
            raise ValueError(f"policy.pth names {brief(argument)}, which is no tensor of float32")
        if opcode not in OPCODES:
            raise ValueError(f"policy.pth is no table of tensors: its pickle has {opcode}")


def _layers(state: Mapping[str, np.ndarray]) -> tuple[tuple[np.ndarray, ...], tuple[np.ndarray, ...]]:
    """Return weights and biases of the policy's network, the last layer being action_net."""
    for key in state:
        if not (LAYER.fullmatch(key) or UNUSED.fullmatch(key) or key in ("action_net.weight", "action_net.bias")):
            raise ValueError(f"has the parameter {brief(key)}: only MlpPolicy of PPO and A2C is supported")
    if "log_std" not in state:
        raise ValueError("has no log_std: its actions are not continuous")
    numbers = sorted({int(match[1]) for match in map(LAYER.fullmatch, state) if match})
    if numbers != list(range(0, 2 * len(numbers), 2)):  # one activation behind each layer
        raise ValueError(f"layers of policy_net must be 0, 2, 4 ..., got {brief(numbers)}")
    names = [f"mlp_extractor.policy_net.{number}" for number in numbers] + ["action_net"]
    for name in names:
        weight, bias = (state.get(f"{name}.{part}") for part in ("weight", "bias"))
        if weight is None or bias is None:
            raise ValueError(f"{name} must have a weight and a bias")
        if weight.ndim != 2 or bias.ndim != 1 or not all(0 < size <= MAX_INPUTS for size in weight.shape + bias.shape):
            raise ValueError(f"{name} must have a weight of two axes and a bias, got {weight.shape} and {bias.shape}")
    return tuple(state[f"{name}.weight"] for name in names), tuple(state[f"{name}.bias"] for name in names)


def _stem(path: str | os.PathLike[str]) -> str:
    """Return a name for the policy made from its file's."""
    return re.sub(r"[^A-Za-z0-9 ._+-]", "-", Path(path).stem).lstrip(" ._+-")[:64] or "sb3"


def _actions(size: int) -> str:
    """Return the kind of actions of that many numbers."""
    for kind, numbers in ACTIONS.items():
        if numbers == size:
            return kind
    raise ValueError(f"gives {size} numbers as actions, must be one of {', '.join(map(str, ACTIONS.values()))}")


def _made(said: Mapping[str, Any], content: bytes) -> dict[str, str]:
    """Return where the policy comes from, as far as the zip says it in plain values."""
    made = {"from": "stable-baselines3", "sha256": sha256(content).hexdigest()}
    return made | {key: str(said[key]) for key in ("num_timesteps", "seed") if type(said.get(key)) is int}
