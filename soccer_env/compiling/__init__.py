"""The implementation of `soccer_env.compiled`: functions become machine code, which is cached on disk.

inner.py        functions that only kernels call are compiled inside their callers
stops.py        points at which a signal may end compiling
numba_parts.py  private parts of numba that we use
cache.py        machine code on disk
announcing.py   progress of compiling, with the number of functions that are left
sources.py      the source files that a function depends on
callback.py     our functions that C calls
borrowing.py    arrays in compiled code without reference counts
"""
