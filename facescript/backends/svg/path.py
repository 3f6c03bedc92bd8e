"""Points in whole quanta to the text of a path: relative cubics, as short as SVG allows."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Ints = NDArray[np.int64]


def path_text(points: Ints, lengths: tuple[int, ...]) -> str:
    """Closed contours of cubics. `points` is array[point, 2]; `lengths` are the contours' point counts in turn.

    Relative commands, because small numbers are short; the numbers are differences of whole quanta, so nothing adds
    up. A minus sign is its own separator.
    """
    parts, first, at = [], 0, (0, 0)
    for length in lengths:
        contour = points[first : first + length]
        start = contour[0]
        parts.append(f"m{_numbers(start[0] - at[0], start[1] - at[1])}c{_curves(contour)}")
        at = (int(contour[-1][0]), int(contour[-1][1]))
        first += length
    return "".join(parts)


def _curves(contour: Ints) -> str:
    """All cubics of a contour: handles and anchor, each from the anchor before."""
    anchors = np.repeat(contour[:-1:3], 3, axis=0)
    return _numbers(*(contour[1:] - anchors).ravel().tolist())


def _numbers(*values: int) -> str:
    return " ".join(map(str, values)).replace(" -", "-")
