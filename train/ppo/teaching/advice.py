"""Lessons by advice: the actor plays, and a scripted team labels every decision with its own action.

The teacher knows the truth, the actor only its robots' beliefs: fitted to the advice, the actor does what is best on
average over all states that agree with the beliefs [learning by cheating: Chen et al. 2019]. The actor plays itself,
so it learns in the situations that it causes [DAgger: Ross, Gordon, Bagnell 2011].

The truth does not teach a robot to find an unseen ball, or to judge whether it is aimed well enough for a kick. There
the advice is that of the teacher by the robot's own beliefs.
"""

from typing import Any, Literal

import numpy as np
import torch

from soccer_env.agents.learned import first_decision_step
from soccer_env.match import Match
from soccer_env.train.ppo.teaching.imitation import NO_KICK, WALK, Rows

KNOWN = 1.5  # [s] since the ball was seen: after this the robot searches for it, by its beliefs
BEND = 0.1  # [1] error of a walk beyond which its size counts, not its square, so that the fit is a median
WALK_WEIGHT, KICK_WEIGHT = 5.0, 2.0  # of a walk's error; of the few decisions with a kick


class Adviser:
    """A team that observes another match and returns the commands that it would give the home robots."""

    def __init__(self, teacher: Any, senses: Literal["ideal", "sensors"], **settings: Any) -> None:
        """Set up the adviser; `senses`: "ideal" to advise by the truth, "sensors" by the robots' own beliefs."""
        self.match = Match(controllers={"home": teacher, "away": "still"}, senses=senses, **settings)
        self.by_beliefs = senses == "sensors"

    def commands(self, watched: Match) -> np.ndarray:
        """Return the adviser's commands for the present state (M, home, 4): forward, left, turn, kick."""
        for name in ("matches", "balls", "robots"):
            getattr(self.match, name)[:] = getattr(watched, name)
        if self.by_beliefs:
            self.match.beliefs[:], self.match.tracks[:] = watched.beliefs, watched.tracks
        home = self.match.settings.rows[0]
        command = self.match.decide()[:, :home]
        return np.stack([command[name] for name in (*WALK, "kick")], axis=-1)


def advised(player: Any, teacher: Any, opponents: Any, players: tuple[int, int], repeat: int, **settings: Any) -> Rows:
    """Let `player` play home; return the observations (n, entries) of its decisions, and the teacher's actions (n, 4).

    Whole episodes are played, once each; robots that are out, and matches that have ended, are left out.
    """
    observations, advice = advised_episodes(player, teacher, opponents, players, repeat, **settings)
    played = np.isfinite(advice[..., 0])
    return observations[played], advice[played]


def advised_episodes(
    player: Any, teacher: Any, opponents: Any, players: tuple[int, int], repeat: int, **settings: Any
) -> Rows:
    """Return the episodes of `advised` as (steps, rows, entries) and (steps, rows, 4), NaN where nothing is asked."""
    senses = settings.pop("senses")
    settings |= {"home": players[0], "away": players[1], "observe": "belief"}
    match = Match(controllers={"home": player, "away": opponents}, senses=senses, **settings)
    advisers = [Adviser(teacher, "ideal", **settings), Adviser(teacher, "sensors", **settings)]
    for _ in range(first_decision_step(match.league.delay_steps, repeat)):
        for adviser in advisers:
            adviser.commands(match)
        match.step()
    observations, advice = [], []
    rows = match.count * players[0]
    while not (match.terminated | match.truncated).all():
        plays = match.robots["active"][:, : players[0]] == 1
        plays &= ~(match.terminated | match.truncated)[:, None]
        known = match.beliefs["ball"]["age"][:, : players[0]] < KNOWN
        observations.append(match.observations[:, : players[0]].reshape(rows, -1).copy())
        asked = play_decision(match, advisers, known, repeat)
        advice.append(np.where(plays[..., None], asked, np.nan).astype(np.float32).reshape(rows, -1))
    for one in (match, *(adviser.match for adviser in advisers)):
        one.close()
    return np.stack(observations), np.stack(advice)


def play_decision(match: Match, advisers: list[Adviser], known: np.ndarray, repeat: int) -> np.ndarray:
    """Play the control steps of one decision; return the advice (M, home, 4): first walk, strongest kick."""
    kick = np.full(known.shape, NO_KICK)
    for step in range(repeat):
        by_truth, by_beliefs = (adviser.commands(match) for adviser in advisers)
        if step == 0:
            asked = np.where(known[..., None], by_truth, by_beliefs)
        kick = np.maximum(kick, np.where(by_beliefs[..., 3] > 0.0, by_beliefs[..., 3], NO_KICK))
        match.step()
    asked[..., 3] = kick
    return asked


def advice_error(actions: torch.Tensor, asked: torch.Tensor) -> torch.Tensor:
    """Return the loss of actions (n, 4) against the advice: Huber for walks, weighted square for kicks."""
    walk = torch.nn.functional.huber_loss(actions[:, :3], asked[:, :3], delta=BEND)
    weights = torch.where(asked[:, 3] > 0.0, KICK_WEIGHT, 1.0)
    return WALK_WEIGHT * walk + (weights * (actions[:, 3] - asked[:, 3]) ** 2).mean()
