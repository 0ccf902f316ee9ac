"""Stage matches for tests: small scenes, commands, and measures of the bodies."""

from typing import Any

import numpy as np

from soccer_env import Match
from soccer_env.leagues import League
from soccer_env.leagues.constants import constants_of
from soccer_env.physics.contacts import paws_gap
from soccer_env.physics.engine.space import robot_moment
from soccer_env.staging import constants_of as running_constants
from soccer_env.staging import put, put_ball, send_off, set_phase
from soccer_env.types import Phase
from tests.scenes.leagues import LEAGUES, LEGGED, MIDDLE, boarded, each_league, endless, icy, patient, steady  # noqa: F401
from tests.scenes.outlines import ball_board_gaps, robot_board_gaps, robot_gaps

WALK = ("forward", "left", "turn")


# Putting things somewhere


def stage(league: Any, matches: int = 1, home: int = 1, away: int = 1, *, ball: Any = None, robots: Any = None,
          **settings: Any) -> Match:  # fmt: skip
    """Return matches in play, the ball at rest on the centre spot, all robots sent off but those that `place` names."""
    match = Match(league, matches=matches, home=home, away=away, **{"seed": 1, **settings})
    set_phase(match, Phase.PLAY)
    send_off(match, range(home + away))
    if ball is not None or robots is not None:
        place(match, ball, robots)
    return match


def place(match: Match, ball: Any = None, robots: Any = None) -> None:
    """Put the ball, as for `put_ball`, and robots by their row, as for `put`, and rebuild the physics on them."""
    for r, where in (robots or {}).items():
        put(match, r, *where)
    if ball is not None:
        put_ball(match, *ball)
    match.rebuild()


def scatter(match: Match, rng: np.random.Generator, share: float = 0.8) -> None:
    """Put the ball and all robots at random, nobody in anybody's way; `share` of the pitch is used."""
    league, count = match.league, match.robots.shape[1]
    room = share * np.array([league.pitch.length, league.pitch.width]) / 2 - league.body.reach
    apart = 2.0 * league.body.reach
    for m in range(match.count):
        places: list[np.ndarray] = []
        tries = 0
        while len(places) < count + 1:
            tries += 1
            assert tries < 100_000, "too many robots for so little room"
            place = rng.uniform(-room, room)
            if all(np.hypot(*(place - other)) > apart for other in places):
                places.append(place)
        match.balls["x"][m], match.balls["y"][m] = places[0]
        match.robots["x"][m], match.robots["y"][m] = np.transpose(places[1:])
    match.robots["heading"] = rng.uniform(-np.pi, np.pi, match.robots.shape)
    match.matches["still_x"], match.matches["still_y"] = match.balls["x"], match.balls["y"]


# Playing


def stand(match: Match) -> np.ndarray:
    """Return actions that let everybody stand."""
    return np.zeros((match.count, match.robots.shape[1], 4))


def asking(
    match: Match, r: Any = 0, forward: Any = 0.0, left: Any = 0.0, turn: Any = 0.0, kick: Any = 0.0
) -> np.ndarray:
    """Return actions in which robot r (or several) asks for something and the others stand."""
    actions = stand(match)
    actions[:, r] = np.stack(np.broadcast_arrays(forward, left, turn, kick), axis=-1)
    return actions


def steps_in(match: Match, seconds: float) -> int:
    """Return the control steps in a time [s]."""
    return round(seconds * match.league.control_rate)


def play(match: Match, seconds: float = 0.0, actions: Any = None, steps: int | None = None) -> None:
    """Play for a time [s], or some control steps; everybody stands unless told otherwise."""
    for _ in range(steps_in(match, seconds) if steps is None else steps):
        match.step(stand(match) if actions is None else actions)


def freeze(match: Match) -> Match:
    """Let neither the ground nor a drive act on the robots of a match, so that blows alone change speeds."""
    for name in ("traction", "thrust", "turn_traction", "turn_thrust"):
        running_constants(match)[f"drive_{name}"] = 1e-12
    return match


# Looking


def speed(records: np.ndarray) -> np.ndarray:
    """Return the speed of balls or robots [m/s]."""
    return np.hypot(records["vx"], records["vy"])


def distance(records: np.ndarray, x: Any, y: Any) -> np.ndarray:
    """Return how far balls or robots are from a point [m]."""
    return np.hypot(records["x"] - x, records["y"] - y)


def energy(match: Match) -> np.ndarray:
    """Return the kinetic energy (M,) of ball and robots [J], rolling and spinning included."""
    league, ball, robots = match.league, match.balls, match.robots
    moving = ball["vx"] ** 2 + ball["vy"] ** 2
    rolling = league.ball.shell * (ball["roll_x"] ** 2 + ball["roll_y"] ** 2)
    spinning = league.ball.shell * league.ball.radius**2 * ball["spin"] ** 2
    driving = league.body.mass * (robots["vx"] ** 2 + robots["vy"] ** 2) + robot_moment(league) * robots["omega"] ** 2
    total: np.ndarray = 0.5 * league.ball.mass * (moving + rolling + spinning) + 0.5 * driving.sum(axis=1)
    return total


def outline(league: League) -> np.ndarray:
    """Return points (N, 2) along the outlines of a robot's trunk and posts, robot frame."""
    body, angle = league.body, np.linspace(-np.pi, np.pi, 721)
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    posts = [place + body.tip_radius * ring for place in np.array(body.posts)]
    if body.corners:
        return np.concatenate([edges(np.array(body.corners)), *posts])
    middles = body.disc_x - np.linspace(0.0, body.disc_back, 200 if body.disc_back else 1)
    trunk = np.concatenate([(x, 0.0) + body.disc_radius * ring for x in middles])
    away = np.abs(trunk[:, 0] - np.clip(trunk[:, 0], middles.min(), middles.max()))
    on_edge = np.hypot(away, trunk[:, 1]) > body.disc_radius - 1e-9
    return np.concatenate([trunk[on_edge], *posts])


def edges(corners: np.ndarray) -> np.ndarray:
    """Return points (N, 2) along the edges of a hull."""
    share = np.linspace(0.0, 1.0, 500)[:, None, None]
    points: np.ndarray = (corners + share * (np.roll(corners, -1, axis=0) - corners)).reshape(-1, 2)
    return points


def overlaps(league: League, ball: np.void, robots: np.ndarray, handedness: float = 1.0) -> dict[str, float]:
    """Return how deep bodies of one match overlap [m]: "ball robot", "ball wall", "robot robot", "robot wall".

    By geometry alone: legs in mid-stroke to robots and walls, and where they are in their stroke to the ball.
    """
    k = constants_of(league)[0]
    to_robots = [paws_gap(robot, k, ball["x"], ball["y"], handedness) for robot in robots if robot["active"] == 1]
    found = {
        "ball robot": np.array(to_robots),
        "ball wall": ball_board_gaps(league, np.array([ball])),
        "robot robot": robot_gaps(league, robots[None]),
        "robot wall": robot_board_gaps(league, robots[None]),
    }
    return {pair: max(0.0, -float(gap.min(initial=np.inf))) for pair, gap in found.items()}


def deepest_overlaps(match: Match) -> dict[str, float]:
    """Return the deepest overlaps [m] in all matches."""
    hands = match.matches["handedness"]
    found = [overlaps(match.league, match.balls[m], match.robots[m], float(hands[m])) for m in range(match.count)]
    return {pair: max(one[pair] for one in found) for pair in found[0]}
