"""The teams and team sizes of a scene: a match from the kick-off, or a drill against its own opponents.

A drill names its opponents (`Scene.opponents`), one for each of away's last robots.
"""

from dataclasses import dataclass

from soccer_env.scenes import Scene

SAVES = "away saves"  # success test of a drill for away's goalkeeper
STILL, PLAYS = "still", "chaser"  # the team without a part in a drill, and the default team


@dataclass(frozen=True)
class Cast:
    """The two sides of a match, home and away: team sizes, team names in words, and the `controllers` of a Match."""

    sizes: tuple[int, int]
    names: tuple[str, str]
    controllers: dict[str, str]


def sizes_of(scene: Scene) -> tuple[int, int]:
    """Return the team sizes of home and away in a drill."""
    if scene.success == SAVES:
        return 1, 2  # a team of one has no goalkeeper
    return scene.players, max(len(scene.opponents), 1)


def controllers_of(scene: Scene, team: str) -> dict[str, str]:
    """Return the `controllers` of a Match for a team in a drill: it plays away in a drill of saves, else home."""
    return cast_of(scene, sizes_of(scene), *((None, team) if scene.success == SAVES else (team, None))).controllers


def cast_of(scene: Scene, sizes: tuple[int, int], home: str | None = None, away: str | None = None) -> Cast:
    """Return the cast of a scene; a side without a name gets the chaser, or the team that the drill is meant for."""
    saves, drill = scene.success == SAVES, scene.success != "none"
    names = (home or (STILL if saves else PLAYS), away or (STILL if drill and not saves else PLAYS))
    if away is not None or not scene.opponents:
        return Cast(sizes, names, {"home": names[0], "away": names[1]})
    first = sizes[1] - len(scene.opponents)  # away's last robots have a part
    players = {f"away_{number}": STILL for number in range(first)}
    players |= {f"away_{first + number}": name for number, name in enumerate(scene.opponents)}
    return Cast(sizes, (names[0], " + ".join(dict.fromkeys(players.values()))), {"home": names[0], **players})
