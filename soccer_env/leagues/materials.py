"""What happens between two things that meet: elasticity and friction of each pair of materials."""

from dataclasses import dataclass, fields

from soccer_env.guards.checking import SHARE, refuse
from soccer_env.leagues.checks import Part


@dataclass(frozen=True)
class Pair(Part):
    """Two surfaces that meet in a blow, or lean on each other."""

    BOUNDS = {"elasticity": SHARE}

    elasticity: float  # [1] speed at which they part over that at which they met, along the normal
    friction: float  # [1] Coulomb's: most impulse along the surface over that along the normal

    def text(self) -> str:
        """Return both numbers in short, for lists."""
        return f"{self.elasticity:g}/{self.friction:g}"


@dataclass(frozen=True)
class Materials(Part):
    """Every pair that meets in a match. Boards, posts and nets are alike to robots, and so is all of a robot."""

    ball_board: Pair  # and the boards on the lines of a walled pitch
    ball_post: Pair  # of a goal
    ball_net: Pair  # behind the goal line
    ball_robot: Pair  # any part of it
    robot_robot: Pair  # any parts of two
    robot_board: Pair  # boards, posts and nets

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, pair in self.pairs().items():
            if not isinstance(pair, Pair):
                refuse(f"Materials.{name}", "a Pair", pair)

    def pairs(self) -> dict[str, Pair]:
        """Return the pairs by name."""
        return {field.name: getattr(self, field.name) for field in fields(self)}
