"""The reports of a training run: its log, evaluations with intervals, and the learning curve."""

import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import product
from typing import Any

import numpy as np

from soccer_env.agents.learned import team_from_policy
from soccer_env.agents.policy import Policy
from soccer_env.leagues import find_league
from soccer_env.train.cluster import Workers
from soccer_env.train.evaluate.contest import Contest, contest_of, play_matches
from soccer_env.train.evaluate.results import MatchLine, summarise
from soccer_env.train.evaluate.settings import EvaluateSettings, conditions_of
from soccer_env.train.ppo.match_blocks import Result
from soccer_env.train.ppo.run_folder import RunFolder
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.stages import Sizes
from soccer_env.train.progress import Progress
from soccer_env.train.report import can_draw, draw_curves

EVALUATIONS = ("decisions", "against", "points", "goal difference a match (95 % interval)")
STAGES = ("rollout", "update", "checkpoint", "evaluation")  # whose times the log has
UNITS = ((1e6, " [million]"), (1e3, " [thousand]"))
EVALUATION_SEED = 1_000_003  # added to the run's seed: evaluations play other matches than training


class ProgressBoard:
    """A run's progress bar, the timer of each rollout's stages, and the writer of its log."""

    def __init__(self, settings: TrainSettings, folder: RunFolder) -> None:
        self.folder = folder
        self._spent = dict.fromkeys(STAGES, 0.0)  # [s] since the last line
        self._words, self._shown = "", 0  # of the last evaluation; steps shown by the bar
        self._settings = settings
        self._logs: Any = None  # opened once the first step of the run is known
        self._steps = settings.steps
        self._progress: Progress | None = None  # until the first step

    @contextmanager
    def timed(self, stage: str) -> Iterator[None]:
        """Add the time of a `with` block to the time of a stage (of STAGES)."""
        started = time.perf_counter()
        try:
            yield
        finally:
            self._spent[stage] += time.perf_counter() - started

    def show(self, step: int) -> None:
        """Move the progress bar to a total number of steps."""
        if self._progress is None:
            self._progress = Progress("training", self._steps)
            self._progress.__enter__()
        self._progress.advance(step - self._shown)
        self._shown = step

    def log(self, record: dict[str, Any]) -> None:
        """Log a rollout and its update, with the times of its stages; show the shares of points beside the bar."""
        spent, self._spent = self._spent, dict.fromkeys(STAGES, 0.0)
        playing = record.pop("playing")  # [s] of the rollout, in the matches
        seconds = {"matches": playing, "networks": spent.pop("rollout") - playing, **spent}
        record = {**record, "seconds": {name: round(value, 3) for name, value in seconds.items()}}
        self.folder.log(record)
        if self._logs is not None:
            self._logs.write(record)
        if self._progress is not None:
            shares = ", ".join(f"{100 * share:.0f} % v {name}" for name, share in record["points"].items())
            stage = f"stage {record['stage']}, " if len(self._settings.stages) > 1 else ""
            self._progress.note(f"{stage}points {shares}{self._words}")

    def open_logs(self, step: int) -> None:
        """Open the optional logs."""
        from soccer_env.train.ppo.reporting.loggers import Logs

        self._logs = Logs(self._settings, self.folder, step)

    def note_evaluation(self, step: int, rows: Sequence[dict[str, Any]]) -> None:
        """Show the results of an evaluation beside the progress bar, and log them."""
        if self._logs is not None:
            self._logs.write_evaluation(step, rows)
        self._words = "; evaluated " + ", ".join(f"{row['goal_difference']:+.2f} {name_of(row)}" for row in rows)

    def close(self) -> None:
        """Close the bar and the logs."""
        if self._progress is not None:
            self._progress.__exit__()
        if self._logs is not None:
            self._logs.close()


def name_of(row: dict[str, Any]) -> str:
    """Return the name of a row of an evaluation: its team sizes and its opponent."""
    return f"{row['players']} v {row['opponent']}" if "players" in row else f"v {row['opponent']}"


def rounded(value: Any) -> float | None:
    """Round a number for the logs; None for a missing number or NaN, which JSON lacks."""
    return round(float(value), 6) if value is not None and np.isfinite(value) else None


def goals_a_minute(results: Sequence[Result]) -> dict[str, dict[str, Any]]:
    """Return goals for and against a minute, and minutes, of episodes, by team sizes and opponent."""
    found: dict[str, dict[str, Any]] = {}
    for sizes, opponent in dict.fromkeys((one.players, one.opponent) for one in results):
        own = [one for one in results if (one.players, one.opponent) == (sizes, opponent)]
        minutes = sum(one.minutes for one in own)
        scored, conceded = sum(one.goals_for for one in own), sum(one.goals_against for one in own)
        found[f"{sizes[0]}v{sizes[1]} {opponent}"] = {
            "for": round(scored / minutes, 4), "against": round(conceded / minutes, 4), "minutes": round(minutes, 2)
        }  # fmt: skip
    return found


