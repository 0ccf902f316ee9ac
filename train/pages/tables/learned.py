"""The tables of the learned teams: their evaluations, and the time of training."""

import tempfile
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.train.evaluate.evaluation import evaluate
from soccer_env.train.evaluate.settings import EvaluateSettings
from soccer_env.train.files import read_lines
from soccer_env.train.pages.tables.teams import crosstable, goals_of, row_of, row_settings
from soccer_env.train.written_settings import with_ray

HELD_OUT = 2  # seed of these evaluations: the policies were trained with other seeds
LEARNED = {  # team: its league, opponents, matches of a cell, minutes of a whole match
    "learned": ("legged-2001", ("chaser", "sacks-2001", "sacks-2001-tuned"), 24, 20.0),
    "learned-2006": ("middle-size-2006", ("chaser", "heinemann-2006", "weigel-2001"), 60, 30.0),
}
CLEAN = ("goals_clean_kick_for", "goals_clean_dribble_for")
WHISTLES = "fouls_"
WHISTLED = "whistles a match in the matches against `chaser`, it : them"


def learned_rows(team: str) -> Iterator[EvaluateSettings]:
    """Yield the settings of a learned team's evaluations, in matches of its league's own length."""
    league, others, matches, minutes = LEARNED[team]
    for players in (1, 2, 3, 5):
        for away in others:
            settings = row_settings(league, team, away, "sensors", matches, minutes, players, HELD_OUT)
            yield replace(settings, pose="particles")


def measure_learned(team: str, ray: str | None = None) -> dict[str, Any]:
    """Play a learned team's evaluations, perhaps on a Ray cluster.

    Return their rows, with the rules, the whistles and the clean goals.
    """
    rows = []
    for settings in learned_rows(team):
        result = evaluate(with_ray(settings, ray))
        rows.append(
            row_of(settings, result)
            | whistles_and_goals(result.statistics)
            | {"rules": settings.rules, "pose": settings.pose}
        )
    return {"rows": rows}


def whistles_and_goals(statistics: Mapping[str, Any]) -> dict[str, Any]:
    """Return the numbers of whistles against each team, and of clean goals and of all goals of the learned team."""
    whistles = [
        sum(one.total for name, one in statistics.items() if name.startswith(WHISTLES) and name.endswith(side))
        for side in ("for", "against")
    ]
    clean = sum(statistics[name].total for name in CLEAN)
    return {"whistles": whistles, "clean_goals": [clean, statistics["goals_for"].total]}


def learned_table(table: dict[str, Any]) -> str:
    """Return the table of a learned team in Markdown: a row for each team size, a column for each opponent."""
    cells, first = {}, table["rows"][0]
    for row in table["rows"]:
        sizes = f"{row['players']}v{row['players']}"
        cells[sizes, f"`{row['away']}`"] = f"{goals_of(row)}, {100.0 * row['points']['mean']:.0f} %"
        if row["away"] == "chaser":
            clean, goals = row["clean_goals"]
            cells[sizes, "clean goals, of all"] = f"{clean:.0f} of {goals:.0f}"
            cells[sizes, WHISTLED] = " : ".join(f"{number / row['matches']:.1f}" for number in row["whistles"])
    shown = (
        f"Goal difference a match and share of the points, in {first['matches']} matches a cell, of "
        f"{first['minutes']:g} minutes, the league's own length."
    )
    return "\n".join([crosstable("players", cells), "", shown, f"Command of a cell: `{first['command']}`"])


# The reference run: the speed of training, and the time of its stages

ROLLOUTS, WARM_UP = 14, 2  # of all rollouts the first two are not counted: they load and compile
WANTED = 15_000  # [decisions/s]
STAGES = {
    "matches": "matches: physics, sensors, beliefs, opponents, observations",
    "networks": "networks while playing, and the rollout's bookkeeping",
    "update": "update: four epochs of PPO",
    "checkpoint": "checkpoint",
}


def reference_settings(out: Path, rollouts: int = ROLLOUTS) -> Any:
    """Return the settings of the reference run: 3 v 3 against sacks-2001, a decision at every control step."""
    from soccer_env.train.ppo.settings import TrainSettings

    rollout, matches = 32, 256
    return TrainSettings(
        players="3v3", opponents="sacks-2001", matches=matches, rollout=rollout, batch=8192, epochs=4,
        hidden="64,64", critic="64,64", action_repeat=1, critic_first=0, mirror=False,
        central_critic=False, steps=3 * matches * rollout * rollouts, evaluate_every=10**12, evaluate_matches=2,
        evaluate_minutes=0.1, evaluate_against="sacks-2001", threads=2, seed=1, out=out,
    )  # fmt: skip


def measure_training(rollouts: int = ROLLOUTS) -> dict[str, Any]:
    """Train the reference run; return its decisions per second and the time of each stage [us per decision]."""
    from soccer_env.train.bench.benchmark import machine
    from soccer_env.train.ppo import train
    from soccer_env.train.ppo.settings import command_of

    host = machine()
    with tempfile.TemporaryDirectory() as folder:
        settings = reference_settings(Path(folder) / "reference", rollouts)
        train(settings)
        lines = read_lines(settings.out / "log.jsonl")[WARM_UP:]
    decisions = 3 * settings.matches * settings.rollout
    stages = {name: [1e6 * line["seconds"][name] / decisions for line in lines] for name in STAGES}
    whole = [sum(parts) for parts in zip(*stages.values(), strict=True)]
    command = command_of(settings).replace(str(settings.out), "runs/reference")
    return {
        "command": command,
        "machine": host,
        "speed": 1e6 / float(np.median(whole)),
        "fastest": 1e6 / min(whole),
        "slowest": 1e6 / max(whole),
        "stages": {name: float(np.median(times)) for name, times in stages.items()},
    }


def training_table(table: dict[str, Any]) -> str:
    """Return the table of the times of the stages of training in Markdown."""
    whole = sum(table["stages"].values())
    lines = ["| stage | time a decision | share |", "|---|---|---|"]
    for name, words in STAGES.items():
        time = table["stages"][name]
        lines.append(f"| {words} | {time:.1f} us | {100 * time / whole:.0f} % |")
    speed, low, high = (f"{table[name]:,.0f}" for name in ("speed", "slowest", "fastest"))
    reached = "" if table["speed"] >= WANTED else " (missed)"
    lines.append(
        f"| all: {speed} decisions a second ({low} to {high} in single rollouts) | target {WANTED:,}{reached} | |"
    )
    host = table["machine"]
    where = f"{host['processor']}, {host['cores']} cores, load before {host['load before']}, Python {host['python']}"
    return "\n".join([*lines, "", f"Command: `{table['command']}`. {where}."])
