"""The site: every public name has a place in its reference, and it builds strictly from the pages where they lie."""

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from dataclasses import fields
from enum import IntEnum
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

import soccer_env
from soccer_env.actions import MEANINGS
from soccer_env.leagues import find_league
from soccer_env.match.arguments import MatchArguments
from soccer_env.observations import OBSERVE, layout
from soccer_env.rewards import NAMES
from soccer_env.scenes import SCENES
from soccer_env.statistics.figures import FIGURES
from soccer_env.teams import NAMES as TEAMS
from soccer_env.train.command.command_line import COMMANDS, kinds_of_settings
from soccer_env.train.command.parsing import flags_of
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.results import FOLDERS, read_stored

for package in ("mkdocs", "material", "mkdocstrings"):
    pytest.importorskip(package)

ROOT = Path(__file__).parents[2]
LINKED = (
    *("Makefile", "pyproject.toml", "mkdocs.yml", "CONTRIBUTING.md", "CHANGELOG.md", "SECURITY.md", "README.md"),
    *(".ci", "soccer_env", "baselines", "agents", "train"),
)


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], ModuleType]:
    """Return what imports a module of the site's own."""
    monkeypatch.syspath_prepend(ROOT / ".ci/site")
    return import_module


Site = Callable[[str], ModuleType]


def test_every_public_name_stands_on_a_page_for_users(site: Site) -> None:
    reference = site("pages.reference")
    shown = {f"soccer_env.{thing}" for page in reference.PUBLIC for thing in page.things}
    for name in soccer_env.__all__:
        found = getattr(soccer_env, name)
        assert any(x.startswith(f"{found.__name__}.") or x.endswith(f".{name}") for x in shown), name
    listed = [path for item in reference.navigation() for path in item.values()]
    assert listed[0] == "reference/index.md" and sorted(listed) == sorted(reference.pages())


@pytest.fixture(scope="module")
def read() -> ModuleType:
    """Return the package as the site reads it, with tables of fields."""
    griffe = pytest.importorskip("griffe")
    sys.path.insert(0, str(ROOT / ".ci/site"))
    try:
        tables = import_module("field_tables")
    finally:
        sys.path.pop(0)
    loader = griffe.GriffeLoader(search_paths=[ROOT], extensions=griffe.load_extensions(tables.FieldTables))
    return loader.load("soccer_env")  # type: ignore[no-any-return]


@pytest.mark.parametrize("module", ["types", "records.percepts", "records.beliefs"])
def test_every_field_of_every_record_and_code_is_in_a_table(read: Any, module: str) -> None:
    for name, found in vars(import_module(f"soccer_env.{module}")).items():
        if isinstance(found, np.dtype) and name.isupper() and name in read[module].members:
            told = read[module][name]
            if not told.is_alias:
                assert rows_of(told.docstring.value) == list(found.names or ())
        if isinstance(found, type) and issubclass(found, IntEnum) and found.__module__.endswith(f".{module}"):
            assert rows_of(read[module][name].docstring.value) == [item.name for item in found]


def rows_of(text: str) -> list[str]:
    return re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE)


def test_fields_have_their_units_defaults_and_meanings(read: Any) -> None:
    ball, phase = read["types.BALL"].docstring.value, read["types.Phase"].docstring.value
    assert "| `vx` | `f8` | `NUMBER` | m/s | field frame |" in ball
    assert "| `PENALTY_KICK` | 7 | of a penalty shoot-out |" in phase
    settings = read["match.arguments.MatchArguments"].docstring.value
    assert sorted(rows_of(settings)) == sorted(field.name for field in fields(MatchArguments))
    assert "| `max_cycles` | `int | None` | `None` | steps until an episode is truncated; None: never |" in settings


@pytest.mark.parametrize("league", ["legged-2001", "middle-size-2006"])
def test_every_entry_of_every_observation_stands_in_the_catalogue_in_numbers(site: Site, league: str) -> None:
    found = site("pages.catalogue").pages()[f"catalogue/observations-{league}.md"]
    told = re.findall(r"^\| \d+ \| `(\w+)` \|.*\| ([^|]+(?:\\\|[^|]+)*) \|[^|]*\|[^|]*\|$", found, re.MULTILINE)
    names = [entry.name for observe in OBSERVE for entry in layout(find_league(league), observe)]
    assert [name for name, _ in told][: len(names)] == names
    assert all(re.search(r"\d", number) for _, number in told), "a number with its unit"
    assert "| `own_x` | own position, towards the opponent's goal | half length plus goal depth |" in found


def test_the_catalogue_names_what_there_is_to_choose_from(site: Site) -> None:
    found = site("pages.catalogue").pages()
    for page, names in {"scenes": SCENES, "rewards": [*NAMES, "gamma"], "teams": TEAMS, "actions": MEANINGS}.items():
        assert [name for name in names if f"`{name}`" not in found[f"catalogue/{page}.md"]] == [], page
    figures = [x.name for x in FIGURES]
    assert [name for name in figures if f"`{name}" not in found["catalogue/statistics.md"]] == []


