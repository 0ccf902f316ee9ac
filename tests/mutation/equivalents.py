"""Slips that change nothing that anybody could notice, each with the argument, read from `equivalents.toml`."""

from __future__ import annotations

import functools
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


@functools.cache
def read() -> list[dict[str, str]]:
    """Return all of them."""
    text = Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
    return list(tomllib.loads(text).get("equivalent", []))


def is_of(one: Mapping[str, str], site: Any) -> bool:
    """Tell whether a row is about a site."""
    same = all(one[name] == getattr(site, name) for name in ("file", "function", "original"))
    return same and one["replacement"] in site.options


def reason(row: Mapping[str, Any]) -> str:
    """Return why a mutant is equivalent, or nothing."""
    names = ("file", "function", "original", "replacement")
    return next((one["reason"] for one in read() if all(one[name] == row.get(name) for name in names)), "")
