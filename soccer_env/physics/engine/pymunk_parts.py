"""pymunk's private interface to Chipmunk: its functions, and the layout of its structs.

pyproject.toml bounds the version; tests/repository/test_private_parts.py names the parts that a new version lacks.
"""

import pymunk

try:
    from pymunk._chipmunk_cffi import ffi, lib
except ImportError as error:
    raise ImportError(f"pymunk {pymunk.version} is not a version that soccer_env knows: {error}") from error

__all__ = ["ffi", "lib"]
