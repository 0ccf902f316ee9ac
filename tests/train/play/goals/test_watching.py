"""Goals of played matches: each is kept once, classed as the statistics count it, with what was called before it."""

import json
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from soccer_env import Match, staging
from soccer_env.statistics.records import GoalKind
from soccer_env.train.play.goals import watching
from soccer_env.train.play.goals.settings import GoalSettings
from soccer_env.train.play.goals.table import TEXTS, counts_of, goals_table, write
from soccer_env.train.play.goals.watching import Call, SeenGoals, Watcher, calls_of, in_words, watch
from soccer_env.types import AWAY, HOME, NO_TEAM, Foul, Phase

EASY = GoalSettings(home="chaser", away="still", players=1, goals=3, minutes=1.0, matches=6, seed=2, senses="ideal")


def rolling(direction: float = 1.0, matches: int = 1) -> Match:
    """Return matches in which the ball rolls into a goal half a second later, past two robots that stand."""
    match = Match(
        "legged-2001", home=1, away=1, matches=matches, keeper=0, seed=1,
        controllers={"home": "still", "away": "still"},
    )  # fmt: skip
    staging.set_phase(match, Phase.PLAY)
    staging.put(match, 0, 0.0, 0.8)
    staging.put(match, 1, 0.0, -0.8)
    staging.put_ball(match, direction * 1.1, 0.0, direction, 0.0)
    staging.begin(match)
    return match


def look_on(match: Match, watcher: Watcher, steps: int) -> None:
    """Play on and look after every step."""
    for _ in range(steps):
        match.step(None)
        watcher.look()


@pytest.mark.parametrize(("direction", "team"), [(1.0, HOME), (-1.0, AWAY)])
def test_a_goal_is_seen_once_with_the_ball_in_the_goal_last(direction: float, team: int) -> None:
    match = rolling(direction, matches=2)
    watcher = Watcher(match, first=30)
    look_on(match, watcher, 16)
    assert [goal.match for goal in watcher.goals] == [30, 31]
    goal = watcher.goals[0]
    assert (goal.team, goal.direction) == (team, int(direction))
    ahead = direction * np.array([float(ball["x"]) for _, ball, _ in goal.moments])
    assert (np.diff(ahead) > 0.0).all()
    line = match.league.pitch.length / 2
    assert ahead[-2] <= line + match.league.ball.radius < ahead[-1]
    assert len(goal.moments) == 1 + round(goal.seconds * match.league.control_rate)  # from the very beginning


def test_goals_are_classed_as_the_statistics_of_their_match_count_them() -> None:
    match = Match("legged-2001", home=1, away=1, minutes=2.0, matches=2, seed=3,
                  senses="ideal", controllers={"home": "chaser", "away": "still"})  # fmt: skip
    watcher = Watcher(match, 0)
    while not match.terminated.all():
        look_on(match, watcher, 1)
    assert len(watcher.goals) >= 4
    counted = match.statistics
    for team in (HOME, AWAY):
        kinds = Counter(goal.kind for goal in watcher.goals if goal.team == team)
        assert [kinds[kind] for kind in GoalKind] == counted["goals"][:, team].sum(axis=0).tolist()
        names = Counter(name for goal in watcher.goals if goal.team == team for name, yes in goal.before.items() if yes)
        assert names["goals_solo"] == counted["solo"][:, team].sum()
        assert names["goals_after_kick_off"] == counted["after_restart"][:, team, Phase.KICK_OFF].sum()
        assert names["goals_after_separation"] == counted["after_separation"][:, team].sum()
        assert names["goals_after_pushed_keeper"] == counted["after_pushed_keeper"][:, team].sum()
    assert {name for goal in watcher.goals for name in goal.before} <= set(TEXTS)


