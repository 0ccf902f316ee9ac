"""Velocities after a time without sight of the ball.  [Sacks 2001, 3.2]"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from soccer_env.match import Match
from soccer_env.train.claims.ball_velocity import true_radial
from soccer_env.train.claims.claim import SACKS, Batch, Claim, Curve, Figure
from soccer_env.train.claims.sight import blind, see_again, stare
from soccer_env.train.claims.staging import begin, play, put, put_ball, stage, standing
from soccer_env.train.claims.values import least_rise, rms
from soccer_env.train.verdicts import Samples, measured

MATCHES = 64
GAPS = (0.25, 0.5, 1.0, 2.0, 3.0)  # [s] without sight of the ball
LIMIT = 1.5  # [s] "more than 1.5 second", Sacks 2001, 3.2
SETTLE = 1.5  # [s] of sight before the gap
AFTER = 1.0  # [s] after it, within which a velocity is read anew
KICKS = 1.0  # [1/s] rate at which the ball is kicked elsewhere
FASTEST = 0.8  # [m/s] of such a kick
ROOM, MIDDLE = 0.35, 0.80  # [m] radius of the circle in which the ball is kept, and how far its middle is ahead


class Manoeuvres:
    """Kicks that come at random times and keep the ball in a circle ahead of the robot; the same for all variants."""

    def __init__(self, batch: Batch) -> None:
        self.rng = batch.rng(1)

    def kick(self, match: Match) -> None:
        """Give some balls a new velocity towards a random point of the circle."""
        count, ball = match.count, match.balls
        hit = self.rng.random(count) < KICKS * match.league.dt
        angle, far = self.rng.uniform(-np.pi, np.pi, count), ROOM * np.sqrt(self.rng.random(count))
        speed = self.rng.uniform(0.0, FASTEST, count)
        x, y = MIDDLE + far * np.cos(angle) - 0.5 - ball["x"], far * np.sin(angle) - ball["y"]
        away = np.maximum(np.hypot(x, y), 1e-9)
        for name, part in (("x", x), ("y", y)):
            ball[f"v{name}"] = np.where(hit, speed * part / away, ball[f"v{name}"])
            ball[f"roll_{name}"] = np.where(hit, speed * part / away, ball[f"roll_{name}"])


def error_after(batch: Batch, gap: float, gate: bool) -> np.ndarray:
    """Return the error (M,) [m/s] of the first radial velocity that is read after a gap, NaN if there is none."""
    match = stage(batch, matches=MATCHES, actions="full", sensors={"patches": 0.0}, memory={"velocity_gate": gate})
    put(match, 0, -0.5, 0.0)
    put_ball(match, MIDDLE - 0.5, 0.0)
    begin(match)
    actions, kicks = standing(match), Manoeuvres(batch)
    for seconds, sight in ((SETTLE, True), (gap, False)):
        if not sight:
            blind(match)
        for _ in play(match, seconds, actions):
            kicks.kick(match)
            stare(match, actions)
    see_again(match)
    before, error = match.beliefs["ball"]["radial"][:, 0].copy(), np.full(MATCHES, np.nan)
    for _ in play(match, AFTER, actions):
        now = match.beliefs["ball"]["radial"][:, 0]
        first = np.isnan(error) & (now != before)
        error[first] = (now - true_radial(match))[first]
        kicks.kick(match)
        stare(match, actions)
    match.close()
    return error


def sweep_gaps(batch: Batch) -> Samples:
    """Return errors (M,) [m/s] after each gap, with the gate and without."""
    return {
        f"{word} {gap}": error_after(batch, gap, gate)
        for gap in GAPS
        for word, gate in (("gated", True), ("any", False))
    }


def errors(samples: Samples, word: str) -> list[float]:
    """Return rms errors [cm/s] over the gaps."""
    return [100 * rms(samples[f"{word} {gap}"]) for gap in GAPS]


def long_gap_ratio(samples: Samples) -> float:
    """Return the gated error after gaps beyond the limit over that after the shortest gap."""
    long = [samples[f"gated {gap}"] for gap in GAPS if gap > LIMIT]
    return rms(np.concatenate(long)) / max(rms(samples[f"gated {GAPS[0]}"]), 1e-12)


def gap_figure(samples: Samples) -> Sequence[Figure]:
    """Draw the errors against the gap."""
    curves = tuple(
        Curve(name, GAPS, errors(samples, word)) for name, word in (("gate on", "gated"), ("gate off", "any"))
    )
    return (Figure("First radial velocity after a gap", "gap [s]", "rms error [cm/s]", curves),)


S19 = Claim(
    id="S19",
    paper=SACKS,
    section="3.2",
    statement="A velocity over more than 1.5 s without sight is likely to be wrong: the position is stored only.",
    method=f"{MATCHES} robots a batch watch a ball that is kicked about at random once a second (up to "
    f"{100 * FASTEST:.0f} cm/s, {100 * (MIDDLE - ROOM):.0f} to {100 * (MIDDLE + ROOM):.0f} cm ahead), then see nothing "
    "of it for a gap; error of the first velocity that is read afterwards, with the rule and without, same seeds.",
    criteria=(
        measured(
            "without the rule the rms error rises with every longer gap (least rise above 0)",
            lambda samples: least_rise(errors(samples, "any")),
            unit="cm/s",
            above=0.0,
        ),
        measured(
            "with the rule the error after gaps above 1.5 s is at most 1.25 times that after the shortest gap",
            long_gap_ratio,
            at_most=1.25,
        ),
    ),
    measure=sweep_gaps,
    figures=gap_figure,
    batches=16,
    ingredients=("how the ball manoeuvres", "memory.velocity_gap", "sensors.dither"),
)

CLAIMS = (S19,)
