"""What is read of a Match: the methods that `Match` inherits, in which nothing changes."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from soccer_env.actions import DISCRETE
from soccer_env.match import truth_state
from soccer_env.match.batch import MatchBatch
from soccer_env.match.settings import Settings
from soccer_env.match.squads import Squad
from soccer_env.observations import Entry
from soccer_env.observations.own import size_of
from soccer_env.types import HOME, Phase

PICTURES = "soccer_env.api.shown"  # stands above this file, and is found when a notebook asks
Match = Any  # soccer_env.match.match.Match, which stands above this file


class Views:
    """Beliefs, percepts, states, sizes and words of the matches of a Match."""

    if TYPE_CHECKING:
        settings: Settings
        batch: MatchBatch
        squads: list[Squad]
        matches: np.ndarray
        balls: np.ndarray
        robots: np.ndarray

    @property
    def beliefs(self) -> np.ndarray:
        """Return what every robot believes (M, R); nothing (confidence 0) of robots whose sensors nobody uses.

        ValueError if nobody uses any.
        """
        return self.batch.read_all()[0]

    @property
    def tracks(self) -> np.ndarray:
        """Return what every robot believes about other players (M, R, slots); ValueError as for `beliefs`."""
        return self.batch.read_all()[1]

    @property
    def percepts(self) -> np.ndarray:
        """Return what every robot's sensors delivered (M, R); ValueError if nobody uses them."""
        if self.batch.senses is None:
            raise ValueError("nobody in this match uses its sensors: give observe='percepts', or senses='sensors'")
        return self.batch.senses.percepts

    def state(self, side: str | None = None) -> np.ndarray:
        """Return the whole truth (M, n) float32 in [-1, 1], with room for max_players a side and present flags.

        side: "home" or "away", from that team's side, which attacks +x in both halves; "field", in the frame of the
        field; None: what the setting `state_side` says. ValueError for anything else.
        """
        side = self.settings.state_side if side is None else truth_state.check_side(side)
        records = {"matches": self.matches, "balls": self.balls, "robots": self.robots}
        return truth_state.states(self.settings, records, side)

    def state_entries(self, side: str | None = None) -> list[Entry]:
        """Return what each number of `state(side)` is: its name, meaning, scale and frame."""
        side = self.settings.state_side if side is None else truth_state.check_side(side)
        return list(truth_state.entries(self.settings.max_players, side))

    def get_env_info(self) -> dict[str, int | None]:
        """Return the sizes that PyMARL asks for; `episode_limit` in steps, None where an episode may go on for ever.

        `n_actions` of continuous actions is how many numbers one has. Only robots that no team plays are agents.
        """
        return env_info(self)

    def __repr__(self) -> str:
        return in_words(self)

    def _repr_png_(self) -> bytes | None:
        """Return what a notebook shows: the first match as it stands, or None where it cannot be drawn."""
        drawn: bytes | None = import_module(PICTURES).png_of(self)
        return drawn


def env_info(match: Match) -> dict[str, int | None]:
    """Return the sizes that PyMARL asks for."""
    settings, learner = match.settings, int(np.argmax(match.learns))
    return {
        "state_shape": len(match.state_names),
        "obs_shape": size_of(match.seen.group_of(learner).form),
        "n_actions": len(DISCRETE) if settings.actions.name == "discrete" else settings.actions.size,
        "n_agents": int(match.learns.sum()),
        "episode_limit": settings.episode_limit,
    }


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
