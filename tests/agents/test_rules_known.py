"""A policy knows the rules it was trained under, and whoever lets it play under others is told so once."""

from dataclasses import replace
from pathlib import Path

import pytest

from soccer_env import Match
from soccer_env.agents.learned import team_of
from soccer_env.agents.policy_file import dump, parse
from soccer_env.agents.rules_known import LOG, differences, recorded, warn_once
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.leagues.rules import SWITCHES, rule_set
from soccer_env.train.command.command_line import main
from tests.agents.staged_policies import from_disk, lively

LEAGUE = find_league("legged-2001")


@pytest.fixture(autouse=True)
def _nothing_told_yet() -> None:
    warn_once.cache_clear()


def under(rules: str) -> League:
    """Return the legged league with a rule set."""
    return replace(LEAGUE, rules=rule_set(LEAGUE.rules, rules))


def warnings_of(caplog: pytest.LogCaptureFixture, policy_rules: str, rules: str) -> list[str]:
    """Return what is said where a policy trained under some rules plays two matches under others."""
    team = team_of(replace(lively(), rules=recorded(under(policy_rules).rules)))
    for _ in range(2):
        Match(home=1, away=1, seed=1, rules=rules, controllers={"home": team, "away": "still"})
    return [record.message for record in caplog.records if record.name == LOG.name]


def test_under_its_own_rules_nothing_is_said(caplog: pytest.LogCaptureFixture) -> None:
    assert warnings_of(caplog, "league", "league") == []


def test_other_rules_are_told_once_with_both_names_and_each_rule_that_differs(caplog: pytest.LogCaptureFixture) -> None:
    theirs = "simple:pushing=True,holding_time=5"
    (text,) = warnings_of(caplog, theirs, "simple:illegal_defender=True")
    assert "'lively'" in text and f"rules {theirs!r}" in text and "under 'simple:illegal_defender=True'" in text
    told = text.split(": ")[-1]
    assert told == "pushing (on, off), illegal_defender (off, on), holding_time (5, 3)"


def test_another_name_of_the_same_rules_is_no_difference(caplog: pytest.LogCaptureFixture) -> None:
    assert warnings_of(caplog, "league:pushing=True", "league:pushing=True,holding_time=3") == []


def test_how_long_a_match_lasts_is_no_rule() -> None:
    assert differences(recorded(LEAGUE.rules), replace(LEAGUE.rules, half_minutes=1.0)) == []


def test_rules_that_came_later_or_went_are_named() -> None:
    known = {**recorded(LEAGUE.rules), "offside": True}
    del known["pushing"]
    assert differences(known, rule_set(LEAGUE.rules, "league:pushing=True")) == [
        "pushing (not there, on)",
        "offside (on, not there)",
    ]


def test_a_file_without_rules_is_said_to_be_older_than_they_are(caplog: pytest.LogCaptureFixture) -> None:
    team_of(replace(lively(), rules={})).check_league(under("simple"))
    (record,) = caplog.records
    assert "does not say under which rules it was trained, and now plays under 'simple'" in record.message
    assert "save_policy or convert_sb3 and rules=..., or give FILE.zip:rules=league" in record.message


def test_a_file_keeps_every_switch_and_number(tmp_path: Path) -> None:
    policy = replace(lively(), rules=recorded(under("simple:pushing=True,pushing_time=4.5").rules))
    read = parse(dump(policy), "file")
    assert read.rules == policy.rules == from_disk(policy, tmp_path).policy.rules
    assert read.rules["name"] == "simple:pushing=True,pushing_time=4.5" and read.rules["pushing_time"] == 4.5
    assert set(SWITCHES) <= set(read.rules) and differences(read.rules, under("simple").rules)


def test_unknown_rules_say_what_exists(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    out = tmp_path / "run"
    assert main(["train", "--rules", "leage", "--out", str(out)]) == 2
    assert "did you mean 'league'" in capsys.readouterr().err
    assert main(["train", "--rules", "league:pushin=True", "--out", str(out)]) == 2
    told = capsys.readouterr().err
    assert "'pushin'" in told and "pushing" in told and "`soccer list rules` names all" in told
    assert not out.exists()
