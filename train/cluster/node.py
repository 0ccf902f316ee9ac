"""A call on a worker, once the code is there."""

import hashlib
import pickle
import platform
from typing import Any

from soccer_env.compiling.sources import ROOT
from soccer_env.train.provenance import play_facts


def answer(facts: dict[str, str], prepare: bytes, call: bytes) -> Any:
    """Return the result of a pickled call; ValueError on a node where matches would end in other states."""
    here = play_facts()
    differences = [f"{name} {here[name]} there, {facts[name]} here" for name in facts if here[name] != facts[name]]
    if differences:
        raise ValueError(f"node {platform.node()} cannot play the same matches: {'; '.join(differences)}")
    if prepare:
        prepare_node(prepare)
    return run(call)


def prepare_node(prepare: bytes) -> None:
    """Make a pickled call once on this node, while its other workers wait: it compiles what they need."""
    from filelock import FileLock

    mark = ROOT.parent / f"prepared-{hashlib.sha256(prepare).hexdigest()[:16]}"
    if mark.exists():
        return
    with FileLock(f"{mark}.lock"):
        if not mark.exists():
            run(prepare)
            mark.touch()


def run(call: bytes) -> Any:
    """Make a pickled call (function, arguments)."""
    function, arguments = pickle.loads(call)
    return function(*arguments)
