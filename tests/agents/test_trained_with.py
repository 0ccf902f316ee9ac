"""A policy knows the senses and rules it was trained with, and says where it meets others; the bundled one as well."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from soccer_env import Match
from soccer_env.agents import rules_known
from soccer_env.agents.learned import BUNDLED, BUNDLED_2006, team_from_policy
from soccer_env.agents.policy_file import dump, load, parse
from soccer_env.agents.rules_known import LOG, recorded, warn_once
from soccer_env.agents.trained_with import training_differences, warn_if_observing_truth
from soccer_env.leagues import find_league
from soccer_env.leagues.league import League
from soccer_env.leagues.rules import rule_set
from soccer_env.teams import Lineup, make_team
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.train.ppo.settings import TrainSettings
from soccer_env.train.ppo.toml_file import settings_of
from tests.agents.staged_policies import random_policy


def test_a_file_keeps_senses_and_pose_and_is_of_the_version_that_knows_them() -> None:
    policy = random_policy(senses="sensors", pose="percept")
    read = parse(dump(policy), "file")
    assert (read.senses, read.pose) == ("sensors", "percept")
    assert b'\\"version\\":5' in dump(policy)
    assert b'\\"version\\":3' in dump(random_policy())
    assert b'\\"version\\":4' in dump(random_policy(squash=True)), "older packages read what they know"


def test_ideal_senses_need_no_pose() -> None:
    assert TrainSettings(senses="ideal").own_senses == {"senses": "ideal", "pose": ""}
    assert TrainSettings(pose="particles").own_senses == {"senses": "sensors", "pose": "particles"}


def test_what_differs_is_told_of_every_policy_of_a_team() -> None:
    policy = random_policy(senses="sensors", pose="percept")
    team = team_from_policy(policy)
    assert training_differences(team, "sensors", "percept") == []
    assert [one[1:] for one in training_differences(team, "sensors", "particles")] == [("pose", "percept", "particles")]
    found = training_differences(team, "ideal", "particles")
    assert [one.setting for one in found] == ["senses"], "no robot has to find itself"
    both = Lineup(["chaser", team])
    assert [one.policy for one in training_differences(both, "sensors", "particles")] == [policy]
    for known in ("learned", "chaser"):
        assert training_differences(make_team(known), "sensors", "particles") == []


def test_a_policy_that_observes_the_truth_is_said_to_need_ideal_senses(caplog: pytest.LogCaptureFixture) -> None:
    warn_once.cache_clear()
    warn_if_observing_truth(replace(random_policy(), name="sees"))
    assert not caplog.records
    for _ in range(2):
        warn_if_observing_truth(random_policy(observe="truth", name="knows"))
    (record,) = caplog.records
    assert record.name == LOG.name and "'knows' observes the truth" in record.message
    assert "--senses ideal" in record.message
    shown = "observe='belief', actions='box': 100 inputs, layers of 32, 4"
    assert repr(random_policy(32)) == f"Policy('lively', 'legged-2001', {shown})"


LEAGUE = find_league("legged-2001")


@pytest.fixture(autouse=True)
def _nothing_told_yet() -> None:
    warn_once.cache_clear()


def under(rules: str) -> League:
    return replace(LEAGUE, rules=rule_set(LEAGUE.rules, rules))


def warnings_of(caplog: pytest.LogCaptureFixture, policy_rules: str, rules: str) -> list[str]:
    """Return what is said where a policy trained under some rules plays two matches under others."""
    team = team_from_policy(replace(random_policy(), rules=recorded(under(policy_rules).rules)))
    for _ in range(2):
        Match(home=1, away=1, seed=1, rules=rules, controllers={"home": team, "away": "still"})
    return [record.message for record in caplog.records if record.name == LOG.name]


def test_other_rules_are_told_once_with_both_names_and_each_rule_that_differs(caplog: pytest.LogCaptureFixture) -> None:
    theirs = "simple:pushing=True,holding_time=5"
    (text,) = warnings_of(caplog, theirs, "simple:illegal_defender=True")
    assert "'lively'" in text and f"rules {theirs!r}" in text and "under 'simple:illegal_defender=True'" in text
    told = text.split(": ")[-1]
    assert told == "pushing (on, off), illegal_defender (off, on), holding_time (5, 3)"


def test_rules_that_came_later_or_went_are_named_and_how_long_a_match_lasts_is_none() -> None:
    assert rules_known.rule_differences(recorded(LEAGUE.rules), replace(LEAGUE.rules, half_minutes=1.0)) == []
    known = {**recorded(LEAGUE.rules), "offside": True}
    del known["pushing"]
    found = rules_known.rule_differences(known, rule_set(LEAGUE.rules, "league:pushing=True"))
    assert found == ["pushing (not there, on)", "offside (on, not there)"]


def test_a_file_without_rules_is_said_to_be_older_than_they_are(caplog: pytest.LogCaptureFixture) -> None:
    team_from_policy(replace(random_policy(), rules={})).check_league(under("simple"))
    (record,) = caplog.records
    assert "does not say under which rules it was trained, and now plays under 'simple'" in record.message
    assert "save_policy or convert_sb3 and rules=..., or give FILE.zip:rules=league" in record.message


LEAST_STEPS = 0.99  # [1] of the steps asked for: a run ends with whole rollouts
# Settings that `learned` was trained with and that there are no more: of imitation, and of other networks.
THEN = {"teacher": "", "teacher_steps": 300_000, "teacher_epochs": 12, "rounds": 0, "ideal_share": 0.0, "kind": "slots"}


@pytest.mark.parametrize("file", [BUNDLED, BUNDLED_2006], ids=lambda path: path.stem)
def test_a_bundled_policy_was_trained_by_its_recipe_by_rewards_alone(file: Path) -> None:
    policy, settings = load(file), settings_of(file.with_suffix(".toml"))
    assert (policy.name, policy.league, policy.observe) == (file.stem, settings.league, "belief")
    then = json.loads(policy.made["settings"])
    assert all(then.pop(name, usual) == usual for name, usual in THEN.items()), "by rewards alone"
    assert then == {name: getattr(settings, name) for name in then} | {"start": Path(settings.start).name}
    assert LEAST_STEPS * settings.steps <= int(policy.made["step"])
    assert file.stat().st_size < 1_000_000 and make_team(file.stem).name == file.stem


@pytest.mark.parametrize(
    ("league", "home", "away", "players", "points"),
    [
        ("middle-size-2006", "learned-2006", "heinemann-2006", 2, 0.7),
        ("legged-2001", "learned", "sacks-2001", 1, 0.6),
    ],
)
def test_the_bundled_teams_beat_the_teams_of_the_papers(
    league: str, home: str, away: str, players: int, points: float
) -> None:
    contest = EvaluateSettings(
        league=league, home=home, away=away, matches=16, minutes=2.0, players=players, seed=11, pose="particles"
    )
    result = evaluate(contest)
    assert result.goal_difference.low > 0.0 and result.points.mean > points


@pytest.mark.parametrize("recipe", sorted(BUNDLED.parent.glob("*.toml")), ids=lambda path: path.stem)
def test_every_bundled_recipe_is_of_settings_that_there_are(recipe: Path) -> None:
    assert settings_of(recipe).name == recipe.stem


def test_a_bundled_setting_is_found_by_its_name_anywhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ("learned-2006", "learned-2006.toml"):
        assert settings_of(Path(name)) == settings_of(BUNDLED_2006.with_suffix(".toml"))
    Path("learned-2006").write_text("steps = 5000\n", encoding="utf-8")  # a file of one's own comes first
    assert settings_of(Path("learned-2006")).steps == 5000
    with pytest.raises(ValueError, match=r"nobody\.toml cannot be read"):
        settings_of(Path("nobody.toml"))
