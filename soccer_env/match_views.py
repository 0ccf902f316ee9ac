"""A match in a line of words, as Python shows it."""

from __future__ import annotations

from typing import Any

from soccer_env.types import HOME, Phase

Match = Any  # soccer_env.match.Match, which stands above this file


def in_words(match: Match) -> str:
    """Return what is played, by whom, and how it stands.

    <Match legged-2001: 2 learners v 1 chaser; first half, 12.5 s, play, 0 : 1>
    """
    settings = match.settings
    sides = (match.agents[: settings.rows[HOME]], match.agents[settings.rows[HOME] :])
    shown = [settings.league.name]
    if settings.scene.name != "kick-off":
        shown.append(settings.scene.name)
    if match.count > 1:
        shown.append(f"{match.count} matches")
    players = " v ".join(" and ".join(who_plays(match, side)) for side in sides)
    return f"<{type(match).__name__} {', '.join(shown)}: {players}; {standing(match)}>"


def who_plays(match: Match, agents: list[str]) -> list[str]:
    """Return the teams that play some robots, and who of them are played from outside."""
    found: dict[str, int] = {}
    for agent in agents:
        row = match.agents.index(agent)
        names = [squad.name for squad in match.squads if row in squad.players]
        name = " or ".join(names) if names else "learners"
        found[name] = found.get(name, 0) + int(match.robots["active"][0, row])
    return [f"{count} {name}" for name, count in found.items() if count]


def standing(match: Match) -> str:
    """Return how one match stands, or how many of several have ended."""
    over = match.terminated | match.truncated
    if match.count > 1:
        return f"{int(over.sum())} ended"
    game = match.matches[0]
    half, phase = ("first", "second")[int(game["half"])], Phase(game["phase"]).name.lower().replace("_", "-")
    home, away = game["score"].tolist()
    words = [f"{half} half", f"{game['clock']:.1f} s", phase, f"{home} : {away}"]
    return ", ".join([*words, *(["ended"] if over[0] else [])])
