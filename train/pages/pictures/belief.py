"""The belief of one robot, drawn over the true state.

The belief is in the robot frame, and is drawn from the pose that the robot believes: an error of its own pose shifts
everything else as well.
"""

from math import cos, dist, pi, sin

import numpy as np

from soccer_env.geometry import out_of_frame, point_of_frame
from soccer_env.leagues.league import League
from soccer_env.match import Match
from soccer_env.render import Area, Label, Overlay, Picture, Points, Polyline
from soccer_env.render.colours import BALL_SHINE, KEEPER, TEAMS_LIGHT, WHITE, Colour
from soccer_env.render.overlays.sight import fan_of_rays
from soccer_env.render.robots import robot_pieces
from soccer_env.train.pages.pictures.legend import Entry, add_legend
from soccer_env.train.pages.pictures.settings import PictureSettings

SIGHT: Colour = (255, 246, 190)
RAYS = 181  # of the fan that shows the field of view
JUST_SEEN = 0.25  # [s] players seen more recently get no label of their age

Pose = tuple[float, float, float]


def belief_picture(settings: PictureSettings) -> np.ndarray:
    """Play the match to `belief_time` and return the picture of the robot's belief, (H, W, 3) uint8."""
    controllers = {"home": settings.home, "away": settings.away}
    match = Match(settings.league, controllers=controllers, pose="particles", seed=settings.belief_seed)
    for _ in range(round(settings.belief_time * match.league.control_rate)):
        match.step()
    row, picture = settings.belief_robot, Picture(match.league, settings.still_width)
    overlays, title = belief_overlays(match, row, settings.still_width / 1000.0), (settings.home, settings.away)
    frame = picture.draw(match.matches[0], match.balls[0], match.robots[0], title=title, overlays=overlays)
    return add_legend(frame, legend_entries(match, row))


def legend_entries(match: Match, row: int) -> list[Entry]:
    """Return the entries of the legend under the picture of a robot's belief."""
    robot = match.robots[0, row]
    name = f"{('red', 'blue')[int(robot['team'])]} {int(robot['number'])}"
    return [
        Entry("box", WHITE, f"where {name} believes it stands"),
        Entry("dots", KEEPER, "its particles: poses it thinks possible"),
        Entry("ring", BALL_SHINE, "where it believes the ball is"),
        Entry("area", SIGHT, "what its camera has in view"),
        Entry("ring", TEAMS_LIGHT[0], "a team-mate as it believes"),
        Entry("ring", TEAMS_LIGHT[1], "an opponent, and how long ago it saw it"),
    ]


def belief_overlays(match: Match, row: int, size: float) -> list[Overlay]:
    """Return the belief of a robot in a single match as overlays; `size` [1] scales lines and letters."""
    robot, belief = match.robots[0, row], match.beliefs[0, row]
    own = pose_in_field(belief["own"], team_direction(match, row))
    true = (float(robot["x"]), float(robot["y"]), float(robot["heading"]))
    ball, true_ball = place_in_field(own, belief["ball"]), (float(match.balls["x"][0]), float(match.balls["y"][0]))
    overlays: list[Overlay] = field_of_view(match.league, true, float(robot["pan"]))
    overlays += particles(match, row, size)
    overlays += outline(match.league, own, WHITE, 2.5 * size)
    radius = match.league.ball.radius * 430.0 * size
    overlays += [
        Points([ball], BALL_SHINE, 1.0 * radius, hollow=True),
        Polyline([true_ball, ball], BALL_SHINE, 1.5 * size),  # the error
    ]
    for track in match.tracks[0, row]:
        if track["present"]:
            overlays += believed_player(match, row, own, track, size)
    return overlays


def team_direction(match: Match, row: int) -> float:
    """Return the heading [rad] in the field frame at which a robot's team attacks."""
    attacks_ahead = (match.matches["home_direction"][0] > 0.0) == (match.robots["team"][0, row] == 0)
    return 0.0 if attacks_ahead else pi


