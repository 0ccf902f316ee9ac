"""The methods of `Match` that save, load and branch matches."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Any
from weakref import WeakSet

import numpy as np

from soccer_env.guards.names import Made
from soccer_env.match.arguments import MatchArguments, select_fields
from soccer_env.match.saving import branches, fitting, saves
from soccer_env.match.saving.whole import calls_python
from soccer_env.match.senses import sensing_sides
from soccer_env.match.squads import with_added_teams
from soccer_env.random_numbers import seeds_for

if TYPE_CHECKING:
    from typing_extensions import Self

    from soccer_env.match.settings import Settings


class Branching:
    """Methods of `Match` to save, load, branch, hash and copy matches."""

    if TYPE_CHECKING:
        arguments: MatchArguments
        count: int
        settings: Settings
        squads: list[Any]
        batch: Any
        recorder: Any
        started: bool
        rewards: np.ndarray
        terms: np.ndarray

        learns: np.ndarray
        _own_terms: Any
        _readers: np.ndarray
        _turn: Any

        def _observe_own(self) -> None: ...

    @property
    def play_fingerprint(self) -> tuple[str, list[Any]]:
        """Return the fingerprint of settings and squads; a save can be loaded only where it is equal."""
        return self._fingerprint, [squad.describe() for squad in self.squads]

    @cached_property
    def _fingerprint(self) -> str:
        return self.settings.fingerprint()

    @property
    def described_settings(self) -> dict[str, list[str]]:
        """Return settings and teams in words, for the error message about a save or branch with other settings."""
        return {**self._settings_in_words, "teams": fitting.describe_teams(self)}

    @cached_property
    def _settings_in_words(self) -> dict[str, list[str]]:
        return fitting.describe_settings(self)

    @cached_property
    def _known_to_fit(self) -> WeakSet[Any]:
        """Return the set of other Matches already known to have compatible settings and teams, which never change."""
        return WeakSet()

    def _use_squads(self, squads: list[Any]) -> None:
        """Set the squads, and the rows of the robots whose teams or skills read beliefs."""
        self.squads = squads
        readers = [r for squad in squads if squad.reads_beliefs for r in squad.players]
        self._readers = self.batch.everyone if self.settings.actions.name == "skills" else np.array(readers, np.int64)

    def _take_up_added_teams(self) -> None:
        """Make squads for the teams that were added to lineups; ValueError if one needs sensors that nobody uses."""
        squads = with_added_teams(self.squads, self.settings, self.count)
        if len(squads) == len(self.squads):
            return
        sides = self.batch.senses.sides if self.batch.senses is not None else ()
        if sensing_sides(self.settings, squads, self.learns) != tuple(sides):
            raise ValueError("a team that was added to a Lineup needs sensors, and no team before it used them")
        self._use_squads(squads)
        self._known_to_fit.clear()
        self._own_terms.forget_teams()
        self._turn.expect_code(calls_python(self))

    def rebuild(self, rows: Iterable[int] | None = None) -> None:
        """Rebuild the physics from the records, as loading does, so that equal records have equal futures."""
        rows = range(self.count) if rows is None else list(rows)
        started, self.started = self.started, False
        self.batch.build_spaces(rows)
        if self.recorder is not None:
            self.recorder.note_rebuild(rows)
        self.started = started

    def save(self, rows: Any = None) -> bytes:
        """Return all data that determine the matches' future, and rebuild the matches' physics from these data.

        A rebuild clears the history of contacts: the running match goes on like every copy of the save, but not like a
        match without the save. Runs that save at the same steps are reproducible.

        rows: number of a match, or several; None: all matches. ValueError for a number that no match has.
        """
        numbers = None if rows is None else branches.check_rows("rows", rows, self.count)
        self._take_up_added_teams()
        saved = saves.dump(self, rows=numbers)
        self.rebuild(numbers)
        return saved

    def load(self, saved: bytes, rows: Any = None) -> None:
        """Continue from a save, in all matches or in some rows; the other matches are not disturbed.

        A save of one match fills every row. ValueError, and no change, if the save is damaged, has other settings, or
        another number of matches.
        """
        numbers = None if rows is None else branches.check_rows("rows", rows, self.count, once=True)
        if not (self.started or numbers is None):
            raise RuntimeError("load: an error has interrupted the last call: load all matches, or call reset")
        self._take_up_added_teams()
        records = saves.arrays_of_save(self, saved, rows=numbers)
        self.started = False
        saves.fill_match(self, records, numbers)
        self._prepare_to_continue(np.arange(self.count) if numbers is None else numbers)

    def branch(self, rows: Any, into: Self | None = None, *, at: Any = None, noise: int | None = None) -> Self:
        """Copy matches of this Match over matches of another Match, in memory; return the other Match.

        rows: number of a match, or several. into: a Match of the same settings and teams, whose number of matches,
        seeds, observations, rewards and actions may differ; None: a new Match with one match for each row. at: the
        matches to overwrite, None: all; a single row overwrites all of them, else row i overwrites at[i]. noise: None:
        under equal actions a branch has the future of its original, bit for bit; a seed: each branch draws new random
        numbers (slips, sensors, referee), so that branches are samples of possible futures.

        The originals are rebuilt as by `save`, which changes their future: to compare play with and without a search
        on one seed, branch in both, or play both from one save. ValueError, and no change, for unknown rows, for
        different numbers of `rows` and `at`, and for a Match that does not fit.
        """
        numbers = branches.check_rows("rows", rows, self.count)
        self._take_up_added_teams()
        other = type(self)(**self._changed_arguments(matches=len(numbers))) if into is None else into
        if other not in self._known_to_fit:
            branches.check_fits(self, other)
            self._known_to_fit.add(other)
        over = np.arange(other.count) if at is None else branches.check_rows("at", at, other.count, once=True)
        if len(numbers) not in (1, len(over)):
            raise ValueError(f"rows must be one match or as many as are overwritten, {len(over)}, got {len(numbers)}")
        if noise is not None:
            seeds_for(noise, 1)
        other._take(self, numbers, over, noise)  # before the rebuild: if it is undone, nothing has happened
        self.rebuild(np.unique(numbers).tolist())
        return other

    def _take(self, other: Self, rows: np.ndarray, over: np.ndarray, noise: int | None) -> None:
        """Copy the matches `rows` of another Match over the matches `over` of this Match, ready to continue."""
        self.started = False
        branches.copy_rows(other, rows, self, over)
        if noise is not None:
            branches.renew_random_streams(self, over, noise)
        self._prepare_to_continue(over)

    def _prepare_to_continue(self, rows: np.ndarray) -> None:
        """Rebuild the physics of matches with new records, clear their rewards, and write their observations."""
        self.rebuild(rows.tolist())
        self.rewards[rows] = 0.0
        self.terms[rows] = 0.0
        if len(rows) == self.count:
            self.batch.observe_anew(0, self.count)
        else:
            for m in rows.tolist():
                self.batch.observe_anew(m, m + 1)
        self._observe_own()
        self.started = True

    def __reduce__(self) -> Made:
        """Pickle the match as its settings and a save, so that a copy has the future of the original."""
        return saves.reduce_by_save(self, type(self), self._changed_arguments())

    def _changed_arguments(self, **changes: Any) -> dict[str, Any]:
        """Return the constructor arguments of this Match with some of them changed, to build a copy."""
        return {**select_fields(self.arguments, MatchArguments), "seed": 0, "seeds": None, **changes}

    def state_hash(self, m: int | None = None) -> str:
        """Return a hash of the state of all matches, or of match m."""
        return saves.state_hash(self, m)
