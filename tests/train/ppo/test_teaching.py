"""What an actor begins with: weights of a file, or rounds of a team's advice, among which a run may be cut as well."""

from hashlib import sha256
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from soccer_env.agents.policy_file import load
from soccer_env.leagues import find_league
from soccer_env.observations import entry_names
from tests.agents.staged_policies import decide, random_attention_policy, random_policy
from tests.scenes.staging import play

pytest.importorskip("stable_baselines3")


import torch

from soccer_env import Match
from soccer_env.agents.learned import first_decision_step
from soccer_env.train.ppo.checkpoints import read_checkpoint
from soccer_env.train.ppo.networks import widened_policy
from soccer_env.train.ppo.reports import best_evaluation_sentence, decisions_of
from soccer_env.train.ppo.teaching import lessons
from soccer_env.train.ppo.teaching.advice import BEND, KICK_WEIGHT, KNOWN, WALK_WEIGHT, Adviser, advice_error, advised
from soccer_env.train.ppo.teaching.imitation import NO_KICK, record
from soccer_env.train.ppo.teaching.lessons import KeptRounds
from soccer_env.train.ppo.training import Training
from tests.train.ppo.staged_training import (
    ROLLOUT,
    as_plain_values,
    outcome,
    records,
    tiny_settings,
    train_plainly,
    weights,
    whole_run,
)

ADVISED: dict[str, Any] = {"rounds": 3, "steps": 4 * ROLLOUT}


@pytest.mark.parametrize("change", [{}, {"kind": "attention", "mirror": False}])
def test_an_actor_may_begin_with_the_weights_of_a_policy_file(tmp_path: Path, change: dict[str, Any]) -> None:
    """As long as the critic learns alone they stay what they are in the file, a teacher or not."""
    train_plainly(tiny_settings(tmp_path / "first", steps=3 * ROLLOUT, past=0, **change))
    first = tmp_path / "first" / "last.safetensors"
    train_plainly(tiny_settings(tmp_path / "next", steps=2 * ROLLOUT, past=0, start=str(first), seed=4, **change))
    assert weights(tmp_path / "next" / "last.safetensors") == weights(first)
    made = load(tmp_path / "next" / "last.safetensors").made
    assert str(tmp_path) not in str(made) and made["start"] == sha256(first.read_bytes()).hexdigest()


def test_a_run_may_go_on_with_actor_critic_and_noise_of_another_run(tmp_path: Path) -> None:
    """Of other team sizes: the critic has room for five a side. Nothing is learned in a run of no steps."""
    train_plainly(tiny_settings(tmp_path / "first", steps=ROLLOUT, past=0, critic_first=0, players="1v1", teacher=""))
    changes = {"past": 0, "start": str(tmp_path / "first"), "seed": 4, "players": "2v2", "noise": 0.9}
    train_plainly(tiny_settings(tmp_path / "next", steps=0, **changes))
    one, other = (read_checkpoint(tmp_path / name) for name in ("first", "next"))
    assert one is not None and other is not None
    assert as_plain_values(one["network"]) == as_plain_values(other["network"])
    assert float(other["network"]["log_std"].exp().mean()) < 0.7
    with pytest.raises(ValueError, match=r"start: .* has hidden layers of 8, the run 9"):
        train_plainly(tiny_settings(tmp_path / "wide", steps=0, hidden="9", **changes))
    with pytest.raises(ValueError, match="start: the networks of the run in .* are not those of this run"):
        train_plainly(tiny_settings(tmp_path / "wise", steps=0, critic="9", **changes))


CLOCKS = ("own_pushing", "own_holding", "own_penalty", "ball_still")


@pytest.mark.parametrize("make", [random_policy, random_attention_policy])
def test_an_actor_of_fewer_inputs_begins_as_it_was_and_sees_the_new_ones_with_weight_0(make: Any) -> None:
    names = tuple(entry_names(find_league("legged-2001"), "belief"))
    old = make(16, mirror=True, inputs=tuple(name for name in names if name not in CLOCKS))
    new = widened_policy(old, names)
    rows = np.random.default_rng(2).uniform(-1.0, 1.0, (50, len(names))).astype(np.float32)
    read = [names.index(name) for name in old.inputs]
    assert new.inputs == names and (decide(new, rows) == decide(old, rows[:, read])).all()
    assert widened_policy(new, names).inputs == names
    with pytest.raises(ValueError, match="policy 'lively' reads the entry 'own_x', which is not observed"):
        widened_policy(old, names[1:])


