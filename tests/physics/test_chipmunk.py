"""Both ways of driving Chipmunk give the same bits, and neither touches memory that is not its own."""

import copy
import ctypes
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pymunk
import pytest

from soccer_env.compiled import compiled
from soccer_env.physics.engine import chipmunk
from soccer_env.physics.engine.chipmunk import step_match
from soccer_env.physics.engine.space_batch import SpaceBatch, default_backend

ROOT = Path(__file__).parents[2]
ROBOTS = 6
BODIES = ROBOTS + 1
HALF_LENGTH, HALF_WIDTH = 1.0, 0.7  # [m] small, so that there is always contact
DT = 0.02  # [s]


def fill_space(seed, polygons=False):
    """Return a Space with seven walls, six robots and a ball, placed at random."""
    space = pymunk.Space()
    space.collision_slop = 0.001
    for start, end in walls():
        wall = pymunk.Segment(space.static_body, start, end, 0.02)
        wall.elasticity, wall.friction = 0.5, 0.4
        space.add(wall)
    rng = np.random.default_rng(seed)
    for r in range(BODIES):
        radius, mass = (0.1, 2.0) if r < ROBOTS else (0.05, 0.2)
        body = pymunk.Body(mass, pymunk.moment_for_circle(mass, 0.0, radius))
        body.position = tuple(rng.uniform(-0.8, 0.8, 2) * (HALF_LENGTH, HALF_WIDTH))
        body.angle = rng.uniform(-3.0, 3.0)
        box = polygons and r < ROBOTS
        shape = pymunk.Poly.create_box(body, (0.25, 0.15), 0.01) if box else pymunk.Circle(body, radius)
        shape.elasticity, shape.friction = 0.4, 0.5
        space.add(body, shape)
    return space


def walls():
    x, y = HALF_LENGTH, HALF_WIDTH
    corners = [(-x, -y), (x, -y), (x, y), (-x, y)]
    goal = [((-x, 0.3), (-x + 0.1, 0.3)), ((x, 0.3), (x - 0.1, 0.3)), ((-x, -0.3), (-x + 0.1, -0.3))]
    return list(zip(corners, corners[1:] + corners[:1], strict=True)) + goal


def fill_batch(matches, backend=None, polygons=False):
    batch = SpaceBatch(matches, BODIES, backend)
    for m in range(matches):
        batch.set_space(m, fill_space(m, polygons))
    return batch


def command(batch, rng):
    """Drive all robots at random, mostly towards the middle, and let the ball roll."""
    bodies, velocities = batch.bodies[:, :BODIES], batch.velocities[:, :BODIES]
    velocities[:] = bodies[:, :, 3:]
    velocities[:, :ROBOTS, :2] = rng.uniform(-1.0, 1.0, (len(bodies), ROBOTS, 2)) - bodies[:, :ROBOTS, :2]
    velocities[:, :ROBOTS, 2] = rng.uniform(-4.0, 4.0, (len(bodies), ROBOTS))
    return rng.integers(2, 9, len(bodies))  # substeps


