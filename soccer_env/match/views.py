"""The methods of `Match` that read the match and change nothing."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

import numpy as np

from soccer_env.actions import action_masks
from soccer_env.match import truth_state
from soccer_env.match.batch import MatchBatch
from soccer_env.match.settings import Settings
from soccer_env.match.squads import Squad
from soccer_env.observations import Entry
from soccer_env.observations.own import form_size, index_arrays
from soccer_env.types import HOME, Phase

PICTURES = "soccer_env.api.shown"  # stands above this file: imported when a notebook asks for a picture
FINAL = ("observations", "matches", "balls", "robots", "events", "robot_events", "terms", "statistics")
Match = Any  # soccer_env.match.match.Match, which stands above this file


class Views:
    """Methods of `Match` that return beliefs, percepts, states, sizes and text."""

    if TYPE_CHECKING:
        settings: Settings
        batch: MatchBatch
        squads: list[Squad]
        skills: Any
        matches: np.ndarray
        balls: np.ndarray
        robots: np.ndarray

    @property
    def beliefs(self) -> np.ndarray:
        """Return the beliefs (M, R), with confidence 0 for robots without senses; ValueError if no robot has senses."""
        return self.batch.read_all()[0]

    @property
    def tracks(self) -> np.ndarray:
        """Return the tracks (M, R, slots): beliefs about other players; ValueError if no robot has senses."""
        return self.batch.read_all()[1]

    @property
    def variation(self) -> dict[str, np.ndarray]:
        """Return by name the factors (M,) of the league's numbers in the present episodes; empty without variation."""
        return self.batch.factors

    @property
    def percepts(self) -> np.ndarray:
        """Return the percepts (M, R) of all robots; ValueError if no robot uses its sensors."""
        if self.batch.senses is None:
            raise ValueError("nobody in this match uses its sensors: give observe='percepts', or senses='sensors'")
        return self.batch.senses.percepts

    def state(self, side: str | None = None) -> np.ndarray:
        """Return the whole truth (M, n) float32 in [-1, 1], with room for max_players robots in each team.

        side: "home" or "away", from that team's side, which attacks +x in both halves; "field", in the frame of the
        field; None: the setting `state_side`. ValueError for anything else.
        """
        side = self.settings.state_side if side is None else truth_state.check_side(side)
        return truth_state.states(self.settings, truth_state.records_of(self), side)

    def action_masks(self) -> np.ndarray:
        """Return the masks (M, R, n) int8 of the actions that have an effect now, see `actions.action_masks`."""
        skills = None
        if self.skills is not None:
            self.batch.read(self.batch.everyone, 0, len(self.matches))
            skills = self.skills.masks()
        return action_masks(self.settings.actions, self.matches, self.robots, self.settings.league, skills)

    @property
    def action_names(self) -> tuple[str, ...]:
        """Return the names of the choices of "discrete" or "skills", in the order of the masks; () for other kinds."""
        return self.settings.actions.names

    def state_entries(self, side: str | None = None) -> list[Entry]:
        """Return name, meaning, scale and frame of each number of `state(side)`."""
        side = self.settings.state_side if side is None else truth_state.check_side(side)
        return list(truth_state.entries(self.settings.max_players, side))

    def get_env_info(self) -> dict[str, int | None]:
        """Return the sizes that PyMARL asks for; `episode_limit` [steps] is None where episodes have no limit.

        `n_actions` of continuous actions is the length of an action, of "multi" that of a mask. Robots that a team
        plays are no agents.
        """
        return pymarl_sizes(self)

    def __repr__(self) -> str:
        return describe_match(self)

    def _repr_png_(self) -> bytes | None:
        """Return a picture of the first match, which a notebook shows, or None if it cannot be drawn."""
        drawn: bytes | None = import_module(PICTURES).match_png(self)
        return drawn


def final_records(match: Match) -> truth_state.FinalRecords:
    """Return what is kept of the episodes that have just ended, by name, before others begin in their rows."""
    kept = {name: index_arrays(getattr(match, name), match.ended) for name in FINAL}
    kept["beliefs"] = match.batch.beliefs[match.ended]
    if match.settings.actions.parts:
        kept["action_masks"] = match.action_masks()[match.ended]
    return truth_state.FinalRecords(match.settings, kept)


def pymarl_sizes(match: Match) -> dict[str, int | None]:
    """Return the sizes of observations, actions and states under PyMARL's names."""
    settings, learner = match.settings, int(np.argmax(match.learns))
    return {
        "state_shape": len(match.state_names),
        "obs_shape": form_size(match.seen.group_of(learner).form),
        "n_actions": sum(settings.actions.parts) or settings.actions.size,
        "n_agents": int(match.learns.sum()),
        "episode_limit": settings.episode_limit,
    }


def describe_match(match: Match) -> str:
    """Return league, players and score: <Match legged-2001: 2 learners v 1 chaser; first half, 12.5 s, play, 0 : 1>."""
    settings = match.settings
    sides = (match.agents[: settings.rows[HOME]], match.agents[settings.rows[HOME] :])
    shown = [settings.league.name]
    if settings.scene.name != "kick-off":
        shown.append(settings.scene.name)
    if match.count > 1:
        shown.append(f"{match.count} matches")
    players = " v ".join(" and ".join(player_counts(match, side)) for side in sides)
    return f"<{type(match).__name__} {', '.join(shown)}: {players}; {status_in_words(match)}>"


def player_counts(match: Match, agents: list[str]) -> list[str]:
    """Return the numbers of active robots that each team plays, and of learners, such as ["2 learners"]."""
    counts: dict[str, int] = {}
    for agent in agents:
        row = match.agents.index(agent)
        names = [squad.name for squad in match.squads if row in squad.players]
        name = " or ".join(names) if names else "learners"
        counts[name] = counts.get(name, 0) + int(match.robots["active"][0, row])
    return [f"{count} {name}" for name, count in counts.items() if count]


def status_in_words(match: Match) -> str:
    """Return half, clock, phase and score of a single match in words, or how many of several matches have ended."""
    over = match.terminated | match.truncated
    if match.count > 1:
        return f"{int(over.sum())} ended"
    game = match.matches[0]
    half, phase = ("first", "second")[int(game["half"])], Phase(game["phase"]).name.lower().replace("_", "-")
    home, away = game["score"].tolist()
    words = [f"{half} half", f"{game['clock']:.1f} s", phase, f"{home} : {away}"]
    return ", ".join([*words, *(["ended"] if over[0] else [])])
