"""observe="percepts" of middle-size robots: bearings and distances in the mirror's picture, and white lines.

`k`: the league's constants; `s`: settings of the sensors.
"""

from soccer_env.compiled import compiled
from soccer_env.geometry import clip, from_polar
from soccer_env.leagues.league import League
from soccer_env.observations.belief import write_game
from soccer_env.observations.entry import NONE, ROBOT, SIDE, Entry, X, Y, entries_dtype, object_entries
from soccer_env.observations.percepts import BODY, BODY_ROW, BODY_SIZE, write_body
from soccer_env.observations.row import record_view
from soccer_env.observations.truth import GAME, GAME_ROW
from soccer_env.records.percepts import OTHERS

SIGHTING = (
    Entry("seen", "1: it is in the picture; else its entries are 0", "1", NONE),
    Entry("cos", "cosine of its bearing", "1", ROBOT, X),
    Entry("sin", "sine of its bearing", "1", ROBOT, Y),
    Entry("near", "nearness", "soft: a / (distance + a), a = 2 m", NONE),
)
MARKER = (Entry("teammate", "1 team-mate, -1 opponent, by its marker", "1", NONE),)  # of players
LINE = "distance of the first white line in this direction, 1 if none is seen"
HALF = 2.0  # [m] half-way point of the soft scale for distances in the mirror's picture, assumed
THINGS = ("ball", "own_goal", "opponent_goal")
SIGHTING_ROW, MARKER_ROW = entries_dtype(SIGHTING), entries_dtype(MARKER)  # for the writers below
SIGHTING_SIZE, MARKER_SIZE = len(SIGHTING), len(MARKER)


def entries(league: League) -> list[Entry]:
    """Return the entries of a middle-size robot's observation in a league, in order."""
    single = [entry for name in THINGS for entry in object_entries(name, 1, SIGHTING)]
    slots = min(league.slots.teammates + league.slots.opponents, OTHERS)
    lines = [Entry(f"line_{i}", LINE, "greatest range", ROBOT, SIDE, "line", i) for i in range(league.sensors.lines)]
    return [*BODY, *single, *object_entries("player", slots, SIGHTING + MARKER), *lines, *GAME]


@compiled
def observe_slice(percepts, beliefs, robots, observations, constants, sensors, half_length, rows, first, last):
    """Write the observations (M, R, n) of middle-size robots; of `beliefs` only the state of the match is used."""
    k, s = constants[0], sensors[0]
    for m in range(first, last):
        for r in rows:
            percept, observation = percepts[m, r], observations[m, r]
            write_body(percept.body, robots[m, r], record_view(observation, 0, BODY_ROW), k)
            at = write_sighting(percept.ball, observation, BODY_SIZE)
            at = write_sighting(percept.own_goal, observation, at)
            at = write_sighting(percept.opponent_goal, observation, at)
            for slot in range(min(k.teammate_slots + k.opponent_slots, OTHERS)):
                player = percept.players[slot]
                at = write_sighting(player, observation, at)
                record_view(observation, at, MARKER_ROW).teammate = player.seen * (2.0 * player.teammate - 1.0)
                at += MARKER_SIZE
            for i in range(s.lines):
                distance = percept.lines[i]
                observation[at + i] = clip(distance / s.line_range, 0.0, 1.0) if distance > 0.0 else 1.0
            write_game(beliefs[m, r].situation, record_view(observation, at + s.lines, GAME_ROW), half_length)


@compiled
def write_sighting(sighting, observation, at):
    """Write a camera sighting into the observation, starting at index `at`; return the next index."""
    row, seen = record_view(observation, at, SIGHTING_ROW), 1.0 if sighting.seen == 1 else 0.0
    row.seen = seen
    row.cos, row.sin = from_polar(seen, sighting.bearing)
    row.near = seen * HALF / (sighting.distance + HALF)
    return at + SIGHTING_SIZE
