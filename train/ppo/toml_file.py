"""The settings of a training run from a TOML file: `soccer train --config FILE`, or the name of a bundled one."""

import sys
from dataclasses import fields
from pathlib import Path
from typing import Any

from soccer_env import agents
from soccer_env.guards.names import unknown
from soccer_env.guards.whole_files import read_regular_file
from soccer_env.train.ppo.settings import TrainSettings

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


MAX_FILE = 16 * 2**10  # [bytes] a name of many parts takes time with the square of its length: 2 s with these
BUNDLED = Path(agents.__file__).parent / "policies"  # in a checkout and where the package is installed


def settings_of(config: Path | None) -> TrainSettings:
    """Read training settings from a TOML file, or return the defaults; ValueError names the file and the mistake.

    A bare name such as first-win is that of a bundled file, unless there is a file of that name.
    """
    if config is None:
        return TrainSettings()
    bundled = BUNDLED / f"{config.name.removesuffix('.toml')}.toml"
    if config.name == str(config) and not config.exists() and bundled.is_file():
        config = bundled
    found = read_toml(config)
    for name, default in TrainSettings().as_dict().items():
        if isinstance(found.get(name), list) and type(default) is str:  # hidden = [64, 64] is "64,64"
            found[name] = ",".join(map(str, found[name]))
    if found.get("anew"):
        raise ValueError(f"{config}: anew is for the command line: here it would remove the run that is to go on")
    try:
        return TrainSettings(**found)
    except ValueError as error:
        raise ValueError(f"{config}: {error}") from error


def read_toml(path: Path) -> dict[str, Any]:
    """Return the contents of a TOML file; ValueError if it cannot be read or names an unknown setting."""
    try:
        found = tomllib.loads(read_regular_file(path, MAX_FILE).decode("utf-8"))
    except (OSError, ValueError, RecursionError) as error:  # what is no TOML or no UTF-8 is a ValueError
        raise ValueError(f"{path} cannot be read: {error}") from error
    known = [field.name for field in fields(TrainSettings)]
    for name in found:
        if name not in known:
            raise ValueError(f"{path}: {unknown('setting', name, known)}")
    return found
