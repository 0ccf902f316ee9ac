"""The mutants of the mutation check: mechanism, piece of source, what replaces it, and the test that must notice."""

from tests import (
    mutants_ball,
    mutants_body,
    mutants_field,
    mutants_omni,
    mutants_picture,
    mutants_players,
    mutants_pose,
    mutants_stuck,
    mutants_team,
)
from tests.mutant import Mutant

__all__ = ["MUTANTS", "Mutant"]

PARTS = (
    mutants_body,
    mutants_picture,
    mutants_ball,
    mutants_players,
    mutants_field,
    mutants_omni,
    mutants_pose,
    mutants_stuck,
    mutants_team,
)
MUTANTS: list[Mutant] = [mutant for part in PARTS for mutant in part.MUTANTS]
