"""Lineups: which team plays an episode follows from seed, episode and side, and it plays as if it had come alone."""

import copy
import re
from typing import Any

import numpy as np
import pytest

from soccer_env import Lineup, Match, team_of_function
from soccer_env.agents.learned import team_from_policy
from soccer_env.teams import make_team
from soccer_env.types import AWAY, HOME
from tests.agents.staged_policies import random_policy
from tests.scenes.staging import play

NAMES = ("still", "random@0.5", "chaser")


class Slow:
    """A team without a kernel."""

    name, memory_dtype = "slow", np.dtype([("steps", "i8")])

    def act(self, view: Any, memory: np.ndarray, rng: Any) -> np.ndarray:
        memory["steps"] += 1
        commands = view.stand()
        commands[..., 0] = rng.uniform(0.2, 0.5)
        commands[..., 2] = np.where(memory["steps"] > 3, view.ball["bearing"], 0.0)
        return commands


def lineup(*weights: float, names: tuple[str, ...] = NAMES) -> Lineup:
    teams: Any = tuple(make_team(name) for name in names)
    return Lineup(teams, np.array(weights or (1.0,) * len(names)), names)


def pitch(away: Any, home: Any = "chaser", **settings: Any) -> Match:
    """Return matches of 2 against 2 that begin again at once."""
    fields: dict[str, Any] = {"home": 2, "away": 2, "autoreset": "same_step", "max_cycles": 8, "seed": 5}
    return Match(controllers={"home": home, "away": away}, **{**fields, **settings})


def who_plays(match: Match, side: int = AWAY) -> list[str]:
    squads = [squad for squad in match.squads if (squad.players[0] >= match.settings.rows[0]) == side]
    playing = np.array([squad.plays for squad in squads if squad.plays is not None])
    assert (playing.sum(axis=0) == 1).all()
    return [squads[index].name for index in playing.argmax(axis=0)]


def episodes(match: Match, count: int = 4) -> list[list[str]]:
    found = []
    for _ in range(count):
        found.append(who_plays(match))
        play(match, steps=8)
    return found


def test_who_plays_follows_from_seed_and_episode_alone() -> None:
    many, threaded = pitch(lineup(), matches=16), pitch(lineup(), matches=16, threads=2)
    found = episodes(many)
    assert episodes(threaded) == found
    threaded.close()
    for m in (0, 7):
        assert episodes(pitch(lineup(), seeds=[many.seeds[m]], seed=None)) == [[row[m]] for row in found]
    chooser = lineup()
    assert [[NAMES[chooser.choose(int(seed), episode)] for seed in many.seeds] for episode in range(4)] == found
    assert all(set(row) == set(NAMES) for row in found), "all of them play somewhere"
    assert any(row != found[0] for row in found), "they change"


def test_a_seed_begins_the_same_order_anew() -> None:
    match = pitch(lineup(), matches=8)
    first = episodes(match)
    match.reset(seed=6)
    assert episodes(match) != first
    match.reset(seed=5)
    assert episodes(match) == first


def test_frequencies_follow_the_weights() -> None:
    chooser, count = lineup(1.0, 6.0, 3.0), 4000
    drawn = np.bincount([chooser.choose(seed, episode) for seed in range(400) for episode in range(10)], minlength=3)
    shares = np.array([0.1, 0.6, 0.3])
    deviation = np.sqrt(count * shares * (1.0 - shares))
    assert (np.abs(drawn - count * shares) < 4.0 * deviation).all()


@pytest.mark.parametrize("weights", [(0.0, 1.0, 0.0), (0.0, 1e-300, 0.0), (0.0, 1e300, 0.0)])
def test_weight_0_never_plays(weights: tuple[float, ...]) -> None:
    chooser = lineup(*weights)
    assert {chooser.choose(seed, 0) for seed in range(500)} == {1}


def test_weights_may_change_between_steps_and_count_from_the_next_episode() -> None:
    chooser = lineup(1.0, 0.0, 0.0)
    match = pitch(chooser, matches=4)
    chooser.weights[:] = 0.0, 0.0, 1.0
    assert episodes(match, 2) == [["still"] * 4, ["chaser"] * 4]


