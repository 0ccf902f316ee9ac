"""The tables of the learned team: which evaluations they are made of, and the time that training takes."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from soccer_env.train.evaluate.settings import EvaluateSettings
from soccer_env.train.files import read_lines
from soccer_env.train.tables.teams import measured, row_settings

TEAM = "learned"
MATCHES = 200
MINUTES = 4.0
SIZES = (1, 2, 3)
OPPONENTS = ("random", "chaser", "sacks-2001@0.25", "sacks-2001@0.5", "sacks-2001@0.75", "sacks-2001")
SENSES = ("sensors", "ideal")
HELD_OUT = 2  # seed: the policy was trained with seed 1, and seeds of matches follow from it
LONG = 10.0  # [min] of the match in which the share of points against the chaser is asked for


def learned_rows() -> Iterator[EvaluateSettings]:
    """Yield the evaluations of the learned team, the long one against the chaser first."""
    yield row_settings("legged-2001", TEAM, "chaser", "sensors", MATCHES, LONG, 3, HELD_OUT)
    for senses in SENSES:
        for players in reversed(SIZES):
            for away in OPPONENTS:
                yield row_settings("legged-2001", TEAM, away, senses, MATCHES, MINUTES, players, HELD_OUT)


def learned_table(table: dict[str, Any]) -> str:
    """Return the table of the learned team in Markdown."""
    lines = [
        "| players | senses | against | minutes | points | goal difference a match | goals a minute | settings |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in table["rows"]:
        players = f"{row['players']} v {row['players']}"
        lines.append(f"| {players} | {row['senses']} | {row['away']} | {row['minutes']:g} | {measured(row)} |")
    command = f"Command of a row: `{table['rows'][0]['command']}`"
    return "\n".join([*lines, "", f"{MATCHES} matches a row. {command}"])


# The reference run: how fast training is, and where its time goes

ROLLOUTS, WARM_UP = 14, 2  # the first ones are not counted: they load and compile
WANTED = 15_000  # [decisions/s]
STAGES = {
    "matches": "matches: physics, sensors, beliefs, opponents, observations",
    "networks": "networks while playing, and the rollout's bookkeeping",
    "update": "update: four epochs of PPO",
    "checkpoint": "checkpoint",
}


def reference_settings(out: Path, rollouts: int = ROLLOUTS) -> Any:
    """Return the settings of the reference run: 3 v 3 against sacks-2001, every control step a decision."""
    from soccer_env.train.ppo.settings import TrainSettings

    rollout, matches = 32, 256
    return TrainSettings(
        players="3v3", opponents="sacks-2001", matches=matches, rollout=rollout, batch=8192, epochs=4,
        hidden="64,64", critic="64,64", action_repeat=1, teacher="", critic_first=0, mirror=False,
        central_critic=False, steps=3 * matches * rollout * rollouts, evaluate_every=10**12, evaluate_matches=2,
        evaluate_minutes=0.1, evaluate_against="sacks-2001", threads=2, seed=1, tensorboard=False, out=out,
    )  # fmt: skip


def measure_training(rollouts: int = ROLLOUTS) -> dict[str, Any]:
    """Run the reference run; return its decisions a second and the time of each stage [us a decision]."""
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
    """Return the time of each stage of training in Markdown."""
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
