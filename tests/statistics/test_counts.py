"""The statistics of whole matches against counts of their events, and against a count by arrays of their records."""

import numpy as np
import pytest

from soccer_env.random_numbers import seeds_for
from soccer_env.statistics.counting import count_calls, count_step, is_notable
from soccer_env.statistics.figures import FIGURES, flatten_statistics, statistics_by_name
from soccer_env.statistics.players import count_player
from soccer_env.statistics.records import BINS, BINS_PER_OCTAVE, FRESH, SHORTEST
from soccer_env.types import AWAY, HOME, NO_TEAM, Phase
from tests.scenes.staging import each_league, play
from tests.scenes.symmetry import Records, mirrored, mirrored_events, other_row, swapped_rows, turned, turned_events
from tests.statistics.recorded_play import chasers, held, kicks, recording_of, running, spells, times, touches


def driving(name, **settings):
    return chasers(name, placement="drive", **settings)


@pytest.fixture(scope="module", params=["legged-2001", "middle-size-2006"])
def played(request):
    """Return finished matches with their recording and the referee's calls of every step."""
    match = driving(request.param, seeds=seeds_for(5, 3).tolist())
    moments, calls, last = [], [], match.robots[["x", "y"]].copy()
    for moment in running(match):
        moments.append(moment)
        now = match.robots[["x", "y"]].copy()
        moved = np.hypot(now["x"] - last["x"], now["y"] - last["y"])
        ordered = (match.events["separated"] == 1) | (match.events["restart"] == Phase.DROP_BALL)
        stays = (match.robots["active"] == 1) & (match.robot_events["returned"] == 0) & (match.robots["penalty"] == 0.0)
        calls.append((match.events.copy(), match.robot_events["foul"].copy(), moved * (stays & ordered[:, None])))
        last = now
    return match, recording_of(match, moments), [np.stack(column) for column in zip(*calls, strict=True)]


def test_times_touches_possession_and_spells_are_those_of_the_recording(played) -> None:
    match, recording, _ = played
    found = match.statistics
    for name, seconds in times(recording).items():
        assert found[name] == pytest.approx(seconds), name
    assert found["touches"].sum(axis=1).tolist() == touches(recording).tolist()
    assert found["kicks"].sum(axis=1).tolist() == kicks(recording).tolist() and (found["scrum"] > 0.0).any()
    assert (found["touches"] > 0).all()
    match, recording, _ = played
    found = match.statistics
    assert found["possession"].sum(axis=1) + found["both"] == pytest.approx(held(recording))
    for m, lengths in enumerate(spells(recording)):
        assert found["spells"][m].sum() == len(lengths)
        assert found["spell_time"][m].sum() == pytest.approx(lengths.sum())
        assert found["longest_spell"][m].max() == pytest.approx(lengths.max())
        counts = found["spell_lengths"][m].sum(axis=0)
        places = np.floor(BINS_PER_OCTAVE * np.log2(np.maximum(lengths, SHORTEST) / SHORTEST) + 1e-9)
        assert counts.tolist() == np.bincount(np.minimum(places, BINS - 1).astype(int), minlength=BINS).tolist()


def test_what_the_referee_called_is_counted_once(played) -> None:
    match, _, (events, fouls, moved) = played
    found = match.statistics
    for m in range(match.count):
        mine = events[:, m]
        assert found["separations"][m] == (mine["separated"] == 1).sum()
        assert found["annulled"][m].sum() == (mine["annulled"] == 1).sum()
        assert found["goals"][m].sum(axis=1).tolist() == match.matches["score"][m].tolist()
        for phase in (p for p in Phase if p not in (Phase.PLAY, Phase.OVER)):
            for team in (HOME, AWAY):
                called = (mine["restart"] == phase) & (mine["restart_team"] == team)
                assert found["restarts"][m, team, phase] == called.sum()
        assert found["drops"][m] == ((mine["restart"] != 0) & (mine["restart_team"] == NO_TEAM)).sum()
        assert found["fouls"][m].sum() >= (mine["foul"] != 0).sum() and found["fouls"][m, :, 0].sum() == 0
        step = match.league.drive.forward * match.league.dt
        assert found["carried"][m] == pytest.approx(moved[:, m].max(initial=0.0), abs=2.0 * step)
    assert found["restarts"].sum() > 0


