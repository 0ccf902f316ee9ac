"""Claims state the rules that their matches are made with, and who is sent off is neither held, free nor in a crowd."""

import re
from pathlib import Path

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.memory import APPROACH, BACK
from soccer_env.match import Match
from soccer_env.match.staging import PATIENT, memory_of
from soccer_env.scenes import SCENES
from soccer_env.train.papers import staging
from soccer_env.train.papers.claim import NO_MATCH, PLAYED, PLAYED_AND_STAGED, STAGED, Batch
from soccer_env.train.papers.claims import all_claims
from soccer_env.train.papers.claims.dribble import or_shoot
from soccer_env.train.papers.claims.stuck import sampled
from soccer_env.train.papers.claims.stuck.branches import FREE_TIME, Fate, follow_moments
from soccer_env.train.papers.claims.stuck.collisions import count_near_ball, ended_by_referee
from soccer_env.train.papers.claims.stuck.detection import Approaches
from soccer_env.train.papers.claims.stuck.sampled import OUT, MotionWindow, behaviours, stack_moments
from soccer_env.train.papers.dribble_runs import PAPER, start_drill
from soccer_env.train.papers.reproduction import reproduce
from soccer_env.train.papers.settings import ReproduceSettings
from soccer_env.train.papers.staging import begin_scene, kick_off, play, put, put_ball, stage, stage_drill
from soccer_env.types import Foul, Phase

BATCH = Batch("test", 0, 0)
TEAM = "sacks-2001"


def test_every_claim_states_its_rules() -> None:
    allowed = (PLAYED, PLAYED_AND_STAGED, STAGED, NO_MATCH)
    assert all(claim.rules in allowed for claim in all_claims().values())
    judged_from_play = {name for name, claim in all_claims().items() if "league" in claim.rules}
    assert {"S01", "S02", "S22", "S24", "S27", "S29", "S30", "S31", "S69"} <= judged_from_play


def test_other_rules_of_play_are_asked_for_by_name(made: set[str]) -> None:
    (result,) = reproduce(ReproduceSettings(claims=("S04",), quick=True, seeds=(1,), rules="simple"))
    assert made == {"simple"} == set(result.rules)


def test_matches_under_rules_that_the_claim_does_not_state_are_refused() -> None:
    staged, played = Batch("S99", 0, 0, rules=STAGED), Batch("S99", 0, 0, rules=PLAYED)
    with pytest.raises(ValueError, match="S99 is judged from play, and states no rules of play"):
        kick_off(staged, matches=1)
    with pytest.raises(ValueError, match="its matches are made with 'simple:dropped_ball=False'"):
        stage(played, matches=1)
    assert kick_off(Batch("S99", 0, 0, rules=("simple",)), matches=1).league.rules.name == "simple"


def test_all_matches_of_claims_are_made_in_one_place() -> None:
    folder = Path(staging.__file__).parent
    calls = [path.name for path in folder.rglob("*.py") for _ in re.findall(r"\bMatch\(", path.read_text())]
    assert sorted(calls) == ["staging.py", "workers.py"], "workers.py compiles by one, which no claim sees"


def test_drills_run_under_their_own_rules_and_where_opponents_play_under_those_of_play() -> None:
    assert start_drill(BATCH, "dribble-past-one", {}, 1, PAPER).league.rules.name == PATIENT
    wall = stage_drill(BATCH, "facing-wall", TEAM, matches=1)
    assert wall.league.rules.name == SCENES["facing-wall"].rules == PATIENT
    simple = Batch("S31", 0, 0, rules=("simple",))
    match = start_drill(simple, or_shoot.SCENE, {}, 1, 0.0, opponents="chaser", rules=simple.play_rules)
    assert match.league.rules.name == "simple"


