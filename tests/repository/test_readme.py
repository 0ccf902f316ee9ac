"""The pages: every Python example and the tutorial run, every command can be typed, every link leads somewhere."""

import re
import sys
from collections.abc import Iterator
from dataclasses import fields
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import gymnasium
import pytest

from soccer_env import Match, __version__, soccer_v0
from soccer_env.leagues import LEAGUES
from soccer_env.match.arguments import MatchSettings
from soccer_env.scenes import SCENES
from soccer_env.teams import NAMES
from soccer_env.train.command.command_line import COMMANDS

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
PAGES = (
    "README.md", "CONTRIBUTING.md", "SECURITY.md", "soccer_env/README.md", "soccer_env/perception/README.md",
    "soccer_env/scenes/README.md",
    "baselines/README.md", "baselines/heinemann_2006/README.md", "baselines/sacks_2001/README.md",
    "baselines/weigel_2001/README.md", "agents/policies/README.md", "train/README.md", "train/MEASURED.md",
    "train/CLUSTER.md",
)  # fmt: skip
TUTORIALS = ("train/FROM_ZERO.md", "train/WATCH_AND_PLOT.md", "train/TRAIN_AND_RANK.md")  # run as notebooks
OTHERS = ("CHANGELOG.md", "soccer_env/REFERENCES.md", *TUTORIALS)  # linked
TEXTS = {page: (ROOT / page).read_text(encoding="utf-8") for page in (*PAGES, *OTHERS)}
EXECUTABLES = {"make", "soccer", "pip", "python", "pytest", "git", "ruff", "mypy", "cffconvert"}
README_LINES = 160
WORDS = {  # of each heading of the README
    "# soccer_env": 120,
    "Install": 80,
    "Play": 60,
    "Gallery": 205,
    "Measured": 305,
    "How it compares": 115,
    "Where to look": 55,
    "Licence": 25,
    "Cite": 35,
}
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
LISTS = {"soccer_env/README.md": sorted(LEAGUES), "baselines/README.md": sorted(NAMES)}  # what ships
LINE = 160  # characters of a line that no command and no table needs
SLOW = ("TrainSettings(", "stable_baselines3")  # examples that take more than five seconds


class Block(NamedTuple):
    """A fenced block of Markdown and the line on which its first line stands."""

    text: str
    line: int


def blocks(markdown: str, language: str) -> list[Block]:
    """Return the fenced blocks of one language, those of a list item without their indentation."""
    found = []
    for match in re.finditer(r"^([ ]*)(`{3,})([^`\n]*)\n(.*?)^\1\2[ ]*$", markdown, re.MULTILINE | re.DOTALL):
        indent, _, info, text = match.groups()
        if info.split()[:1] == [language]:
            lines = [line.removeprefix(indent) for line in text.splitlines()]
            found.append(Block("\n".join(lines) + "\n", markdown[: match.start(4)].count("\n") + 1))
    return found


def commands(shell: str) -> list[list[str]]:
    """Return the words of each command of a shell block, without comments, prompts and variable settings."""
    found = []
    for line in shell.replace("\\\n", " ").splitlines():
        for part in re.split(r"&&|\|\||[;|]", re.sub(r"(^|\s)#.*", "", line)):
            words = part.removeprefix("$ ").split()
            while words and re.fullmatch(r"\w+=\S*", words[0]):
                words.pop(0)
            if words:
                found.append(words)
    return found