def test_calls_of_the_ten_seconds_before_a_goal_are_kept_and_no_earlier_ones() -> None:
    match = rolling()
    rate = round(match.league.control_rate)
    staging.put_ball(match, 0.0, 0.0)
    staging.begin(match)
    watcher = Watcher(match, 0)
    for foul in (Foul.HOLDING, Foul.PUSHING):
        look_on(match, watcher, rate)
        match.robot_events["foul"][0, 1] = match.events["foul"][0] = foul
        watcher.look()
    look_on(match, watcher, round(9.4 * rate))
    staging.put_ball(match, 1.4, 0.0, 1.0, 0.0)
    staging.begin(match)
    look_on(match, watcher, rate)
    (goal,) = watcher.goals
    assert [words for _, words in goal.calls] == ["away: pushing"]
    assert 9.4 < goal.calls[0][0] <= 10.0


def test_each_call_has_its_words() -> None:
    match = rolling()
    match.events["foul"], match.events["foul_team"] = Foul.GAME_STUCK, HOME
    match.events["restart"], match.events["restart_team"] = Phase.THROW_IN, AWAY
    match.events["separated"] = match.events["annulled"] = 1
    said = [in_words(call) for call in calls_of(match, 0)]
    assert said == ["home: game stuck", "goal annulled", "separation", "away: throw in"]
    match.robot_events["foul"][0] = Foul.CHARGING, Foul.PUSHING
    match.events["restart"], match.events["restart_team"] = Phase.DROP_BALL, NO_TEAM
    said = [in_words(call) for call in calls_of(match, 0)]
    assert said == ["home: charging", "away: pushing", "goal annulled", "separation", "dropped ball"]
    assert next(calls_of(match, 0)) == Call(0, "fouls_charging", HOME)


def test_matches_are_played_until_enough_goals_have_fallen_however_many_at_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(watching, "BLOCK", 2)
    two = watch(EASY)
    monkeypatch.setattr(watching, "BLOCK", 6)
    six = watch(EASY)
    assert [goal.as_dict() for goal in two.goals] == [goal.as_dict() for goal in six.goals]
    assert len(two.goals) == 3 <= two.fallen <= six.fallen
    assert two.matches < six.matches == 6
    assert [(goal.match, goal.seconds) for goal in two.goals] == sorted(
        (goal.match, goal.seconds) for goal in two.goals
    )


def test_nobody_scores_and_all_matches_are_played() -> None:
    seen = watch(GoalSettings(home="still", away="still", players=1, matches=3, minutes=0.1))
    assert (seen.goals, seen.fallen, seen.matches) == ([], 0, 3)
    assert goals_table(seen, EASY).row_count == len(GoalKind)


def test_the_table_counts_every_goal_once_in_its_kind_and_the_file_has_a_line_each(tmp_path: Path) -> None:
    seen = watch(EASY)
    counts = counts_of(seen)
    assert sum(counts[f"goals_{kind.name.lower()}"] for kind in GoalKind) == len(seen.goals) == 3
    assert counts["scored by home"] == 3
    assert goals_table(seen, EASY).row_count == len(counts)
    called = SeenGoals(seen.league, [seen.goals[0]], 1, 1)
    object.__setattr__(called.goals[0], "calls", ((2.0, "away: pushing"), (1.0, "away: pushing")))
    assert counts_of(called)["10 s before: away: pushing"] == 1
    write(seen, tmp_path / "new")
    lines = [json.loads(line) for line in (tmp_path / "new" / "goals.jsonl").read_text().splitlines()]
    assert [line["kind"] for line in lines] == [goal.kind.name.lower() for goal in seen.goals]
    assert {line["team"] for line in lines} == {"home"}


@pytest.mark.parametrize("wrong", [{"matches": 0}, {"minutes": 0.0}, {"goals": 0}, {"sheets": -1}, {"players": 12}])
def test_wrong_settings_are_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(ValueError, match=f"{next(iter(wrong))} must be"):
        GoalSettings(**wrong)  # type: ignore[arg-type]
