"""The task and the actor on a worker. They are sent by value, and import the code sent with them instead of the
installed code.

The code lies in the folder of the cache (SOCCER_ENV_CACHE, or ~/.cache/soccer_env), in a folder named by its hash.
"""

from typing import Any


def run_call(code: bytes, digest: str, facts: dict[str, str], prepare: bytes, call: bytes) -> Any:
    """Unpack the code unless this node has it, and return what the pickled call returns.

    `facts`: versions and machine that results depend on. `prepare`: a pickled call that each node makes once.
    """
    import io
    import os
    import shutil
    import sys
    import tempfile
    import zipfile
    from pathlib import Path

    folder = Path(os.environ.get("SOCCER_ENV_CACHE") or os.path.expanduser("~/.cache/soccer_env"), "code", digest)
    if not folder.exists():
        folder.parent.mkdir(parents=True, exist_ok=True)
        aside = tempfile.mkdtemp(dir=folder.parent)
        with zipfile.ZipFile(io.BytesIO(code)) as archive:
            archive.extractall(aside)
        try:
            os.rename(aside, folder)
        except OSError:  # another worker was faster
            shutil.rmtree(aside)
    if sys.path[0] != str(folder):
        sys.path.insert(0, str(folder))
    from soccer_env.train.cluster.node import answer

    return answer(facts, prepare, call)


class Holder:
    """An actor that holds what a call made, and calls its methods."""

    def make(self, *making: Any) -> None:
        """Make the object by the arguments of `run_call`."""
        self.held = run_call(*making)

    def call(self, made: None, method: str, *arguments: Any) -> Any:
        """Call a method of the object; `made` is the result of `make`, whose error would be that of this call."""
        return getattr(self.held, method)(*arguments)