def test_it_is_judged_after_every_round_and_the_rounds_are_gone_at_the_end(tmp_path: Path) -> None:
    result = train_plainly(tiny_settings(tmp_path / "run", rounds=3, steps=0))
    assert result.steps == 0 and not (tmp_path / "run" / "rounds").exists()
    found = records(tmp_path / "run" / "evaluations.jsonl")
    advised = [one["advised"] for one in found]
    assert [one["step"] for one in found] == [0, 0, 0] and advised == sorted({*advised}) and advised[0] > 0
    assert decisions_of(found) == advised
    assert decisions_of([*found, {"step": 48, "advised": 0}])[-1] == advised[-1] + 48, "rewards come after advice"
    assert any(f"after {count:,} decisions" in best_evaluation_sentence(result) for count in advised)


@pytest.mark.parametrize("where", ["playing", "fitting", "judging", "keeping"])
@pytest.mark.parametrize("count", [1, 2])
def test_a_run_that_is_cut_among_its_rounds_goes_on_as_if_it_had_not_been(
    tmp_path: Path, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch, where: str, count: int
) -> None:
    owner, name = {
        "playing": (lessons.Lessons, "_round"), "fitting": (lessons.Lessons, "_fit_advice"),
        "judging": (Training, "evaluate"), "keeping": (KeptRounds, "keep"),
    }[where]  # fmt: skip
    done, left = getattr(owner, name), [count]

    def cut(*given: Any, **named: Any) -> Any:
        left[0] -= 1
        if left[0] == 0:
            raise KeyboardInterrupt
        return done(*given, **named)

    whole = outcome(whole_run(tmp_path_factory, **ADVISED))
    with monkeypatch.context() as patched:
        patched.setattr(owner, name, cut)
        with pytest.raises(KeyboardInterrupt):
            train_plainly(tiny_settings(tmp_path / "cut", **ADVISED))
    played: list[int] = []

    def counted(self: lessons.Lessons, number: int, progress: Any) -> Any:
        played.append(number)
        return round_of(self, number, progress)

    round_of = lessons.Lessons._round
    monkeypatch.setattr(lessons.Lessons, "_round", counted)
    train_plainly(tiny_settings(tmp_path / "cut", **ADVISED))
    assert outcome(tmp_path / "cut") == whole
    assert played == list(range(count - 1, 3)), "what was kept is not played again"


def test_a_damaged_round_is_refused_and_left_alone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(KeptRounds, "forget", lambda self: None)
    monkeypatch.setattr(Training, "save_checkpoint", lambda self: None)
    settings = tiny_settings(tmp_path / "run", rounds=2, steps=0)
    train_plainly(settings)
    path = tmp_path / "run" / "rounds" / "round-001.npz"
    torn = path.read_bytes()[:-100]
    path.write_bytes(torn)
    with pytest.raises(ValueError, match=r"round-001.npz is damaged \(.*\); --anew starts again"):
        train_plainly(settings)
    assert path.read_bytes() == torn
    train_plainly(tiny_settings(tmp_path / "run", rounds=2, steps=0, anew=True))


def test_what_is_kept_of_rounds_is_what_was_given(tmp_path: Path) -> None:
    import torch

    network, other = torch.nn.Linear(3, 2), torch.nn.Linear(3, 2)
    kept = KeptRounds(tmp_path)
    assert kept.restore(other) == []
    rows = [(np.full((n, 3), n, np.float32), np.full((n, 4), -n, np.float32)) for n in (1, 2)]
    for number, one in enumerate(rows):
        kept.keep(number, one, network)
    for one, found in zip(rows, kept.restore(other), strict=True):
        assert all(np.array_equal(*pair) for pair in zip(one, found, strict=True))
    assert torch.equal(network.weight, other.weight) and torch.equal(network.bias, other.bias)
    kept.forget()
    assert kept.restore(other) == []