def pose_in_field(pose: np.void, direction: float) -> Pose:
    """Convert a pose from the team frame to the field frame; `direction`: heading [rad] in which the team attacks."""
    x, y = float(pose["x"]), float(pose["y"])
    field_x, field_y = out_of_frame(x, y, cos(direction), sin(direction))
    return field_x, field_y, float(pose["heading"]) + direction


def place_in_field(own: Pose, thing: np.void) -> tuple[float, float]:
    """Convert the place of `thing` from the frame of a robot at pose `own` to the field frame."""
    x, y, heading = own
    at: tuple[float, float] = point_of_frame(x, y, float(thing["x"]), float(thing["y"]), cos(heading), sin(heading))
    return at


def field_of_view(league: League, pose: Pose, pan: float) -> list[Overlay]:
    """Return the field of view of a head camera as a fan; nothing for an omnidirectional camera."""
    if league.sensors.KIND != "legged":
        return []
    neck = league.sensors.neck_ahead
    x, y = pose[0] + neck * cos(pose[2]), pose[1] + neck * sin(pose[2])
    half, middle = league.sensors.view_width / 2, pose[2] + pan
    edge = fan_of_rays(league, x, y, middle - half, middle + half, RAYS)
    return [Area([(x, y), *edge], SIGHT, 70), Polyline([edge[0], (x, y), edge[-1]], SIGHT, 1.5, under=True)]


def particles(match: Match, row: int, size: float) -> list[Overlay]:
    """Return the particles of a robot's pose, drawn as dots."""
    senses = match.batch.senses
    if senses is None:
        return []
    direction = team_direction(match, row)
    places = [pose_in_field(one, direction)[:2] for one in senses.particles[0, row]]
    return [Points(places, KEEPER, 1.6 * size)] if places else []


def outline(league: League, pose: Pose, colour: Colour, width: float) -> list[Overlay]:
    """Return the outline of a robot's trunk at a pose."""
    x, y, heading = pose
    parts = robot_pieces(league.body, 0.0, walks=True)
    (trunk,) = (part.outline for part in parts if part.role == "body")
    corners = [point_of_frame(x, y, u, v, cos(heading), sin(heading)) for u, v in trunk]
    return [Polyline(corners, colour, width, closed=True)]


def believed_player(match: Match, row: int, own: Pose, track: np.void, size: float) -> list[Overlay]:
    """Return the drawing of a player at its believed place; an empty list if this place is off the pitch.

    A player seen longer ago than JUST_SEEN gets a label with its age, and a line to its true place.
    """
    team = int(match.robots["team"][0, row])
    team = team if track["teammate"] else 1 - team
    colour, where, pitch = TEAMS_LIGHT[team], place_in_field(own, track), match.league.pitch
    if abs(where[0]) > pitch.length / 2 or abs(where[1]) > pitch.width / 2:
        return []
    found: list[Overlay] = [Points([where], colour, 17.0 * size, hollow=True)]
    if track["age"] > JUST_SEEN:
        age = float(track["age"])
        words = f"{age:.0f} s ago" if age >= 1.0 else f"{age:.1f} s ago"
        found.append(Polyline([nearest_player(match, row, team, where), where], colour, 1.5 * size))
        found.append(Label(where, words, WHITE, 24.0 * size, (20.0 * size, -16.0 * size), "left"))
    return found


def nearest_player(match: Match, row: int, team: int, where: tuple[float, float]) -> tuple[float, float]:
    """Return the true place of the player of `team`, other than the robot itself, that is nearest to `where`.

    A track does not name its player: the nearest player is assumed to be the one.
    """
    robots = match.robots[0]
    others = [r for r in range(len(robots)) if r != row and robots["team"][r] == team and robots["active"][r]]
    places = [(float(robots["x"][r]), float(robots["y"][r])) for r in others]
    return min(places, key=lambda at: dist(at, where))
