"""What a robot does by itself while the person holds a key: carry the ball, shoot, pass.

Each is a skill that learners can choose as well, as a compiled team for one robot. It decides from the robot's own
belief, and searches for a ball that the robot has lost.

`k`: the league's constants; `play`: the numbers of the skills.
"""

from collections.abc import Callable

from soccer_env.compiled import compiled
from soccer_env.skills import fitted, skill_settings
from soccer_env.skills.choices import SKILLS, play_skill
from soccer_env.skills.settings import MEMORY
from soccer_env.skills.sight import SIGHT
from soccer_env.teams import CompiledTeam
from soccer_env.teams.kernels import per_player
from soccer_env.train.command.playing.controls import CARRY, PASS, SHOOT

NAMES = list(SKILLS)
CARRIES, SHOOTS, PASSES = NAMES.index("dribble to goal"), NAMES.index("shoot"), NAMES.index("pass")


@compiled
def carry(belief, tracks, memory, noise, command, k, play, sight):
    """Go for the ball and carry it towards the goal, past opponents."""
    play_skill(CARRIES, belief, tracks, memory, noise, command, k, play, sight)


@compiled
def shoot(belief, tracks, memory, noise, command, k, play, sight):
    """Go for the ball, carry it to where a way into the goal is free, and shoot."""
    play_skill(SHOOTS, belief, tracks, memory, noise, command, k, play, sight)


@compiled
def pass_ball(belief, tracks, memory, noise, command, k, play, sight):
    """Go for the ball and pass it to the team-mate whose way is the freest and the least to turn for."""
    play_skill(PASSES, belief, tracks, memory, noise, command, k, play, sight)


def assist(name: str, act: Callable[..., None]) -> CompiledTeam:
    """Return a team of one robot that does one thing."""
    return CompiledTeam(name, per_player(act, SIGHT), MEMORY, skill_settings(), fit=fitted)


ASSISTS = {CARRY: assist(CARRY, carry), SHOOT: assist(SHOOT, shoot), PASS: assist(PASS, pass_ball)}
