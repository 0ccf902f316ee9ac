"""Begin an episode of one match: empty records, noise streams, the kick-off formation, then the scene; and end it.

The seed chooses the side that kicks off first; the other side kicks off the second half. In a drill home kicks off.
Two matches of one seed with swapped teams begin with a kick-off by the same side, so that each team kicks off first
in one of the two.

`k`: the league's constants.
"""

from math import hypot
from typing import Any

import numpy as np

from soccer_env.compiled import compiled, inlined
from soccer_env.match.settings import Settings
from soccer_env.physics.kicker import holds_ball
from soccer_env.physics.parking import parking_place
from soccer_env.random_numbers import draw_uniform, start_streams
from soccer_env.referee.restarts import carry_out_restart
from soccer_env.scenes import SCENES
from soccer_env.scenes.scene import choose_start
from soccer_env.types import AWAY, HOME, NO_TEAM, MatchStream, Phase

KICK_OFF = int(Phase.KICK_OFF)
WHO_KICKS_OFF = int(MatchStream.KICK_OFF)


@compiled
def begin_episode(match, ball, robots, k, seed, episode, half_length, drill):
    """Initialise the records of one match for the first kick-off; team, number, keeper and active are already set."""
    match.seed, match.episode = seed, episode
    start_streams(match.noise, seed, episode, 0)
    match.handedness = match.home_direction = 1.0
    match.half_length = half_length
    match.phase = KICK_OFF
    match.kick_off_team = HOME if drill == 1 or draw_uniform(match.noise, WHO_KICKS_OFF) < 0.5 else AWAY
    match.restart_team = match.kick_off_team
    match.last_touch_team, match.last_touch_robot = NO_TEAM, -1
    match.whistled = match.kick_off_shot = NO_TEAM
    match.taker = -1
    for r in range(robots.shape[0]):
        start_streams(robots[r].noise, seed, episode, 1 + 2 * robots[r].number + robots[r].team)
        robots[r].slip.forward = robots[r].slip.left = robots[r].slip.turn = 1.0
        robots[r].command.head = -1.0
    carry_out_restart(match, ball, robots, k, 0)


@compiled
def note_possession(ball, robots, k):
    """Set `has_ball` of each robot of a match to whether the robot has the ball."""
    for r in range(robots.shape[0]):
        robots[r].has_ball = 1 if robots[r].active == 1 and holds_ball(robots[r], k, ball.x, ball.y) else 0


def assign_players_to_rows(settings: Settings, robots: np.ndarray) -> None:
    """Set team, number and goalkeeper of the robots (R,) of one match; park unused rows off the field."""
    home_rows = settings.rows[HOME]
    for r in range(len(robots)):
        team, number = (HOME, r) if r < home_rows else (AWAY, r - home_rows)
        size = settings.home if team == HOME else settings.away
        robots[r]["team"], robots[r]["number"] = team, number
        robots[r]["active"] = number < size
        robots[r]["keeper"] = size >= 2 and number == settings.keeper
        if number >= size:
            robots[r]["x"], robots[r]["y"], robots[r]["heading"] = parking_place(r)


def start_match(
    settings: Settings, constants: np.ndarray, match: Any, ball: Any, robots: np.ndarray, seed: int, episode: int
) -> None:
    """Begin an episode in the records of one match: match (1,), ball (1,), robots (1, R)."""
    for record in (match, ball, robots):
        record[...] = np.zeros((), record.dtype)
    assign_players_to_rows(settings, robots[0])
    scene = settings.scene.of_episode(seed, episode)
    drill = int(scene.place is not None)
    begin_single_episode(match, ball, robots, constants, np.uint64(seed), episode, settings.half_length, drill)
    if scene.success != "none":
        choose_start(match[0], settings.starts)
    scene.set_up(settings.league, match[0], ball[0], robots[0])
    if not scene.in_play and scene.restart != Phase.KICK_OFF:
        begin_single_restart(match, ball, robots, constants)
    if scene.place is not None and SCENES.get(scene.name) is not scene:
        check_scene_numbers(f"scene {scene.name!r}", settings, ball, robots)
        check_scene_room(f"scene {scene.name!r}", settings, ball[0], robots[0])
    robots["placed"] = robots["active"]
    note_single_possession(ball, robots, constants)


