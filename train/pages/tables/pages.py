"""The tables of the pages: measured by commands, stored as JSON beside this file, written between markers.

TABLES has all tables; the headlines of the main README are taken from the other tables.

    python -m soccer_env.train.pages.tables [NAME]     measure all tables, or one, and write file and pages;
        [--ray [ADDRESS]]                              play on a Ray cluster; times are measured here in any case
    python -m soccer_env.train.pages.tables write      write the pages again from the file, without measuring
    python -m soccer_env.train.pages.tables states     update the final states of first pairs whose scores agree,
                                                       after a change to the fields of records (never to play)
    python -m soccer_env.train.pages.tables --check    replay a small part of each table; fail if it no longer agrees

The check plays the first pair of matches of every row again and compares score and final state. With other versions or
another kind of machine play differs in its last bits: the check then reports this instead. For speed it measures
quickly and fails only if a ratio has grown beyond SLOWER.
"""

import json
import sys
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple

from soccer_env.guards.whole_files import write_atomically
from soccer_env.train.bench.benchmark import run_benchmark as run_bench
from soccer_env.train.bench.settings import BenchSettings
from soccer_env.train.command.parsing import fill_flag, take_out_flag
from soccer_env.train.pages.tables.drills import drills_table, measure_drills
from soccer_env.train.pages.tables.headlines import headlines_table
from soccer_env.train.pages.tables.ladder import ladder_table, measure_ladder
from soccer_env.train.pages.tables.learned import (
    learned_table,
    measure_learned,
    measure_training,
    training_table,
)
from soccer_env.train.pages.tables.paper_page import replace_between_markers
from soccer_env.train.pages.tables.plausibility import measure_plausibility, plausibility_table
from soccer_env.train.pages.tables.robustness import measure_robustness, robustness_table
from soccer_env.train.pages.tables.teams import (
    first_pair,
    heinemann_rows,
    heinemann_table,
    measure_rows,
    replay_row,
    sacks_rows,
    sacks_table,
    scripted_rows,
    scripted_table,
)
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.replays import changed_rows
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.results import FOLDERS, read_stored
from soccer_env.train.papers.settings import ReproduceSettings, command_of
from soccer_env.train.provenance import date_and_commit, play_facts
from soccer_env.train.written_settings import with_ray
from soccer_env.types import WORLD

DATA = Path(__file__).with_name("tables.json")
ROOT = Path(__file__).resolve().parents[3]
# tables whose rows are matches
PLAYED = ("ladder", "scripted", "sacks", "heinemann", "learned", "learned_2006", "plausibility", "robustness")
SLOWER = 2.0  # factor by which a ratio may grow before the check fails; machines are noisy


def measure_sensors(ray: str | None = None) -> dict[str, Any]:
    """Measure the errors of all sensors and estimates over the range."""
    settings = ReproduceSettings(claims=("sensors",), seeds=(1,), threads=2)
    (result,) = reproduce(with_ray(settings, ray))
    return {"command": command_of(settings), "n": result.n, "note": result.note}


def measure_speed() -> dict[str, Any]:
    """Measure the speed."""
    bench = run_bench(BenchSettings())
    return {"command": "soccer bench", "machine": bench["machine"], "rows": bench["rows"]}


def about() -> dict[str, str]:
    """Return date, commit, machine and versions of a measurement."""
    return date_and_commit() | play_facts()


def sensors_table(table: dict[str, Any]) -> str:
    """Return the table of the sensors' errors in Markdown."""
    return f"{table['note'].strip()}\n\nCommand: `{table['command']}`, n = {table['n']}."


def speed_table(table: dict[str, Any]) -> str:
    """Return the table of speeds in Markdown."""
    lines = ["| | measured | target |", "|---|---|---|"]
    for row in table["rows"]:
        missed = {False: " (missed)", True: "", None: ""}[row["met"]]
        lines.append(f"| {row['name']} | {row['text']}{missed} | {row['target']} |")
    host = table["machine"]
    where = f"{host['processor']}, {host['cores']} cores, load before {host['load before']}, Python {host['python']}"
    return "\n".join([*lines, "", f"Command: `{table['command']}`. {where}."])


class PageTable(NamedTuple):
    """A table: the page that shows it, seen from the checkout's root, and the functions that measure and show it."""

    page: str
    measure: Callable[[str | None], dict[str, Any]]  # of the address of a Ray cluster; without `about`
    show: Callable[[dict[str, Any]], str]  # in Markdown, without footer


TABLES = {
    "sensors": PageTable("soccer_env/perception/README.md", measure_sensors, sensors_table),
    "ladder": PageTable("baselines/README.md", measure_ladder, ladder_table),
    "scripted": PageTable("baselines/README.md", lambda ray: measure_rows(scripted_rows(), ray), scripted_table),
    "sacks": PageTable("baselines/README.md", lambda ray: measure_rows(sacks_rows(), ray), sacks_table),
    "heinemann": PageTable("baselines/README.md", lambda ray: measure_rows(heinemann_rows(), ray), heinemann_table),
    "robustness": PageTable("baselines/README.md", measure_robustness, robustness_table),
    "drills": PageTable("soccer_env/scenes/README.md", measure_drills, drills_table),
    "learned": PageTable("agents/policies/README.md", lambda ray: measure_learned("learned", ray), learned_table),
    "learned_2006": PageTable(
        "agents/policies/README.md", lambda ray: measure_learned("learned-2006", ray), learned_table
    ),
    "training": PageTable("train/MEASURED.md", lambda ray: measure_training(), training_table),
    "speed": PageTable("train/MEASURED.md", lambda ray: measure_speed(), speed_table),
    "plausibility": PageTable("train/MEASURED.md", measure_plausibility, plausibility_table),
}
PAGES = {"headlines": "README.md"} | {name: table.page for name, table in TABLES.items()}


