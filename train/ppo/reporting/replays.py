"""Replays of the best policy of a run: the matches of its evaluation, played again."""

from __future__ import annotations

import re

from soccer_env.agents.policy_file import load
from soccer_env.train.evaluate.contest import play_matches
from soccer_env.train.evaluate.results import MatchLine
from soccer_env.train.keeping import Keep, Kept, keep_replays, kept_in
from soccer_env.train.ppo.reports import evaluation_of
from soccer_env.train.ppo.run_folder import BEST, RunFolder
from soccer_env.train.ppo.settings import TrainSettings


def keep_best(settings: TrainSettings, folder: RunFolder) -> list[Kept]:
    """Keep the replays asked for of best.safetensors against each opponent of the evaluations.

    The matches are those of its evaluation; they are played once more to learn which of them are worth keeping.
    """
    path = folder.path / BEST
    if not path.exists() or not (settings.keep or kept_in(folder.path)):
        return []
    policy, found = load(path), []
    for number, opponent in enumerate(settings.judges, 1):
        contest = evaluation_of(policy, opponent, settings)
        lines: list[MatchLine] = []
        play_matches(contest, set(), "", settings.threads, lines.extend, lambda steps: None)
        before = f"{number}-{re.sub(r'[^A-Za-z0-9.@=-]', '-', opponent)[:40]}-"
        found += keep_replays(contest, lines, Keep(settings.keep, settings.keep_pages), folder.path, before)
    return found
