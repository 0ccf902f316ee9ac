"""Tables of whole numbers as text for `unpack.js`: changes from row to row, low bytes before high, deflated, base64."""

import base64
import zlib

import numpy as np


def pack_table(table: np.ndarray) -> str:
    """Pack a table (T, C) int16 as text; differences between rows wrap round."""
    changes = np.diff(table, axis=0, prepend=np.int16(0)).T  # (C, T): a column's changes lie together
    folded = ((changes.astype(np.int32) << 1) ^ (changes.astype(np.int32) >> 15)).astype("<u2")  # 0, -1, 1, -2, ...
    planes = np.concatenate([(folded & 255).astype(np.uint8).ravel(), (folded >> 8).astype(np.uint8).ravel()])
    return pack_bytes(planes.tobytes())


def pack_bytes(content: bytes) -> str:
    """Deflate bytes and return them as base64 text."""
    return base64.b64encode(zlib.compress(content, 9)).decode()
