"""The angles from which players see each other in play.  [Sacks 2001, 4.1.2]"""

from functools import partial

import numpy as np

from soccer_env.match import Match
from soccer_env.train.papers.claim import PLAYED, Batch, claim
from soccer_env.train.papers.plots import plot
from soccer_env.train.papers.staging import kick_off, wrap_angle
from soccer_env.train.papers.verdicts import Samples, measured

MATCHES = 16
SECONDS = 60.0  # [s] of each
EVERY = 8  # control steps between two looks at the play: half a second
FAR = 2.0  # [m] within which another player is more than a speck, assumed
SECTORS = 12  # of 15 degrees in the histogram, both sides together


def views_in_play(match: Match) -> tuple[np.ndarray, np.ndarray]:
    """Return the angles (M, R, R) [rad] from which robots see others, 0 head-on; and whether the others are in view.

    In view: within FAR and within the camera's width around the head's current direction; occlusion is ignored.
    """
    robots = match.robots
    dx = robots["x"][:, None, :] - robots["x"][:, :, None]  # from the one that looks (axis 1) to the other (axis 2)
    dy = robots["y"][:, None, :] - robots["y"][:, :, None]
    course, distance = np.arctan2(dy, dx), np.hypot(dx, dy)
    view = np.abs(wrap_angle(course + np.pi - robots["heading"][:, None, :]))
    gaze = (robots["heading"] + robots["pan"])[:, :, None]
    seen = np.abs(wrap_angle(course - gaze)) < 0.5 * match.league.sensors.view_width
    both = (robots["active"][:, :, None] == 1) & (robots["active"][:, None, :] == 1)
    return view, seen & both & (distance < FAR) & ~np.eye(robots.shape[1], dtype=bool)


def play_matches(batch: Batch, senses: str) -> np.ndarray:
    """Count sightings of other robots by their angle of view, in matches of the chaser: (M, SECTORS)."""
    match = kick_off(batch, matches=MATCHES, senses=senses)
    counts = np.zeros((MATCHES, SECTORS))
    for step in range(round(SECONDS * match.league.control_rate)):
        match.step(None)
        if step % EVERY == 0:
            view, seen = views_in_play(match)
            sector = np.minimum((view / np.pi * SECTORS).astype(int), SECTORS - 1)
            for m in range(MATCHES):
                counts[m] += np.bincount(sector[m][seen[m]], minlength=SECTORS)
    match.close()
    return counts


def shares_by_third(counts: np.ndarray) -> np.ndarray:
    """Return the shares [%] of views from the front (within 60 degrees), the sides, and the rear (beyond 120)."""
    total = counts.sum(axis=0).reshape(3, -1).sum(axis=1)
    return np.asarray(100.0 * total / max(total.sum(), 1.0))


def front_lead(counts: np.ndarray) -> float:
    """Return the share of head-on views minus the larger share of the two other thirds [%]."""
    front, side, rear = shares_by_third(counts)
    return float(front - max(side, rear))


def sector_shares(samples: Samples, senses: str) -> list[float]:
    """Return the shares [%] of the views in each sector."""
    total = samples[senses].sum(axis=0)
    return list(100 * total / max(total.sum(), 1.0))


S69 = claim(
    "S69", "4.1.2", "A robot's most common view of another player is head-on.",
    f"{MATCHES} games of 3 v 3 a batch, chaser against chaser by their own sensors, {SECONDS:g} s each, every "
    f"half second: the angle under which each other player within {FAR:g} m and within the width of the camera's view "
    "is seen, in thirds of the circle: head-on (60 degrees to both sides), from the side, from behind.",
    measured("share of head-on views less the next third's", lambda samples: front_lead(samples["sensors"]),
             unit="%", above=0.0),
    rules=PLAYED,
    measure=lambda batch: {senses: play_matches(batch, senses) for senses in ("sensors", "ideal")},
    figures=plot("Angles under which players are seen, 3 v 3", "angle from head-on [degrees]", "share of views [%]",
                 [180.0 / SECTORS * (i + 0.5) for i in range(SECTORS)],
                 {"play by sensors": partial(sector_shares, senses="sensors"),
                  "play by ideal senses": partial(sector_shares, senses="ideal")}),
    seconds=4.0,
    ingredients=("the chaser, who faces the ball that it goes for", "the head, which follows the ball"),
)  # fmt: skip
