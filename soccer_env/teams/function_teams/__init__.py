"""Functions of observations as teams: what lets a policy of any library play where a team is asked for.

    team.py      the team
    answers.py   what its function may return
    asking.py    ask the functions of a match, before anybody moves

Policy files are faster and need no library (`agents/`); this is for whatever does not fit into one.
"""

from soccer_env.teams.function_teams.asking import ask_functions
from soccer_env.teams.function_teams.team import FunctionTeam, team_of_function

__all__ = ["FunctionTeam", "ask_functions", "team_of_function"]
