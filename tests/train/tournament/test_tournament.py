"""A tournament: the same matches whatever the threads, the stops and the moment at which a team was added."""

import json
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env import make_team
from soccer_env.train.evaluate import EvaluateSettings, evaluate, recheck
from soccer_env.train.evaluate import contest as contests
from soccer_env.train.tournament import TournamentResult, TournamentSettings, tournament

SHORT: dict[str, Any] = {"teams": "chaser,random,still", "matches": 4, "minutes": 0.1, "players": 1, "senses": "ideal"}


def short(**changes: Any) -> TournamentResult:
    return tournament(TournamentSettings(**{**SHORT, **changes}))


def files(folder: Path) -> dict[str, Any]:
    """Return what a tournament has left: its result, and the lines of all matches in order."""
    found: dict[str, Any] = {"result": json.loads((folder / "result.json").read_text(encoding="utf-8"))}
    for path in folder.rglob("matches.jsonl"):
        lines = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
        plain = [{**line, "settings": ""} for line in lines]  # lines keep the settings of a smaller tournament
        found[path.parent.name] = sorted(plain, key=lambda line: int(line["match"]))
    return found


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """Return the files of a tournament that nothing has disturbed."""
    folder = tmp_path_factory.mktemp("whole") / "cup"
    short(out=folder)
    return files(folder)


