"""Ratings of teams from the points of their matches, with 95 % intervals.

Elo: the most likely ratings of all matches at once (Bradley and Terry 1952), which do not depend on their order; the
intervals are bootstraps over pairs of matches. openskill: Plackett-Luce ratings (Weng and Lin 2011), match after match;
the intervals are the model's own, mu +- 1.96 sigma, which take matches as independent.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, log

import numpy as np
from openskill.models import PlackettLuce

from soccer_env.train.evaluate.results import Estimate

MEAN = 1500.0  # [Elo] of all teams
LOGIT = 400.0 / log(10.0)  # [Elo] a difference of 400 is 10 : 1
PRIOR = 1.0  # drawn matches of each team against an average one: ratings of a team that wins always stay finite
RESAMPLES = 1000
STEPS = 100  # of Newton's method, at most
NORMAL = 1.96  # [1] of sigma: 95 % of a normal distribution

Results = Sequence[tuple[int, int, np.ndarray]]  # first team, second team, its points in each match (N,): 0, 0.5 or 1


@dataclass(frozen=True)
class Ratings:
    """The ratings of all teams; `above[a, b]` is the probability that team a is above team b by Elo."""

    openskill: list[Estimate]
    elo: list[Estimate]
    above: np.ndarray


def rate_teams(teams: int, results: Results) -> Ratings:
    """Rate teams by the results of their pairings; matches 2 p and 2 p + 1 are a pair from one seed."""
    (elo,) = elo_ratings(*sum_points(teams, results, [np.ones((1, len(points) // 2)) for *_, points in results]))
    rng = np.random.default_rng(0)
    weights = [draw_weights(rng, len(points) // 2) for *_, points in results]
    drawn = elo_ratings(*sum_points(teams, results, weights))
    low, high = np.percentile(drawn, [2.5, 97.5], axis=0)
    difference = drawn[:, :, None] - drawn[:, None, :]
    above = (difference > 1e-6).mean(axis=0) + 0.5 * (np.abs(difference) <= 1e-6).mean(axis=0)
    rows = np.stack([elo, low, high], axis=1).tolist()
    return Ratings(openskill_ratings(teams, results), [Estimate(*row) for row in rows], above)


def draw_weights(rng: np.random.Generator, pairs: int) -> np.ndarray:
    """Draw how often each pair is in each resample (RESAMPLES, pairs)."""
    return rng.multinomial(pairs, [1.0 / pairs] * pairs, size=RESAMPLES)


def sum_points(teams: int, results: Results, weights: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Return points (R, T, T) of team a against team b in R weighted samples of pairs, and their matches (T, T)."""
    points, matches = np.zeros((len(weights[0]), teams, teams)), np.zeros((teams, teams))
    for (first, second, scored), weight in zip(results, weights, strict=True):
        taken = weight @ scored.reshape(-1, 2).sum(axis=1)
        points[:, first, second] += taken
        points[:, second, first] += len(scored) - taken
        matches[[first, second], [second, first]] += len(scored)
    return points, matches


def elo_ratings(points: np.ndarray, matches: np.ndarray) -> np.ndarray:
    """Return the Elo ratings (R, T), by Newton's method, from points (R, T, T) of a against b, and matches (T, T)."""
    strength = np.zeros(points.shape[:2])  # [1] natural logarithm of odds
    diagonal = np.arange(points.shape[1])
    for _ in range(STEPS):
        expected = 1.0 / (1.0 + np.exp(strength[:, None, :] - strength[:, :, None]))
        average = 1.0 / (1.0 + np.exp(-strength))
        slope = (points - matches * expected).sum(axis=2) + PRIOR * (0.5 - average)
        curve = -matches * expected * (1.0 - expected)
        curve[:, diagonal, diagonal] = PRIOR * average * (1.0 - average) - curve.sum(axis=2)
        step = np.linalg.solve(curve, slope[..., None])[..., 0]
        longest = np.abs(step).max(axis=1, keepdims=True)
        strength += step / np.maximum(longest, 1.0)
        if longest.max() < 1e-9:
            break
    return np.asarray(MEAN + LOGIT * (strength - strength.mean(axis=1, keepdims=True)))


def openskill_ratings(teams: int, results: Results) -> list[Estimate]:
    """Return the openskill ratings after the first match of every pairing, then the second of every one, and so on."""
    model = PlackettLuce()
    ratings = [model.rating() for _ in range(teams)]
    for match in range(max(len(points) for *_, points in results)):
        for first, second, points in results:
            if match < len(points):
                scored = float(points[match])
                rated = model.rate([[ratings[first]], [ratings[second]]], ranks=[1.0 - scored, scored])
                (ratings[first],), (ratings[second],) = rated
    spreads = [(rating.mu, NORMAL * rating.sigma) for rating in ratings]
    return [Estimate(mu, mu - spread, mu + spread) for mu, spread in spreads]


def matches_needed(elo: Sequence[Estimate], half_width: float, matches: int) -> int | None:
    """Return the even number of matches a pairing with which the widest Elo interval would be +- half_width.

    From `matches` a pairing now: intervals shrink with the root of the number. None if nothing scatters.
    """
    widest = max(0.5 * (one.high - one.low) for one in elo)
    return 2 * ceil(0.5 * matches * (widest / half_width) ** 2) if widest > 0.0 else None
