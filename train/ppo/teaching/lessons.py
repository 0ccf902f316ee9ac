"""The lessons that a scripted teacher gives a run's actor, in every match setting of the run."""

import io
import shutil
from collections.abc import Callable, Iterator, Sequence
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import torch

from soccer_env.agents.learned import team_from_policy
from soccer_env.agents.policy_file import load
from soccer_env.guards.whole_files import write_atomically
from soccer_env.observations.entry import Entry
from soccer_env.train.ppo.checkpoints import read_checkpoint
from soccer_env.train.ppo.networks import SoccerPolicy, copy_actor, export_policy
from soccer_env.train.ppo.run_folder import ROUNDS
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.teaching.advice import advice_error, advised, advised_episodes
from soccer_env.train.ppo.teaching.imitation import Rows, fit, permute_own_commands, record
from soccer_env.train.progress import Progress

TEACHER_SEED = 2_000_003  # added to the run's seed: the teacher plays other matches than the learner
ROUND_SEED = 100_003  # added for each round
ADVICE_BATCH = 2048  # decisions in a step of a fit to advice
LAST_EPOCHS = 2  # times as many epochs after the last round


def teaching_cases(settings: TrainSettings) -> list[Any]:
    """Return the match settings in which to record a teacher: (team sizes, opponent, (share, senses)) of each."""
    return list(product(settings.sizes, settings.opponent_names, settings.kinds_of_senses))


def recordings_by_setting(settings: TrainSettings) -> Iterator[tuple[Any, tuple[int, int], int, dict[str, Any]]]:
    """Yield for each match setting: opponent, team sizes, decisions per robot to record, and settings of `Match`."""
    cases = teaching_cases(settings)
    decisions = max(1, round(60.0 * settings.minutes * settings.played.control_rate / settings.action_repeat))
    for index, (players, opponent, (weight, senses)) in enumerate(cases):
        share = weight * len(settings.kinds_of_senses) * settings.teacher_steps / len(cases) / players[0]
        count = max(1, round(share / decisions))
        yield opponent, players, min(decisions, max(1, round(share / count))), {
            "league": settings.played, "scene": settings.scene, "matches": count, "minutes": settings.minutes,
            "seed": settings.seed + TEACHER_SEED + 1009 * index, "senses": senses, "pose": settings.pose,
            "threads": settings.threads, "starts": "training",
        }  # fmt: skip


def lessons(
    settings: TrainSettings, entries: Sequence[Entry], advance: Callable[[float], None] = lambda cases: None
) -> Rows:
    """Record the teacher's observations and actions in every match setting of the run, from fixed seeds."""
    parts = []
    for opponent, players, decisions, given in recordings_by_setting(settings):
        given |= {"observe": settings.observe}
        parts.append(record(settings.teacher, opponent, players, decisions, settings.action_repeat, **given))
        advance(1.0)
    return join_lessons(parts, settings, entries)


def join_lessons(parts: Sequence[Rows], settings: TrainSettings, entries: Sequence[Entry]) -> Rows:
    """Join the rows of all match settings, and shuffle the entries for robots' own last commands."""
    observations, actions = join_rows(parts)
    permute_own_commands(observations.reshape(-1, observations.shape[-1]), entries, settings.seed)
    return observations, actions


def join_rows(parts: Sequence[Rows]) -> Rows:
    """Join rows (n, ...), or episodes (steps, rows, ...); after the end of a shorter episode nothing is asked for."""
    if parts[0][1].ndim == 3:
        steps = max(len(advice) for _, advice in parts)
        parts = [(lengthened(seen, steps, 0.0), lengthened(advice, steps, np.nan)) for seen, advice in parts]
    return np.concatenate([part[0] for part in parts], axis=-2), np.concatenate([part[1] for part in parts], axis=-2)


def lengthened(array: np.ndarray, steps: int, filling: float) -> np.ndarray:
    """Return an array (steps, rows, n), filled up after its end."""
    return np.pad(array, ((0, steps - len(array)), (0, 0), (0, 0)), constant_values=filling)