def policy_contest(policy: Policy, opponent: str, settings: TrainSettings, players: Sizes) -> Contest:
    """Return the contest of a policy against one opponent of the evaluations, at these team sizes."""
    asked = EvaluateSettings(
        league=settings.league, home="policy", away=opponent, matches=settings.evaluate_matches,
        minutes=settings.evaluate_minutes, players=f"{players[0]}v{players[1]}",
        seed=settings.seed + EVALUATION_SEED, senses=settings.senses, pose="particles", rules=settings.rules,
    )  # fmt: skip
    league = find_league(settings.league)
    return contest_of(conditions_of(asked, league), league, {"policy": team_from_policy(policy)})


def evaluate_policy(policy: Policy, settings: TrainSettings, workers: Workers) -> list[dict[str, Any]]:
    """Evaluate a policy at each team size against each opponent; return a row of results with 95 % intervals each."""
    rows = []
    for players, opponent in product(settings.sizes, settings.judges):
        contest = policy_contest(policy, opponent, settings, players)
        lines: list[MatchLine] = []
        play_matches(contest, set(), "", workers, lines.extend, lambda steps: None)
        result = summarise(contest.conditions, {}, lines)
        mean, low, high = (getattr(result.goal_difference, name) for name in ("mean", "low", "high"))
        rows.append(
            {
                "players": f"{players[0]}v{players[1]}",
                "opponent": opponent,
                "goal_difference": mean,
                "low": low,
                "high": high,
                "points": result.points.mean,
            }  # fmt: skip
        )
    return rows


def merit(evaluation: dict[str, Any]) -> tuple[float, float]:
    """Return the mean points of an evaluation, then its mean goal difference: the best policy has the largest."""
    rows = evaluation["rows"]
    return float(np.mean([row["points"] for row in rows])), float(np.mean([row["goal_difference"] for row in rows]))


def learning_curve(evaluations: Sequence[dict[str, Any]], settings: TrainSettings) -> bytes:
    """Draw the learning curve, goal differences over steps with 95 % intervals; PNG, or b"" without matplotlib."""
    return draw_curves(curve_of(evaluations, settings)) if can_draw() else b""


def curve_of(evaluations: Sequence[dict[str, Any]], settings: TrainSettings) -> dict[str, Any]:
    """Return the learning curve as the argument of `draw_curves`."""
    steps = [one["step"] for one in evaluations]
    unit, words = step_unit(max(steps))
    curves = []
    for index, row in enumerate(evaluations[0]["rows"]):
        found = [one["rows"][index] for one in evaluations]
        curves.append(
            {
                "name": name_of(row),
                "x": [step / unit for step in steps],
                "y": [part["goal_difference"] for part in found],
                "low": [part["low"] for part in found],
                "high": [part["high"] for part in found],
            }
        )
    title = f"{settings.name}: {settings.league}, seed {settings.seed}"
    matches = f"{settings.evaluate_matches} matches of {settings.evaluate_minutes:g} min"
    return {
        "title": title, "x_label": f"decisions{words}", "y_label": f"goals - goals against, a match\n({matches})",
         "curves": curves, "rules": [0.0], "rule": "even",
    }  # fmt: skip


def step_unit(steps: int) -> tuple[float, str]:
    """Return a unit (such as a million) that shortens a number of steps, with its name."""
    return next(((unit, words) for unit, words in UNITS if steps >= unit), (1.0, ""))


def evaluation_rows(evaluations: Sequence[dict[str, Any]]) -> Iterator[tuple[str, ...]]:
    """Yield the rows of the table of evaluations, below the head EVALUATIONS."""
    for one in evaluations:
        for row in one["rows"]:
            difference = f"{row['goal_difference']:+.2f} ({row['low']:+.2f} to {row['high']:+.2f})"
            yield f"{one['step']:,}", name_of(row), f"{100 * row['points']:.0f} %", difference


def screen_table(result: Any) -> Any:
    """Return the evaluations of a run (`training.TrainResult`) as a table for the screen."""
    from rich.table import Table

    table = Table(title=f"{result.policy.name}: {result.steps:,} steps, {result.seconds:.0f} s")
    for column in EVALUATIONS:
        table.add_column(column, justify="left" if column == "against" else "right")
    for row in evaluation_rows(result.evaluations):
        table.add_row(*row)
    return table


def best_evaluation_sentence(result: Any) -> str:
    """Return a sentence about the best evaluation of a run (`training.TrainResult`)."""
    best = max(result.evaluations, key=merit)
    points, goals = merit(best)
    return (
        f"best: after {best['step']:,} decisions, {100 * points:.0f} % of points and {goals:+.2f} goals on average; "
        "the largest of several is a lucky one"
    )