SETTINGS: dict[str, Any] = {"matches": 3, "seed": 2, "minutes": 0.2}
TEAMS: dict[str, Any] = {"home": 2, "away": 1, "observe": "belief"}
WORDS = ("forward", "left", "turn", "kick")


def watched(senses: Any, player: str = "chaser") -> Match:
    """Return matches of two players against a chaser."""
    return Match(controllers={"home": player, "away": "chaser"}, senses=senses, **TEAMS, **SETTINGS)


@pytest.mark.parametrize("team", ["chaser", "sacks-2001"])
@pytest.mark.parametrize("senses", ["sensors", "ideal"])
def test_of_a_match_that_the_team_plays_itself_it_says_what_is_done(senses: str, team: str) -> None:
    match = watched({"home": senses, "away": "sensors"}, team)
    adviser = Adviser(team, senses, **TEAMS, **SETTINGS)
    for _ in range(60):
        advice = adviser.commands(match)
        match.step()
        done = match.robots["command"][:, :2]
        assert np.array_equal(advice, np.stack([done[word] for word in WORDS], axis=-1))


def test_by_the_truth_it_goes_to_a_ball_that_the_robot_does_not_see() -> None:
    match = watched("sensors")
    adviser = Adviser("chaser", "ideal", **TEAMS, **SETTINGS)
    match.robots["heading"][:, 1] = 0.0
    for side in (1.0, -1.0):
        match.balls["x"] = match.robots["x"][:, 1] - 0.2
        match.balls["y"] = match.robots["y"][:, 1] + side * 0.6
        assert (side * adviser.commands(match)[:, 1, 2] > 0.0).all()


def test_with_ideal_senses_advice_is_what_the_teacher_does_itself() -> None:
    settings = {**SETTINGS, "senses": "ideal"}
    observations, advice = advised("chaser", "chaser", "still", (2, 1), 8, **settings)
    decisions = len(advice) // (2 * SETTINGS["matches"])
    seen, done = record("chaser", "still", (2, 1), decisions, 8, observe="belief", **settings)
    assert len(advice) == len(done) and np.array_equal(observations, seen)
    assert np.allclose(advice, done) and (advice[:, 3] > NO_KICK).any()


def test_a_ball_unseen_for_long_is_searched_for_as_beliefs_say() -> None:
    """What is asked there is what the player, the same team, does itself."""
    settings = {**SETTINGS, "minutes": 0.3, "scene": "lost-ball-behind", "episode": "match"}
    sides = {"home": "chaser", "away": "still"}
    match = Match(controllers=sides, senses="sensors", home=1, away=1, observe="belief", **settings)
    play(match, steps=first_decision_step(match.league.delay_steps, 8))
    done, known = [], []
    while not (match.terminated | match.truncated).all():
        known.append(match.beliefs["ball"]["age"][:, 0] < KNOWN)
        match.step()
        done.append(np.stack([match.robots["command"][:, 0][word] for word in WORDS[:3]], axis=-1))
        play(match, steps=7)
    _, advice = advised("chaser", "chaser", "still", (1, 1), 8, senses="sensors", **settings)
    unknown = ~np.concatenate(known)
    assert 0.0 < unknown.mean() < 1.0 and len(advice) == len(unknown)
    differs = (advice[:, :3] != np.concatenate(done).astype(np.float32)).any(axis=1)
    assert not differs[unknown].any() and differs[~unknown].mean() > 0.3


def test_errors_of_walks_count_by_size_and_those_of_kicks_by_the_square() -> None:
    asked = torch.tensor([[0.0, 0.0, 0.0, NO_KICK], [0.0, 0.0, 0.0, 1.0]])
    assert float(advice_error(asked, asked)) == 0.0
    walks = asked + torch.tensor([1.0, 0.0, 0.0, 0.0])
    assert float(advice_error(walks, asked)) == pytest.approx(WALK_WEIGHT * BEND * (1.0 - 0.5 * BEND) / 3.0)
    kicks = asked + torch.tensor([[0.0, 0.0, 0.0, 0.5], [0.0, 0.0, 0.0, 0.0]])
    missed = asked - torch.tensor([[0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.5]])
    assert float(advice_error(missed, asked)) == pytest.approx(KICK_WEIGHT * float(advice_error(kicks, asked)))
