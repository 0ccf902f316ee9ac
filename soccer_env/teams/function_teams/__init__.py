"""Teams made from functions of observations, so that a policy of any library plays wherever a team is expected.

    team.py      the team
    answers.py   checks of what its function returns
    asking.py    ask the functions of a match, before anybody moves

Policy files are faster and need no library (`agents/`); use a function for a policy that does not fit into a file.
"""

from soccer_env.teams.function_teams.asking import ask_functions
from soccer_env.teams.function_teams.team import FunctionTeam, team_of_function

__all__ = ["FunctionTeam", "ask_functions", "team_of_function"]
