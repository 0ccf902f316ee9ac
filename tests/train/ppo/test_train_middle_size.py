"""What a training in the middle size leaves plays against the team of 2006 in an evaluation."""

from pathlib import Path

from soccer_env.train.evaluate import EvaluateSettings, evaluate
from tests.train.ppo.staged_training import plainly, tiny


def test_a_policy_that_was_trained_for_a_moment_is_evaluated_against_the_team_of_2006(tmp_path: Path) -> None:
    settings = tiny(
        tmp_path / "run", league="middle-size-2006", players="1v1", steps=64, minutes=0.16, evaluate_minutes=0.16,
        evaluate_every=64, opponents="chaser@0.5",
    )  # fmt: skip
    plainly(settings)
    result = evaluate(
        EvaluateSettings(
            league="middle-size-2006",
            home=str(tmp_path / "run" / "last.safetensors"),
            away="heinemann-2006",
            matches=2,
            minutes=0.1,
            players=2,
            seed=1,
            pose="percept",  # as it was trained
        )  # fmt: skip
    )
    assert len(result.lines) == 2 and {line.goals_for >= 0 for line in result.lines} == {True}
    assert result.conditions.away == "heinemann-2006" and result.conditions.league == "middle-size-2006"


def test_a_policy_that_was_trained_for_ten_minutes_is_evaluated_against_the_team_of_2006() -> None:
    """The file is `best.safetensors` of `soccer train --league middle-size-2006 --players 3v3 --seed 1`."""
    policy = Path(__file__).with_name("ten-minutes-middle-size-2006.safetensors")
    result = evaluate(
        EvaluateSettings(
            league="middle-size-2006",
            home=str(policy),
            away="heinemann-2006",
            matches=4,
            minutes=1.0,
            players=3,
            seed=3,
            pose="particles",
        )
    )
    assert len(result.lines) == 4
    assert result.goals_against >= result.goals_for, "in four minutes it loses by half a goal"
