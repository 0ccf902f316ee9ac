"""Call the user's own functions in a control step, and check their results at once.

Functions that play are called before the physics; success functions of scenes and reward terms after it.
"""

from typing import Any, NamedTuple, cast

import numpy as np

from soccer_env.match.settings import Settings
from soccer_env.observations import layout, own
from soccer_env.rewards import COUNT, POTENTIALS, TERMS, OwnTerm, Rewards, measure_potentials
from soccer_env.scenes import Scene
from soccer_env.teams.function_teams import FunctionTeam, ask_functions
from soccer_env.types import HOME, Phase

Match = Any  # soccer_env.match.match.Match, which stands above this file
ANY = own.ArrayForm((), np.asarray(-np.inf), np.asarray(np.inf), np.dtype(float))  # a finite number


class ObservationGroup(NamedTuple):
    """A group of robots that have the same kind of observation."""

    side: str  # "" for both teams
    observe: Any
    rows: slice
    form: own.Form


class UserObservations:
    """Observations that a user's own object computes, or that differ between the two teams.

    `arrays` is (M, R, ...) or a dict of such arrays; if teams differ, {"home": (M, H, ...), "away": (M, A, ...)}.
    """

    def __init__(self, settings: Settings, matches: int) -> None:
        home, self._agents = settings.rows[HOME], settings.agents
        self.by_side = isinstance(settings.observe, own.SideObservations)
        self.own = not isinstance(settings.observe, str)
        who = {"home": slice(0, home), "away": slice(home, None)} if self.by_side else {"": slice(0, None)}
        observes = settings.observes if self.by_side else (settings.observe,)
        self.groups = [
            ObservationGroup(side, observe, rows, own.observation_form(observe, len(layout(settings.league, observe))))
            for (side, rows), observe in zip(who.items(), observes, strict=True)
        ]
        self._all = [
            own.zero_observations(group.form, matches if self.own else 0, len(self._agents)) for group in self.groups
        ]
        views = [
            own.index_arrays(seen, (slice(None), group.rows))
            for group, seen in zip(self.groups, self._all, strict=True)
        ]
        self.arrays = dict(zip(who, views, strict=True)) if self.by_side else views[0]

    def fill(self, match: Match) -> None:
        """Compute all observations; ValueError if a user's object returns a wrong result."""
        for group, seen in zip(self.groups, self._all, strict=True):
            if isinstance(group.observe, str):
                rows = np.arange(len(self._agents))[group.rows]
                match.batch.write_observations(seen, group.observe, rows, 0, match.count)
            else:
                what = f"observe of {group.side}" if group.side else "observe"
                own.fill(group.form, seen, group.observe(match), what, self._agents, group.rows)

    def group_of(self, row: int) -> ObservationGroup:
        """Return the group that a robot (row) belongs to."""
        return next(group for group in self.groups if row in range(len(self._agents))[group.rows])

    def of_robot(self, observations: Any, row: int) -> Any:
        """Return the observation (M, ...) of one robot (row), taken from the observations of all robots."""
        group = self.group_of(row)
        seen = observations[group.side] if self.by_side else observations
        return own.index_arrays(seen, (slice(None), row - (group.rows.start or 0)))


