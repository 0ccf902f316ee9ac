"""Advice: a team that watches says what it would do itself there, by the truth or by the robots' own beliefs."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.agents.learned import first_decision

pytest.importorskip("stable_baselines3")

import torch

from soccer_env.train.ppo.teaching.advice import BEND, KICK_WEIGHT, KNOWN, WALK_WEIGHT, Adviser, advice_error, advised
from soccer_env.train.ppo.teaching.imitation import NO_KICK, record

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
    """The ball lies to the left behind the robot, which has never seen it and turns by its own choice."""
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
    match = Match(
        controllers={"home": "chaser", "away": "still"}, senses="sensors", home=1, away=1, observe="belief", **settings
    )
    for _ in range(first_decision(match.league.delay_steps, 8)):
        match.step()
    done, known = [], []
    while not (match.terminated | match.truncated).all():
        known.append(match.beliefs["ball"]["age"][:, 0] < KNOWN)
        match.step()
        done.append(np.stack([match.robots["command"][:, 0][word] for word in WORDS[:3]], axis=-1))
        for _ in range(7):
            match.step()
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
