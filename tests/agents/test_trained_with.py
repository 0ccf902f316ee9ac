"""A policy knows the senses it was trained with: in its file, in what its run left, and where it meets others."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from soccer_env.agents.learned import BUNDLED, team_of
from soccer_env.agents.policy_file import dump, load, parse
from soccer_env.agents.rules_known import LOG, warn_once
from soccer_env.agents.trained_with import differences, senses_of_run, tell_of_truth, trained_with
from soccer_env.teams import Lineup, make_team
from tests.agents.staged_files import TABLE, refused, with_fields
from tests.agents.staged_policies import lively

UNKNOWN = {"senses": "", "pose": ""}


def test_a_file_keeps_senses_and_pose_and_is_of_the_version_that_knows_them() -> None:
    policy = lively(senses="sensors", pose="percept")
    read = parse(dump(policy), "file")
    assert trained_with(read) == {"senses": "sensors", "pose": "percept"}
    assert b'\\"version\\":5' in dump(policy)
    assert b'\\"version\\":3' in dump(lively()) and trained_with(lively()) == UNKNOWN
    assert b'\\"version\\":4' in dump(lively(squash=True)), "older packages read what they know"


def test_another_word_is_refused() -> None:
    fields = {**TABLE, "squash": False, "at_once": False, "normalise": {}, "version": 5}
    refused(with_fields(**fields, senses="sensors", pose="compass"), "pose must be one of")
    refused(with_fields(**fields, senses="eyes", pose=""), "senses must be one of")
    refused(with_fields(**{**fields, "version": 4}, pose=""), "unknown key 'pose' for version 4")


def test_what_a_run_left_says_it_for_files_that_are_older() -> None:
    assert trained_with(load(BUNDLED)) == {"senses": "", "pose": "particles"}, "a tenth of its matches had ideal senses"
    settings = json.dumps({"senses": "sensors", "ideal_share": 0.0, "pose": "percept"})
    assert trained_with(lively(made={"settings": settings})) == {"senses": "sensors", "pose": "percept"}
    for nonsense in ("", "[" * 100_000, "[]", '{"pose": 7, "senses": ["x"]}', '{"ideal_share": "much"}'):
        assert trained_with(lively(made={"settings": nonsense[:2000]})) == UNKNOWN


def test_who_is_told_the_truth_needs_no_pose() -> None:
    assert senses_of_run({"senses": "ideal", "pose": "percept"}) == {"senses": "ideal", "pose": ""}
    assert senses_of_run({"senses": "sensors", "ideal_share": 1.0, "pose": "percept"})["senses"] == "ideal"


def test_what_differs_is_told_of_every_policy_of_a_team() -> None:
    policy = lively(senses="sensors", pose="percept")
    team = team_of(policy)
    assert differences(team, "sensors", "percept") == []
    assert [one[1:] for one in differences(team, "sensors", "particles")] == [("pose", "percept", "particles")]
    assert [one.setting for one in differences(team, "ideal", "particles")] == ["senses"], "no robot has to find itself"
    both = Lineup(["chaser", team])
    assert [one.policy for one in differences(both, "sensors", "particles")] == [policy]
    for known in ("learned", "chaser"):
        assert differences(make_team(known), "sensors", "particles") == []


def test_a_policy_that_observes_the_truth_is_said_to_need_ideal_senses(caplog: pytest.LogCaptureFixture) -> None:
    warn_once.cache_clear()
    tell_of_truth(replace(lively(), name="sees"))
    assert not caplog.records
    for _ in range(2):
        tell_of_truth(lively(observe="truth", name="knows"))
    (record,) = caplog.records
    assert record.name == LOG.name and "'knows' observes the truth" in record.message
    assert "--senses ideal" in record.message


def test_a_policy_is_shown_by_what_it_is(tmp_path: Path) -> None:
    shown = repr(lively(32))
    assert shown == (
        "Policy('lively', 'legged-2001', observe='belief', actions='box': slots of 93 inputs, layers of 32, 4)"
    )
