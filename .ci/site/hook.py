"""Build the site from the pages that lie in the folders, and its reference from the packages' docstrings.

mkdocs calls `on_config` and `on_files`. Pages keep the paths that they have in the repository, so that the links
between them hold in both places; a page of the reference is made for each package, with its modules.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

ROOT = Path(__file__).resolve().parents[2]
PACKAGES = {"soccer_env": "soccer_env"} | {f"soccer_env.{name}": name for name in ("baselines", "agents", "train")}
PAGES = ("*.md", "soccer_env/**/*.md", "baselines/**/*.md", "agents/**/*.md", "train/**/*.md")
PICTURES = ("soccer_env/pictures/*", "agents/policies/*.png")
HEAD_ONLY = "    options:\n      show_root_heading: false\n      members: false\n"


def packages() -> Iterator[tuple[str, Path]]:
    """Yield the import name and the folder of every package, in order."""
    for name, folder in PACKAGES.items():
        for file in sorted((ROOT / folder).rglob("__init__.py")):
            inner = file.parent.relative_to(ROOT / folder).parts
            yield ".".join([name, *inner]), file.parent


def first_line(file: Path) -> str:
    """Return the first line of a module's docstring."""
    text = ast.get_docstring(ast.parse(file.read_text(encoding="utf-8"))) or ""
    return text.partition("\n")[0]


def index_page() -> str:
    """Return the page that names every package and says what it is for."""
    lines = ["# Reference", "", "Every package with its modules, from their docstrings.", ""]
    lines += ["| package | what it is |", "|---|---|"]
    for name, folder in packages():
        lines.append(f"| [`{name}`]({name}.md) | {first_line(folder / '__init__.py')} |")
    return "\n".join(lines) + "\n"


def package_page(name: str, folder: Path) -> str:
    """Return the page of a package: its docstring, then each of its modules."""
    parts = [f"# `{name}`\n", f"::: {name}\n{HEAD_ONLY}"]
    for file in sorted(folder.glob("*.py")):
        if not file.stem.startswith("__"):
            parts.append(f"::: {name}.{file.stem}\n")
    return "\n".join(parts)


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Add the pages of the reference to the navigation."""
    pages: list[Any] = [{name: f"reference/{name}.md"} for name, _ in packages()]
    config.nav = [*(config.nav or []), {"Reference": ["reference/index.md", *pages]}]
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages and pictures of the repository, and the pages of the reference."""
    for pattern in (*PAGES, *PICTURES):
        for path in sorted(ROOT.glob(pattern)):
            if path.is_file():
                uri = path.relative_to(ROOT).as_posix()
                files.append(File.generated(config, uri, abs_src_path=str(path)))
    files.append(File.generated(config, "reference/index.md", content=index_page()))
    for name, folder in packages():
        files.append(File.generated(config, f"reference/{name}.md", content=package_page(name, folder)))
    return files
