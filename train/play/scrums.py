"""Scrums, and how deep bodies sink into each other there and elsewhere."""

from __future__ import annotations

import numpy as np

from soccer_env.train.play.figures import Measure, Samples, most, percentile, share
from soccer_env.train.play.recording import Recording
from soccer_env.train.play.runs import by_match

CROWD = 3  # robots that make a scrum
MARGIN = 0.10  # [m] beyond the reach of a robot that lies at the ball: 30 cm from centre to centre in the legged league
KINDS = ("ball_robot", "robot_robot", "ball_board", "robot_board")


def members(recording: Recording) -> np.ndarray:
    """Return which robots (T, M, R) stand about the ball."""
    near = recording.ball_distance < recording.league.body.reach + recording.league.ball.radius + MARGIN
    found: np.ndarray = near & (recording.robots["active"] == 1)
    return found


def scrums(recording: Recording) -> Samples:
    """Time in play with three robots or more whose centres are within 30 cm (legged; middle size 50 cm) of the ball."""
    return {"scrum": recording.seconds(in_scrum(recording))}


def in_scrum(recording: Recording) -> np.ndarray:
    """Return where (T, M) there is a scrum."""
    found: np.ndarray = recording.in_play & (members(recording).sum(axis=-1) >= CROWD)
    return found


def overlap_in_scrums(recording: Recording) -> Samples:
    """Depth, at the end of each control step with a scrum, of every overlap of the ball and its robots with anything.

    Depth is by outlines; posts and nets count as boards, bodies touch without overlap at 0. Percentiles are over the
    overlaps above 0.
    """
    scrum, inside = in_scrum(recording), members(recording)
    pairs = recording.gaps.pairs
    both = inside[..., pairs[:, 0]] & inside[..., pairs[:, 1]]
    chosen = (inside, both, np.ones_like(scrum), inside)
    return depths(recording, "scrum", [scrum.reshape(scrum.shape + (1,) * (one.ndim - 2)) & one for one in chosen])


def overlap_in_play(recording: Recording) -> Samples:
    """Depth, at the end of each control step in play, of every overlap of ball, robots and boards."""
    return depths(recording, "play", everything(recording, recording.in_play))


def overlap_while_placing(recording: Recording) -> Samples:
    """Depth of every overlap while robots drive to their places and the ball is held."""
    return depths(recording, "placing", everything(recording, recording.live & (recording.matches["placing"] == 1)))


def everything(recording: Recording, when: np.ndarray) -> list[np.ndarray]:
    """Return the flags of all gaps at some times (T, M), a kind each."""
    gaps = (getattr(recording.gaps, kind) for kind in KINDS)
    return [np.broadcast_to(when.reshape(when.shape + (1,) * (gap.ndim - 2)), gap.shape) for gap in gaps]


def depths(recording: Recording, when: str, chosen: list[np.ndarray]) -> Samples:
    """Return the depths [m] of the chosen overlaps of each kind."""
    found = {}
    for kind, where in zip(KINDS, chosen, strict=True):
        gap = getattr(recording.gaps, kind)
        overlaps = where & (gap < 0.0)
        match_of = np.nonzero(overlaps)[1]
        found[f"{when}_{kind}"] = by_match(-gap[overlaps], match_of, recording.live.shape[1], 1)
    return found


def overlap(samples: object, when: str, words: str) -> Measure:
    """Return the measure of overlaps at some times: three figures a kind."""
    figures = []
    for kind in KINDS:
        name = f"{words}, {kind.replace('_', '-')}"
        figures += [percentile(f"{name}, {p} %", f"{when}_{kind}", float(p), "mm", 1000.0) for p in (50, 99)]
        figures.append(most(f"{name}, most", f"{when}_{kind}", "mm", 1000.0))
    return Measure(samples, tuple(figures))  # type: ignore[arg-type]


MEASURES = (
    Measure(scrums, (share("scrum", "scrum"),)),
    overlap(overlap_in_scrums, "scrum", "overlap in scrums"),
    overlap(overlap_in_play, "play", "overlap in play"),
    overlap(overlap_while_placing, "placing", "overlap while placing"),
)
