"""Outlines of cubics to outlines of fewer numbers: chains of quadratics, each of which begins as the last one ended."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

FINE = 12
"""Samples of a cubic by which a chain is fitted to it."""

SOME = 3
"""Of those samples, how many apart those are at which it is held to the outline ever after."""

ROUNDS = 3
"""How often the samples are given anew to the nearest points of the chain."""

NEAR = 8
"""Places of a quadratic at which they are looked for."""

MOST = 3
"""Quadratics that stand for a cubic at most; beyond that a chain does not pay."""

ENOUGH = 1.7
"""Controls for a cubic from which on it is tried whether two chains are shorter than one."""

BENT = np.cos(np.radians(6.0))
"""Where an outline turns by more there is a corner."""

SHORT = 0.5
"""What is shorter has no direction, in the unit of the points."""

FIRM = 1e-7
"""How firmly controls are held to be small, beside how they are held to the samples."""

T = (np.arange(FINE) + 0.5) / FINE
BERNSTEIN = np.stack([(1 - T) ** 3, 3 * T * (1 - T) ** 2, 3 * T**2 * (1 - T), T**3], axis=1)
SLOPE = np.stack([-((1 - T) ** 2), (1 - T) ** 2 - 2 * T * (1 - T), 2 * T * (1 - T) - T**2, T**2], axis=1)


@dataclass(frozen=True, slots=True)
class Chain:
    """One stretch of a contour without corners, as quadratics.

    Its controls follow from the contour's points by `map`, array[control, point]. A joint lies midway between two
    handles. An open chain begins and ends at its first and last control; all others, and all of a closed one, are
    handles. Samples are `basis` times the controls; `sampled` and `slope` times the points are where the outline is
    there, and which way it runs.
    """

    map: Floats
    closed: bool
    basis: Floats
    sampled: Floats
    slope: Floats

    @property
    def count(self) -> int:
        """Controls."""
        return len(self.map)


@dataclass(frozen=True, slots=True)
class Curves:
    """A shape's outline in few numbers: `map` makes of its points the controls of all chains of all contours in turn.

    Spots are samples and then corners: `spots` times the points, `basis` times the controls. `slope` is the samples'.
    """

    chains: tuple[tuple[Chain, ...], ...]
    map: Floats
    basis: Floats
    spots: Floats
    slope: Floats


def curves(poses: Floats, lengths: Sequence[int], off: float) -> Curves:
    """As few quadratics as stay within about `off` of the outlines `poses`, array[pose, point, xy]; `lengths` are the
    contours' point counts in turn."""
    firsts = np.cumsum([0, *lengths[:-1]])
    contours = [chains(poses[:, first : first + length], off) for first, length in zip(firsts, lengths, strict=True)]
    every = [(chain, first) for first, contour in zip(firsts, contours, strict=True) for chain in contour]
    points, controls = poses.shape[1], sum(chain.count for chain, _ in every)
    starts = np.cumsum([0, *(chain.count for chain, _ in every)])[:-1]
    maps, sampled, slope = (
        np.concatenate([_wide(getattr(chain, part), first, points) for chain, first in every])
        for part in ("map", "sampled", "slope")
    )
    basis = np.concatenate(
        [_wide(chain.basis, start, controls) for (chain, _), start in zip(every, starts, strict=True)]
    )
    corners = [start for (chain, _), start in zip(every, starts, strict=True) if not chain.closed]
    basis = np.concatenate([basis, np.eye(controls)[corners]])
    return Curves(tuple(map(tuple, contours)), maps, basis, np.concatenate([sampled, maps[corners]]), slope)


def _wide(rows: Floats, first: int, columns: int) -> Floats:
    """Rows as rows of a longer table, from column `first` on."""
    wide = np.zeros((len(rows), columns))
    wide[:, first : first + rows.shape[1]] = rows
    return wide


def chains(poses: Floats, off: float) -> list[Chain]:
    """The chains of a contour, each from where the last one ended."""
    segments = (poses.shape[1] - 1) // 3
    corners = [number for number in range(segments) if _corner(poses, number)]
    turned = corners or [0]
    stretches = pairwise([*turned, turned[0] + segments])
    return [
        chain
        for begin, end in stretches
        for chain in _stretch(poses, [number % segments for number in range(begin, end)], not corners, off)
    ]


def _stretch(poses: Floats, segments: list[int], closed: bool, off: float) -> list[Chain]:
    """The chains of a stretch: one, or more where that takes fewer numbers, as at a hairpin."""
    whole = _chain(poses, segments, closed, off)
    place = whole.worst // FINE + (whole.worst % FINE >= FINE // 2)
    if len(segments) == 1 or (whole.missed <= off and whole.count <= ENOUGH * len(segments)):
        return [whole.chain]
    if closed:
        turned = place % len(segments)
        parts = _stretch(poses, segments[turned:] + segments[:turned], False, off)
    else:
        cut = min(max(place, 1), len(segments) - 1)
        parts = _stretch(poses, segments[:cut], False, off) + _stretch(poses, segments[cut:], False, off)
    return parts if whole.missed > off or sum(part.count for part in parts) < whole.count else [whole.chain]


def _corner(poses: Floats, number: int) -> bool:
    """Whether the outline turns sharply at the start of a segment, in any pose."""
    segments = (poses.shape[1] - 1) // 3
    before, after = 3 * ((number - 1) % segments), 3 * number
    into = poses[:, [before + 3]] - poses[:, [before + 2, before + 1, before]]
    out = poses[:, after + 1 : after + 4] - poses[:, [after]]
    return bool((np.sum(_direction(into) * _direction(out), axis=1) < BENT).any())


