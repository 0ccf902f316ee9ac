"""The page: markup, style, scripts and data in one file that loads nothing from a network."""

from __future__ import annotations

import html
import json
import os
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from soccer_env.guards.whole_files import write_atomically
from soccer_env.render.overlays.flags import OverlayFlags
from soccer_env.shows.browser.collect import collect_page_data
from soccer_env.shows.film import check_overwrite

if TYPE_CHECKING:
    from soccer_env.replay.replay_file import Replay

SCRIPTS = ("unpack.js", "forces.js", "moment.js", "pitch.js", "overlays.js", "charts.js", "panel.js", "main.js")
ESCAPED = {ord(letter): f"\\u{ord(letter):04x}" for letter in "<>&\u2028\u2029"}


def write_page(
    replay: Replay, path: str | os.PathLike[str], anew: bool = False, note: Callable[[int], None] | None = None,
    flags: OverlayFlags | None = None,
) -> Path:  # fmt: skip
    """Write the first match of a replay as a page; `note` is called after each control step. See `showing.html`."""
    target = Path(path)
    if target.suffix.lower() != ".html":
        raise ValueError(f"the path of a page must end with .html, got {str(path)!r}")
    check_overwrite(target, anew)
    write_atomically(target, make_page(collect_page_data(replay, note, flags)))
    return target


def make_page(contents: dict[str, Any]) -> str:
    """Return the page that shows the contents, a result of `collect_page_data`."""
    home, away = contents["teams"]
    scripts = "\n".join(read_part(name) for name in SCRIPTS)
    filled = {
        "TITLE": html.escape(f"{home} - {away}"),
        "STYLE": read_part("look.css"),
        "DATA": script_json(contents),
        "SCRIPT": f'"use strict";\n(() => {{\n{scripts}\n}})();',
    }
    return fill_template(read_part("page.html"), filled)


def fill_template(template: str, filled: dict[str, str]) -> str:
    """Replace each %%NAME%% of a template by its text, which is not looked at again."""
    pieces = template.split("%%")  # text, name, text, name, ..., text
    return "".join(filled[piece] if at % 2 else piece for at, piece in enumerate(pieces))


def script_json(value: Any) -> str:
    """Return a value as JSON that cannot close the script element around it."""
    text = json.dumps(value, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
    return text.translate(ESCAPED)


def read_part(name: str) -> str:
    """Return the text of a file of this folder."""
    return files(__package__).joinpath(name).read_text(encoding="utf-8")