def run_block(block: Block, name: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Execute a block as a module of its own, in a file whose line numbers are the README's."""
    module = ModuleType(name)
    file = folder / f"{name}.py"
    source = "\n" * (block.line - 1) + block.text
    file.write_text(source, encoding="utf-8")
    module.__file__ = str(file)
    monkeypatch.setitem(sys.modules, name, module)  # dataclasses and protocols look their module up
    monkeypatch.chdir(folder)
    exec(compile(source, str(file), "exec"), module.__dict__)


def examples() -> Iterator[Any]:
    """Yield the Python examples of all pages, each with the page it stands in."""
    for page in PAGES:
        for block in blocks(TEXTS[page], "python"):
            slow = [pytest.mark.slow] if any(word in block.text for word in SLOW) else []
            yield pytest.param(page, block, id=f"{page} line {block.line}", marks=slow)


@pytest.mark.parametrize(("page", "block"), list(examples()))
def test_python_example_runs(page: str, block: Block, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    name = re.sub(r"\W", "_", page.removesuffix(".md"))
    if "import torch" in block.text:
        pytest.importorskip("torch")
    run_block(block, f"{name}_line_{block.line}", tmp_path, monkeypatch)


@pytest.mark.parametrize("page", PAGES)
def test_commands_can_be_typed(page: str) -> None:
    typed = [words for block in blocks(TEXTS[page], "bash") for words in commands(block.text)]
    assert [words for words in typed if words[0].removeprefix(".venv/bin/") not in EXECUTABLES] == []
    targets = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    assert [words for words in typed if words[0] == "make" and not set(words[1:]) <= targets] == []
    assert [words for words in typed if words[0] == "soccer" and words[1] not in {"--help", *COMMANDS}] == []


def test_the_two_first_commands_come_first_and_ci_runs_all_tests() -> None:
    typed = [words for block in blocks(TEXTS["README.md"], "bash") for words in commands(block.text)]
    assert typed[:2] == [["make", "match"], ["make", "test"]]
    assert "part make test-all\n" in (ROOT / ".ci/run").read_text(encoding="utf-8")


def test_the_readme_is_short_and_its_lines_too() -> None:
    assert len(TEXTS["README.md"].splitlines()) <= README_LINES
    for page in PAGES:
        shown = re.sub(r"<!-- table: (\w+) -->.*?<!-- end of table: \1 -->", "", TEXTS[page], flags=re.DOTALL)
        if page != "baselines/sacks_2001/README.md":
            assert [line for line in shown.splitlines() if len(line) > LINE and "](" not in line] == [], page


def test_the_page_of_the_environment_says_what_every_extra_is_for() -> None:
    extras = PROJECT["optional-dependencies"]
    _, _, section = TEXTS["soccer_env/README.md"].partition("\n## Extras and environment variables\n")
    named = set(re.findall(r"`([\w]+)`", section.partition("| variable |")[0]))
    assert sorted(set(extras) ^ named) == []
    inside = re.findall(r"\w+", extras["all"][0].partition("[")[2])
    assert len(inside) == 7, "the page counts what `all` has"


def test_each_heading_of_the_readme_keeps_to_its_words() -> None:
    parts = re.split(r"^## ", TEXTS["README.md"], flags=re.MULTILINE)
    words = {part.split("\n")[0]: len(part.split()) for part in parts}
    assert sum(WORDS.values()) <= 1000
    assert list(words) == list(WORDS)
    assert {name: count for name, count in words.items() if count > WORDS[name]} == {}


def gallery() -> dict[str, str]:
    """Return the line of code of each picture in the gallery of the README."""
    return dict(re.findall(r"!\[[^]]+\]\(soccer_env/pictures/([\w.-]+)\)<br>[^`]+`([^`]+)`", TEXTS["README.md"]))


@pytest.mark.parametrize("picture", gallery())
def test_the_code_below_each_picture_of_the_gallery_runs(picture: str) -> None:
    code = gallery()[picture]
    if code.startswith("soccer "):
        assert code.split()[1] in COMMANDS
    else:
        found = eval(code, {"Match": Match, "soccer_v0": soccer_v0, "gymnasium": gymnasium})
        if "episode" in code:  # a drill: the picture bears its name
            assert found.settings.scene.name == picture.removesuffix(".png")


def test_the_gallery_shows_both_leagues_two_pictures_a_row_and_the_table_counts_the_drills() -> None:
    rows = re.findall(r"^\| !.*$", TEXTS["README.md"], re.MULTILINE)
    assert len(gallery()) == 2 * len(rows) == TEXTS["README.md"].count("<br>")
    assert {'Match("legged-2001")', 'Match("middle-size-2006")'} <= set(gallery().values())
    drills = [scene for scene in SCENES.values() if scene.success != "none"]
    assert f"| drills | {len(drills)} |" in TEXTS["README.md"]


def test_badges_and_citation_say_what_the_package_says() -> None:
    versions = [x.rpartition(" ")[2] for x in PROJECT["classifiers"] if re.search(r":: 3\.\d+$", x)]
    python, licence = (ROOT / f"soccer_env/pictures/{name}.svg" for name in ("python", "licence"))
    assert f">{versions[0]} to {versions[-1]}<" in python.read_text(encoding="utf-8")
    assert f">{PROJECT['license']}<" in licence.read_text(encoding="utf-8")
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    for field in ("title", "version"):
        told = re.findall(rf'^{field}: "?([^"\n]+)', citation, re.MULTILINE)
        assert told and re.findall(f"{field} = {{([^}}]+)}}", TEXTS["README.md"])[:1] == told[:1]
    (day,) = re.findall(r"^date-released: ([-\d]+)$", citation, re.MULTILINE)
    assert told == [__version__]
    newest = re.search(r"^## (.*)", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert newest and newest[1] == f"[{told[0]}] - {day}"


def test_the_page_of_the_environment_names_every_setting_of_a_match() -> None:
    _, _, section = TEXTS["soccer_env/README.md"].partition("\n## Settings\n")
    rows = re.findall(r"^\| (`.*?`) \|", section.partition("\n## ")[0], re.MULTILINE)
    named = {name for row in rows for name in re.findall(r"`(\w+)`", row)}
    known = {field.name for field in fields(MatchSettings)}
    assert known - named <= {"autoreset"}  # of `Match` alone, in the text below the table
    assert named - known <= {"opponents", "teammates", "controllers"}


def links(markdown: str) -> list[str]:
    """Return the targets of the links and pictures of a page, without those in code."""
    prose = re.sub(r"^( *)(`{3,}).*?^\1\2 *$|`[^`\n]*`", "", markdown, flags=re.DOTALL | re.MULTILINE)
    return re.findall(r"\]\(([^)\s]+)\)", prose)


def anchors(markdown: str) -> set[str]:
    """Return the names of a page's headings, as GitHub and the site make them."""
    titles = re.findall(r"^#+ (.+)$", markdown, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).strip().replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", TEXTS)
def test_links_lead_to_a_page_a_heading_or_a_picture(page: str) -> None:
    for link in links(TEXTS[page]):
        if link.startswith("https://"):
            continue
        path, _, heading = link.partition("#")
        target = ((ROOT / page).parent / path).resolve() if path else ROOT / page
        assert target.is_file(), f"{page} links to {link}"
        if heading:
            assert heading in anchors(target.read_text(encoding="utf-8")), f"{page} links to {link}"


def test_every_page_is_reached_from_the_readme() -> None:
    reached, queue = {"README.md"}, ["README.md"]
    while queue:
        page = queue.pop()
        for link in links(TEXTS[page]):
            target = ((ROOT / page).parent / link.partition("#")[0]).resolve()
            name = target.relative_to(ROOT).as_posix() if target.is_relative_to(ROOT) else ""
            if name in TEXTS and name not in reached:
                reached.add(name)
                queue.append(name)
    assert reached == set(TEXTS)


EXAMPLE = """
```bash
$ make match   # plays
SEED=1 soccer evaluate \\
    --out runs/x && rm -rf runs/x
```
```text
not python
```
* item
  ```python
  from dataclasses import dataclass

  @dataclass
  class A:
      x: "int"
  assert A(1).x == 2, "wrong"
  ```
"""


def test_blocks_and_commands_are_found() -> None:
    (shell,) = blocks(EXAMPLE, "bash")
    assert commands(shell.text) == [
        ["make", "match"], ["soccer", "evaluate", "--out", "runs/x"], ["rm", "-rf", "runs/x"],
    ]  # fmt: skip
    (example,) = blocks(EXAMPLE, "python")
    assert example.line == 12
    assert example.text.startswith("from dataclasses")


@pytest.mark.parametrize("page", LISTS)
def test_what_ships_is_named_on_its_page(page: str) -> None:
    named = set(re.findall(r"`([\w-]+)`", TEXTS[page]))
    assert [name for name in LISTS[page] if name not in named] == []
