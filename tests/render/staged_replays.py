"""Replays whose records are written by hand, step by step: what robots do, see and believe, and what is whistled."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from soccer_env import Match
from soccer_env.replay import Replay, Thoughts
from soccer_env.replay.parts import replay_settings
from soccer_env.statistics.records import GoalKind
from soccer_env.types import COMMAND, GAZE, QUIET, Foul, Phase
from tests.scenes.staging import LEGGED, MIDDLE

TEAMS = {LEGGED: ("sacks-2001", "chaser"), MIDDLE: ("weigel-2001", "heinemann-2006")}
STEPS = 48
EVENTS: dict[int, dict[str, Any]] = {  # of control steps
    6: {"goal": 0, "scorer": 2, "restart": Phase.KICK_OFF, "restart_team": 1, "kind": GoalKind.DEFLECTED_KICK},
    13: {"goal": 0, "scorer": 3, "restart": Phase.KICK_OFF, "restart_team": 1, "kind": GoalKind.OWN_GOAL},
    14: {"foul": Foul.PUSHING, "foul_team": 1, "fouls": 3},
    15: {"foul": Foul.ILLEGAL_DEFENDER, "foul_team": 0},
    16: {"foul": Foul.GAME_STUCK},
    18: {"restart": Phase.THROW_IN, "restart_team": 1},
    19: {"restart": Phase.DROP_BALL},
    20: {"annulled": 1},
    21: {"half_time": 1},
    23: {"goal": 1, "scorer": 3, "restart": Phase.KICK_OFF, "restart_team": 0, "kind": GoalKind.CLEAN_KICK},
    25: {"goal": 0, "scorer": 0, "kind": GoalKind.CLEAN_DRIBBLE},
    27: {"goal": 1, "kind": GoalKind.SCRUM},
    28: {"restart": Phase.PENALTY_KICK, "restart_team": 0},
    31: {"penalty": 1},
    32: {"restart": Phase.PENALTY_KICK, "restart_team": 1},
    33: {"penalty": 2, "goal": 0, "scorer": 2, "kind": GoalKind.OWN_GOAL},
    34: {"final_whistle": 1},
    41: {"goal": 1, "scorer": 2, "kind": GoalKind.DEFLECTED_KICK},
}
TOUCHES = {1: (0,), 2: (1,), 5: (0, 2), 11: (3,), 22: (3,), 24: (0,), 30: (0, 1), 39: (2,), 40: (1,)}
KICKS = {3: (1,), 9: (3,), 10: (3,), 22: (3,), 38: (2,)}
FLIGHTS = {3: 1, 4: 1, 5: 1, 39: 2}  # row of who sent the ball on its way


class StagedReplay(Replay):
    """A replay of two against two that writes its records instead of playing."""

    def __init__(self, league: str, thinks: bool = True, senses: str = "sensors") -> None:
        self.league, self.senses = league, senses
        match = self.new_match()
        thoughts = Thoughts(match) if thinks else None
        for step in range(1, STEPS + 1):
            stage(match, step)
            if thoughts is not None:
                thoughts.note(match, step)
        commands = np.zeros((STEPS, *match.robots.shape), COMMAND)
        packed = {} if thoughts is None else thoughts.packed()
        super().__init__(replay_settings(match), b"", commands, np.zeros(commands.shape, GAZE), [], [], "0.9\n", packed)

    def new_match(self) -> Match:
        settings = {"home": 2, "away": 2, "matches": 2, "seed": 5, "senses": self.senses, "pose": "particles"}
        return Match(self.league, controllers=dict(zip(("home", "away"), TEAMS[self.league])), **settings)

    def play(self) -> Iterator[Match]:
        match = self.new_match()
        stage(match, 0)
        yield match
        for step in range(1, STEPS + 1):
            stage(match, step)
            yield match


def stage(match: Match, step: int) -> None:
    """Write the records of a control step."""
    record, turn = match.matches, 0.13 * step
    length, width = match.league.pitch.length, match.league.pitch.width
    record["step"], record["clock"] = (step if step < 36 else step - 35), step / match.league.control_rate
    record["half"], record["home_direction"] = step >= 21, 1.0 if step < 21 else -1.0
    record["phase"], record["restart_team"], record["last_touch_robot"] = step % 9, step % 3 - 1, step % 5 - 1
    record["score"], record["shoot_out_score"] = (step // 6, step // 20), (step // 31, 0)
    ball, robots = match.balls, match.robots
    ball["x"], ball["y"] = 0.43 * length * np.sin(turn), 0.37 * width * np.cos(1.3 * turn)
    rows = np.arange(4)
    robots["x"], robots["y"] = 0.31 * length * np.cos(turn + rows), 0.3 * width * np.sin(0.7 * turn + 1.9 * rows)
    robots["heading"] = np.arctan2(np.sin(turn + 2.0 * rows), np.cos(turn + 2.0 * rows))
    robots["pan"] = 0.7 * np.sin(turn + rows)
    robots["active"], robots["has_ball"] = (step + rows) % 11 != 0, (step + rows) % 4 == 0
    robots["fallen"], robots["kick_clock"] = ((step + rows) % 7 == 0) * 0.6, ((step + rows) % 5 == 0) * 0.3
    robots["kick_strength"] = 0.2 + 0.1 * rows
    robots["command"]["forward"], robots["command"]["left"] = 0.1 * rows + 0.01 * step, -0.2
    robots["command"]["turn"], robots["command"]["kick"] = 0.03 * rows, -0.01 * step
    stage_events(match, step)
    stage_beliefs(match, step)
    if match.batch.senses is not None:
        stage_percepts(match, step)
    turn_over_second(match)


def turn_over_second(match: Match) -> None:
    """Make the second match another: nothing of it may be shown."""
    match.matches["home_direction"][1] *= -1.0
    match.matches["half_length"][1], match.matches["step"][1], match.matches["phase"][1] = 77.0, 1, Phase.OVER
    match.matches["score"][1], match.matches["shoot_out_score"][1], match.matches["clock"][1] = 9, 9, 0.0
    match.events[1], match.robot_events["touch"][1], match.robot_events["kick"][1] = QUIET, 1, 1
    match.balls[1] = 0
    match.robots["x"][1], match.robots["active"][1], match.robots["kick_strength"][1] = 0.1, 0, 0.9
    match.robots["has_ball"][1], match.robots["command"][1] = 1, 0


def stage_events(match: Match, step: int) -> None:
    """Write what happened in a control step, as referee and statistics tell it."""
    given = {**EVENTS.get(step, {})}
    kind, fouls = given.pop("kind", None), given.pop("fouls", None)
    match.events[0] = QUIET
    for name, value in given.items():
        match.events[name] = value
    match.events["ball_x"], match.events["ball_y"] = match.balls["x"] + 0.011, match.balls["y"] - 0.007
    match.robot_events[0] = np.zeros((), match.robot_events.dtype)
    match.robot_events["touch"][0, list(TOUCHES.get(step, ()))] = 1
    match.robot_events["kick"][0, list(KICKS.get(step, ()))] = 1
    if fouls is not None:
        match.robot_events["foul"][0, fouls] = given["foul"]
    if kind is not None:
        match.statistics["goals"][0, given["goal"], kind] += 1
    match.statistics["trail"]["flight"] = FLIGHTS.get(step, -1)
    match.statistics["trail"]["flight_step"] = match.matches["step"] if step in KICKS else 1


def stage_beliefs(match: Match, step: int) -> None:
    """Write what robots believe, a little beside the truth, and what teams remember."""
    rows = np.arange(4)
    robots, beliefs, tracks = match.robots[0], match.beliefs[0], match.tracks[0]
    sign = np.where((robots["team"] == 0) == (match.matches["home_direction"][0] > 0.0), 1.0, -1.0)
    own, ball = beliefs["own"], beliefs["ball"]
    own["x"], own["y"] = sign * robots["x"] + 0.031, sign * robots["y"] - 0.023
    own["heading"], own["confidence"] = robots["heading"] + 0.07 + (sign < 0.0) * np.pi, 40.0 + 3.1 * rows + 0.5 * step
    ball["x"], ball["y"], ball["confidence"] = 0.4 + 0.05 * rows, 0.11 * rows - 0.01 * step, 90.0 - step
    ball["distance"], ball["bearing"] = np.hypot(ball["x"], ball["y"]), np.arctan2(ball["y"], ball["x"])
    ball["age"] = np.where((rows == 2) & (step > 30), np.inf, 0.11 * rows + 0.03 * step)
    beliefs["obstacle"]["distance"], beliefs["obstacle"]["bearing"] = 0.31 + 0.02 * rows, 0.2 - 0.01 * step
    slots = np.arange(tracks.shape[1])
    tracks["present"] = (slots + rows[:, None] + step // 12) % 3 != 0
    tracks["teammate"] = slots == 0
    tracks["x"], tracks["y"] = 0.5 + 0.13 * slots + 0.01 * step, 0.3 - 0.17 * slots + 0.1 * rows[:, None]
    tracks["distance"], tracks["age"] = np.hypot(tracks["x"], tracks["y"]), 0.37 * slots + 90.0 * (step > 44) * slots
    tracks["bearing"] = np.arctan2(tracks["y"], tracks["x"])
    for squad in match.squads:
        for name in ("behaviour", "role", "attacks", "stuck", "tries", "rank"):
            if name in (squad.memory.dtype.names or ()):
                squad.memory[name] = (step // 8 + np.arange(len(squad.players))) % 3
    if match.batch.senses is not None:
        cloud = match.batch.senses.particles[0]
        number = np.arange(cloud.shape[1])
        cloud["x"], cloud["y"] = 0.2 * np.sin(1.7 * number), 0.1 * np.sin(1.7 * number + 0.6 + 0.3 * rows[:, None])


def stage_percepts(match: Match, step: int) -> None:
    """Write what cameras and rangers deliver."""
    assert match.batch.senses is not None
    percepts, rows = match.batch.senses.percepts[0], np.arange(4)
    if "infrared" in (percepts.dtype.names or ()):
        percepts["pan"], percepts["tilt"] = match.robots["pan"][0], -0.1 - 0.01 * rows
        percepts["infrared"] = 0.2 + 0.1 * rows
        for at, name in enumerate(("ball", "own_goal", "opponent_goal", "teammates", "opponents", "landmarks")):
            blobs = percepts[name]
            number = np.arange(blobs.shape[1]) + rows[:, None]
            blobs["left"], blobs["right"] = 40 - 7 * number - at, 31 - 8 * number - at
            blobs["high"], blobs["low"] = 20 - at - number, 3 - 2 * number
            blobs["area"] = np.maximum(0, 90 - 17 * number - (step + at) % 4 * 30)
        return
    for at, name in enumerate(("ball", "own_goal", "opponent_goal")):
        percepts[name]["distance"], percepts[name]["bearing"] = 1.0 + at + 0.1 * rows, 0.4 * at - 0.02 * step
        percepts[name]["seen"] = (step + at + rows) % 3 != 0
    players = percepts["players"]
    number = np.arange(players.shape[1])
    players["distance"], players["bearing"] = 0.8 + 0.4 * number, 0.9 * number - 2.0
    players["seen"], players["teammate"] = number < 3 + rows[:, None], number % 2
    percepts["lines"] = np.maximum(0.0, 2.0 * np.sin(np.arange(percepts["lines"].shape[1]) + rows[:, None]))
