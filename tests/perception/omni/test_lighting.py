"""Light changes, the colour table follows it or does not, and what is seen depends on the difference."""

from typing import Any

import numpy as np
import pytest

from soccer_env import Match
from soccer_env.leagues import find_league
from tests.perception.omni.staged_omni import NOW, SURE, around, look, watching
from tests.scenes.staging import MIDDLE, play, put, put_ball

LEAGUE = find_league(MIDDLE)
S = LEAGUE.sensors
CHANGING = {"light_drift": 0.5, **SURE, **NOW}


def seeing(match: Match, seconds: float) -> dict[str, np.ndarray]:
    """Let light go by, robots and ball where they are; return robot 0's light, table, ball and players (T, M)."""
    found: dict[str, list[np.ndarray]] = {name: [] for name in ("light", "table", "ball", "players", "lines")}
    for step in range(round(seconds * 50)):
        match.matches["step"], match.matches["clock"] = step, step * 0.02
        match.batch.senses.sense(0, match.count)
        for name, kept in found.items():
            records = match.batch.senses.sensor_states if name == "table" else match.percepts
            kept.append(records[name][:, 0].copy())
    return {name: np.stack(kept) for name, kept in found.items()}


def ball_at(match: Match, distance: float) -> None:
    """Put the ball round about robot 0."""
    bearings = around(match.count)
    put_ball(match, distance * np.cos(bearings), distance * np.sin(bearings))


def test_mh07_light_swings_as_told_and_differs_from_match_to_match() -> None:
    """MH07: the same for all robots of a match, a swing of `light_drift` in `light_period`."""
    match = watching(20, sensors={**CHANGING, "light_period": 10.0}, seed=5)
    put(match, 1, 3.0, 0.0)
    light = seeing(match, 10.0)["light"]
    assert light.max(axis=0) == pytest.approx(0.5, abs=0.05) and light.min(axis=0) == pytest.approx(-0.5, abs=0.05)
    assert abs(light[-1] - light[0]).max() < 0.08  # a period has passed
    assert len(np.unique(light[0].round(1))) > 5
    assert match.percepts["light"][:, 0] == pytest.approx(match.percepts["light"][:, 1], abs=0.08)


def test_mh07_the_adaptive_table_follows_the_light_and_the_fixed_one_does_not() -> None:
    """MH07: H26, a fixed colour table fails when the light changes, the adapting one does not."""
    shares, errors = {}, {}
    for table in ("adaptive", "fixed"):
        match = watching(40, sensors={**CHANGING, "light_period": 60.0, "colour_table": table}, seed=6)
        ball_at(match, 2.0)
        seen = seeing(match, 6.0)
        ball = seen["ball"]
        shares[table] = (ball["seen"] == 1).mean()
        errors[table] = (ball["distance"][ball["seen"] == 1] - 2.0).mean()
        lag = seen["light"] - seen["table"]
        assert abs(lag).max() < 0.2 if table == "adaptive" else (seen["table"] == 0.0).all()
    assert shares["adaptive"] > 0.9 and shares["fixed"] < 0.7
    assert errors["fixed"] > 0.01 > abs(errors["adaptive"])  # a blob that lost its rim seems farther


def test_mh07_a_table_that_is_off_by_its_width_misses_half() -> None:
    """MH07: of balls, players and lines alike."""
    match = watching(400, sensors={**CHANGING, "light_drift": 1.0, "colour_table": "fixed"}, seed=7)
    ball_at(match, 1.0)
    bearings = around(400) + 1.0
    put(match, 1, 2.0 * np.cos(bearings), 2.0 * np.sin(bearings))
    percepts = look(match)
    off = abs(percepts["light"])
    for near, share in ((abs(off - S.table_width) < 0.04, 0.5), (off < 0.06, 1.0), (off > 0.7, 0.0)):
        assert near.sum() > 5
        assert (percepts["ball"]["seen"][near] == 1).mean() == pytest.approx(share, abs=0.3 if share == 0.5 else 0.05)
        assert (percepts["players"]["seen"][near, 0] == 1).mean() == pytest.approx(share, abs=0.3)


def test_in_constant_light_the_table_does_not_matter() -> None:
    percepts = []
    for table in ("adaptive", "fixed"):
        match = Match(MIDDLE, home=2, away=2, seed=8, observe="percepts", sensors={"colour_table": table})
        play(match, steps=20)
        percepts.append(match.percepts.tobytes())
        assert not match.percepts["light"].any() and not match.batch.senses.sensor_states["table"].any()
    assert percepts[0] == percepts[1]


def table_after(off: float, seconds: float = 1.0, placed: bool = False, **settings: Any) -> float:
    """Put the table of a robot on the centre spot off the still light; return by how much it is off afterwards [1]."""
    sensors = {**CHANGING, "light_period": 1e6, "table_time": 1.0, **settings.pop("sensors", {})}
    match = watching(sensors=sensors, pose="particles", **settings)
    seeing(match, 0.1)
    senses: Any = match.batch.senses
    light = float(senses.percepts["light"][0, 0])
    senses.sensor_states["table"][0, 0] = light + off
    match.robots["placed"][0, 0] = placed
    for step in range(round(seconds * 50)):
        match.matches["step"] = 5 + step
        senses.sense(0, 1)
    return float(senses.sensor_states["table"][0, 0]) - light


def test_the_table_takes_its_time() -> None:
    """A time constant: after a sudden change a share of 1 - 1/e of it is made good in `table_time`."""
    assert table_after(0.2, 1.0) == pytest.approx(0.2 / np.e, abs=0.02)


def test_mh07_light_that_jumps_leaves_the_table_behind() -> None:
    """MH07: colours beyond two standard deviations of their class are taken for something else."""
    reach = 2.0 * S.table_width / np.sqrt(2.0 * np.log(2.0))
    assert table_after(1.2 * reach, 4.0) == pytest.approx(1.2 * reach, abs=1e-6)
    assert abs(table_after(0.8 * reach, 4.0)) < 0.1 * reach


def test_mh07_who_cannot_know_its_place_learns_no_colours() -> None:
    """MH07: which class a pixel must show follows from the own pose: by lines in the picture, or as it is sensed."""
    blind = {"line_miss": 1.0}
    assert table_after(0.2, sensors=blind) == pytest.approx(0.2, abs=1e-6)
    match = watching(sensors={**CHANGING, **blind, "light_period": 60.0}, pose="percept", seed=6)
    seen = seeing(match, 6.0)
    assert abs(seen["light"] - seen["table"]).max() < 0.2 < np.ptp(seen["light"])


def test_mh07_who_is_told_its_place_trains_a_table_anew() -> None:
    """MH07: it needs no table to begin with, however far the light has gone meanwhile."""
    assert abs(table_after(1.0, 0.1, placed=True)) < 0.05
    assert table_after(1.0, 0.1) == pytest.approx(1.0, abs=1e-6)


def test_delayed_pictures_keep_one_table() -> None:
    """The table goes from picture to picture, not from delivery to delivery."""
    lags = []
    for late in (0, 3):
        match = watching(10, sensors={**CHANGING, "light_period": 20.0, "camera_delay": late}, seed=9)
        seen = seeing(match, 8.0)
        lags.append(abs(seen["light"] - seen["table"])[100:].mean())
    assert lags[1] == pytest.approx(lags[0], rel=0.1)