@pytest.mark.parametrize("polygons", [False, True])
def test_both_ways_agree_bit_for_bit_over_10000_match_steps(polygons):
    ways = [fill_batch(10, backend, polygons) for backend in ("c", "batch")]
    rngs = [np.random.default_rng(1) for _ in ways]
    knocks = 0
    for step in range(1000):
        for batch, rng in zip(ways, rngs, strict=True):
            batch.step_all(DT, command(batch, rng))
            if step % 100 == 99:  # somebody puts things elsewhere, and the ball to the middle
                batch.bodies[step // 100, :BODIES, :3] *= 0.9
                batch.bodies[step // 100, ROBOTS, :2] = 0.0
                batch.write_bodies(step // 100)
        assert ways[0].bodies.tobytes() == ways[1].bodies.tobytes(), step
        knocks += np.count_nonzero(ways[0].bodies[:, :ROBOTS, 3:5] != ways[0].velocities[:, :ROBOTS, :2]) / 2
    assert knocks > 20000  # of 60,000: rich in contact


@pytest.mark.parametrize("backend", ["c", "batch"])
def test_body_attributes_agree_with_the_rows_and_two_threads_play_what_one_plays(backend):
    batch = fill_batch(1, backend)
    bodies = list(batch.spaces[0].bodies)
    batch.step_all(DT, command(batch, np.random.default_rng(2)))
    rows = [[*body.position, body.angle, *body.velocity, body.angular_velocity] for body in bodies]
    assert batch.bodies[0, :BODIES].tolist() == rows and not batch.bodies[0, BODIES:].any()
    batch.bodies[0, 2] = 0.5, -0.25, 1.5, 0.125, 2.0, -3.0
    batch.write_bodies(0)
    body = bodies[2]
    assert (*body.position, body.angle, *body.velocity, body.angular_velocity) == (0.5, -0.25, 1.5, 0.125, 2.0, -3.0)
    alone, shared = fill_batch(40, backend), fill_batch(40, backend)
    rngs = [np.random.default_rng(5) for _ in range(2)]
    with ThreadPoolExecutor(2) as pool:
        for _ in range(100):
            alone.step_all(DT, command(alone, rngs[0]))
            substeps = command(shared, rngs[1])
            halves = [pool.submit(shared.step_slice, DT, substeps, first, first + 20) for first in (0, 20)]
            for half in halves:
                half.result()
    assert alone.bodies.tobytes() == shared.bodies.tobytes()


@compiled
def drive_and_step(links, velocities, bodies, m, speed):
    for r in range(velocities.shape[1] - 3):
        velocities[m, r, 0] = speed - bodies[m, r, 0]
        velocities[m, r, 1] = -bodies[m, r, 1]
    step_match(links, m, 4, 0.02)
    return bodies[m, 0, 0]


def test_a_kernel_writes_steps_and_reads_in_one_call_and_a_body_at_1_m_per_s_is_2_cm_further_after_20_ms():
    inside, outside = fill_batch(2, "c"), fill_batch(2, "c")
    for _ in range(50):
        x = drive_and_step(inside.links, inside.velocities, inside.bodies, 1, 0.3)
        outside.velocities[1, :BODIES, 0] = 0.3 - outside.bodies[1, :BODIES, 0]
        outside.velocities[1, :BODIES, 1] = -outside.bodies[1, :BODIES, 1]
        outside.step_slice(DT, 4, 1, 2)
        assert x == outside.bodies[1, 0, 0]
    assert inside.bodies.tobytes() == outside.bodies.tobytes()
    batch = SpaceBatch(1, 1)
    space = pymunk.Space()
    space.add(pymunk.Body(1.0, 1.0))  # no static body: Chipmunk visits this one only
    batch.set_space(0, space)
    batch.velocities[0, 0] = 1.0, 0.0, 0.5
    batch.step_all(DT, 4)
    assert batch.bodies[0, 0] == pytest.approx([0.02, 0.0, 0.01, 1.0, 0.0, 0.5])
    before = batch.bodies.copy()
    batch.step_all(DT, 0)
    assert (batch.bodies == before).all()


RESETS = """
import gc, resource, sys
sys.path.insert(0, {root!r})
import numpy as np
from tests.physics.test_chipmunk import BODIES, DT, command, fill_space
from soccer_env.physics.engine.space_batch import SpaceBatch
def play(resets):
    for k in range(resets):
        batch.set_space(k % 4, fill_space(k, polygons=k % 2 == 1))
        batch.step_all(DT, command(batch, rng))
        batch.write_bodies(k % 4)
        assert np.isfinite(batch.bodies).all()
    gc.collect()
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # [KiB]
batch, rng = SpaceBatch(4, BODIES, {backend!r}), np.random.default_rng(0)
for m in range(4):
    batch.set_space(m, fill_space(m))
before = play(300)
print(play(1000) - before)
"""


@pytest.mark.slow
@pytest.mark.parametrize("backend", ["c", "batch"])
@pytest.mark.skipif(sys.platform != "linux", reason="MALLOC_PERTURB_ is glibc's")
def test_a_thousand_resets_neither_crash_nor_leak_with_freed_memory_overwritten(backend):
    code = RESETS.format(root=str(ROOT), backend=backend)
    environment = os.environ | {"MALLOC_PERTURB_": "165"}
    done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert int(done.stdout) < 4096  # [KiB] a Space is about 60


@pytest.fixture
def asked_anew():
    """Let the default backend be found out in this test, and again after it."""
    default_backend.cache_clear()
    yield
    default_backend.cache_clear()


def test_an_unknown_library_means_the_batch_way_and_a_warning(monkeypatch, asked_anew):
    assert chipmunk.layout_fits()
    monkeypatch.setitem(chipmunk.C_FUNCTIONS, "step", "cpNoSuchFunction")
    assert not chipmunk.layout_fits()
    with pytest.warns(RuntimeWarning, match="slower"):
        assert default_backend() == "batch"


@pytest.mark.parametrize(("answers", "backend"), [((b"this", b"this"), "c"), ((b"this", b"that"), "batch")])
def test_another_platform_takes_the_c_way_only_after_a_test(monkeypatch, asked_anew, answers, backend):
    monkeypatch.setattr("platform.machine", lambda: "riscv64")
    if backend == "batch":  # else it is really tested
        left = iter(answers)
        monkeypatch.setattr("soccer_env.physics.engine.space_batch._simulate_collision", lambda backend: next(left))
    assert default_backend() == backend


@pytest.mark.parametrize("backend", ["c", "batch"])
def test_what_would_crash_or_mislead_is_refused(backend):
    batch, kinematic, sleepy = SpaceBatch(2, BODIES, backend), fill_space(0), fill_space(0)
    next(iter(kinematic.bodies)).body_type = pymunk.Body.KINEMATIC
    sleepy.sleep_time_threshold = 0.5
    for message, call in (
        ("no Space yet", lambda: batch.step_all(DT, 4)),
        ("7 dynamic bodies", lambda: batch.set_space(0, pymunk.Space())),
        ("dynamic", lambda: batch.set_space(0, kinematic)),
        ("sleep", lambda: batch.set_space(0, sleepy)),
        ("dt", lambda: batch.step_all(float("nan"), 4)),
        ("slice", lambda: batch.step_slice(DT, 4, 0, 3)),
        ("backend", lambda: SpaceBatch(1, 1, "fast")),
    ):
        with pytest.raises(ValueError, match=message):
            call()
    with pytest.raises(TypeError, match="addresses"):
        copy.deepcopy(batch)


def test_the_c_way_works_without_the_compiler():
    code = """
from tests.physics.test_chipmunk import fill_batch, command, DT
import numpy as np
c, batch = fill_batch(2, "c"), fill_batch(2, "batch")
for _ in range(5):
    for b in (c, batch):
        b.step_all(DT, command(b, np.random.default_rng(0)))
assert c.bodies.tobytes() == batch.bodies.tobytes()
"""
    environment = os.environ | {"NUMBA_DISABLE_JIT": "1", "PYTHONPATH": str(ROOT)}
    subprocess.run([sys.executable, "-c", code], env=environment, check=True, timeout=60)


@pytest.mark.parametrize(("call", "kinds", "given"), [
    (chipmunk._python_step, (ctypes.c_size_t, ctypes.c_double), (7, 0.25)),
    (chipmunk._python_each, (ctypes.c_size_t,) * 3, (7, 9, 11)),
    (chipmunk._python_shape, (ctypes.c_size_t,) * 2, (7, 9)),
])  # fmt: skip
def test_without_compiling_a_function_of_chipmunk_is_called_by_its_address(call, kinds, given):
    heard = []
    function = ctypes.CFUNCTYPE(None, *kinds)(lambda *words: heard.append(words))
    call(ctypes.cast(function, ctypes.c_void_p).value, *given)
    assert heard == [given]
