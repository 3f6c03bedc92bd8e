"""Anchors of a closed outline -> how its Bezier handles follow from them: Hobby's spline, frozen into a linear map."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Anchor = tuple[float, float, bool]
"""x, y, and whether the outline has a corner there."""

Term = tuple[int, float]
"""An anchor's number within its outline and its weight."""

Handles = list[tuple[tuple[Term, ...], tuple[Term, ...]]]
"""For each segment i -> i + 1 the two handles as sums of at most three anchors, weights that add to 1."""

LONGEST = 3.0
"""A handle is at most this many thirds of its chord: Hobby's rho grows without bound in a hairpin."""


OUTSIDE = 0.25
"""How much a tangent outside the angle of its chords is doubted."""


def handle_map(anchors: Sequence[Anchor], wary: float = 0.0) -> Handles:
    """Handles of the closed outline through `anchors` as weights of anchors.

    At the anchors given, the handles are exactly those of Hobby's spline (curl 1 at corners). Each smooth anchor's
    tangent is stored as a combination of its two chords, so the outline stays smooth there (G1) however the anchors
    move, and any affine motion carries the curve with it. A corner's tangent looks one chord ahead; `wary` > 0 makes
    it trust that chord less, for outlines that change their shape so much that it would overshoot.
    """
    count = len(anchors)
    z = [complex(x, y) for x, y, _ in anchors]
    corners = [i for i, anchor in enumerate(anchors) if anchor[2]]
    if not corners:
        run = list(range(count))
        return _run_map(run, z, True, 0.0)
    ends = [*corners, corners[0] + count]
    handles: dict[int, tuple[tuple[Term, ...], tuple[Term, ...]]] = {}
    for first, last in pairwise(ends):
        run = [i % count for i in range(first, last + 1)]
        for start, pair in zip(run, _run_map(run, z, False, wary), strict=False):
            handles[start] = pair
    return [handles[i] for i in range(count)]


def _run_map(run: list[int], z: list[complex], closed: bool, wary: float) -> Handles:
    points = _apart([z[i] for i in run])
    count = len(points)
    if count == 2:
        a, b = run
        return [(((a, 2 / 3), (b, 1 / 3)), ((a, 1 / 3), (b, 2 / 3)))]
    leaving, arriving = _hobby(points, closed)
    segments = count if closed else count - 1
    return [
        (
            _as_terms(leaving[i] - points[i], i, run, points, closed, wary),
            _as_terms(arriving[i] - points[(i + 1) % count], (i + 1) % count, run, points, closed, wary),
        )
        for i in range(segments)
    ]


def _apart(points: list[complex]) -> list[complex]:
    """The points, none on top of the one before, so that every chord has a direction."""
    out = points[:1]
    for point in points[1:]:
        out.append(point if abs(point - out[-1]) > 1e-6 else out[-1] + (0.01 + 0.01j))
    return out


def _as_terms(
    arm: complex, i: int, run: list[int], points: list[complex], closed: bool, wary: float
) -> tuple[Term, ...]:
    """The handle `points[i] + arm` as anchors i - 1, i, i + 1 (at an end of an open run: the three nearest)."""
    count = len(points)
    middle = i if closed else min(max(i, 1), count - 2)
    before, after = (middle - 1) % count, (middle + 1) % count
    chord_in, chord_out = points[middle] - points[before], points[after] - points[middle]
    doubts = (0.0, 0.0) if i == middle else ((wary, 0.0) if i < middle else (0.0, wary))
    a, b = _combine(arm, chord_out, chord_in, doubts)
    weights = {before: -b, middle: b - a, after: a}
    weights[i] += 1.0
    return tuple((run[k], w) for k, w in weights.items())


def _combine(arm: complex, first: complex, second: complex, doubts: tuple[float, float]) -> tuple[float, float]:
    """a, b with a * first + b * second nearest to `arm`: exact for chords at an angle, of least norm along a line.

    A doubt > 0 draws the weight of its chord towards 0. A tangent that runs outside the angle of its chords (an
    outline that is all but straight) is doubted of itself: its weights would be large and of opposite signs.
    """
    a, b = _solve(arm, first, second, doubts)
    if a * b < 0 and doubts == (0.0, 0.0):
        a, b = _solve(arm, first, second, (OUTSIDE, OUTSIDE))
    return a, b


def _solve(arm: complex, first: complex, second: complex, doubts: tuple[float, float]) -> tuple[float, float]:
    rows = [[first.real, second.real], [first.imag, second.imag]]
    rows += [[doubts[0] * abs(first), 0.0], [0.0, doubts[1] * abs(second)]]
    a, b = np.linalg.pinv(np.array(rows), rcond=0.02) @ np.array([arm.real, arm.imag, 0.0, 0.0])
    return float(a), float(b)


def _hobby(z: list[complex], closed: bool) -> tuple[list[complex], list[complex]]:
    """Handles leaving each point and arriving at the next, by J. D. Hobby, "Smooth, easy to compute interpolating
    splines" (1986), curl 1 at open ends."""
    count = len(z)
    segments = count if closed else count - 1
    chords = [z[(i + 1) % count] - z[i] for i in range(segments)]
    turns = [
        _wrap(cmath.phase(chords[i % segments]) - cmath.phase(chords[i - 1])) if closed or 0 < i < count - 1 else 0.0
        for i in range(count)
    ]
    theta = _angles([abs(c) for c in chords], turns, closed)
    leaving, arriving = [], []
    for i in range(segments):
        j = (i + 1) % count
        out, into = theta[i], -turns[j] - theta[j]
        leaving.append(z[i] + chords[i] * cmath.rect(min(_rho(out, into), LONGEST) / 3, out))
        arriving.append(z[j] - chords[i] * cmath.rect(min(_rho(into, out), LONGEST) / 3, -into))
    return leaving, arriving


def _angles(lengths: list[float], turns: list[float], closed: bool) -> NDArray[np.float64]:
    """Angle at which the curve leaves each point, from the chord: the mock curvature is continuous."""
    count = len(turns)
    matrix = np.zeros((count, count))
    right = np.zeros(count)
    for i in range(count):
        if not closed and i in (0, count - 1):
            matrix[i, i] = 1.0
            matrix[i, 1 if i == 0 else i - 1] += 1.0
            right[i] = -turns[1] if i == 0 else 0.0
            continue
        before, after = 1 / lengths[i - 1], 1 / lengths[i % len(lengths)]
        matrix[i, i - 1] += before
        matrix[i, i] += 2 * before + 2 * after
        matrix[i, (i + 1) % count] += after
        right[i] = -2 * turns[i] * before - turns[(i + 1) % count] * after
    angles: NDArray[np.float64] = np.linalg.solve(matrix, right).astype(np.float64)
    return angles


def _rho(theta: float, phi: float) -> float:
    sine_t, sine_p, cosine_t, cosine_p = math.sin(theta), math.sin(phi), math.cos(theta), math.cos(phi)
    bend = math.sqrt(2) * (sine_t - sine_p / 16) * (sine_p - sine_t / 16) * (cosine_t - cosine_p)
    return (2 + bend) / (1 + 0.5 * (math.sqrt(5) - 1) * cosine_t + 0.5 * (3 - math.sqrt(5)) * cosine_p)


def _wrap(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi
