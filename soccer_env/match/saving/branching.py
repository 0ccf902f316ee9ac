"""What a Match does with saves and branches: the methods that `Match` inherits."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING, Any
from weakref import WeakSet

import numpy as np

from soccer_env.guards.names import Made
from soccer_env.match.arguments import MatchArguments, part_of
from soccer_env.match.saving import branches, fitting, saves
from soccer_env.random_numbers import seeds_for

if TYPE_CHECKING:
    from typing_extensions import Self

    from soccer_env.match.settings import Settings


class Branching:
    """Save, load, branch, hash and copy the matches of a Match."""

    if TYPE_CHECKING:
        asked: MatchArguments
        count: int
        settings: Settings
        squads: list[Any]
        batch: Any
        recorder: Any
        started: bool
        rewards: np.ndarray
        terms: np.ndarray

        def _observe_own(self) -> None: ...

    @property
    def played_by(self) -> tuple[str, list[Any]]:
        """Return the fingerprint of the settings, and who plays now: what a save must agree with."""
        return self._fingerprint, [squad.describe() for squad in self.squads]

    @cached_property
    def _fingerprint(self) -> str:
        return self.settings.fingerprint()

    @property
    def told(self) -> dict[str, list[str]]:
        """Return settings and teams in words, for the message to a match that a save or a branch does not fit."""
        return {**self._told, "teams": fitting.told_of_teams(self)}

    @cached_property
    def _told(self) -> dict[str, list[str]]:
        return fitting.told(self)

    @cached_property
    def _fitting(self) -> WeakSet[Any]:
        """Return the Matches that are known to fit this one: nothing that decides it ever changes."""
        return WeakSet()

    def rebuild(self, rows: Iterable[int] | None = None) -> None:
        """Rebuild the physics from the records, as a load does: matches with equal records then go on alike."""
        rows = range(self.count) if rows is None else list(rows)
        started, self.started = self.started, False
        self.batch.build_spaces(rows)
        if self.recorder is not None:
            self.recorder.note_rebuild(rows)
        self.started = started

    def save(self, rows: Any = None) -> bytes:
        """Return everything that the future depends on, and rebuild the physics of the running matches from it.

        Contacts forget what touches have built up, so the running match goes on as every copy of the save does, and
        otherwise than without it: a run that saves at the same steps is reproducible, one that never saves is another.

        rows: a match's number, or several; None: all of them. ValueError for a number that no match has.
        """
        found = None if rows is None else branches.check_rows("rows", rows, self.count)
        saved = saves.dump(self, rows=found)
        self.rebuild(found)
        return saved

    def load(self, saved: bytes, rows: Any = None) -> None:
        """Go on from what `save` returned, in all matches or in some rows; the others go on as they were.

        A save of one match goes into every one of the rows. ValueError (and no change) if it is damaged, from other
        settings, or of another number of matches.
        """
        found = None if rows is None else branches.check_rows("rows", rows, self.count, once=True)
        if not (self.started or found is None):
            raise RuntimeError("load: an error has cut short what was done before: load all matches, or call reset")
        records = saves.opened(self, saved, rows=found)
        self.started = False
        saves.fill(self, records, found)
        self._go_on(np.arange(self.count) if found is None else found)

    def branch(self, rows: Any, into: Self | None = None, *, at: Any = None, noise: int | None = None) -> Self:
        """Copy matches over matches of another Match, in memory; return that Match.

        rows: which ones, a number or several. into: a Match of the same settings and teams, whose number of matches,
        seeds, observations, rewards and actions may differ; None: a new one, with one match a row. at: over which of
        its matches, None: all; one row goes over all of them, else row i goes over at[i]. noise: None: a branch has the
        future of its original, bit for bit, under the same actions; a seed: each branch draws all that is left to
        chance anew (slips, sensors, referee), so that branches are samples of what may happen.

        The originals are rebuilt as by `save`, which changes how they go on: to compare play with a search and play
        without on one seed, branch in both, or play both from one save. ValueError, and nothing has changed, for rows
        that there are not, or another number of them than of `at`, and for a Match that does not fit.
        """
        found = branches.check_rows("rows", rows, self.count)
        other = type(self)(**self._asked(matches=len(found))) if into is None else into
        if other not in self._fitting:
            branches.check_fits(self, other)
            self._fitting.add(other)
        over = np.arange(other.count) if at is None else branches.check_rows("at", at, other.count, once=True)
        if len(found) not in (1, len(over)):
            raise ValueError(f"rows must be one match or as many as are overwritten, {len(over)}, got {len(found)}")
        if noise is not None:
            seeds_for(noise, 1)
        other._take(self, found, over, noise)  # before the rebuild: if it is undone, nothing has happened
        self.rebuild(np.unique(found).tolist())
        return other

    def _take(self, other: Self, rows: np.ndarray, over: np.ndarray, noise: int | None) -> None:
        """Go on, in the matches `over`, as the matches `rows` of another Match do."""
        self.started = False
        branches.copy_rows(other, rows, self, over)
        if noise is not None:
            branches.draw_anew(self, over, noise)
        self._go_on(over)

    def _go_on(self, rows: np.ndarray) -> None:
        """Play matches on from records that were just written."""
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
        """Copy by settings and `save`: pickled and deep copies have the future that the original has from then."""
        return saves.by_save(self, type(self), self._asked())

    def _asked(self, **changes: Any) -> dict[str, Any]:
        """Return the settings of this Match, some changed, for one that gets its matches from this."""
        return {**part_of(self.asked, MatchArguments), "seed": 0, "seeds": None, **changes}

    def state_hash(self, m: int | None = None) -> str:
        """Return a hash of the state of all matches, or of match m."""
        return saves.state_hash(self, m)
