"""Chipmunk itself, which pymunk keeps private: its functions, and the layout of its structs.

pyproject.toml bounds the version; tests/repository/test_private_parts.py says what a new one lacks.
"""

import pymunk

try:
    from pymunk._chipmunk_cffi import ffi, lib
except ImportError as error:
    raise ImportError(f"pymunk {pymunk.version} is not a version that soccer_env knows: {error}") from error

__all__ = ["ffi", "lib"]
