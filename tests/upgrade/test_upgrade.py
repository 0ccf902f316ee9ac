"""Files of every released version are read, and play on bit for bit while the world is the same."""

import json
from pathlib import Path
from shutil import copytree

import pytest

from soccer_env import __version__
from soccer_env.replay import Replay
from soccer_env.train.evaluate import recheck
from soccer_env.train.tournament import TournamentSettings, tournament
from soccer_env.types import WORLD
from tests.upgrade.corpus import LEAGUES, STEPS, first_action, staged, versions

each_version = pytest.mark.parametrize("folder", versions(), ids=lambda folder: folder.name)


def facts_of(folder: Path) -> dict[str, object]:
    """Return what the files must give; skip if results have changed since, which the changelog then says."""
    facts = json.loads((folder / "facts.json").read_text(encoding="utf-8"))
    if facts["world"] != WORLD:
        pytest.skip(f"files of world {facts['world']}, this is {WORLD}")
    return facts


def test_the_present_version_has_its_files() -> None:
    assert __version__ in [folder.name for folder in versions()], "python -m tests.upgrade.corpus writes them"


@each_version
@pytest.mark.parametrize("league", LEAGUES)
def test_replays_and_saves_play_on(folder: Path, league: str) -> None:
    replay = Replay.read(folder / f"{league}.replay")
    assert len(replay) == STEPS and replay.notes() is not None
    facts = facts_of(folder)
    assert replay.check() == STEPS
    match = staged(league, "still")
    match.load((folder / f"{league}.save").read_bytes())
    match.step()
    assert match.state_hash() == facts[league]


@each_version
def test_policies_act_as_before(folder: Path) -> None:
    assert first_action(folder / "policy.safetensors") == pytest.approx(facts_of(folder)["action"], abs=1e-6)


@each_version
def test_evaluations_are_played_again_and_a_tournament_says_what_goes_on_with_it(folder: Path, tmp_path: Path) -> None:
    kept = copytree(folder, tmp_path / "kept")
    found = recheck(kept / "evaluation", pairs="all")
    assert not found.differences or found.made_otherwise
    before = (kept / "tournament/result.json").read_bytes()
    try:
        result = tournament(TournamentSettings(out=kept / "tournament", add="random"))
    except ValueError as error:  # results of two codes do not mix
        assert "code" in str(error) and (kept / "tournament/result.json").read_bytes() == before
    else:
        assert len(result.names) == 3