def check_scene_numbers(scene: str, settings: Settings, ball: Any, robots: np.ndarray) -> None:
    """Raise ValueError if a user's scene left a number that is not finite, or changed team, number or goalkeeper."""
    lined_up = np.zeros(robots.shape[1], robots.dtype)
    assign_players_to_rows(settings, lined_up)
    for who, record in (("the ball", ball[0]), *zip(settings.agents, robots[0], strict=True)):
        for name in record.dtype.names:
            if record.dtype[name].kind == "f" and not np.isfinite(record[name]).all():
                raise ValueError(f"{scene} must leave finite numbers, got {name} {record[name]} of {who}")
    for name in ("team", "number", "keeper"):
        for agent, actual, expected in zip(settings.agents, robots[0][name], lined_up[name], strict=True):
            if actual != expected:
                raise ValueError(f"{scene} must leave {name} of {agent} {expected}, got {actual}")


def check_scene_room(scene: str, settings: Settings, ball: Any, robots: np.ndarray) -> None:
    """Raise ValueError if a user's scene put a body outside the boards, or one robot into another.

    Robots may overlap a little, since physics separates them: their centres must be half their reach apart.
    """
    pitch, apart = settings.league.pitch, 0.5 * settings.league.body.reach
    room = {"x": 0.5 * pitch.length + max(pitch.band_end, pitch.goal_depth), "y": 0.5 * pitch.width + pitch.band_side}
    there = [("the ball", ball)]
    for agent, robot in zip(settings.agents, robots, strict=True):
        there += [(agent, robot)] if robot["active"] else []
    for number, (who, body) in enumerate(there):
        for axis, most in room.items():
            if abs(body[axis]) > most:
                raise ValueError(f"{scene} must put {who} at {axis} = {-most:g} to {most:g} m, got {body[axis]:g}")
        for other, near in there[1:number]:  # without the ball: a robot may stand over it
            gap = hypot(body["x"] - near["x"], body["y"] - near["y"])
            if gap < apart:
                raise ValueError(f"{scene} must put {who} at least {apart:.2g} m from {other}, got {gap:.2g}")


@compiled
def begin_single_episode(matches, balls, robots, constants, seed, episode, half_length, drill):
    """Call `begin_episode` for a single match, whose records have shape (1,)."""
    begin_episode(matches[0], balls[0], robots[0], constants[0], seed, episode, half_length, drill)


@compiled
def begin_single_restart(matches, balls, robots, constants):
    """Call `carry_out_restart`, under instant placement, for a single match, whose records have shape (1,)."""
    carry_out_restart(matches[0], balls[0], robots[0], constants[0], 0)


@compiled
def note_single_possession(balls, robots, constants):
    """Call `note_possession` for a single match, whose records have shape (1,)."""
    note_possession(balls[0], robots[0], constants[0])


# The end of an episode


@inlined
def is_cut_off(events, cuts):
    """Tell whether a match has ended by the clock alone, which its learners do not observe."""
    return cuts and events.final_whistle == 1


@inlined
def note_episode_end(match, events, outcome, m, k, numbers):
    """Set whether match m is terminated, or truncated: by the limit of steps, the drill's, or an unobserved clock."""
    out_of_time = match.step >= numbers.limit or (k.drill != 0 and match.step * k.dt >= k.drill_time - 0.5 * k.dt)
    cut_off = is_cut_off(events, numbers.cuts)
    outcome.terminated[m] = match.over == 1 and not cut_off
    outcome.truncated[m] = cut_off or (match.over == 0 and out_of_time)