def two(rows: int = 1) -> Match:
    """Return matches of two robots that go for a ball ahead, in contact, their legs walking on the spot."""
    match = stage(BATCH, matches=rows, controllers={"home": TEAM, "away": TEAM})
    put(match, 0, -0.3, 0.0, 0.0, forward=0.12)
    put(match, 1, -0.3, 0.12, 0.0, forward=0.12)
    put_ball(match, 0.3, 0.0)
    begin_scene(match, placed=True)
    for r in (0, 1):
        memory_of(match, r)["behaviour"] = APPROACH
    match.robot_events["collision"] = 1
    return match


def test_who_is_sent_off_is_not_held() -> None:
    match = two()
    watch = MotionWindow(match)
    for _ in range(watch.size):
        watch.look()
    assert watch.held().all() and watch.fell_short().all() and watch.there().all()
    match.robots["active"][:, 1] = 0  # where it stood: only the record tells
    watch.look()
    assert watch.held().tolist() == watch.fell_short().tolist() == watch.there().tolist() == [[True, False]]
    assert behaviours(match).tolist() == [[APPROACH, OUT]]
    match.robots["active"][:, 1] = 1
    watch.look()
    assert not watch.held()[0, 1], "it was out a moment ago"


def test_who_was_put_elsewhere_by_a_whistle_was_not_there_throughout() -> None:
    match = two()
    watch = MotionWindow(match)
    watch.look()
    match.robot_events["returned"][:, 1] = 1
    watch.look()
    assert watch.there().tolist() == [[True, False]]


def test_who_is_sent_off_is_not_free() -> None:
    match = two(2)
    match.robot_events["collision"] = 0
    match.robots["active"][1, 0] = 0
    fate = Fate(match, np.zeros(2, int))
    for _ in range(round(FREE_TIME * match.league.control_rate) + 1):
        free = fate.goes_freely(np.zeros(2, bool))
    assert free.tolist() == [True, False]


def test_a_recovery_that_goes_on_after_a_penalty_is_no_alarm() -> None:
    match = two()
    match.robot_events["collision"] = 0
    seen = Approaches(match)

    def look(times: int = 1) -> None:
        for _ in range(times):
            seen.look(1)

    look(seen.watch.size)
    memory_of(match, 1)["behaviour"] = BACK
    match.robots["active"][:, 1] = 0
    look()
    match.robots["active"][:, 1] = 1
    look()
    assert seen.found["recoveries"].tolist() == [0.0] and seen.causes.sum() == 0.0
    memory_of(match, 0)["behaviour"] = BACK
    look()
    assert seen.found["recoveries"].tolist() == [1.0] and seen.causes.sum() == 1.0


def test_who_is_sent_off_is_not_in_a_crowd() -> None:
    match = two()
    match.robots["x"] = 0.1
    assert count_near_ball(match).tolist() == [2]
    match.robots["active"][:, 1] = 0
    assert count_near_ball(match).tolist() == [1]


@pytest.mark.parametrize(
    ("events", "ends"),
    [
        ({"foul": int(Foul.PUSHING)}, True), ({"restart": int(Phase.DROP_BALL)}, True), ({"separated": 1}, True),
        ({"restart": int(Phase.KICK_OFF), "goal": 0}, False), ({}, False),
    ],
)  # fmt: skip
def test_the_referee_ends_a_contest_but_a_goal_does(events: dict[str, int], ends: bool) -> None:
    match = two()
    next(iter(play(match, 0.1)))  # events of a step in which nothing was called
    for field, value in events.items():
        match.events[field] = value
    assert ended_by_referee(match).tolist() == [ends]


def test_matches_in_which_nobody_is_held_have_no_fate(monkeypatch: pytest.MonkeyPatch) -> None:
    none = stack_moments(two(), [])
    assert len(none) == 0
    monkeypatch.setattr(sampled, "sample_moments", lambda batch: none)
    found = follow_moments(Batch("test", 99, 0), recovery=True)
    assert np.isnan(found["near"]).all() and np.isnan(found["freed"]).all()
