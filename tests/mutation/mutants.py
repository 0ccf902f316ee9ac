"""The mutants of the mutation check: mechanism, piece of source, what replaces it, and the test that must notice."""

from tests.mutation import ball, body, field, heinemann, omni, picture, players, pose, stuck, team, ways
from tests.mutation.mutant import Mutant
from tests.mutation.play import goals, maps, steps
from tests.mutation.rules import legged, middle_size, referee

__all__ = ["MUTANTS", "PLAY", "RULES", "Mutant"]

PARTS = (body, picture, ball, players, field, omni, pose, stuck, team, ways, heinemann)
MUTANTS: list[Mutant] = [mutant for part in PARTS for mutant in part.MUTANTS]
PLAY: list[Mutant] = steps.MUTANTS + goals.MUTANTS + maps.MUTANTS  # of what is counted, by the name of the statistic
RULES: list[Mutant] = referee.MUTANTS + legged.MUTANTS + middle_size.MUTANTS  # of the referee, by the rule