class UserRewardTerms:
    """The reward terms that users wrote, in the columns after the built-in terms."""

    def __init__(self, rewards: Rewards) -> None:
        self._terms = cast("dict[str, OwnTerm]", rewards.extra)  # Rewards has made terms of plain functions
        self._waiting: np.ndarray = np.zeros(0, bool)  # (M,) matches that were over before the control step
        self._before: dict[str, np.ndarray] = {}  # potentials (M, R) before the control step, by name
        self._asks: bool | None = None  # whether functions play; None: not yet known
        self._judges = False  # whether a success function ends matches

    def forget_teams(self) -> None:
        """Look anew, before the next control step, for functions that play."""
        self._asks = None

    def begin(self, match: Match) -> None:
        """Before a control step, call the users' functions that play robots, and compute the users' potentials."""
        if self._asks is None:  # once: a list of the squads at each step would cost a match alone 0.4 us
            self._asks = any(isinstance(squad.team, FunctionTeam) for squad in match.squads)
            self._judges = callable(match.settings.scene.success) and match.settings.episode == "drill"
        if self._asks:
            ask_functions(match)
        if self._terms:
            self._waiting = match.matches["over"] == 1
            shaping = {name: term for name, term in self._terms.items() if term.kind == "potential"}
            self._before = {
                name: compute_reward_term(match, name, term).copy() for name, term in shaping.items()
            }  # may be a view

    def pay(self, match: Match) -> None:
        """After a control step, let a success function end matches, and add the users' terms to the rewards."""
        if self._judges:
            apply_success_function(match, match.settings.scene)
        if not self._terms:  # the usual case: the lines below would cost a match alone 1 us of the 15 us of a step
            return
        ended, gamma = match.terminated[:, None], float(match.batch.weights["gamma"][0])
        for column, (name, term) in enumerate(self._terms.items(), start=COUNT):
            value = compute_reward_term(match, name, term)
            if term.kind == "potential":
                value = gamma * np.where(ended, 0.0, value) - self._before[name]
            value = -term.weight * value if term.kind == "cost" else term.weight * value
            match.terms[..., column] = np.where(self._waiting[:, None], 0.0, value)
            match.rewards += match.terms[..., column]


def check_result(values: Any, shape: tuple[int, ...], what: str, limit: float = np.inf) -> np.ndarray:
    """Convert the result of users' code to an array of a shape; ValueError names the code and the wrong result."""
    try:
        numbers = np.broadcast_to(np.asarray(values, np.float64), shape)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{what} must return numbers of shape {shape}, got shape {np.shape(values)}") from error
    with np.errstate(invalid="ignore"):
        wrong = ~(np.abs(numbers) <= limit) | ~np.isfinite(numbers)
    if wrong.any():
        at = tuple(int(i) for i in np.argwhere(wrong)[0])
        allowed = "finite numbers" if limit == np.inf else f"numbers in [{-limit:g}, {limit:g}]"
        raise ValueError(f"{what} must return {allowed}, got {numbers[at]} at {at}")
    return numbers


def apply_success_function(match: Match, scene: Scene) -> None:
    """End matches by a scene's success function (1 success, -1 failure, 0 continue), or truncate by its time limit.

    A match that ends here has potential 0, like a match that the referee ends.
    """
    verdicts = check_result(scene.success(match), (match.count,), f"success of scene {scene.name!r}", limit=1.0)  # type: ignore[operator]
    if (verdicts != np.rint(verdicts)).any():
        m = int(np.argmax(verdicts != np.rint(verdicts)))
        raise ValueError(
            f"success of scene {scene.name!r} must return 1, -1 or 0 for each match, got {verdicts[m]} for {m}"
        )
    goes_on = match.matches["over"] == 0
    for m in np.flatnonzero(goes_on & (verdicts != 0)).tolist():
        subtract_final_shaping(match, m)
        match.matches["over"][m], match.matches["phase"][m] = 1, Phase.OVER
        match.events["drill"][m] = int(verdicts[m])
        match.terminated[m], match.truncated[m] = True, False
    played = match.matches["step"] * match.league.dt
    match.truncated |= goes_on & (verdicts == 0) & (played >= scene.time_limit - 0.5 * match.league.dt)


def subtract_final_shaping(match: Match, m: int) -> None:
    """Subtract the shaping reward of the final potential from the terms and rewards of match m."""
    potentials, weights = np.zeros(POTENTIALS), match.batch.weights
    records = match.matches[m], match.balls[m], match.robots[m]
    measure_potentials(*records, match.batch.constants[0], weights[0], potentials)
    columns = [column for column, term in enumerate(TERMS) if term.kind == "potential"]
    for index, column in enumerate(columns):
        share = weights["gamma"][0] * weights["term"][0, column] * potentials[match.robots["team"][m], index]
        match.terms[m, :, column] -= share
        match.rewards[m] -= share


def compute_reward_term(match: Match, name: str, term: OwnTerm) -> np.ndarray:
    """Compute a user's reward term (M, R); ValueError names the term, the robot and the wrong value."""
    what = f"reward term {name!r}"
    numbers = own.convert_to_numbers(term.function(match), match.rewards.shape, what, match.agents)
    own.check_bounds(ANY, numbers, what, match.agents)
    return numbers.astype(float)
