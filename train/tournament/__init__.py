"""Rank teams by a tournament: `soccer tournament`.

    result = tournament(TournamentSettings(teams="chaser,random,walker@0.5", matches=20))

Every pairing is an evaluation of its own, with its folder, its report and its kept replays.

settings.py    the options of the command, and those of a tournament to go on with
systems.py     who meets whom: round robin, Swiss, knock-out
playing.py     `tournament`: play the pairings that a folder lacks
ratings.py     openskill and Elo ratings with intervals, and who is above whom
results.py     the result: standings, ratings, pairings
sweeping.py    `soccer evaluate --sweep`: evaluations over a number of the league
report.py      the result as a page for the browser, and on the screen
"""

from typing import TYPE_CHECKING

from soccer_env.guards.names import lazy_names

if TYPE_CHECKING:
    from soccer_env.train.tournament.playing import tournament
    from soccer_env.train.tournament.results import TournamentResult
    from soccer_env.train.tournament.settings import TournamentSettings

__all__ = ["TournamentResult", "TournamentSettings", "tournament"]
__getattr__, __dir__ = lazy_names(
    __name__, {"TournamentResult": "results", "TournamentSettings": "settings", "tournament": "playing"}
)
