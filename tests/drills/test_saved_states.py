"""Starts from saved states: an episode goes on from a saved match, drawn by its seed; other saves are refused."""

import pickle
import re
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest

from soccer_env import Match, soccer_v0
from soccer_env.match.saving import collect_states
from soccer_env.records import save_file
from soccer_env.scenes import find_scene, scene_names
from soccer_env.scenes.saved_states import NEW_OF_MATCH, NEW_OF_ROBOT
from soccer_env.train.evaluate import EvaluateSettings, evaluate
from soccer_env.types import WORLD
from tests.scenes.staging import LEAGUES, play

SIZES: dict[str, Any] = {"home": 2, "away": 1}


def running(league: str = "legged-2001", matches: int = 6, **settings: Any) -> Match:
    """Return matches in play, everybody at some place of its own, with a robot of home out of some of them."""
    match = Match(league, matches=matches, seed=5, actions="full", **{**SIZES, **settings})
    rng = np.random.default_rng(2)
    for _ in range(3 * match.league.control_rate + 1):
        match.step(rng.uniform(-0.5, 1.0, (matches, len(match.agents), 7)))
    match.robots["penalty"][: matches // 2, 1], match.robots["active"][: matches // 2, 1] = 12.5, 0
    match.matches["score"], match.matches["still_clock"] = (2, 1), np.arange(matches)
    return match


def written(match: Match, folder: Path) -> str:
    """Return the scene of the saved states of a match."""
    path = folder / "play.states"
    path.write_bytes(match.save())
    return f"states:{path}"


def drawn(match: Match, saved: Match) -> list[int]:
    """Return for each match the saved match whose first robot it has."""
    return [int(np.flatnonzero(saved.robots["x"][:, 0] == x)[0]) for x in match.robots["x"][:, 0]]


@pytest.mark.parametrize("league", LEAGUES)
def test_an_episode_begins_in_a_saved_state_and_its_own_clock_and_score_begin(league: str, tmp_path: Path) -> None:
    saved = running(league)
    match = Match(league, matches=24, seed=1, scene=written(saved, tmp_path), **SIZES)
    rows = drawn(match, saved)
    assert len(set(rows)) == 6, "each state is drawn"
    for name in set(match.balls.dtype.names):
        assert (match.balls[name] == saved.balls[name][rows]).all()
    for name in set(match.robots.dtype.names) - {*NEW_OF_ROBOT, "delayed", "placed"}:
        assert (match.robots[name] == saved.robots[name][rows]).all(), name
    for name in set(match.matches.dtype.names) - {*NEW_OF_MATCH}:
        assert (match.matches[name] == saved.matches[name][rows]).all(), name
    assert (match.matches["still_clock"] == rows).all() and (match.robots["penalty"][:, 1] > 0.0).any()
    assert not match.matches["score"].any() and not match.matches["clock"].any() and not match.matches["step"].any()
    assert (match.robots["placed"] == match.robots["active"]).all()


def test_a_walk_goes_on_as_it_would_have_gone_in_the_saved_match(tmp_path: Path) -> None:
    """Commands on their way to the wheels arrive in the step in which they would have; wheels do not slip."""
    saved = running("middle-size-2006", matches=1, rules="none")
    assert int(saved.matches["step"][0]) % (saved.league.delay_steps + 1), "the delay line is in the middle of a round"
    match = Match("middle-size-2006", seed=9, scene=written(saved, tmp_path), rules="none", actions="full", **SIZES)
    for _ in range(20):
        actions = np.random.default_rng(1).uniform(-1.0, 1.0, (1, 3, 7))
        for one in (saved, match):
            one.step(actions)
        for name in ("x", "y", "heading"):
            np.testing.assert_allclose(match.robots[name], saved.robots[name], atol=1e-9)
        np.testing.assert_allclose(match.balls["x"], saved.balls["x"], atol=1e-9)


def test_a_state_is_drawn_by_the_matchs_own_seed_anew_for_each_episode(tmp_path: Path) -> None:
    saved = running()
    scene = written(saved, tmp_path)
    many = Match(matches=16, seed=3, scene=scene, threads=2, **SIZES)
    first = drawn(many, saved)
    one = Match(seeds=[many.seeds[11]], scene=scene, **SIZES)
    assert drawn(one, saved) == [first[11]] and one.state_hash(0) == many.state_hash(11)
    play(many, steps=5, actions=np.zeros((16, 3, 4)))
    play(one, steps=5, actions=np.zeros((1, 3, 4)))
    assert one.state_hash(0) == many.state_hash(11)
    many.reset()
    assert drawn(many, saved) != first
    copy = pickle.loads(pickle.dumps(many))
    assert copy.state_hash() == many.state_hash()


def test_states_mix_with_other_scenes(tmp_path: Path) -> None:
    saved = running()
    text = f"kick-off:0.3,{written(saved, tmp_path)}:0.7"
    assert scene_names(text) == ["kick-off", f"states:{tmp_path / 'play.states'}"]
    match = Match(matches=60, seed=1, scene=text, **SIZES)
    assert 0.5 < np.isin(match.robots["x"][:, 0], saved.robots["x"][:, 0]).mean() < 0.9


def test_every_api_and_command_begins_in_them(tmp_path: Path) -> None:
    saved = running()
    scene = written(saved, tmp_path)
    parallel = soccer_v0.parallel_env(scene=scene, **SIZES)
    parallel.reset(seed=1)
    turns = soccer_v0.env(scene=scene, **SIZES)
    turns.reset(seed=1)
    solo = gymnasium.make("soccer_env/Legged2001-1v1-v0", scene=scene, **SIZES)
    solo.reset(seed=1)
    matches = [parallel.match, turns.unwrapped.match, solo.unwrapped.match]
    assert len({drawn(match, saved)[0] for match in matches}) == 1
    vector = gymnasium.make_vec("soccer_env/Legged2001-1v1-v0", num_envs=4, scene=scene, **SIZES)
    vector.reset(seed=1)
    assert len(drawn(vector.match, saved)) == 4  # type: ignore[attr-defined]
    scene = written(running(away=2), tmp_path)
    settings = EvaluateSettings(home="still", away="still", players=2, matches=2, minutes=0.05, scene=scene)
    assert len(evaluate(settings).lines) == 2


def test_training_begins_in_them(tmp_path: Path) -> None:
    pytest.importorskip("stable_baselines3")
    from soccer_env.train.ppo.vec_env import SoccerVecEnv

    saved = running()
    env = SoccerVecEnv(players=[(2, 1)], matches=4, opponents="still", scene=written(saved, tmp_path), minutes=0.1)
    env.reset()
    assert len(drawn(env.matches[0], saved)) == 4


def test_collected_states_are_those_of_many_moments_and_of_matches_in_play(tmp_path: Path) -> None:
    teams = {"home": "chaser", "away": "chaser"}
    match = Match(matches=3, seed=1, controllers=teams, senses="ideal", minutes=0.1, **SIZES)
    path = tmp_path / "many.states"
    path.write_bytes(collect_states(match, moments=16, every=0.5))
    assert match.terminated.all(), "after 6 s of play"
    matches, balls, robots = find_scene(f"states:{path}").records  # type: ignore[attr-defined]
    assert 30 <= len(matches) <= 42 and robots.shape == (len(matches), 3) and not matches["over"].any()
    assert len(np.unique(balls["x"])) > 10 and path.stat().st_size < 2**20
    Match(seed=1, scene=f"states:{path}", **SIZES)
    with pytest.raises(ValueError, match="moments must be 1 to 1000000, got 0"):
        collect_states(match, moments=0)


def forged(saved: bytes, **changes: Any) -> bytes:
    """Return a save whose header says something else."""
    body, start, header = save_file.open_save(saved)
    arrays = np.frombuffer(body[start:], np.uint8)
    return save_file.join_save({**header, **changes}, [arrays])


def test_states_of_another_league_size_or_world_are_refused_in_one_line(tmp_path: Path) -> None:
    saved = running()
    scene = written(saved, tmp_path)
    begins = f"scene {scene!r}"
    data = saved.save()
    told = save_file.open_save(data)[2]["told"]
    cases: list[tuple[dict[str, Any], bytes, str]] = [
        ({"league": "middle-size-2006"}, data, f"{begins} holds states of 'legged-2001' at 2 v 1, the match is of "
         "'middle-size-2006' at 2 v 1"),
        ({"home": 3}, data, f"{begins} holds states of 'legged-2001' at 2 v 1, the match is of 'legged-2001' at 3 v 1"),
        ({"max_players": 4}, data, f"{begins} holds states of 3 rows of robots, the match has 8: give the same"),
        ({}, forged(data, world=WORLD - 1), f"{begins}: this save is of world {WORLD - 1}, this is world"),
        ({}, b"nonsense", f"{begins}: this is not a save of soccer_env, or it is damaged"),
        ({}, data[:-1], f"{begins}: this is not a save of soccer_env, or it is damaged"),
        ({}, forged(data, parts=[]), f"{begins}: this save lacks matches, balls, robots of this version"),
        ({}, forged(data, told={}), f"{begins}: it does not say of which match it is"),
        ({}, forged(data, told={**told, "home": ["many", ""]}), f"{begins}: invalid literal"),
        ({"episode": "drill"}, data, "episode 'drill' needs a scene with a success test"),
    ]  # fmt: skip
    for settings, content, said in cases:
        (tmp_path / "play.states").write_bytes(content)
        with pytest.raises(ValueError, match=f"^{re.escape(said)}") as error:
            Match(seed=1, scene=scene, **{**SIZES, **settings})
        assert "\n" not in str(error.value)
    with pytest.raises(ValueError, match="scene 'states:nowhere': No such file or directory"):
        Match(seed=1, scene="states:nowhere")
    with pytest.raises(ValueError, match="is a folder, not a file"):
        Match(seed=1, scene=f"states:{tmp_path}")


def test_numbers_that_no_match_has_and_places_off_the_pitch_are_refused(tmp_path: Path) -> None:
    saved = running()
    scene = written(saved, tmp_path)
    for records, name, value, said in (
        (saved.robots, "x", np.nan, "x of robots is out of range"),
        (saved.matches, "phase", 99, "phase of matches is out of range"),
        (saved.robots, "caught_by", [1, 0, 0], "caught_by of robots names a robot that cannot hold a leg"),
        (saved.balls, "x", 5.0, "holds a state beyond the boards of 'legged-2001'"),
    ):
        before = records[name][0].copy()
        records[name][0] = value
        header = save_file.open_save((tmp_path / "play.states").read_bytes())[2]
        arrays = {"matches": saved.matches, "balls": saved.balls, "robots": saved.robots}
        content = save_file.join_save({**header, "parts": save_file.describe_parts(arrays)}, arrays.values())
        (tmp_path / "play.states").write_bytes(content)
        with pytest.raises(ValueError, match=said):
            Match(seed=1, scene=scene, **SIZES)
        records[name][0] = before
    saved.matches["over"] = 1
    (tmp_path / "play.states").write_bytes(saved.save())
    with pytest.raises(ValueError, match="no match in it goes on"):
        Match(seed=1, scene=scene, **SIZES)
