"""The structs in which Chipmunk keeps the shapes, pairs and contacts of a Space.

Nodes and pairs of trees, arbiters and bins of hash sets live in pools: buffers of 32 KiB. Chipmunk uses the first item
of a buffer first, then the items from the last one downwards, and a freed item next. So the items in use lie at the
head and the tail of a buffer.

`engine/memory.py` has the structs of bodies and contacts. The numbers below are those of the 64-bit builds of pymunk
7.3 (Munk2D, `chipmunk_structs.h`, `cpBBTree.c`, `cpHashSet.c`, `cpSpaceStep.c`).
"""

from __future__ import annotations

import functools

import pymunk

from soccer_env.physics.engine.memory import BODY_ARBITERS, address_of
from soccer_env.physics.engine.pymunk_parts import ffi

# Sizes of structs and offsets in them [bytes]
SPACE_SIZE = 608  # struct cpSpace, with its static body
SPACE_SHAPE_IDS = 128  # the number of the next shape, in eight bytes
SPACE_BODIES, SPACE_CONSTRAINTS, SPACE_ARBITERS = 96, 152, 160  # addresses of cpArrays
SPACE_STATIC, SPACE_DYNAMIC = 136, 144  # addresses of the trees of static and of moving shapes
SPACE_CONTACTS = 168  # address of the newest in a ring of buffers
SPACE_CACHED, SPACE_POOLED = 176, 184  # a hash set of arbiters, a cpArray of unused arbiters
ARRAY_SIZE, ARRAY_ITEMS = 16, 8  # struct cpArray: a count, and the address of its items
TREE_SIZE, TREE_LEAVES, TREE_BUFFERS = 88, 40, 72  # struct cpBBTree: a hash set of leaves, a cpArray of buffers
SET_SIZE, SET_ROOM, SET_TABLE, SET_BUFFERS = 48, 4, 24, 40  # struct cpHashSet: the length of its table, its address
BIN_SIZE, BIN_NEXT = 24, 16  # struct cpHashSetBin: an item, the next bin
NODE_SIZE = 64  # struct Node of a tree: first the shape of a leaf
BUFFER_SIZE = 32768  # of a pool
BODY_SIZE, CONSTRAINT_SIZE, ARBITER_SIZE = 312, 128, 184
CONTACTS_NEXT = 8  # of a buffer of contacts: the next in the ring
CONTACTS_SIZE = 320  # of the head of such a buffer, with its first three contacts
SHAPE_SIZES = (232, 328, 216)  # of a circle, a segment and a polygon
POLYGON = 2
POLYGON_COUNT, POLYGON_PLANES = 200, 208  # the number of corners, and the address of two planes for each corner
PLANE_SIZE = 32


@functools.cache
def layout_fits() -> bool:
    """Tell whether the structs of a known Space have the sizes and offsets above."""
    space = pymunk.Space()
    bodies = [pymunk.Body(1.0, 1.0) for _ in range(2)]
    box = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
    moving = [pymunk.Circle(bodies[0], 0.5), pymunk.Poly(bodies[1], box)]
    walls = [pymunk.Segment(space.static_body, (5.0, 0.0), (6.0, 0.0), 0.1), pymunk.Poly(space.static_body, box)]
    walls[1].filter = pymunk.ShapeFilter(mask=0)
    space.add(*bodies, *moving, *walls)
    space.step(1e-9)
    at = address_of(space)
    arbiter = _struct_at(address_of(bodies[0]) + BODY_ARBITERS)
    return (
        _struct_at(at + SPACE_SHAPE_IDS) == len(moving) + len(walls)
        and _array_items(_struct_at(at + SPACE_BODIES)) == [address_of(body) for body in bodies]
        and _tree_leaves(_struct_at(at + SPACE_DYNAMIC)) == {address_of(shape) for shape in moving}
        and _tree_leaves(_struct_at(at + SPACE_STATIC)) == {address_of(shape) for shape in walls}
        and [_struct_at(_struct_at(address_of(shape))) & 0xFF for shape in (*moving, *walls)]
        == [0, POLYGON, 1, POLYGON]
        and _struct_at(address_of(walls[1]) + POLYGON_COUNT) & 0xFF == len(box)
        and _array_items(_struct_at(at + SPACE_ARBITERS)) == [arbiter] == _set_items(_struct_at(at + SPACE_CACHED))
        and _array_items(_struct_at(at + SPACE_CONSTRAINTS)) == []
        and arbiter not in _array_items(_struct_at(at + SPACE_POOLED))
        and ffi.sizeof("cpArbiter") == ARBITER_SIZE
        and _struct_at(_struct_at(at + SPACE_CONTACTS) + CONTACTS_NEXT) == _struct_at(at + SPACE_CONTACTS)
    )


def _struct_at(address: int) -> int:
    return int(ffi.cast("uintptr_t *", address)[0])


def _item_count(address: int) -> int:
    return int(ffi.cast("int *", address)[0])


def _array_items(array: int) -> list[int]:
    return [_struct_at(_struct_at(array + ARRAY_ITEMS) + 8 * i) for i in range(_item_count(array))]


def _set_items(hash_set: int) -> list[int]:
    items = []
    for i in range(_item_count(hash_set + SET_ROOM)):
        place = _struct_at(_struct_at(hash_set + SET_TABLE) + 8 * i)
        while place != 0:
            items.append(_struct_at(place))
            place = _struct_at(place + BIN_NEXT)
    return items


def _tree_leaves(tree: int) -> set[int]:
    return {_struct_at(leaf) for leaf in _set_items(_struct_at(tree + TREE_LEAVES))}
