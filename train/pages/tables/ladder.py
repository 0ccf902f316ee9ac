"""The ladder: all shipped teams of a league, rated by a round robin under the whole rule book.

The tournaments stay in runs/ladder/, so a measurement that was stopped goes on there.
"""

from pathlib import Path
from typing import Any

from soccer_env.train.evaluate.report import table
from soccer_env.train.pages.tables.teams import row_of
from soccer_env.train.tournament import TournamentSettings, tournament
from soccer_env.train.tournament.report import HEAD, standing_rows
from soccer_env.train.tournament.settings import command_of
from soccer_env.train.written_settings import with_ray

TEAMS = {  # none of the past selves of the learned teams is shipped
    "legged-2001": (
        "chaser", "learned", "sacks-2001-tuned", "sacks-2001", "sacks-2001-future", "walker", "random", "still",
    ),
    "middle-size-2006": ("heinemann-2006", "weigel-2001", "chaser", "walker", "random", "still", "learned-2006"),
}  # fmt: skip
FOLDER = Path("runs/ladder")


def measure_ladder(ray: str | None = None) -> dict[str, Any]:
    """Play the ladder of each league, perhaps on a Ray cluster; `rows` has a pairing of each, for the check."""
    leagues, rows = [], []
    for league in TEAMS:
        settings = TournamentSettings(
            teams=",".join(TEAMS[league]), league=league, players=3, minutes=4.0, matches=40, seed=1, threads=2,
            pose="particles", out=FOLDER / league,
        )  # fmt: skip
        result = tournament(with_ray(settings, ray))
        standings = [list(row) for row in standing_rows(result)]
        shown = {"league": league, "command": command_of(settings), "matches": settings.matches}
        leagues.append({**shown, "standings": standings})
        rows.append(row_of(settings.pairing(0, 1), result.pairings[0].result))
    return {"leagues": leagues, "rows": rows}


def ladder_table(measured: dict[str, Any]) -> str:
    """Return the ladders in Markdown, a table for each league."""
    parts = []
    for ladder in measured["leagues"]:
        rows = [(place, f"`{team}`", *rest) for place, team, *rest in ladder["standings"]]
        head = (ladder["league"], *HEAD[1:])
        parts += [table(head, rows), f"Each pair of teams played {ladder['matches']} matches: `{ladder['command']}`"]
    return "\n\n".join(parts)