def add_footer(text: str, table: dict[str, Any]) -> str:
    """Return a table with its footer, which has a hash of the settings of all its rows."""
    hashes = [row["settings_hash"] for row in table.get("rows", []) if "settings_hash" in row]
    settings = {"settings": sha256(" ".join(hashes).encode()).hexdigest()[:12]} if hashes else {}
    return f"{text}\n{footer(table['about'] | settings)}"


def footer(facts: dict[str, str]) -> str:
    """Return the line under a table: date, commit, machine and versions; and the world, if it is an older one."""
    about = "Made by `make tables`: " + ", ".join(f"{name} {value}" for name, value in facts.items()) + "."
    world = facts.get("world", "1")
    return about if world == str(WORLD) else f"{about} Measured in world {world}; the present one is {WORLD}."


def fill_page_tables(text: str, page: str, data: dict[str, Any]) -> str:
    """Return a page with its tables between their markers; ValueError for a marker that is missing."""
    for name, where in PAGES.items():
        if where != page:
            continue
        if name == "headlines":
            text = replace_between_markers(text, name, headlines_table(data))
        elif name in data:
            text = replace_between_markers(text, name, add_footer(TABLES[name].show(data[name]), data[name]))
    return text


def page_text(page: str) -> str:
    """Return the present text of a page."""
    return (ROOT / page).read_text(encoding="utf-8")


def check(data: dict[str, Any], quick: bool = False) -> list[str]:
    """Measure a small part of each table again; return a sentence for each difference. `quick`: without the speed."""
    problems = []
    for page in dict.fromkeys(PAGES.values()):
        if fill_page_tables(page_text(page), page, data) != page_text(page):
            problems.append(f"{page} does not show what tables.json holds: run python -m {__package__} write")
    now = play_facts()
    for name in PLAYED:
        if name not in data:
            continue
        made = data[name]["about"]
        if all(made.get(fact, "1") == now[fact] for fact in now):
            problems += [problem for row in data[name]["rows"] for problem in replay_row(row)]
        else:
            print(
                f"tables: versions, machine or world differ from those of {name}; matches are not compared",
                file=sys.stderr,
            )
    for folder in FOLDERS.values():
        problems += changed_rows(read_stored(folder), all_claims())
    return problems if quick else problems + slower_rows(data["speed"])


def update_final_states(data: dict[str, Any]) -> list[str]:
    """Play the first pair of each row again; update its final states in `data`; return a sentence per changed score."""
    problems = []
    for row in (row for name in PLAYED for row in data.get(name, {"rows": []})["rows"]):
        again = first_pair(row)
        if [pair[:2] for pair in again] == [pair[:2] for pair in row["first_pair"]]:
            row["first_pair"] = again
        else:
            problems.append(f"{row['command']}: the first pair now ends {again}, the table has {row['first_pair']}")
    return problems


def slower_rows(table: dict[str, Any]) -> list[str]:
    """Measure the speed quickly; return a sentence for each ratio to the bare physics that has grown beyond SLOWER."""
    before = {
        row["name"]: row["value"] for row in table["rows"] if " over " in row["name"] and "threads" not in row["name"]
    }
    now = {row["name"]: row["value"] for row in run_bench(BenchSettings(quick=True))["rows"]}
    return [
        f"{name}: {now[name]:.2f} now, {value:.2f} in the table"
        for name, value in before.items()
        if now[name] > SLOWER * value
    ]


def read_measurements() -> dict[str, Any]:
    """Return the stored measurements."""
    tables: dict[str, Any] = json.loads(DATA.read_text(encoding="utf-8"))
    return tables


def write_pages(data: dict[str, Any]) -> None:
    """Write every table into its page."""
    for page in dict.fromkeys(PAGES.values()):
        write_atomically(ROOT / page, fill_page_tables(page_text(page), page, data))


def main(arguments: list[str]) -> int:
    """Measure and write the tables, or check them; return the exit code."""
    ray, arguments = take_out_flag(fill_flag(arguments, "--ray", "local"), "--ray")
    names = [name for name in arguments if name in TABLES]
    others = (["write"], ["states"], ["--check"], ["--check", "--quick"])
    if arguments != names and (ray or arguments not in others):
        choices = f"[{'|'.join(TABLES)} ...] [--ray [ADDRESS]], or write, states, --check [--quick]"
        print(f"usage: python -m soccer_env.train.pages.tables {choices}", file=sys.stderr)
        return 2
    if arguments == ["write"]:
        write_pages(read_measurements())
        return 0
    if arguments == names:
        data = read_measurements() if names else {}
        data |= {name: {"about": about(), **TABLES[name].measure(ray or None)} for name in names or TABLES}
        write_atomically(DATA, json.dumps(data, indent=1) + "\n")
        write_pages(data)
        return 0
    if arguments == ["states"]:
        data = read_measurements()
        problems = update_final_states(data)
        write_atomically(DATA, json.dumps(data, indent=1) + "\n")
    else:
        problems = check(read_measurements(), quick="--quick" in arguments)
    for problem in problems:
        print(problem, file=sys.stderr)
    print("tables: " + ("all agree" if not problems else f"{len(problems)} no longer agree"))
    return 1 if problems else 0
