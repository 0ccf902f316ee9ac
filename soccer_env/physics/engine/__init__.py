"""The pymunk engine: one Space for each match, and the arrays through which compiled kernels use the Spaces.

space.py        one Space: boards, goals, ball, robots
surfaces.py     which shapes collide, with which elasticity and friction
space_batch.py  M Spaces, and the arrays through which kernels use them
reseat.py       reset a used Space to the state of a new one
chipmunk.py     calls of Chipmunk, the C library under pymunk, from compiled loops
pymunk_parts.py pymunk's private interface to Chipmunk
memory.py       Chipmunk's structs in memory: bodies, contacts
pools.py        Chipmunk's structs for shapes, pairs and contacts
prefetch.py     fetch the memory of the next match into the cache while this match is stepped
reference.py    the bare scene that `soccer bench` compares with
"""
