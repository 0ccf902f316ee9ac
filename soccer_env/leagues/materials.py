"""Elasticity and friction of each pair of things that collide."""

from dataclasses import dataclass, fields

from soccer_env.guards.checking import SHARE, raise_not_allowed
from soccer_env.leagues.checks import LeaguePart


@dataclass(frozen=True)
class Pair(LeaguePart):
    """The elasticity and friction between two surfaces that collide or rest against each other."""

    BOUNDS = {"elasticity": SHARE}

    elasticity: float  # [1] speed after over speed before a blow, along the normal
    friction: float  # [1] Coulomb's: greatest impulse along the surface over impulse along the normal

    def text(self) -> str:
        """Return the text "elasticity/friction", for tables."""
        return f"{self.elasticity:g}/{self.friction:g}"


@dataclass(frozen=True)
class Materials(LeaguePart):
    """The elasticity and friction of every pair of surfaces in a match.
    To a robot, boards, posts and nets are alike; all parts of a robot are alike.
    """

    ball_board: Pair  # all boards
    ball_post: Pair  # posts of a goal
    ball_net: Pair  # the back of a goal
    ball_robot: Pair  # any part of the robot
    robot_robot: Pair  # any parts of two robots
    robot_board: Pair  # boards, posts and nets

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, pair in self.pairs().items():
            if not isinstance(pair, Pair):
                raise_not_allowed(f"Materials.{name}", "a Pair", pair)

    def pairs(self) -> dict[str, Pair]:
        """Return the pairs of materials in contact by name, such as ball_board."""
        return {field.name: getattr(self, field.name) for field in fields(self)}