def test_two_threads_and_three_kills_leave_the_same_lines_and_result(
    whole: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, play = tmp_path / "cup", contests.play
    monkeypatch.setattr(contests, "BATCH", 1)
    for allowed in (1, 3, 2):
        left = iter(range(allowed))

        def killed(*arguments: Any, left: Any = left) -> Any:
            if next(left, None) is None:
                raise KeyboardInterrupt
            return play(*arguments)

        monkeypatch.setattr(contests, "play", killed)
        with pytest.raises(KeyboardInterrupt):
            short(out=folder, threads=2)
        torn = next(folder.rglob("matches.jsonl"))
        torn.write_bytes(torn.read_bytes() + b'{"match": 3, "pa')  # as a power failure leaves it
    monkeypatch.setattr(contests, "play", play)
    short(out=folder, threads=2)
    assert files(folder) == whole


def test_a_team_that_is_added_and_more_matches_give_the_tournament_that_had_them_from_the_start(
    whole: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder, played, play = tmp_path / "cup", list[Any](), contests.play

    def seen(contest: Any, *rest: Any) -> Any:
        played.append({contest.first, contest.second})
        return play(contest, *rest)

    short(out=folder, teams="chaser,random", matches=2)
    tournament(TournamentSettings(out=folder, matches=4))
    monkeypatch.setattr(contests, "play", seen)
    for _ in range(2):  # the same command again finds everything played
        tournament(TournamentSettings(out=folder, add="still"))
    assert files(folder) == whole
    assert {"chaser", "random"} not in played and len(played) == 4


def test_a_pairing_is_an_evaluation_of_the_same_seeds(tmp_path: Path) -> None:
    result = short(out=tmp_path / "cup", teams="random,still", keep="best", keep_pages=True)
    alone = evaluate(EvaluateSettings(home="random", away="still", **{x: SHORT[x] for x in list(SHORT)[1:]}))
    (pairing,) = result.pairings
    assert pairing.result.lines == alone.lines
    assert recheck(tmp_path / "cup" / pairing.folder, pairs="all").agrees
    page = (tmp_path / "cup/report.html").read_text(encoding="utf-8")
    links = re.findall(r'href="(pairings/[^"]+)"', page)
    assert len(links) == 2 and all((tmp_path / "cup" / link).is_file() for link in links)


@pytest.mark.parametrize(("system", "pairings"), [("swiss", 4), ("knock-out", 3)])
def test_standings_add_up(system: Any, pairings: int) -> None:
    result = short(teams="chaser,random,still,random@0.5", system=system, matches=2)
    assert len(result.pairings) == pairings
    assert (
        sum(one.points for one in result.standings) == sum(one.matches for one in result.standings) / 2 == 2 * pairings
    )
    assert sum(one.goals_for - one.goals_against for one in result.standings) == 0
    assert result.standings[0].team == "chaser" and set(result.above["chaser"]) == set(result.names[1:])


class Runner:
    """A user's team: run ahead."""

    name = "runner"
    memory_dtype = np.dtype([])

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        commands = view.stand()
        commands[..., 0] = 1.0
        return commands


def test_objects_and_strengths_play_too() -> None:
    settings = TournamentSettings(**{**SHORT, "teams": "mine,weak,still", "matches": 2})
    result = tournament(settings, teams={"mine": Runner(), "weak": make_team("chaser", strength=0.5)})
    assert set(result.names) == {"mine", "weak", "still"}


WRONG = {
    "--teams chaser": "teams must be two names or more with commas between them, got 'chaser'",
    "--teams chaser,still,chaser": "teams must be different, got",
    "--teams chasr,still": "unknown team 'chasr', did you mean 'chaser'? known: still,",
    "--teams chaser@2,still": "strength of team 'chaser@2' must be a number from 0 to 1",
    "--teams chaser,heinemann-2006": "heinemann-2006",
    "--teams chaser,still --system ladder": "unknown --system 'ladder'; known: round-robin, swiss, knock-out",
    "--teams chaser,still,random --system swiss --rounds 3": "rounds must be 1 to 2 for 3 teams",
    "--teams chaser,still --rounds 1": "rounds goes with --system swiss",
    "--teams chaser,still --add random --out {out}": "or add alone, which no tournament",
    "--teams chaser,still --matches 3": "matches must be an even whole number",
    "--teams chaser,still --keep best": "replays are kept in a folder: give out as well",
    "--add random": "or give the out of a tournament",
    "--add random --out {out}": "holds no tournament: give teams to begin one",
    "--add random --out {out} --minutes 3": "minutes goes with teams alone",
}


@pytest.mark.parametrize("words", WRONG)
def test_a_mistake_is_told_in_one_line_before_a_folder_is_made(
    words: str, soccer: Callable[..., str], tmp_path: Path
) -> None:
    folder = tmp_path / "cup"
    asked = words.format(out=folder).split()
    asked += [] if "--out" in asked or "--keep" in asked or "--teams" not in asked else ["--out", str(folder)]
    assert WRONG[words] in soccer("tournament", *asked, code=2)
    assert not folder.exists()


def test_code_that_a_folder_names_runs_only_if_it_is_named_again(
    soccer: Callable[..., str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    text = "from soccer_env import make_team\n\ndef team(strength=1.0):\n    return make_team('random')\n"
    (tmp_path / "named_in_a_folder.py").write_text(text, encoding="utf-8")
    words = ["--minutes", "0.1", "--players", "1", "--senses", "ideal", "--matches", "2", "--out", "cup"]
    soccer("tournament", "--teams", "named_in_a_folder:team,still", *words)
    monkeypatch.delitem(sys.modules, "named_in_a_folder")
    assert "is code, which is not run because cup names it" in soccer("tournament", "--out", "cup", code=2)
    assert "named_in_a_folder" not in sys.modules
    told = soccer("tournament", "--teams", "named_in_a_folder:team,still,random", *words)
    assert "random" in told and "No team is shown to be the best:" in " ".join(told.split())


def test_other_settings_and_other_runs_lose_nothing(soccer: Callable[..., str], tmp_path: Path) -> None:
    folder = tmp_path / "cup"
    words = [f"--{name}={value}" for name, value in {**SHORT, "teams": "random,still", "out": folder}.items()]
    record = json.loads(soccer("tournament", *words, "--json"))
    before = files(folder)
    assert record == before["result"] and record["standings"][0]["matches"] == 4
    assert "seed 0 there, 1 now" in soccer("tournament", *words, "--seed", "1", code=2)
    assert "unknown team 'chasr'" in soccer("tournament", "--out", folder, "--add", "chasr", code=2)
    assert "something else than an evaluation" in soccer(
        "evaluate", "--senses", "ideal", "--players", "1", "--out", folder, code=2
    )
    (pairing,) = (folder / "pairings").iterdir()
    assert "something else than a tournament" in soccer("tournament", "--out", pairing, "--add", "chaser", code=2)
    assert files(folder) == before
    assert "random" in soccer("tournament", "--out", folder) and files(folder) == before
