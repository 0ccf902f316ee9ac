"""Multi-agent robot soccer after two published teams: physics by pymunk, play by policies and scripted teams.

How to use it:

    soccer_v0.py         the PettingZoo API
    gymnasium_envs.py    the Gymnasium API
    api/                 what both share
    match.py             `Match`: many matches at once, without dictionaries
    thoughts/            what robots saw, believed and decided, noted as a match is played
    replay/              matches on disk that play again exactly
    data_out/            replays as tables and in the formats of football data
    render/              pictures, windows and overlays
    staging.py           robots and ball put somewhere, for experiments

What a match is made of:

    types.py             every record of a match, with units, frames and ranges
    ranges.py            what the fields of records may hold, and the check of it
    percept_types.py     the records of percepts
    belief_types.py      the records of beliefs
    match_settings.py    the settings of a match, each declared once
    settings.py          the settings of a match, every name resolved
    leagues/             the leagues, every number with unit and source
    teams/               what a team is, and the teams by name
    function_teams/      functions of observations as teams: policies of any library
    team_kernels.py      the kernel of a team, made from what one player does
    actions.py           what learners may do
    observations/        what learners see
    rewards/             what learners are paid for
    scenes/              how an episode begins: kick-off and drills
    physics/             bodies, wheels, legs and ball; the only user of pymunk
    referee/             goals, restarts and the other rules
    statistics/          who has the ball and what he does with it, how goals fall
    optics/              what a camera shows where
    robot_kinds/         each kind of robot declared in one file
    perception/          percepts from the truth
    belief/              beliefs from percepts

How it is played:

    match_batch.py       the records of M matches, and how a slice of them is stepped
    step.py              one control step, from commands to observations
    world.py             the arrays that the step passes about, by name
    episodes.py          how an episode begins
    squads.py            who plays which robot
    senses.py            what robots perceive and believe
    saving/              save, load, branch, hash
    truth_state.py       the whole truth as one vector, for centralised critics
    match_views.py       beliefs, states and words of a match, to be read
    user_code.py         checks of what a user's own functions return

What all of it stands on:

    guards/              what keeps a match whole where signals, threads and forks come in
    geometry.py          angles, vectors and frames
    random_numbers.py    the generator that lives in the records
    ball_words.py        words of four bits for a distance to the ball
    compiled.py          the decorator that compiles a function
    compiling/           how that is done, and machine code on disk
    borrowing.py         arrays in compiled code without a count of references
    names.py             names imported when they are used, and what to say of unknown ones
    checking.py          checks of what somebody gives, with one kind of message
    whole_files.py       files that are written whole or not at all

The folders baselines/, agents/ and train/ of the repository are imported as `soccer_env.baselines` and so on.
"""

import sys
from typing import TYPE_CHECKING

from soccer_env.api.ids import register as _register
from soccer_env.names import FoldersBeside, lazy_names

if TYPE_CHECKING:
    from soccer_env import soccer_v0
    from soccer_env.function_teams import team_of_function
    from soccer_env.leagues import League
    from soccer_env.match import Match
    from soccer_env.rewards import OwnTerm, Rewards
    from soccer_env.scenes import Scene
    from soccer_env.teams import Lineup, Team, make_team
    from soccer_env.truth_state import WholeTruth

__version__ = "0.1.0"
__all__ = [
    "League", "Lineup", "Match", "OwnTerm", "Rewards", "Scene", "Team", "WholeTruth", "make_team", "soccer_v0",
    "team_of_function",
]  # fmt: skip
__getattr__, __dir__ = lazy_names(  # resolved at first use, so that importing the package stays quick
    __name__,
    {
        "League": "soccer_env.leagues",
        "Lineup": "soccer_env.teams",
        "Match": "soccer_env.match",
        "OwnTerm": "soccer_env.rewards",
        "Rewards": "soccer_env.rewards",
        "Scene": "soccer_env.scenes",
        "Team": "soccer_env.teams",
        "WholeTruth": "soccer_env.truth_state",
        "make_team": "soccer_env.teams",
        "soccer_v0": "soccer_env.soccer_v0",
        "team_of_function": "soccer_env.function_teams",
    },
)

sys.meta_path.append(FoldersBeside(__name__, __file__, ("baselines", "agents", "train")))  # in a checkout
_register()
