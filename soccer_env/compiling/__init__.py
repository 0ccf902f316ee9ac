"""What stands behind `soccer_env.compiled`: how functions become machine code, and where that is kept.

inner.py      functions that only compiled ones call become machine code inside those alone
stops.py      where a signal may end compiling
numba_parts.py  what we use of numba without its promise
cache.py      machine code on disk
sources.py    which source files that code depends on
callback.py   functions of ours that C calls
borrowing.py  arrays in compiled code without a count of references
"""
