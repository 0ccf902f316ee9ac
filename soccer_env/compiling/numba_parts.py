"""All private parts of numba that this package uses, collected here because other versions may rename them.

pyproject.toml bounds the version; tests/repository/test_private_parts.py names the parts that a new version lacks.
"""

from typing import Any

import numba

try:
    from numba.core import caching, cgutils, compiler, event, serialize, sigutils
    from numba.core.ccallback import CFunc
    from numba.core.codegen import JITCodeLibrary
    from numba.core.compiler_lock import global_compiler_lock
    from numba.core.dispatcher import Dispatcher
    from numba.core.errors import NumbaError
    from numba.core.registry import CPUDispatcher
    from numba.np.numpy_support import from_dtype

    Cache: Any = caching._Cache
    CachedResult: Any = caching.CompileResultCacheImpl
    Pipeline: Any = compiler.Compiler
    Listener: Any = event.Listener
    register: Any = event.register
    dumps: Any = serialize.dumps
    normalized: Any = sigutils.normalize_signature
except (ImportError, AttributeError) as error:
    raise ImportError(f"numba {numba.__version__} is not a version that soccer_env knows: {error}") from error

Callback: Any = CFunc
Library: Any = JITCodeLibrary
Kernel: Any = CPUDispatcher
numba_lock: Any = global_compiler_lock
__all__ = [
    "Cache", "CachedResult", "Callback", "Dispatcher", "Kernel", "Library", "Listener", "NumbaError", "Pipeline",
    "cgutils", "dumps", "from_dtype", "normalized", "numba_lock", "register",
]  # fmt: skip