def test_lineups_of_the_two_sides_choose_apart() -> None:
    match = pitch(lineup(), lineup(), matches=64)
    pairs = set(zip(who_plays(match, HOME), who_plays(match, AWAY), strict=True))
    assert len(pairs) == len(NAMES) ** 2


def test_a_team_may_be_in_the_lineups_of_both_sides() -> None:
    chaser: Any = make_team("chaser")
    still: Any = make_team("still")
    at_home, away = Lineup((chaser, still), np.ones(2), ("c", "s")), Lineup((chaser, still), np.ones(2), ("c", "s"))
    match = pitch(away, at_home, matches=32)
    seeds = [int(seed) for seed in match.seeds]
    assert who_plays(match, HOME) == ["cs"[at_home.choose(seed, 0, HOME)] for seed in seeds]
    assert who_plays(match, AWAY) == ["cs"[away.choose(seed, 0, AWAY)] for seed in seeds]


def learned_too() -> Lineup:
    """Return a lineup of a scripted team and of two policies that decide at different times."""
    policies = [team_from_policy(random_policy(8, action_repeat=repeat, seed=repeat)) for repeat in (1, 4)]
    chaser: Any = make_team("chaser")
    return Lineup((chaser, *policies), np.ones(3), ("chaser", "quick", "slow"))


def test_a_save_keeps_who_plays() -> None:
    match, other = pitch(learned_too(), matches=8), pitch(learned_too(), matches=8, seed=6)
    play(match, steps=21)
    assert who_plays(other) != who_plays(match)
    other.load(match.save())
    assert who_plays(other) == who_plays(match)
    for _ in range(20):
        match.step()
        other.step()
        assert match.state_hash() == other.state_hash()


def test_a_save_of_another_lineup_is_refused() -> None:
    saved = pitch(lineup()).save()
    for other in (lineup(names=("still", "chaser", "random@0.5")), lineup(names=("still", "chaser")), "chaser"):
        with pytest.raises(ValueError, match="teams differ"):
            pitch(other).load(saved)


@pytest.mark.parametrize("senses", ["ideal", "sensors"])
def test_a_match_of_a_lineup_is_bit_for_bit_that_of_the_team_that_plays(senses: str) -> None:
    """Of teams with kernels, in Python and of functions, and of policies that decide at different times."""
    seen: list[int] = []

    def counted(observations: np.ndarray, memory: np.ndarray) -> np.ndarray:
        seen.append(len(observations))
        memory += 1.0
        return np.tanh(observations[..., :4] + 0.1 * memory)

    members: dict[str, Any] = {
        **dict(zip(learned_too().names, learned_too().teams, strict=True)), "in Python": Slow(),
        "counted": team_of_function(counted, action_repeat=3, memory=("f4", (1,))),
    }  # fmt: skip
    match = pitch(Lineup(tuple(members.values()), np.ones(5), tuple(members)), matches=20, senses=senses, max_cycles=60)
    playing = who_plays(match)
    assert set(playing) == set(members)
    alone = {name: pitch(team, matches=20, senses=senses, max_cycles=60) for name, team in members.items()}
    for _ in range(59):
        seen.clear()
        match.step()
        assert seen in ([], [playing.count("counted")])
        for other in alone.values():
            other.step()
    for m, name in enumerate(playing):
        for records in ("matches", "balls", "robots"):
            assert getattr(match, records)[m].tobytes() == getattr(alone[name], records)[m].tobytes()


