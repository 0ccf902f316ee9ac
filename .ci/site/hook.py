"""Build the site from the pages that lie in the folders, and from the package itself.

mkdocs calls `on_config` and `on_files`. Pages keep the paths that they have in the repository, so that the links
between them hold in both places; `pages/` makes the others.
"""

from __future__ import annotations

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from pages import catalogue, claims, commands, examples, notebooks, reference

ROOT = reference.ROOT
PAGES = ("*.md", "soccer_env/**/*.md", "baselines/**/*.md", "agents/**/*.md", "train/**/*.md")
MADE = {
    "How-to": examples.navigation,
    "Reference": lambda: [{"Command line": "commands.md"}, *catalogue.navigation(), *reference.navigation()],
    "Explanation": claims.navigation,
}
LINKED = ("soccer_env/pictures/*", "agents/policies/*.png", "train/*.ipynb", "CITATION.cff")


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Add the pages that are made to the navigation."""
    home, *topics = config.nav or []
    for topic in topics:
        (name,) = topic
        topic[name] += MADE.get(name, list)()
    config.nav = [home, *topics]
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages of the repository, the files that they link, and the pages that are made."""
    made = catalogue.pages() | claims.pages() | examples.pages() | notebooks.pages() | reference.pages()
    for pattern in (*PAGES, *LINKED):
        for path in sorted(ROOT.glob(pattern)):
            uri = path.relative_to(ROOT).as_posix()
            if path.is_file() and uri not in made:  # a page with a notebook is made with its outputs
                files.append(File.generated(config, uri, abs_src_path=str(path)))
    for uri, content in {"commands.md": commands.page(), **made}.items():
        files.append(File.generated(config, uri, content=content))
    return files