def counted(records, events, robot_events, before, k, statistics):
    """Count a step of a match from records as they stand after it; `before` is where robots were (R, 2)."""
    match, ball, robots = records.matches[0], records.balls[0], records.robots[0]
    bodies = np.zeros((len(robots) + 1, 6))
    bodies[1:, :2] = before
    for r in range(len(robots)):
        count_player(match, ball, robots, robot_events[0, r], r, k, statistics[0])
    count_step(match, ball, robots, events[0], k, statistics[0])
    if is_notable(events[0]):
        count_calls(match, robots, events[0], robot_events[0], bodies, statistics[0])


@each_league
def test_a_mirrored_match_has_the_same_statistics_and_a_turned_one_those_of_the_other_team(name):
    match = driving(name, seed=2, matches=1, minutes=1.0)
    rows, k = match.robots.shape[1], match.batch.constants[0]
    found = {what: np.full(1, FRESH) for what in ("as it is", "mirrored", "turned")}
    before = np.stack([match.robots["x"][0], match.robots["y"][0]], axis=-1)
    while not match.terminated[0]:
        match.step()
        records = Records.of(match)
        turn = turned_events(match.events, rows)
        turn["scorer"] = other_row(match.events["scorer"], rows)
        images = {
            "as it is": (records, match.events, match.robot_events, before),
            "mirrored": (mirrored(records), mirrored_events(match.events), match.robot_events, before * (1.0, -1.0)),
            "turned": (turned(records), turn, swapped_rows(match.robot_events), -np.roll(before, rows // 2, axis=0)),
        }
        for what, (image, events, robot_events, places) in images.items():
            counted(image, events, robot_events, places, k, found[what])
        before = np.stack([match.robots["x"][0], match.robots["y"][0]], axis=-1)
    as_it_is = statistics_by_name(found["as it is"], HOME)
    for key, values in as_it_is.items():
        assert statistics_by_name(found["mirrored"], HOME)[key] == pytest.approx(values), key
        assert statistics_by_name(found["turned"], AWAY)[key] == pytest.approx(values), key
    real = statistics_by_name(match.statistics, HOME)
    assert all(real[key] == pytest.approx(as_it_is[key]) for key in real if key != "carried")
    assert min(real["touches_for"], real["touches_against"]) > 0


@each_league
def test_both_backends_and_any_number_of_threads_count_alike(name):
    found = []
    for settings in ({"backend": "c"}, {"backend": "batch"}, {"threads": 2}):
        match = driving(name, seed=4, matches=4, **settings)
        play(match, steps=300)
        found.append(match.statistics.tobytes())
        match.close()
    assert found[0] == found[1] == found[2]


@each_league
def test_a_save_brings_the_statistics_back_and_a_hash_leaves_them_out(name):
    match, other = driving(name, seed=4), driving(name, seed=9)
    for step in range(400):
        if step == 200:
            saved = match.save()
        match.step()
    after = match.statistics.copy()
    other.load(saved)
    play(other, steps=200)
    assert other.statistics.tobytes() == after.tobytes()
    before = match.state_hash()
    match.statistics[:] = FRESH
    assert match.state_hash() == before


@pytest.mark.parametrize("field", ["player", "player_team", "flight", "flight_team", "kicker", "kicker_team", "kind"])
def test_a_save_whose_statistics_name_a_robot_that_there_is_not_is_refused(field):
    match = driving("legged-2001", matches=1)
    match.statistics["trail"][field] = 99
    saved = match.save()
    with pytest.raises(ValueError, match=f"{field} of statistics is out of range"):
        match.load(saved)


def test_a_new_episode_begins_with_nothing_counted_and_the_last_one_is_kept() -> None:
    match = driving("legged-2001", minutes=0.2, autoreset="same_step", matches=2)
    play(match, steps=round(12.0 * match.league.control_rate))
    assert match.final["statistics"]["played"] == pytest.approx(12.0)
    assert match.statistics.tobytes() == np.full(2, FRESH).tobytes()


def test_a_team_sees_its_own_numbers_as_for_and_its_opponents_as_against(played) -> None:
    match, _, _ = played
    record = match.statistics[0]
    home, away = flatten_statistics(record, HOME), flatten_statistics(record, AWAY)
    for figure in FIGURES:
        if figure.team:
            assert home[f"{figure.name}_for"] == away[f"{figure.name}_against"]
            assert home[f"{figure.name}_against"] == away[f"{figure.name}_for"]
        else:
            assert home[figure.name] == away[figure.name]
    assert home["touches_for"] == record["touches"][HOME]
    assert all(isinstance(value, (int, float)) for value in home.values())
    assert len({figure.name for figure in FIGURES}) == len(FIGURES)
    assert all(figure.text.endswith(".") for figure in FIGURES)
