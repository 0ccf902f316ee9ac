"""The pymunk engine: one Space for each match, and the ways by which compiled kernels reach them.

space.py        a Space: boards, goals, ball, robots
surfaces.py     what meets what in it, and how much that bounces and rubs
space_batch.py  M of them, and the arrays through which kernels reach them
dropping.py     a Space freed with all that is in it
reseat.py       a used Space made as good as new
chipmunk.py     calls of Chipmunk, the C library under pymunk, from compiled loops
pymunk_parts.py what pymunk keeps private of it
memory.py       its structs in memory: bodies, contacts
pools.py        where it keeps shapes, pairs and contacts
prefetch.py     fetch the next match's memory into the cache while this one is played
reference.py    a bare scene for `soccer bench` to compare with
"""
