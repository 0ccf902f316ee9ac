"""Nested records go into compiled code, and without the compiler the same code gives the same bits."""

import os
import subprocess
import sys

import numba
import numpy as np
import pytest

from soccer_env.compiled import compiled, config, inlined, view_with_attributes
from soccer_env.compiling.sources import ROOT

POINT = np.dtype([("x", "f8"), ("y", "f8")])
PERCEPT = np.dtype([("ball", POINT), ("distance", "f4"), ("seen", "?")])
BELIEF = np.dtype([("ball", PERCEPT), ("velocity", POINT), ("confidence", "f8")])
TRACK = np.dtype([("place", POINT), ("age", "i4")])
ROBOT = np.dtype([("place", POINT), ("heading", "f8"), ("tracks", TRACK, 3)])
MATCH = np.dtype([("noise", "u8", 4), ("clock", "f8"), ("score", "i4", 2)])

RECORDS = """
import numpy as np
from soccer_env.compiled import compiled
POINT = np.dtype([("x", "f8"), ("y", "f8")])
TRACK = np.dtype([("place", POINT), ("age", "i4")])
ROBOT = np.dtype([("place", POINT), ("heading", "f8"), ("tracks", TRACK, 3)])
MATCH = np.dtype([("noise", "u8", 4), ("clock", "f8")])
@compiled
def draw(match, stream):
    match.noise[stream] = match.noise[stream] * np.uint64(6364136223846793005) + np.uint64(1442695040888963407)
    return (match.noise[stream] >> np.uint64(11)) * (1.0 / 9007199254740992.0)
@compiled
def wander(match, robot):
    robot.heading = (robot.heading + draw(match, 3)) % 6.25
    robot.place.x += np.cos(robot.heading) / (1.0 + draw(match, 1))
    robot.place.y += np.sqrt(np.exp(np.sin(robot.heading))) / 0.3
    track = robot.tracks[1]
    track.place.x = np.arctan2(robot.place.y, robot.place.x)
    track.age += 1
@compiled
def play(matches, robots):
    for m in range(matches.shape[0]):
        matches[m].clock += 0.02
        for r in range(robots.shape[1]):
            wander(matches[m], robots[m, r])
matches, robots = np.zeros(2, MATCH), np.zeros((2, 3), ROBOT)
matches["noise"] = np.arange(8, dtype="u8").reshape(2, 4)
for _ in range(50):
    play(matches, robots)
wander(matches[0], robots[0, 0])
assert robots["tracks"]["age"][0, 0, 1] == 51
print(matches.tobytes().hex(), robots.tobytes().hex())
"""


def test_plain_python_gives_what_compiled_code_gives(tmp_path):
    (tmp_path / "records.py").write_text(RECORDS, encoding="utf-8")
    path = os.pathsep.join([str(ROOT.parent), str(tmp_path)])
    own = {"PYTHONPATH": path, "SOCCER_ENV_CACHE": str(tmp_path / "cache"), "SOCCER_ENV_QUIET": "1"}
    results = []
    for flag in ("0", "1"):
        variables = os.environ | own | {"NUMBA_DISABLE_JIT": flag}
        command = [sys.executable, "-W", "error::RuntimeWarning", "-c", "import records"]  # such as a wrapped integer
        results.append(subprocess.run(command, env=variables, capture_output=True, text=True, timeout=60, check=True))
    assert results[0].stdout == results[1].stdout != ""
    assert results[1].stderr == ""


@compiled
def look(matches, robots, balls, percepts, beliefs, tracks):
    for m in range(matches.shape[0]):
        matches[m].score[1] += 1
        for r in range(robots.shape[1]):
            percept = percepts[m, r]
            percept.ball.x = balls[m].x - robots[m, r].place.x
            percept.seen = percept.ball.x < 2.0
            if percept.seen:
                beliefs[m, r].ball.ball.x = percept.ball.x
                beliefs[m, r].confidence += 0.5
            tracks[m, r, 2].place.y = robots[m, r].tracks[0].place.y


def test_six_arrays_of_nested_records_go_into_one_function():
    matches, balls = np.zeros(4, MATCH), np.zeros(4, POINT)
    robots, percepts, beliefs = (np.zeros((4, 6), dtype) for dtype in (ROBOT, PERCEPT, BELIEF))
    tracks = np.zeros((4, 6, 3), TRACK)
    balls["x"], robots["place"]["x"][:, 1], robots["tracks"]["place"]["y"][..., 0] = 3.0, 2.5, 7.0
    look(matches, robots, balls, percepts, beliefs, tracks)
    assert (matches["score"] == [0, 1]).all()
    assert beliefs["ball"]["ball"]["x"][0].tolist() == [0.0, 0.5, 0.0, 0.0, 0.0, 0.0]
    assert beliefs["confidence"].sum() == 4 * 0.5
    assert (tracks["place"]["y"][..., 2] == 7.0).all()


def test_a_view_with_attributes_writes_through():
    robots = np.zeros((2, 2), ROBOT)
    view = view_with_attributes(robots)
    view[1, 0].tracks[2].place.x = 4.0
    view_with_attributes(robots[0, 1]).place.y = 5.0
    assert robots["tracks"]["place"]["x"][1, 0, 2] == 4.0
    assert robots["place"]["y"][0, 1] == 5.0
    assert view_with_attributes(view) is view
    assert view_with_attributes(3) == 3


def long_work(values, x):
    """Do something long enough for the compiler to leave it in a function of its own, if it is called twice."""
    for i in range(values.shape[0]):
        for j in range(i, values.shape[0]):
            if values[i] > values[j] * x:
                values[i], values[j] = values[j] + np.sin(x), values[i] / (1.0 + x * x)
            elif values[j] > 3.0 * x:
                values[j] = np.arctan2(values[i], x) + np.exp(-abs(values[j])) * np.cos(values[j] * x)
            else:
                values[i] += np.sqrt(abs(values[j] - x)) + np.tan(x) * np.log(1.0 + values[i] * values[i])
    for i in range(1, values.shape[0]):  # half of this is short enough for some processors' compilers to inline
        if values[i - 1] > x:
            values[i] = np.arctan2(values[i - 1], 1.0 + x * x) + np.sin(values[i]) * np.cos(values[i - 1] - x)
        elif values[i] < np.exp(-x * x):
            values[i] -= np.log(1.0 + values[i - 1] * values[i - 1]) * np.tanh(values[i] + x)
        else:
            values[i - 1] = np.sqrt(abs(values[i] * x)) + np.arctan(values[i - 1]) * np.sinh(x)
    return values[0] + np.cos(values[-1])


@pytest.mark.skipif(bool(config.DISABLE_JIT), reason="plain Python inlines nothing")
def test_an_inlined_function_is_called_nowhere_and_gives_the_same():
    answers, calls = [], []
    for decorator in (compiled, inlined):
        work = decorator(long_work)
        work._cache.disable()  # which does not tell two decorators of one function apart
        call = numba.njit(lambda values, x: work(values, x) + work(values, 2.0 * x))  # noqa: B023 - compiled below
        values = np.linspace(-1.0, 1.0, 9)
        answers.append((call(values, 0.7), values.tolist()))
        code = call.inspect_asm(call.signatures[0]).splitlines()
        calls.append(sum("long_work" in line and ("call" in line or "mov" in line) for line in code))
    assert answers[0] == answers[1]
    assert calls[0] > 0 == calls[1]
