"""Promises of the whole chain of senses: nothing hidden is seen, no belief reads the truth, noise is reproducible."""

import pkgutil
from importlib import import_module

import numpy as np
import pytest

import soccer_env
from soccer_env import Match, baselines, belief, leagues, perception
from tests.senses.staged_senses import LEAGUES, random_actions, sensing_matches

HIDDEN = {"legged-2001": "scale", "middle-size-2006": "table"}  # what each camera remembers and does not deliver


def finite(records: np.ndarray) -> bool:
    """Tell whether every number of records is finite; ages may be infinite."""
    if records.dtype.names:
        names = set(records.dtype.names) - {"age", "seconds_left", "heard"}
        return all(finite(records[name]) for name in names)
    return records.dtype.kind != "f" or bool(np.isfinite(records).all())


@pytest.mark.parametrize("pose", ["percept", "particles"])
@pytest.mark.parametrize("league", LEAGUES)
def test_a_belief_never_reads_the_truth(league: str, pose: str) -> None:
    match, other = (sensing_matches(league, pose=pose) for _ in range(2))
    actions = random_actions(match, 60)
    for step in range(60):
        match.step(actions[step])
        batch, senses = other.batch, other.batch.senses
        look, senses.believe = senses.believe, lambda first, last: None  # type: ignore[method-assign]
        batch.observe = lambda first, last: None  # type: ignore[method-assign]
        other.step(actions[step])
        truth = [array.copy() for array in (batch.matches, batch.balls, batch.robots)]
        hidden = senses.sensor_states, senses.pending
        remembered = [array.copy() for array in hidden]
        for array in (batch.matches, batch.balls, batch.robots, *hidden):
            make_nonsense(array)
        look(0, other.count)
        noise, gaze = batch.robots["noise"].copy(), batch.robots["gaze"].copy()
        for array, kept in zip((batch.matches, batch.balls, batch.robots, *hidden), truth + remembered, strict=True):
            array[:] = kept
        batch.robots["noise"], batch.robots["gaze"] = noise, gaze
        del senses.believe, batch.observe
    assert other.beliefs.tobytes() == match.beliefs.tobytes()
    assert other.tracks.tobytes() == match.tracks.tobytes() and other.state_hash() == match.state_hash()


def make_nonsense(records: np.ndarray) -> None:
    """Put NaN and 77 into all numbers of records, but for the robots' own noise streams and gazes."""
    for name in records.dtype.names or ():
        if name in ("noise", "gaze"):
            continue
        if records[name].dtype.names:
            make_nonsense(records[name])
        else:
            records[name] = np.nan if records[name].dtype.kind == "f" else 77


@pytest.mark.parametrize("league", LEAGUES)
def test_what_sensors_remember_is_told_to_nobody(league: str) -> None:
    """The error of the noisy pose, the scale of sizes, the colour table: who knew one of them could take it out."""
    changing = {"light_drift": 0.5, "light_period": 10.0} if league == LEAGUES[1] else {}
    match = sensing_matches(league, sensors=changing)
    for actions in random_actions(match, 40):
        match.step(actions)
    senses = match.batch.senses
    hidden = leaves(senses.sensor_states)
    assert set(hidden) == {f"pose_error.{name}" for name in ("x", "y", "heading")} | {HIDDEN[league]}
    for array in (senses.percepts, senses.beliefs, senses.tracks, senses.memories, senses.messages):
        told = {name: values for name, values in leaves(array).items() if values.dtype.kind == "f"}
        for name, values in told.items():
            for secret, remembered in hidden.items():
                assert not np.isin(remembered, values).any(), f"{name} holds {secret}"


def leaves(records: np.ndarray, name: str = "") -> dict[str, np.ndarray]:
    """Return the numbers of records by the names of their fields, joined by dots."""
    if not records.dtype.names:
        return {name: records}
    parts = {field: leaves(records[field], f"{name}.{field}" if name else field) for field in records.dtype.names}
    return {path: values for found in parts.values() for path, values in found.items()}


@pytest.mark.parametrize("league", LEAGUES)
def test_play_is_the_same_whatever_robots_sense(league: str) -> None:
    plays = []
    for settings in ({"observe": "truth"}, {"observe": "percepts"}, {"observe": "belief", "pose": "particles"}):
        match = sensing_matches(league, **settings)
        for actions in random_actions(match, 100):
            match.step(actions)
        plays.append(np.concatenate([match.robots[name].ravel() for name in ("x", "y", "heading", "vx", "omega")]))
        plays[-1] = np.append(plays[-1], match.balls["x"])
    assert plays[0].tobytes() == plays[1].tobytes() == plays[2].tobytes()


@pytest.mark.parametrize("league", LEAGUES)
def test_one_match_alone_senses_what_it_senses_among_many_and_an_episode_begins_with_nothing_remembered(league) -> None:
    many = sensing_matches(league, matches=8, pose="particles", threads=2)
    alone = sensing_matches(league, matches=1, pose="particles", seed=None, seeds=many.seeds[5:6])
    for actions in random_actions(many, 150):
        many.step(actions)
        alone.step(actions[5:6])
    assert alone.state_hash(0) == many.state_hash(5)
    assert alone.percepts.tobytes() == many.percepts[5:6].tobytes()
    assert alone.observations.tobytes() == many.observations[5:6].tobytes()
    used, fresh = sensing_matches(league, pose="particles"), sensing_matches(league, pose="particles", seed=42)
    for actions in random_actions(used, 40):
        used.step(actions)
    used.reset(seed=42)
    assert used.state_hash() == fresh.state_hash(), "beliefs, memories, particles and messages are part of the state"


