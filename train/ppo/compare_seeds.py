"""Show how much a training varies from seed to seed: runs of one recipe and different seeds, drawn into one picture.

    for seed in 1 2 3; do
        soccer train --config legged-2001-short --seed $seed --out runs/short-$seed
    done
    python -m soccer_env.train.ppo.compare_seeds runs/short-1 runs/short-2 runs/short-3 --out spread.png

It prints the last evaluation of each run, and over the runs mean, least and most.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import tyro

from soccer_env.train.files import read_lines
from soccer_env.train.plots import draw_curves
from soccer_env.train.ppo.reports import decisions_of, scale
from soccer_env.train.ppo.run_folder import EVALUATIONS
from soccer_env.train.results_folder import SETTINGS
from soccer_env.whole_files import write_whole

MAY_DIFFER = ("seed", "name")  # of the settings of runs of one recipe


@dataclass(frozen=True)
class Run:
    """A training run: its conditions and its evaluations, oldest first."""

    conditions: dict[str, Any]
    evaluations: list[dict[str, Any]]


def read_run(folder: Path) -> Run:
    """Read a run's folder; ValueError for one without evaluations."""
    path = folder / SETTINGS
    if not path.is_file():
        raise ValueError(f"{folder} holds no training")
    evaluations = read_lines(folder / EVALUATIONS)
    if not evaluations:
        raise ValueError(f"{folder} holds no evaluation yet")
    return Run(json.loads(path.read_text(encoding="utf-8"))["conditions"], evaluations)


def check_alike(runs: Sequence[Run]) -> None:
    """Raise ValueError unless runs are of one recipe and of different seeds."""
    first = runs[0].conditions
    for run in runs[1:]:
        differing = [name for name in first if name not in MAY_DIFFER and run.conditions.get(name) != first[name]]
        if differing:
            raise ValueError(f"these runs are of different recipes: {', '.join(differing)} differ")
    seeds = [run.conditions["seed"] for run in runs]
    if len(set(seeds)) < len(seeds):
        raise ValueError(f"seeds must be different, got {', '.join(map(str, seeds))}")


def figure_of(runs: Sequence[Run]) -> dict[str, Any]:
    """Return the curves of goal differences, one for each opponent and run, for `plots.draw_curves`."""
    unit, words = scale(max(count for run in runs for count in decisions_of(run.evaluations)))
    curves = []
    for index, opponent in enumerate(opponents_of(runs)):
        for run in runs:
            rows = [one["rows"][index] for one in run.evaluations]
            curves.append(
                {
                    "name": f"against {opponent}, seed {run.conditions['seed']}",
                    "x": [count / unit for count in decisions_of(run.evaluations)],
                    "y": [row["goal_difference"] for row in rows], "low": [], "high": [],
                }
            )  # fmt: skip
    return {
        "title": f"{len(runs)} seeds of one recipe", "x_label": f"decisions{words}",
        "y_label": "goals - goals against, a match", "curves": curves, "rules": [0.0], "rule": "even",
    }  # fmt: skip


def opponents_of(runs: Sequence[Run]) -> list[str]:
    """Return the opponents of the evaluations."""
    return [row["opponent"] for row in runs[0].evaluations[-1]["rows"]]


def table_of(runs: Sequence[Run]) -> list[str]:
    """Return the last goal difference of each run and their spread, a line for each opponent."""
    lines = []
    for index, opponent in enumerate(opponents_of(runs)):
        last = np.array([run.evaluations[-1]["rows"][index]["goal_difference"] for run in runs])
        each = ", ".join(f"{value:+.2f}" for value in last)
        lines.append(f"{opponent}: {each}; mean {last.mean():+.2f}, from {last.min():+.2f} to {last.max():+.2f}")
    return lines


def main(runs: tuple[Path, ...], /, out: Path = Path("spread.png")) -> None:
    """Draw the evaluations of runs of one recipe and different seeds, and print where they ended.

    Args:
        runs: folders of the runs.
        out: the picture.
    """
    found = [read_run(folder) for folder in runs]
    if len(found) < 2:
        raise ValueError(f"a spread needs two runs at least, got {len(found)}")
    check_alike(found)
    print("\n".join(table_of(found)))
    write_whole(out, draw_curves(figure_of(found)))


if __name__ == "__main__":
    tyro.cli(main)
