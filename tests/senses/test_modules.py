"""Perception, memory and actuation are modules that share records: each fills its own and reads those before it."""

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.teams import TeamRandom, View
from soccer_env.types import AWAY
from tests.scenes.staging import LEGGED, place, play, stage, steady


def looking() -> Match:
    """Return a robot that has just looked at a ball, a team-mate and an opponent, and has not thought about it yet."""
    match = stage(steady(LEGGED), home=2, away=1, observe="belief")
    place(match, ball=(0.0, 0.1), robots={0: (-0.9, 0.0), 1: (0.2, 0.3, 2.0), 2: (0.3, -0.2, 3.0)})
    match.batch.senses.start(0)
    match.batch.senses.sense(0, 1)
    return match


def test_ms01_memory_gets_percepts_alone_and_fills_the_shared_records() -> None:
    """MS01: self, ball, foe, pal and head are filled from percepts; of the truth nothing is left at that time."""
    match = looking()
    belief, tracks, robot = match.beliefs[0, 0], match.tracks[0, 0], match.robots[0, 0]
    assert match.percepts["ball"]["area"][0, 0, 0] > 0  # perception has written
    robot["gaze"] = 0.0, 0.0
    assert belief["ball"]["confidence"] == 0.0 and not tracks["present"].any()  # and nothing but its own record
    match.percepts["body"]["forward"][0, 0] = 0.004
    for name in ("x", "y", "heading", "pan", "tilt"):
        match.robots[name] = np.nan
    match.balls["x"] = match.balls["y"] = np.nan
    match.batch.senses.believe(0, 1)
    assert belief["own"]["forward"] == pytest.approx(0.004 * match.league.control_rate)  # self
    assert belief["ball"]["confidence"] == 100.0 and belief["ball"]["distance"] == pytest.approx(0.91, abs=0.15)
    assert tracks["present"][tracks["teammate"] == 1].sum() == 1  # pal
    assert tracks["present"][tracks["teammate"] == 0].sum() == 1  # foe
    assert robot["gaze"]["pan"] == pytest.approx(np.arctan2(0.1, 0.9 - 0.075), abs=0.1)  # head


def test_ms01_actuation_reads_what_memory_wrote() -> None:
    match = looking()
    match.batch.senses.believe = lambda first, last: None  # type: ignore[method-assign]
    match.robots["gaze"]["pan"][0, 0] = -0.6
    play(match, steps=16, actions=np.zeros((1, 3, 4)))
    assert match.robots["pan"][0, 0] == pytest.approx(-0.6)


class Reader:
    """A planner: it keeps what it was shown, and walks ahead."""

    name = "reader"
    memory_dtype = np.dtype([("unused", "i8")])

    def __init__(self) -> None:
        self.shown: list[View] = []

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        self.shown.append(View(view.league, view.beliefs.copy(), view.tracks.copy()))
        commands = view.stand()
        commands[..., 0] = 1.0
        return commands


def test_ms01_any_team_plans_on_the_shared_records_alone() -> None:
    planner = Reader()
    match = Match(LEGGED, seed=3, controllers={"away": planner}, senses="sensors")
    kept = match.beliefs.copy(), match.tracks.copy()
    match.step(np.zeros((1, 6, 4)))
    shown, rows = planner.shown[-1], match.robots["team"][0] == AWAY
    assert shown.beliefs.tobytes() == kept[0][:, rows].tobytes()
    assert shown.tracks.tobytes() == kept[1][:, rows].tobytes()
    play(match, steps=16, actions=np.zeros((1, 6, 4)))
    assert (match.robots["walk"]["forward"][0, rows] > 0.0).any()