@pytest.mark.parametrize("league", LEAGUES)
def test_a_crowd_in_one_place_or_one_bearing_breaks_nothing_nor_does_a_robot_that_sees_nothing_for_minutes(league):
    match = sensing_matches(league, matches=2, home=11, away=11, pose="particles")
    match.robots["y"], match.robots["heading"][1], match.balls["x"], match.balls["y"] = 0.0, 0.0, 0.3, 0.0
    for x in (0.3, np.linspace(-1.0, 1.0, 22)):  # the ball inside all of them; then all in one bearing
        match.robots["x"] = x
        for _ in range(30):
            match.batch.senses.step(0, match.count)
            assert finite(match.beliefs) and finite(match.tracks) and finite(match.percepts)
    names = ("ball_miss", "player_miss") if league == LEAGUES[1] else ("ball_miss", "player_miss", "landmark_miss")
    blind = dict.fromkeys(names, 1.0) | ({"line_miss": 1.0, "goal_miss": 1.0} if league == LEAGUES[1] else {})
    match = sensing_matches(league, matches=1, home=1, away=1, pose="particles", sensors=blind, minutes=10.0)
    for actions in random_actions(match, 3 * 60 * match.league.control_rate // 4):
        match.step(actions)
    assert finite(match.beliefs) and finite(match.tracks) and np.isfinite(match.observations).all()
    assert np.abs(match.observations).max() <= 1.0


@pytest.mark.parametrize("observe", ["percepts", "belief"])
@pytest.mark.parametrize("league", LEAGUES)
def test_observations_stay_in_their_box_at_every_team_size(league: str, observe: str) -> None:
    for home, away in ((1, 1), (2, 5), (11, 11)):
        match = sensing_matches(league, matches=2, home=home, away=away, observe=observe)
        for actions in random_actions(match, 60):
            match.step(actions)
            assert np.abs(match.observations).max() <= 1.0
        assert match.observations.shape[2] == len(match.observation_names) == len(set(match.observation_names))


@pytest.mark.parametrize("name", ["beliefs", "percepts"])
def test_beliefs_that_nobody_uses_are_not_made_up(name: str) -> None:
    with pytest.raises(ValueError, match="nobody in this match uses its sensors"):
        getattr(Match("legged-2001", seed=1), name)
    assert Match("legged-2001", seed=1, senses="ideal").beliefs["ball"]["confidence"].min() == 100.0


def test_each_team_has_its_own_senses_and_looking_at_beliefs_is_no_part_of_the_state() -> None:
    """Rows with ideal senses are filled when somebody reads them, whoever that is."""
    teams = {"home": "chaser", "away": "chaser"}
    match = Match("legged-2001", seed=1, controllers=teams, senses={"home": "ideal", "away": "sensors"}, minutes=0.2)
    while not match.terminated.all():
        match.step()
    true = np.hypot(match.balls["x"] - match.robots["x"][0], match.balls["y"] - match.robots["y"][0])
    assert match.beliefs["ball"]["distance"][0, :3] == pytest.approx(true[:3], abs=1e-9)
    assert (abs(match.beliefs["ball"]["distance"][0, 3:] - true[3:]) > 1e-6).all()
    teams = {"home": "chaser", "away": "chaser"}
    senses = {"home": "ideal", "away": "sensors"}
    looked, left = (Match("legged-2001", seed=1, controllers=teams, senses=senses) for _ in range(2))
    for _ in range(20):
        looked.step()
        left.step()
        assert looked.beliefs["ball"]["confidence"][0, 0] == 100.0
        assert looked.state_hash() == left.state_hash()
    assert looked.save() == left.save()


@pytest.mark.parametrize("league", LEAGUES)
def test_percepts_of_robots_with_ideal_senses_leave_their_beliefs_true(league: str) -> None:
    """One provider fills a robot's beliefs: learners may observe percepts beside a team that knows the truth."""
    match = Match(league, home=2, away=2, matches=2, seed=3, senses="ideal", observe="percepts", teammates="chaser")
    for actions in random_actions(match, 30):
        match.step(actions)
    assert match.percepts["body"]["frame"].min() > 0 and np.abs(match.observations).max() > 0.0
    true = np.hypot(match.balls["x"][:, None] - match.robots["x"], match.balls["y"][:, None] - match.robots["y"])
    assert match.beliefs["ball"]["distance"] == pytest.approx(true, abs=1e-9)
    assert (match.robots["senses"] == 0).all()  # their heads follow the true ball


def test_no_field_of_a_record_hides_behind_a_method_of_numpys() -> None:
    """In plain Python `record.round` would be numpy's method, whatever the field holds."""
    names = dir(np.void)
    for package in (soccer_env, perception, belief, baselines, leagues):
        for module in pkgutil.iter_modules(package.__path__, package.__name__ + "."):
            if not module.ispkg:
                for name, value in vars(import_module(module.name)).items():
                    fields = set(value.names or ()) if isinstance(value, np.dtype) else set()
                    assert not fields & set(names), f"{module.name}.{name}"
