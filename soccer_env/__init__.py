"""Multi-agent robot soccer after two published teams: physics by pymunk, play by policies and scripted teams.

How to use it:

    soccer_v0.py         the PettingZoo API
    gymnasium_envs.py    the Gymnasium API
    api/                 the parts that both share
    match/               `Match`: many matches at once, without dictionaries, and one step of them
    thoughts/            percepts, beliefs and decisions of robots, noted while a match is played
    replay/              matches on disk that play again exactly
    render/              pictures, windows and overlays
    shows/               replays as pictures, films and pages for the browser
    data_out/            replays as tables and in the formats of football data

The parts of a match:

    types.py             every record of a match, with units, frames and ranges
    records/             the records of percepts, of beliefs and of a step
    leagues/             the leagues, every number with unit and source
    teams/               the protocol of a team, the registry of teams, and functions as teams
    actions.py           the actions of learners
    observations/        the observations of learners
    rewards/             the rewards of learners
    scenes/              how an episode begins: kick-off and drills
    physics/             bodies, wheels, legs and ball; the only user of pymunk
    referee/             goals, restarts and the other rules
    statistics/          possession, passes, shots, and the kinds of goals
    optics/              geometry of the cameras
    robot_kinds/         each kind of robot, declared in one file
    perception/          percepts from the truth
    belief/              beliefs from percepts
    skills/              skills that scripted players share, from belief to command

The foundations:

    guards/              checks, ranges, whole files, and protection against signals, threads and errors
    geometry.py          angles, vectors and frames
    random_numbers.py    the generator that lives in the records
    compiled.py          the decorator that compiles a function
    compiling/           the compiler, and machine code on disk

The folders baselines/, agents/ and train/ of the repository are imported as `soccer_env.baselines` and so on.
"""

import sys
from typing import TYPE_CHECKING

from soccer_env.api.ids import register as _register
from soccer_env.guards.names import FoldersBeside, lazy_names

if TYPE_CHECKING:
    from soccer_env import soccer_v0
    from soccer_env.data_out.belief_errors import errors_of
    from soccer_env.leagues import League
    from soccer_env.match import Match
    from soccer_env.match.truth_state import WholeTruth
    from soccer_env.rewards import OwnTerm, Rewards
    from soccer_env.scenes import Scene
    from soccer_env.teams import Lineup, Team, make_team
    from soccer_env.teams.function_teams import team_of_function

__version__ = "0.1.0"
__all__ = [
    "League", "Lineup", "Match", "OwnTerm", "Rewards", "Scene", "Team", "WholeTruth", "errors_of", "make_team",
    "soccer_v0", "team_of_function",
]  # fmt: skip
_MODULES = {
    "League": "leagues", "Lineup": "teams", "Match": "match", "OwnTerm": "rewards", "Rewards": "rewards",
    "Scene": "scenes", "Team": "teams", "WholeTruth": "match.truth_state",
    "errors_of": "data_out.belief_errors", "make_team": "teams",
    "soccer_v0": "soccer_v0", "team_of_function": "teams.function_teams",
}  # fmt: skip
__getattr__, __dir__ = lazy_names(__name__, _MODULES)

sys.meta_path.append(FoldersBeside(__name__, __file__, ("baselines", "agents", "train")))  # in a checkout
_register()