def test_a_team_that_is_added_plays_from_the_next_episode_on_as_if_it_had_been_there() -> None:
    """A save of it fits a match whose lineup had the team from the beginning, and plays on the same."""
    grown = lineup(names=("still", "chaser"))
    match = pitch(grown, matches=8)
    play(match, steps=4)
    quick = team_from_policy(random_policy(8, seed=1))
    before = who_plays(match)
    assert grown.add(quick, name="quick") == "quick" and grown.names == ("still", "chaser", "quick")
    assert grown.weights.tolist() == [1.0, 1.0, 1.0] and who_plays(match) == before
    grown.weights[:] = 0.0, 0.0, 2.0
    play(match, steps=3)
    assert who_plays(match) == before
    play(match, steps=1)
    assert who_plays(match) == ["quick"] * 8
    fresh = pitch(Lineup([make_team("still"), make_team("chaser"), quick], [0, 0, 2], ["still", "chaser", "quick"]))
    fresh.load(match.save(rows=[3]))
    alone = pitch(grown)
    alone.load(match.save(rows=[3]))
    for _ in range(8):
        fresh.step(), alone.step()
    assert fresh.state_hash() == alone.state_hash()


def test_a_team_that_is_added_in_python_is_undone_and_copied_like_others() -> None:
    grown = lineup(names=("still", "chaser"))
    match = pitch(grown, matches=2)
    play(match, steps=2)
    grown.add(Slow())
    copied = copy.deepcopy(match)
    grown.weights[:] = copied.squads[-1].lineup.weights[:] = 0.0, 0.0, 1.0
    for _ in range(12):
        match.step(), copied.step()
    assert who_plays(match) == who_plays(copied) == ["slow"] * 2 and match.state_hash() == copied.state_hash()
    assert not match._turn.sure, "an error of its code undoes a step"


def test_what_cannot_be_added_changes_nothing() -> None:
    grown = lineup(names=("still", "chaser"))
    for arguments, message in (
        (("still",), "has the name 'still'"), ((grown,), "not of lineups"), (("random", -1.0), "must be 3 numbers"),
        (("nobody",), "unknown team"),
    ):  # fmt: skip
        with pytest.raises(ValueError, match=message):
            grown.add(*arguments)
        assert grown.names == ("still", "chaser") and grown.weights.tolist() == [1.0, 1.0]
    blind = Lineup(["still"])
    match = Match(home=1, away=1, opponents=blind, observe="truth", autoreset="same_step", max_cycles=4, seed=1)
    blind.add("chaser")
    with pytest.raises(ValueError, match="needs sensors, and no team before it used them"):
        match.reset()


CHASER: Any = make_team("chaser")


WEIGHTS = "weights of a Lineup must be 2 numbers from 0, not all 0"
BAD: list[tuple[tuple[Any, ...], str]] = [
    (((), np.ones(0), ()), "a Lineup needs a list of one team at least, got ()"),
    (("chaser",), "a Lineup needs a list of one team at least, got 'chaser'"),
    ((["chaser", "chaser"],), "the 2 teams of a Lineup must have different names, got ('chaser', 'chaser')"),
    (([lineup()],), "a Lineup is made of teams, not of lineups"),
    (([3],), "a team needs name, memory_dtype and act, got 3"),
    (((CHASER, CHASER), np.ones(2), ("a",)), "the 2 teams of a Lineup must have different names, got ('a',)"),
    *((((CHASER, CHASER), np.array(bad), ("a", "b")), WEIGHTS)
      for bad in ([1.0] * 3, [0.0, 0.0], [1.0, -0.1], [1.0, np.nan], [1.0, np.inf], ["1", "2"])),
]  # fmt: skip


@pytest.mark.parametrize(("given", "message"), BAD, ids=range(len(BAD)))
def test_what_is_no_lineup_is_refused(given: tuple[Any, ...], message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        Lineup(*given)


def test_a_team_that_cannot_play_and_weights_that_were_spoilt_are_named() -> None:
    truth = Lineup((CHASER, team_from_policy(random_policy(observe="truth"))), np.ones(2), ("chaser", "t"))
    with pytest.raises(ValueError, match="team 'lively' observes truth: it needs senses='ideal', got 'sensors'"):
        pitch(truth)
    chooser = lineup()
    match = pitch(chooser)
    chooser.weights[:] = np.nan
    with pytest.raises(ValueError, match="weights of a Lineup must be 3 numbers from 0, not all 0, got"):
        match.reset()
