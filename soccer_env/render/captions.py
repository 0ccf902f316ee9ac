"""The words of a picture, from its records: clock, half, phase, possession, the last goal."""

from __future__ import annotations

from math import ceil, floor, isfinite

import numpy as np

from soccer_env.leagues.rules import Rules
from soccer_env.render.colours import TEAM_NAMES
from soccer_env.types import NO_TEAM, Phase

PHASES = {
    Phase.PLAY: "play",
    Phase.KICK_OFF: "kick-off",
    Phase.THROW_IN: "throw-in",
    Phase.GOAL_KICK: "goal kick",
    Phase.CORNER_KICK: "corner kick",
    Phase.DROP_BALL: "dropped ball",
    Phase.FREE_KICK: "free kick",
    Phase.PENALTY_KICK: "penalty kick",
    Phase.OVER: "final whistle",
}
GOAL_SHOWN = 4.0  # [s] of the kick-off after a goal


def clock_words(match: np.void) -> str:
    """Return the time played in this half, as minutes and seconds."""
    seconds = max(0, floor(float(match["clock"]) + 1e-9))
    return f"{seconds // 60:02d}:{seconds % 60:02d}"


def half_words(match: np.void) -> str:
    """Return the half and its length in words."""
    length = float(match["half_length"])
    if not isfinite(length):
        return "no halves"
    minutes = f"{length / 60.0:g} min" if length % 30.0 == 0.0 else f"{length:g} s"
    return f"{('1st', '2nd')[min(max(int(match['half']), 0), 1)]} half, {minutes}"


def phase_words(match: np.void, rules: Rules) -> str:
    """Return in words the phase of play, the restarting team, and the time left for placing robots."""
    phase, team = int(match["phase"]), int(match["restart_team"])
    if int(match["over"]) and phase != Phase.OVER:
        return "end of episode"
    words = PHASES[Phase(phase)]
    if phase in (Phase.PLAY, Phase.OVER):
        return words
    if team != NO_TEAM and phase != Phase.DROP_BALL:
        words = f"{words} {TEAM_NAMES[team]}"
    if int(match["placing"]):
        words = f"{words}, placing {max(0, ceil(rules.placing_time - float(match['phase_clock'])))} s"
    return words


def goal_team(match: np.void) -> int:
    """Return the team whose goal led to the present kick-off, or NO_TEAM."""
    early = float(match["phase_clock"]) < GOAL_SHOWN
    after_goal = int(match["phase"]) == Phase.KICK_OFF and float(match["clock"]) > float(match["phase_clock"]) + 1e-6
    team = 1 - int(match["restart_team"])
    if early and after_goal and team in (0, 1) and int(match["score"][team]) > 0:
        return team
    return NO_TEAM


def possession_words(match: np.void, robots: np.ndarray) -> tuple[str, int]:
    """Return the robots (R,) that have the ball, in words, and their team; NO_TEAM if both or neither have it."""
    holders = np.flatnonzero((robots["has_ball"] != 0) & (robots["active"] != 0))
    if len(holders):
        teams = {int(team) for team in robots["team"][holders]}
        names = " + ".join(player_words(robots[row]) for row in holders)
        return f"ball: {names}", teams.pop() if len(teams) == 1 else NO_TEAM
    team, row = int(match["last_touch_team"]), int(match["last_touch_robot"])
    if 0 <= row < len(robots):
        return f"loose, last touch: {player_words(robots[row])}", NO_TEAM
    if team in (0, 1):
        return f"loose, last touch: {TEAM_NAMES[team]}", NO_TEAM
    return "loose, not touched yet", NO_TEAM


def player_words(robot: np.void) -> str:
    """Return a player's colour and number, and "(keeper)" for a goalkeeper."""
    keeper = " (keeper)" if int(robot["keeper"]) else ""
    return f"{TEAM_NAMES[int(robot['team'])]} {int(robot['number'])}{keeper}"
