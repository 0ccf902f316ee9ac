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


ROOT = Path(__file__).resolve().parents[2]


@functools.cache
def read() -> list[dict[str, str]]:
    """Return all of them."""
    text = Path(__file__).with_suffix(".toml").read_text(encoding="utf-8")
    return list(tomllib.loads(text).get("equivalent", []))


def is_of(one: Mapping[str, str], site: Any) -> bool:
    """Tell whether a row is about a site."""
    same = one["file"] == site.file and one["original"] == site.original and one["replacement"] in site.options
    return same and one["text"] in line_of(site.file, site.place.first_line)


def reason(row: Mapping[str, Any]) -> str:
    """Return why a mutant is equivalent, or nothing."""
    names = ("file", "original", "replacement")
    alike = (one for one in read() if all(one[name] == row.get(name) for name in names))
    return next((one["reason"] for one in alike if one["text"] in line_of(one["file"], row["line"])), "")


def line_of(file: str, number: int) -> str:
    """Return a line of a file of the checkout."""
    lines = (ROOT / file).read_text(encoding="utf-8").splitlines()
    return lines[number - 1] if number <= len(lines) else ""
