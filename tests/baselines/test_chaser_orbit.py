"""Going round a ball near a board: never between the two."""

import numpy as np
import pytest

from soccer_env.leagues import find_league
from soccer_env.leagues.constants import constants_of
from soccer_env.skills.approaching import choose_side_round
from soccer_env.skills.settings import MEMORY

LEGGED = "legged-2001"
RADIUS = 0.25  # [m] of the way round the ball
BOARDS = {"left": (0.3, 0.9), "right": (0.3, -0.9), "opponents' end": (1.4, 0.6), "own end": (-1.4, -0.6)}  # ball [m]


def path(start: float, end: float, sense: float) -> np.ndarray:
    """Return directions [rad] on the way from one direction to another, +1 counter-clockwise."""
    return start + sense * np.linspace(0.0, (sense * (end - start)) % (2.0 * np.pi), 60)


@pytest.mark.parametrize("board", BOARDS)
def test_the_way_round_a_ball_never_leads_between_the_ball_and_a_board(board: str) -> None:
    x, y = BOARDS[board]
    out = np.array([0.0, np.sign(y)] if board in ("left", "right") else [np.sign(x), 0.0])  # towards the board
    k, rng = constants_of(find_league(LEGGED))[0], np.random.default_rng(1)
    judged = 0
    for _ in range(2000):
        here, aim = rng.uniform(-np.pi, np.pi, 2)
        away, u = np.array([np.cos(here), np.sin(here)]), np.array([np.cos(aim), np.sin(aim)])
        angle = np.arccos(np.clip(-(away @ u), -1.0, 1.0))
        if angle < 1.7 or -u @ out > -0.1:  # the ball is played along the board or towards it
            continue
        sense = choose_side_round(np.zeros(1, MEMORY)[0], k, x, y, *(RADIUS * away), *u, angle, RADIUS)
        turns = path(here, aim + np.pi, sense)
        nearest = (np.cos(turns) * out[0] + np.sin(turns) * out[1]).max()
        assert nearest < max(away @ out, 0.0) + 0.1, (here, aim)
        judged += 1
    assert judged > 50
