"""Controls in whole units to the text of a path: relative quadratics, as short as SVG allows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.backends.svg.curves import Chain

Ints = NDArray[np.int64]


def path_text(controls: Ints, contours: Sequence[Sequence[Chain]]) -> str:
    """Closed contours of chains of quadratics, in half units; `controls` is array[control, xy].

    Relative commands, because small numbers are short; the numbers are differences of whole half units, so nothing
    adds up. Only the first handle of a chain is written: `t` gives the others. A minus sign is its own separator.
    """
    parts: list[str] = []
    first, at = 0, np.zeros(2, dtype=np.int64)
    for contour in contours:
        for number, chain in enumerate(contour):
            start, handle, joints = _quadratics(controls[first : first + chain.count], chain.closed)
            if number == 0:
                parts += ["m", numbers(start - at)]
            parts += ["q", numbers(np.array([handle - start, joints[0] - start]))]
            if len(joints) > 1:
                parts += ["t", numbers(np.diff(joints, axis=0))]
            first, at = first + chain.count, joints[-1]
    return "".join(parts)


def _quadratics(controls: Ints, closed: bool) -> tuple[Ints, Ints, Ints]:
    """Where a chain begins, its first handle, and the ends of its quadratics, in half units."""
    if closed:
        joints = controls + np.roll(controls, -1, axis=0)
        return joints[-1], 2 * controls[0], joints
    joints = np.concatenate([controls[1:-2] + controls[2:-1], 2 * controls[-1:]])
    return 2 * controls[0], 2 * controls[1], joints


def numbers(values: Ints) -> str:
    """Whole numbers as a path has them, no sign more than it takes."""
    return " ".join(map(str, values.ravel().tolist())).replace(" -", "-")


def decimal(value: float) -> str:
    """A number to four decimals, without what need not be written."""
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text.replace("0.", ".", 1) if text.lstrip("-").startswith("0.") else text
