"""What the claims about dribbling count is what happened: lost balls, ways past players, saved shots."""

import numpy as np
import pytest

from soccer_env.baselines.sacks_2001.memory import DRIBBLE
from soccer_env.match.staging import memory_of, set_mass
from soccer_env.train.papers import dribble_runs
from soccer_env.train.papers.claim import Batch
from soccer_env.train.papers.claims import goalkeeper
from soccer_env.train.papers.claims.dribble import dribbling, past
from soccer_env.train.papers.dribble_runs import Contacts
from soccer_env.train.papers.staging import begin_scene, put, put_ball, stage, stage_team

BATCH = Batch("test", 0, 0)


def way(gaps: list[float], step: float = 0.1) -> dribble_runs.DribbleRecord:
    """Return the way of one robot that goes straight on, the ball `gaps` [m] from its chest in each step."""
    gap = np.array(gaps)[:, None]
    x = step * np.arange(len(gaps))[:, None]
    nothing, always = np.zeros_like(x), np.ones_like(x, bool)
    return dribble_runs.DribbleRecord(x, nothing, gap, gap < 0.02, always, ~always, x, nothing, ~always)


def test_a_ball_is_lost_once_until_the_robot_has_it_again() -> None:
    found = dribble_runs.losses(way([0.0, 0.0, dribble_runs.LOST + 0.01, 0.3, 0.3, 0.0, 0.0, 0.2, 0.0]))
    assert found["lost"].tolist() == [2.0]
    assert found["tried"].tolist() == [True] and found["kept"].tolist() == [False]


def test_a_metre_with_the_ball_is_a_metre_kept() -> None:
    found = dribble_runs.losses(way([0.0] * 12))
    assert found["metres"][0] == pytest.approx(1.1) and found["kept"].tolist() == [True]
    assert dribble_runs.losses(way([0.0] * 5))["tried"].tolist() == [False]


def test_a_dribbler_begins_with_its_ball_and_knows_where_it_is() -> None:
    match = stage_team(BATCH, "sacks-2001", dribble_runs.NO_SHOTS, matches=8, keeper=0)
    dribble_runs.place_with_ball(match, heading=np.linspace(-0.5, 0.5, 8))
    begin_scene(match, placed=True)
    dribble_runs.start_dribbling(match)
    own = match.beliefs["own"][:, 0]
    assert (np.hypot(own["x"] - dribble_runs.START, own["y"]) < 0.15).all()
    for _ in range(32):
        match.step()
    assert (memory_of(match)["behaviour"] == DRIBBLE).mean() > 0.8
    assert match.robots["has_ball"][:, 0].all()


def test_the_knee_is_where_losses_reach_half_of_their_greatest_share() -> None:
    lost = np.array([[0.0] * 5 + [0.2, 0.8, 1.0, 1.0, 1.0, 1.0]])
    assert dribbling.half_loss_angle({"lost": lost}) == pytest.approx(52.5)
    assert np.isnan(dribbling.half_loss_angle({"lost": np.zeros_like(lost)}))
    assert dribbling.wide_angle_loss_difference({"lost": lost}) == pytest.approx(100.0)


def test_a_curve_tells_what_deciding_more_often_brings_and_costs() -> None:
    """A parabola in the logarithm of the time is its own curve: 8 points lower at a second than at half a second."""
    shares = 0.8 - 0.08 * np.log2(np.array(past.REPLANS) / 0.5) ** 2
    samples = {"clean": np.tile(shares, (3, 1))}
    assert past.fitted_clean_share(samples, 0.5) - past.fitted_clean_share(samples, 1.0) == pytest.approx(8.0)


def test_a_contact_that_stops_or_turns_somebody_is_told_from_a_touch() -> None:
    match = stage(BATCH, matches=3, senses="ideal")
    put(match, 0, -0.3, 0.0, 0.0)
    put(match, 1, [0.0, 0.9, 0.9], [0.0, 0.0, 0.6], np.pi)
    put_ball(match, -1.0, 0.8)
    begin_scene(match, placed=True)
    set_mass(match, (1,), 1e4, 1e4)  # the one that it meets does not give way
    dribble_runs.start_dribbling(match)
    contacts, actions = Contacts(match), dribbling.walking_actions(match, 0.035, np.zeros(3))
    actions[2] = 0.0
    for _ in range(64):
        match.step(actions)
        contacts.note(match, np.ones(3, bool))
    assert contacts.touched.tolist() == contacts.hindered.tolist() == [True, False, False]


@pytest.mark.slow
def test_shots_at_an_empty_goal_go_in_and_a_goalkeeper_saves_some(monkeypatch: pytest.MonkeyPatch) -> None:
    scored, speed = goalkeeper.face_shots(BATCH, {})
    assert 0.0 < scored.mean() < 0.6 and (speed <= 1.5).all()
    monkeypatch.setattr(goalkeeper, "put", lambda match, r, *_: put(match, r, 1.2, 0.8, 0.0))
    assert goalkeeper.face_shots(BATCH, {})[0].mean() > 0.95
