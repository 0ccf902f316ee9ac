"""Teams that play differently have different hashes, so that a folder never takes the results of one for another's."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import make_team
from soccer_env.compiled import compiled
from soccer_env.teams import CompiledTeam, TeamRandom, View
from soccer_env.teams.kernels import NO_MEMORY, STRENGTH, per_blind_player
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.provenance import UNKNOWN, team_hash


class Own:
    name, memory_dtype = "own", np.dtype([])

    def __init__(self, **kept: Any) -> None:
        vars(self).update(kept)

    def act(self, view: View, memory: np.ndarray, rng: TeamRandom) -> np.ndarray:
        return view.stand()


@compiled
def walk(memory, noise, command, k, settings):  # type: ignore[no-untyped-def]
    command.forward = settings.strength


def test_compiled_teams_are_told_apart_by_code_and_settings() -> None:
    numbers = np.array([(1.0,)], STRENGTH)
    still: Any = make_team("still")
    made: list[Any] = [make_team(name) for name in ("random", "chaser", "chaser@0.5", "sacks-2001", "still")]
    made += [make_team("sacks-2001:recovery=False"), make_team("sacks-2001-tuned")]
    made += [CompiledTeam("still", per_blind_player(walk), NO_MEMORY, numbers)]  # the name and settings of another
    hashes = [team_hash(team) for team in made]
    assert len(set(hashes)) == len(made)
    assert team_hash(make_team("chaser@0.5")) == hashes[2] == team_hash("chaser@0.5")
    assert team_hash(CompiledTeam("still", still.kernel, NO_MEMORY, numbers)) == hashes[4]


def test_python_teams_are_told_apart_by_what_they_keep() -> None:
    kept = [{}, {"gain": 1.0}, {"gain": 2.0}, {"net": np.zeros(3)}, {"net": np.ones(3)}, {"net": [np.ones(3)]}]
    hashes = [team_hash(Own(**one)) for one in kept]
    assert len(set(hashes)) == len(kept) and UNKNOWN not in hashes
    memory, net = np.dtype("i8"), np.ones(3)
    assert team_hash(Own(net=net, memory_dtype=memory)) == team_hash(Own(memory_dtype=memory, net=net))
    assert team_hash(Own(gain=object())) == UNKNOWN
    one, other = (team_hash(Own(gain=object(), fingerprint=text)) for text in ("a", "b"))
    assert one != other and UNKNOWN not in (one, other)


def played(out: Path | None, team: Any) -> int:
    settings = EvaluateSettings(home="mine", away="still", matches=2, minutes=0.1, players=1, seed=1, out=out)
    return len(evaluate(settings, teams={"mine": team}).lines)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (lambda: make_team("chaser", strength=0.0), lambda: make_team("random")),
        (lambda: make_team("chaser", strength=0.0), lambda: make_team("chaser", strength=0.5)),
        (lambda: Own(gain=1.0), lambda: Own(gain=2.0)),
    ],
)
def test_an_evaluation_does_not_go_on_with_another_team(tmp_path: Path, first: Any, second: Any) -> None:
    played(tmp_path, first())
    played(tmp_path, first())
    with pytest.raises(ValueError, match="holds an evaluation with other settings .*home_team"):
        played(tmp_path, second())


def test_a_team_that_cannot_be_told_from_another_is_evaluated_without_a_folder_alone(tmp_path: Path) -> None:
    assert played(None, Own(gain=object())) == 2
    with pytest.raises(ValueError, match="give it a `fingerprint`"):
        played(tmp_path / "new", Own(gain=object()))
    assert not (tmp_path / "new").exists()
