"""Record views of part of an observation, so that kernels write each number by the name of its entry."""

from typing import Any

import numpy as np
from numba.extending import intrinsic, overload

NUMBER = np.dtype("f4").itemsize  # [bytes]


def record_view(row: Any, at: int, record: Any) -> Any:
    """Return a record view of the row (n,), starting at index `at`; writing to the record changes the row.

    `record` comes from `entry.record_of`. In compiled code this costs nothing, while the checks of a view of a slice
    cost tens of nanoseconds; the caller makes sure that the row is long enough.
    """
    return row[at : at + record.itemsize // NUMBER].view(record).view(np.recarray)[0]


@intrinsic
def _record_view(context, row, at, record):
    """Compile `record_view`: cast the address of the row's number at index `at` to the address of a record."""

    def generate(target, builder, signature, arguments):
        array = target.make_array(signature.args[0])(target, builder, arguments[0])
        return builder.bitcast(builder.gep(array.data, [arguments[1]]), target.get_value_type(signature.return_type))

    return record.dtype(row, at, record), generate


@overload(record_view)
def _compiled_record_view(row, at, record):  # numba compares the signatures
    if row.ndim == 1 and row.layout == "C" and row.dtype.bitwidth == 8 * NUMBER:
        return lambda row, at, record: _record_view(row, at, record)  # type: ignore[call-arg]  # numba gives the context
    return None