class Lessons:
    """The lessons that a teacher gives a run's actor: before PPO."""

    def __init__(self, settings: TrainSettings, network: SoccerPolicy) -> None:
        self.settings, self.network = settings, network
        self.kept = KeptRounds(settings.out)

    def teach(self) -> Iterator[int]:
        """Initialise the actor from a policy file or by its teacher, as the settings say.

        Yields the number of advised decisions after each round, and once without rounds; the caller's work at a yield,
        such as an evaluation, is repeated if the run is interrupted before the round is kept.
        """
        settings = self.settings
        if settings.start_file is not None:
            copy_actor(self.network, load(settings.start_file))
            if Path(settings.start).is_dir():
                take_over(self.network, Path(settings.start))
        if settings.rounds:
            yield from self._take_advice()
            return
        if settings.teacher and not settings.start:
            self._imitate()
        yield 0

    def _imitate(self) -> None:
        """Fit the actor to the teacher's recorded decisions."""
        settings, epochs = self.settings, self.settings.teacher_epochs
        with Progress(f"learning from {settings.teacher}", len(teaching_cases(settings)) + epochs / 2) as progress:
            rows = lessons(settings, self.network.entries, progress.advance)
            fit(self.network, *rows, epochs, settings.seed, lambda share: progress.advance(share * epochs / 2))

    def _take_advice(self) -> Iterator[int]:
        """Play rounds of advice, the first by the teacher unless `start` is set; fit the actor after each round."""
        settings = self.settings
        cases = len(teaching_cases(settings))
        rounds = self.kept.restore(self.network)
        for number in range(len(rounds), settings.rounds):
            with Progress(f"advised by {settings.teacher}, round {number + 1}", 2 * cases) as progress:
                rounds.append(self._round(number, progress))
                self._fit_advice(rounds, progress)
            yield sum(int(np.isfinite(actions[..., 0]).sum()) for _, actions in rounds)
            self.kept.keep(number, rounds[-1], self.network)

    def _round(self, number: int, progress: Progress) -> Rows:
        """Play one round of advice in every match setting; return observations and advised actions."""
        settings, parts = self.settings, []
        ask = advised_episodes if settings.memory else advised
        player = self._actor_as_team() if number or settings.start else settings.teacher
        for opponent, players, _, given in recordings_by_setting(settings):
            given["seed"] += ROUND_SEED * number
            parts.append(ask(player, settings.teacher, opponent, players, settings.action_repeat, **given))
            progress.advance(1.0)
        return join_rows(parts)

    def _fit_advice(self, rounds: list[Rows], progress: Progress) -> None:
        """Fit the actor to the advice of all rounds so far, for more epochs after the last round."""
        settings, number = self.settings, len(rounds)
        epochs = settings.teacher_epochs * (LAST_EPOCHS if number == settings.rounds else 1)
        cases = len(teaching_cases(settings))
        fit(
            self.network, *join_lessons(rounds, settings, self.network.entries), epochs, settings.seed + number - 1,
            lambda share: progress.advance(share * cases), batch=ADVICE_BATCH, error=advice_error,
        )  # fmt: skip

    def _actor_as_team(self) -> Any:
        """Return the present actor as a team."""
        settings = self.settings
        return team_from_policy(
            export_policy(
                self.network,
                name=settings.name,
                league=settings.played,
                observe=settings.observe,
                action_repeat=settings.action_repeat,
                made={},
            )  # fmt: skip
        )


def take_over(network: SoccerPolicy, run: Path) -> None:
    """Copy actor, noise and critic from the newest checkpoint of a run's folder; ValueError if they do not fit."""
    saved = read_checkpoint(run)
    try:
        network.load_state_dict((saved or {})["network"])
    except (KeyError, RuntimeError) as error:
        raise ValueError(f"start: the networks of the run in {run} are not those of this run ({error})") from error


ROWS = ("observations", "advice")
NETWORK = "network/"


class KeptRounds:
    """The recorded rows of each round and the network after it, kept in a run's folder until the teaching is over."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder / ROUNDS

    def path(self, number: int) -> Path:
        """Return the file of a round."""
        return self.folder / f"round-{number:03d}.npz"

    def keep(self, number: int, rows: Rows, network: torch.nn.Module) -> None:
        """Write the rows of a round and the network after it, whole or not at all. OSError leaves earlier rounds."""
        weights = {NETWORK + name: tensor.cpu().numpy() for name, tensor in network.state_dict().items()}
        buffer = io.BytesIO()
        np.savez(buffer, **dict(zip(ROWS, rows, strict=True)), **weights)  # type: ignore[arg-type]  # of arrays by name
        self.folder.mkdir(exist_ok=True)
        write_atomically(self.path(number), buffer.getvalue())

    def restore(self, network: torch.nn.Module) -> list[Rows]:
        """Return the rows of all kept rounds; load the last round's weights into `network`; ValueError if damaged."""
        kept: list[Rows] = []
        weights: dict[str, Any] = {}
        while (path := self.path(len(kept))).exists():
            try:
                with np.load(path) as file:
                    kept.append((file[ROWS[0]], file[ROWS[1]]))
                    weights = {name: file[name] for name in file.files if name.startswith(NETWORK)}
            except Exception as error:  # a damaged archive may raise whatever its parts do
                raise ValueError(f"{path} is damaged ({error}); --anew starts again") from error
        if weights:
            tensors = {name.removeprefix(NETWORK): torch.as_tensor(value) for name, value in weights.items()}
            network.load_state_dict(tensors)
        return kept

    def forget(self) -> None:
        """Remove all rounds."""
        shutil.rmtree(self.folder, ignore_errors=True)
