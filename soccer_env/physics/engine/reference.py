"""The bare physics that `soccer bench` compares with: a fixed scene, and cpSpaceStep alone."""

from __future__ import annotations

from typing import Any

import numpy as np
import pymunk

from soccer_env.compiled import compiled
from soccer_env.physics.engine.chipmunk import advance, read_bodies, write_velocities

REFERENCE_DISCS = 6
REFERENCE_SUBSTEPS = 8
REFERENCE_ITERATIONS = 10
REFERENCE_DT = 0.02  # [s] of a control step


def reference_space(rng: np.random.Generator) -> Any:
    """Return the reference scene: a walled field of 9 x 6 m with three corners cut, six discs of 0.25 m and a ball."""
    space = pymunk.Space()
    space.iterations, space.collision_slop = REFERENCE_ITERATIONS, 0.002
    x, y, cut = 4.5, 3.0, 0.5  # [m]
    corners = [(-x, -y), (x - cut, -y), (x, cut - y), (x, y - cut), (x - cut, y), (cut - x, y), (-x, y - cut)]
    ends = zip(corners, corners[1:] + corners[:1], strict=True)
    walls = [pymunk.Segment(space.static_body, *both, 0.05) for both in ends]
    space.add(*walls)
    for index in range(1 + REFERENCE_DISCS):
        mass, radius = (0.43, 0.11) if index == 0 else (15.0, 0.25)
        body = pymunk.Body(mass, pymunk.moment_for_circle(mass, 0.0, radius))
        body.position = tuple(rng.uniform((-x + 1.0, -y + 1.0), (x - 1.0, y - 1.0)))
        disc = pymunk.Circle(body, radius)
        disc.elasticity, disc.friction = 0.5, 0.3
        space.add(body, disc)
    return space


@compiled
def write_slice(links, first, last):
    """Copy the velocities of a slice of matches from the arrays into the Spaces."""
    for m in range(first, last):
        write_velocities(links, m)


@compiled
def step_bare_slice(links, substeps, dt, first, last):
    """Call cpSpaceStep for a slice of matches, and nothing else."""
    for m in range(first, last):
        advance(links, m, substeps[m], dt)


@compiled
def read_slice(links, first, last):
    """Copy poses and velocities of a slice of matches from the Spaces into the arrays."""
    for m in range(first, last):
        read_bodies(links, m)