def test_everything_that_was_measured_of_a_claim_stands_on_its_own_page(site: Site) -> None:
    found = site("pages.claims").pages()
    for paper, folder in FOLDERS.items():
        stored = read_stored(folder)
        for claim in (one for one in all_claims().values() if one.paper == paper and not one.study):
            page, row = found[f"claims/{folder.name}/{claim.id}.md"], stored.get(claim.id)
            assert page.startswith(f"# {claim.id}: {row['verdict'] if row else 'not measured'}")
            assert claim.statement in page and f"soccer reproduce {claim.id} --out" in page
            shown = [one["shown"] for one in row["findings"]] if row else []
            assert [text for text in shown if f"| {text} |" not in page] == [], claim.id
            assert f"[{claim.id}]({claim.id}.md)" in found[f"claims/{folder.name}/index.md"]
    listed = str(site("pages.claims").navigation())
    assert [path for path in found if path.endswith(".md") and path not in listed] == []


def test_a_claims_page_shows_its_plot_its_cause_and_when_its_question_changed(site: Site) -> None:
    found = site("pages.claims").pages()
    assert found["claims/sacks_2001/S15-1.png"].startswith(b"\x89PNG")
    assert "](S15-1.png)" in found["claims/sacks_2001/S15.md"]
    s63 = found["claims/sacks_2001/S63.md"]
    assert "Likely cause: the paper; it does not tell the speed" in s63 and "\n[changed] 2026-11-22: before, " in s63
    assert "](S63-1.png)" in s63 and "| not [changed] |" in found["claims/sacks_2001/index.md"]


def test_every_option_of_every_command_stands_on_the_page_of_commands(site: Site) -> None:
    parts = dict(part.split("\n", 1) for part in site("pages.commands").page().split("\n## soccer ")[1:])
    kinds = kinds_of_settings()
    assert list(parts) == list(COMMANDS) and set(kinds) == set(COMMANDS)
    for name, part in parts.items():
        rows = re.findall(r"^\| `([^`]+)` \|.*\| (.*) \|$", part, re.MULTILINE)
        assert [flag for flag, meaning in rows if not meaning.strip()] == [], name
        flags = flags_of(kinds[name], pairs=False)
        assert [flag for flag in flags if f"| `{flag}` |" not in part] == [], name


def test_a_page_that_has_a_notebook_stands_there_with_its_outputs(site: Site) -> None:
    pages = site("pages.notebooks").pages()
    for file in (ROOT / "train").glob("*.ipynb"):
        shown = pages[f"train/{file.stem}.md"]
        lines = file.with_suffix(".md").read_text(encoding="utf-8").splitlines()
        assert [line for line in lines if line not in shown.splitlines()] == []
        cells = json.loads(file.read_text(encoding="utf-8"))["cells"]
        drawn = re.findall(rf"\]\(({file.stem}-\d+\.png)\)", shown)
        assert all(pages[f"train/{name}"].startswith(b"\x89PNG") for name in drawn)
        assert shown.count("```text\n") + len(drawn) == sum(len(cell.get("outputs", ())) for cell in cells)
    assert "train/WATCH_AND_PLOT-3.png" in pages


def strict_site(folder: Path) -> Path:
    """Return the site that continuous integration has just built by `make docs`, strictly, or one built in a folder."""
    if os.environ.get("CI") and (ROOT / "site/index.html").is_file():
        return ROOT / "site"
    for name in LINKED:
        (folder / name).symlink_to(ROOT / name)
    subprocess.run(["make", "types"], cwd=folder, check=True, capture_output=True)
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet"]
    environment = {**os.environ, "NO_MKDOCS_2_WARNING": "1"}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return folder / "site"


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("make") is None, reason="needs make")
def test_the_site_builds_strictly(tmp_path: Path) -> None:
    built = strict_site(tmp_path)
    home = (built / "index.html").read_text(encoding="utf-8")
    assert "soccer_env/pictures/match.gif" in home and (built / "soccer_env/pictures/match.gif").is_file()
    assert "fonts.googleapis.com" not in home
    assert all(f"> {topic} <" in " ".join(home.split()) for topic in ("Tutorial", "How-to", "Reference", "Explanation"))
    pages = {file.name for file in (built / "reference").iterdir() if file.is_dir()}
    assert "playing" in pages and not any(name.startswith("soccer_env") for name in pages), "public names alone"
    found = (built / "search/search_index.json").read_text(encoding="utf-8")
    assert all(name in found for name in ("own_x", "ball_near_x", "kick_ready", "max_cycles", "keep-pages"))
