"""Rows of whole numbers to few bytes, and back: differences, small numbers first, then deflate."""

from __future__ import annotations

import base64
import zlib

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]

LEVEL = 9
"""Of zlib: packing is done once, and takes little of a build."""


def packed(rows: Ints) -> str:
    """Rows array[row, column] of numbers below 2 ** 30 as text (base64): each row as the differences of its
    neighbours, zigzag (0, -1, 1, -2 ... as 0, 1, 2, 3 ...), the lowest bytes of all first; `player.js` unpacks it."""
    steps = np.diff(rows, axis=1, prepend=0)
    folded = ((steps << 1) ^ (steps >> 63)).astype("<u4")
    planes = folded.reshape(-1, 1).view(np.uint8).T
    return base64.b64encode(zlib.compress(planes.tobytes(), LEVEL)).decode("ascii")


def unpacked(text: str, count: int) -> Ints:
    """What `packed` had, `count` rows of it."""
    planes = np.frombuffer(zlib.decompress(base64.b64decode(text)), dtype=np.uint8).reshape(4, -1)
    folded = np.ascontiguousarray(planes.T).view("<u4").reshape(count, -1).astype(np.int64)
    return np.cumsum((folded >> 1) ^ -(folded & 1), axis=1)
