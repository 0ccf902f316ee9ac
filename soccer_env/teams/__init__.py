"""The protocol of a team, and the registry of teams by name.

    team.py          the protocol, and compiled teams
    explaining.py    how a team explains itself to people who watch it
    lineup.py        several teams, one of which plays each episode
    kernels.py       the kernel of a team, made from the function of one player
    function_teams/  functions of observations as teams: policies of any library
    registry.py      teams by name: shipped ones, and those of packages, files and your own modules

The teams themselves stand in `baselines/` and `agents/`.
"""

from soccer_env.teams.explaining import DecisionInputs, Explanation, explanation_of, shipped_team
from soccer_env.teams.lineup import Lineup
from soccer_env.teams.registry import (
    ENTRY_POINTS,
    NAMES,
    is_module_team,
    make_team,
    parse_team,
    registered_teams,
    result_name,
)
from soccer_env.teams.team import CompiledTeam, ObservingTeam, Team, TeamRandom, View

__all__ = [
    "ENTRY_POINTS", "NAMES", "CompiledTeam", "Explanation", "Lineup", "DecisionInputs", "ObservingTeam", "Team",
    "TeamRandom",
    "View", "result_name", "explanation_of", "is_module_team", "make_team", "parse_team", "registered_teams",
    "shipped_team",
]  # fmt: skip