def _direction(ways: Floats) -> Floats:
    """The direction of the first of the ways array[pose, way, xy] that has any length; none has none."""
    lengths = np.linalg.norm(ways, axis=2)
    first = np.argmax(lengths > SHORT, axis=1)
    poses = np.arange(len(ways))
    return np.asarray(ways[poses, first] / np.maximum(lengths[poses, first], SHORT)[:, None])


@dataclass(frozen=True, slots=True)
class _Fit:
    """A chain, how far it is off, and the sample at which a shorter one was off most."""

    chain: Chain
    missed: float
    worst: int

    @property
    def count(self) -> int:
        return self.chain.count


def _chain(poses: Floats, segments: list[int], closed: bool, off: float) -> _Fit:
    """The shortest chain within `off`, or where none is the longest tried."""
    sampled, slope = (_rows(part, segments, poses.shape[1]) for part in (BERNSTEIN, SLOPE))
    ends = np.eye(poses.shape[1])[[3 * segments[0], 3 * segments[-1] + 3]]
    along, wanted = slope @ poses, sampled @ poses
    across = np.stack([-along[..., 1], along[..., 0]], axis=2)
    across /= np.maximum(np.linalg.norm(along, axis=2), 1e-9)[..., None]
    worst, few = 0, slice(1, None, SOME)
    for count in _counts(3 if closed else 1, len(segments)):
        controls, basis = _fitted(poses.mean(axis=0), sampled, ends, count, closed)
        away = np.abs(((basis @ (controls @ poses) - wanted) * across).sum(axis=2)).max(axis=0)
        missed = float(away.max())
        if missed <= off:
            break
        worst = int(away.argmax())
    return _Fit(Chain(controls, closed, basis[few], sampled[few], slope[few]), missed, worst)


def _counts(least: int, segments: int) -> list[int]:
    """The numbers of quadratics tried: the more there are, the wider apart."""
    found = [max(least, segments // 2)]
    while found[-1] < MOST * segments + 3:
        found.append(max(found[-1] + 1, found[-1] * 6 // 5))
    return found


def _rows(weights: Floats, segments: list[int], points: int) -> Floats:
    """The samples of some segments as sums of a contour's points."""
    rows = np.zeros((len(segments) * FINE, points))
    for place, number in enumerate(segments):
        rows[place * FINE : (place + 1) * FINE, 3 * number : 3 * number + 4] = weights
    return rows


def _fitted(mean: Floats, sampled: Floats, ends: Floats, count: int, closed: bool) -> tuple[Floats, Floats]:
    """The map to `count` quadratics that come nearest to a contour `mean`, and their weights at the samples."""
    wanted = sampled @ mean
    steps = np.linalg.norm(np.diff(wanted, axis=0, prepend=(ends @ mean)[:1]), axis=1)
    whole = np.cumsum([*steps, np.linalg.norm((ends @ mean)[1] - wanted[-1])])
    at = whole[:-1] / max(float(whole[-1]), 1e-9) * count
    fine, drawing = _finely(count, closed)
    for _ in range(ROUNDS):
        basis = _basis(at, count, closed)
        inner = slice(None) if closed else slice(1, -1)
        known = np.zeros_like(sampled) if closed else basis[:, [0, -1]] @ ends
        handles = _nearest(basis[:, inner], sampled - known)
        controls = handles if closed else np.concatenate([ends[:1], handles, ends[1:]])
        drawn = drawing @ (controls @ mean)
        at = fine[np.argmin((drawn**2).sum(axis=1) - 2.0 * (wanted @ drawn.T), axis=1)]
    return controls, basis


@lru_cache(maxsize=512)
def _finely(count: int, closed: bool) -> tuple[Floats, Floats]:
    """Places close together along a chain, and the weights of its controls there."""
    fine = np.linspace(0, count, count * NEAR + 1)
    return fine, _basis(fine, count, closed)


def _nearest(basis: Floats, wanted: Floats) -> Floats:
    """The controls that come nearest to what is wanted; those that no sample tells of stay small."""
    square = basis.T @ basis
    square[np.diag_indices(len(square))] += FIRM * np.trace(square) / len(square)
    return np.asarray(np.linalg.solve(square, basis.T @ wanted))


def _basis(at: Floats, count: int, closed: bool) -> Floats:
    """The weights of a chain's controls at places 0..count along it."""
    number = np.minimum(at.astype(np.intp), count - 1)
    t = at - number
    before, after = (1 - t) ** 2, t**2
    own = 2 * t * (1 - t) + (before + after) / 2
    if not closed:
        first, last = number == 0, number == count - 1
        own -= (first * before + last * after) / 2
        before, after = before * (1 + first), after * (1 + last)
    rows = np.arange(len(at))
    weights = np.zeros((len(at), count if closed else count + 2))
    for handle, weight in ((number, before / 2), (number + 1, own), (number + 2, after / 2)):
        weights[rows, _place(handle, count, closed)] += weight
    return weights


def _place(handle: Ints, count: int, closed: bool) -> Ints:
    """The column of a handle; handles of an open chain count from 1, its ends are 0 and count + 1."""
    return (handle - 1) % count if closed else handle
