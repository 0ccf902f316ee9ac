"""The files that a user keeps, one of each kind: `python -m tests.upgrade.corpus` writes those of the present version.

The folder of a released version is frozen; until its release a change of a format writes it anew.
"""

import json
import os
from pathlib import Path
from shutil import rmtree
from typing import Any

import numpy as np

from soccer_env import Match, __version__
from soccer_env.agents.policy_file import dump
from soccer_env.replay import Recorder, Thoughts
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.tournament import TournamentSettings, tournament
from soccer_env.types import WORLD
from tests.agents.staged_policies import random_policy

HERE = Path(__file__).parent
LEAGUES = ("legged-2001", "middle-size-2006")
STEPS = 40


def versions() -> list[Path]:
    """Return the folder of each version."""
    return [path.parent for path in sorted(HERE.glob("*/facts.json"))]


def staged(league: str, home: str, steps: int = 0) -> Match:
    """Return a match after some steps; a save holds what teams remember, so those of a save remember nothing."""
    match = Match(league, home=1, away=1, seed=3, minutes=1.0, controllers={"home": home, "away": "random"})
    for _ in range(steps):
        match.step()
    return match


def write_corpus(folder: Path) -> None:
    """Write the files into an empty folder, with what they must still give."""
    rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    policy = folder / "policy.safetensors"
    policy.write_bytes(dump(random_policy(4, league="middle-size-2006")))
    facts: dict[str, Any] = {"world": WORLD, "action": first_action(policy)}
    for league in LEAGUES:
        match = staged(league, "chaser")
        recorder = Recorder(match, Thoughts(match))
        for _ in range(STEPS):
            match.step()
        recorder.stop().write(folder / f"{league}.replay")
        match = staged(league, "still", STEPS)
        (folder / f"{league}.save").write_bytes(match.save())
        match.step()
        facts[league] = match.state_hash()
    common = {"league": "middle-size-2006", "players": 1, "minutes": 0.1, "matches": 2, "seed": 5}
    evaluate(EvaluateSettings(home="chaser", away="random", out=folder / "evaluation", **common))
    tournament(TournamentSettings(teams="chaser,still", out=folder / "tournament", **common))
    for page in folder.rglob("report.*"):
        page.unlink()
    (folder / "facts.json").write_text(json.dumps(facts, indent=2) + "\n", encoding="utf-8")


def first_action(policy: Path) -> list[float]:
    """Return what a robot played by the policy does after ten steps."""
    match = Match("middle-size-2006", home=1, away=1, seed=3, controllers={"home": str(policy)}, senses="ideal")
    for _ in range(10):
        match.step(np.zeros((1, 2, 4)))
    command = match.robots["command"][0, 0]
    return [float(command[name]) for name in ("forward", "left", "turn", "kick")]


if __name__ == "__main__":
    os.chdir(HERE)  # for files that name no folder of the machine
    write_corpus(Path(__version__))
