"""Who plays a scene, and how many of each side: a match from the kick-off, or a drill as it is meant.

Drills name the opponents that they are meant for (`Scene.opponents`), one for each of away's last robots.
"""

from dataclasses import dataclass

from soccer_env.scenes import Scene

SAVES = "away saves"  # of a drill that away's goalkeeper has to do
STILL, PLAYS = "still", "chaser"  # who has no part in a drill, and who plays where nobody is named


@dataclass(frozen=True)
class Cast:
    """Who plays: sizes of home and away, their teams in words, and the controllers of a Match."""

    sizes: tuple[int, int]
    names: tuple[str, str]
    controllers: dict[str, str]


def sizes_of(scene: Scene) -> tuple[int, int]:
    """Return how many play at home and away in a drill."""
    if scene.success == SAVES:
        return 1, 2  # a team of one has no goalkeeper
    return scene.players, max(len(scene.opponents), 1)


def controllers_of(scene: Scene, team: str) -> dict[str, str]:
    """Return who plays a drill for a team: away's goalkeeper a save, home's robot everything else."""
    return cast_of(scene, sizes_of(scene), *((None, team) if scene.success == SAVES else (team, None))).controllers


def cast_of(scene: Scene, sizes: tuple[int, int], home: str | None = None, away: str | None = None) -> Cast:
    """Return who plays a scene where a side is not named: chaser, or in a drill the one that it is meant for."""
    saves, drill = scene.success == SAVES, scene.success != "none"
    names = (home or (STILL if saves else PLAYS), away or (STILL if drill and not saves else PLAYS))
    if away is not None or not scene.opponents:
        return Cast(sizes, names, {"home": names[0], "away": names[1]})
    first = sizes[1] - len(scene.opponents)  # away's last robots have a part
    players = {f"away_{number}": STILL for number in range(first)}
    players |= {f"away_{first + number}": name for number, name in enumerate(scene.opponents)}
    return Cast(sizes, (names[0], " + ".join(dict.fromkeys(players.values()))), {"home": names[0], **players})
