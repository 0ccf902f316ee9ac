"""The README of the teams of 2006: what the paper says beside what was measured, and every setting with its source.

    python -m soccer_env.train.tables.heinemann                 measure every claim (goes on where it stopped)
    python -m soccer_env.train.tables.heinemann run FOLDER ...  take in what runs of `soccer reproduce` found
    python -m soccer_env.train.tables.heinemann write           write README.md again from claims.json

Measurements are kept in baselines/heinemann_2006/claims.json; README.md beside it shows them between markers. The
paper's figure, planned and travelled paths of both planners, is drawn anew each time that something is measured.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from soccer_env.baselines.heinemann_2006 import settings as heinemann_settings
from soccer_env.baselines.heinemann_2006.settings import HeinemannSettings
from soccer_env.baselines.weigel_2001.planner import PlannerSettings
from soccer_env.train.plots.style import canvas, plot
from soccer_env.train.reproduce.claim import HEINEMANN
from soccer_env.train.reproduce.claims import all_claims
from soccer_env.train.reproduce.reproduction import reproduce
from soccer_env.train.reproduce.settings import ReproduceSettings
from soccer_env.train.tables.markers import between_markers
from soccer_env.train.tables.sacks import SHOWN, claims_table, take_folder, take_pictures, with_notes
from soccer_env.train.tables.sacks_settings import settings_table
from soccer_env.whole_files import write_whole

FOLDER = Path(heinemann_settings.__file__).resolve().parent
README, DATA = FOLDER / "README.md", FOLDER / "claims.json"
RUN = Path("runs/claims-heinemann")  # where all claims are measured, so that it can be stopped
PICTURES = {"H10": 1, "H20": 1}  # of the page: a claim's figure, by its number
PATHS = "heinemann-paths.png"
CLAIMS = tuple(claim.id for claim in all_claims().values() if claim.paper == HEINEMANN and not claim.study)

Measured = Mapping[str, Mapping[str, Any]]
PARTS: dict[str, Callable[[Measured], str]] = {
    "claims": lambda measured: claims_table(measured, CLAIMS),
    "settings": lambda _: settings_table(HeinemannSettings()),
    "planner": lambda _: settings_table(PlannerSettings()),
}


def with_parts(readme: str, measured: Measured) -> str:
    """Return the README with its tables between their markers."""
    for name, show in PARTS.items():
        readme = between_markers(readme, name, show(measured))
    return readme


def stored() -> dict[str, dict[str, Any]]:
    """Return what claims.json holds."""
    found: dict[str, dict[str, Any]] = json.loads(DATA.read_text(encoding="utf-8")) if DATA.exists() else {}
    return found


def write(measured: Measured) -> None:
    """Write claims.json and README.md."""
    ordered = with_notes({name: measured[name] for name in CLAIMS if name in measured})
    write_whole(DATA, json.dumps(ordered, indent=1) + "\n")
    write_whole(README, with_parts(README.read_text(encoding="utf-8"), ordered))


def measure() -> dict[str, dict[str, Any]]:
    """Measure every claim of the paper, in RUN, and return them."""
    reproduce(ReproduceSettings(claims=CLAIMS, threads=2, out=RUN))
    return take_run(RUN)


def take_run(path: Path) -> dict[str, dict[str, Any]]:
    """Return the claims of a run, and take its figures; draw the paper's own anew."""
    take_pictures(path, PICTURES)
    write_whole(SHOWN / PATHS, draw_paths())
    return take_folder(path, CLAIMS, HEINEMANN)


@plot
def draw_paths() -> Any:
    """Return the paper's figure as a PNG: both planners in crossing a after 1, 30 and 60 cycles.  MH18"""
    from soccer_env.baselines.weigel_2001.planner.drawing import draw_travel
    from soccer_env.train.reproduce.claims.ways.crossings import CYCLES
    from soccer_env.train.reproduce.claims.ways.runs import PLANNERS, travel
    from soccer_env.train.reproduce.claims.ways.scenes import CANONICAL

    drawn, rows = canvas(5.2, 10.0, 2, len(CYCLES), sharex=True, sharey=True)
    for row, (name, changes) in zip(rows, PLANNERS.items(), strict=True):
        one = travel(CANONICAL["a"], **changes)
        for axes, cycle in zip(row, CYCLES, strict=True):
            draw_travel(axes, one, cycle)
            axes.set_title(f"{'conventional' if name == 'old' else 'time-variant'}, t = {cycle}", fontsize="small")
            axes.set(xlim=(-4.0, 4.0), ylim=(-2.5, 2.5))
    return drawn


def main(arguments: Iterable[str]) -> int:
    """Measure, take in runs or write; return the exit code."""
    words = list(arguments)
    if not words:
        write(measure())
    elif words == ["write"]:
        write(stored())
    elif words[0] == "run" and len(words) > 1:
        measured = stored()
        for folder in words[1:]:
            measured |= take_run(Path(folder))
        write(measured)
    else:
        print("usage: python -m soccer_env.train.tables.heinemann [run FOLDER ... | write]", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
