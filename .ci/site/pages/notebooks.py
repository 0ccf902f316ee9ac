"""Pages that have a notebook: each with the outputs of its notebook below its code."""

from __future__ import annotations

import json
from base64 import b64decode
from pathlib import Path
from typing import Any

from pages.reference import ROOT

FOLDER = ROOT / "train"
BASH = "%%bash -e\n"


def pages() -> dict[str, str | bytes]:
    """Return the pages by path, with the pictures that they show."""
    found: dict[str, str | bytes] = {}
    for file in sorted(FOLDER.glob("*.ipynb")):
        found |= page(file)
    return found


def page(file: Path) -> dict[str, str | bytes]:
    """Return the page of a notebook and its pictures by path."""
    parts, pictures = [], {}
    for cell in json.loads(file.read_text(encoding="utf-8"))["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(source)
            continue
        is_bash = source.startswith(BASH)
        parts.append(f"```{'bash' if is_bash else 'python'}\n{source.removeprefix(BASH)}\n```")
        for output in cell["outputs"]:
            if png := output.get("data", {}).get("image/png"):
                name = f"{file.stem}-{len(pictures) + 1}.png"
                pictures[f"train/{name}"] = b64decode("".join(png))
                parts.append(f"![What the code above shows]({name})")
            else:
                parts.append(f"```text\n{text_of(output)}\n```")
    return {f"train/{file.stem}.md": "\n\n".join(parts) + "\n", **pictures}


def text_of(output: dict[str, Any]) -> str:
    """Return the text of an output."""
    return "".join(output["text"] if "text" in output else output["data"]["text/plain"]).rstrip()
