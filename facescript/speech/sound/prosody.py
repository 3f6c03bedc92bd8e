"""Turns the sound of a line into its energy and fundamental frequency (F0), a frame every 10 ms.

F0 is the lag of a peak of the normalised autocorrelation (the frame's, divided by the window's own), and the best path
through the candidates of all frames decides between octaves and between voiced and unvoiced, as Boersma did in 1993.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Samples = NDArray[np.int16]
Singles = NDArray[np.float32]
Numbers = NDArray[np.intp]

HOP = 0.01
"""Seconds from frame to frame; the first stands at the start of the sound."""

LOWEST, HIGHEST = 60.0, 500.0
"""Hz that the F0 of a voice lies between."""

QUIET = -96.0
"""dB of full scale that silence has: the last of 16 bits."""

WINDOW, LOUDNESS = 0.046, 0.025
"""Seconds of sound from which one frame's F0 (2.8 periods of the lowest voice) and one frame's energy are taken."""

BAND = 5_500.0
"""Samples a second, about, at which F0 is looked for; what lies above a third of it is filtered out before."""

SILENT, FLOOR = 35.0, -60.0
"""dB below the loudest frame, and dB of full scale, below which a frame is unvoiced without a look at it."""

FINER = 2
"""Lags to a sample: between two of them a parabola is near enough."""

CANDIDATES = 3
"""Values of F0 that are weighed for each frame, besides that it is unvoiced."""

OCTAVE, THRESHOLD, JUMP, TURN = 0.02, 0.45, 0.35, 0.14
"""What a candidate loses for each octave below the highest, how strong it is that a frame is unvoiced, and what an
octave from one frame to the next and a change of voicing cost, where a pure tone has 1 (Boersma 1993)."""

WEAK, FAINT = -22.0, -34.0
"""dB below the loudest frame of the low band: from the first on a frame is less likely voiced, beyond the second never.
Hiss and hum are not a voice."""

BLOCK = 4_096
"""Frames that are looked at together: what is held does not grow with the line."""

FEW = 4
"""Frames in one product of matrices: so few that it is not shared out among threads, which would wait for each other
and sum up in another order."""


@dataclass(frozen=True, slots=True)
class Prosody:
    """A line's prosody, a frame every `HOP` seconds from its start: `energy` in dB of full scale (at least `QUIET`)
    and `f0` in Hz, 0 where there is no voice; array[frame] both."""

    energy: Floats
    f0: Floats

    @property
    def voiced(self) -> NDArray[np.bool_]:
        return self.f0 > 0.0


def prosody(pcm: bytes | memoryview, rate: int) -> Prosody:
    """The prosody of a sound: mono samples (16-bit little-endian) at `rate` Hz, at least 4,000. A pure function."""
    samples = np.frombuffer(pcm, dtype="<i2")
    count = int(len(samples) / rate / HOP) + 1 if len(samples) else 0
    blocks = [(first, min(first + BLOCK, count)) for first in range(0, count, BLOCK)]
    energy = np.concatenate([np.zeros(0), *(_energy(samples, rate, *block) for block in blocks)])
    loud = energy > max(energy.max(initial=QUIET) - SILENT, FLOOR)
    f0 = np.zeros(count)
    if loud.any():
        search = _search(rate)
        found = [search.at(samples, np.flatnonzero(loud[first:last]) + first) for first, last in blocks]
        candidates, strength, power = (np.concatenate(part) for part in zip(*found, strict=True))
        f0[loud] = path(np.flatnonzero(loud), *_or_unvoiced(candidates, strength, power))
    return Prosody(energy, f0)


def _energy(samples: Samples, rate: int, first: int, last: int) -> Floats:
    """dB of the mean square around each of the frames `first` to `last`; there is silence around the sound."""
    centres = np.arange(first, last) * HOP
    starts, ends = (
        np.clip(np.rint((centres + side * LOUDNESS / 2.0) * rate).astype(np.intp), 0, len(samples))
        for side in (-1.0, 1.0)
    )
    edges = np.unique(np.concatenate([starts, ends]))
    squares = np.square(samples[edges[0] : edges[-1]], dtype=np.int64)
    sums = np.concatenate([[0], np.cumsum(np.add.reduceat(squares, edges[:-1] - edges[0]))])
    mean = np.subtract(*(sums[np.searchsorted(edges, side)] for side in (ends, starts))) / (LOUDNESS * rate)
    level: Floats = np.maximum(10.0 * np.log10(np.maximum(mean, 1e-9) / 32_768.0**2), QUIET)
    return level


@lru_cache(maxsize=8)
def _search(rate: int) -> Search:
    """The search in sound at a rate, kept from line to line."""
    return Search(rate)


class Search:
    """Looks for F0 in sound at `rate` Hz."""

    def __init__(self, rate: int) -> None:
        self._factor = max(round(rate / BAND), 1)
        self._rate = rate / self._factor
        self._half = round(WINDOW * self._rate / 2.0)
        self._fine = FINER * self._rate
        self._lags = np.arange(int(self._fine / HIGHEST) - 1, int(self._fine / LOWEST) + 3)
        self._size = _fast(2 * self._half + int(self._lags[-1]) // FINER + 1)
        self._waves = _cosines(self._size, self._lags)
        self._window = np.hanning(2 * self._half + 1)[:-1].astype(np.float32)
        self._own = self._correlated(self._window[None, :])[0]

    def at(self, samples: Samples, frames: Numbers) -> tuple[Floats, Floats, Floats]:
        """The candidates of `frames`: F0 in Hz (0 where there are fewer) and strength (1 for a pure tone), array[frame,
        candidate] both, and each frame's power in the low band."""
        if not len(frames):
            return np.zeros((0, CANDIDATES)), np.zeros((0, CANDIDATES)), np.zeros(0)
        centres = np.rint(frames * (HOP * self._rate)).astype(np.intp)
        low = _decimated(samples, self._factor, int(centres[0]) - self._half, int(centres[-1]) + self._half)
        cut = sliding_window_view(low, 2 * self._half)[centres - centres[0]]
        cut -= cut.mean(axis=1, keepdims=True)
        cut *= self._window
        power = np.einsum("ij,ij->i", cut, cut).astype(np.float64)
        return (*_peaks(self._correlated(cut) / self._own, self._lags, self._fine), power)

    def _correlated(self, cut: Singles) -> Singles:
        """The autocorrelation of each row at the lags, as if it were 1 at lag 0."""
        spectrum = np.fft.rfft(cut, self._size)
        power = spectrum.real**2 + spectrum.imag**2
        padded = np.concatenate([power, np.zeros((-len(power) % FEW, power.shape[1]), dtype=np.float32)])
        correlated = (padded.reshape(-1, FEW, power.shape[1]) @ self._waves).reshape(len(padded), -1)[: len(power)]
        return (correlated[:, 1:] / np.maximum(correlated[:, :1], 1e-9)).astype(np.float32, copy=False)


def _cosines(size: int, lags: Numbers) -> Singles:
    """The power at each frequency of a spectrum of `size` samples to the autocorrelation at lag 0 and at `lags`:
    array[frequency, 1 + lag]. Few lags are asked for: this is quicker than a transform that gives them all."""
    turns = np.outer(np.arange(size // 2 + 1), np.concatenate([[0], lags]) / (FINER * size))
    waves = 2.0 * np.cos(2.0 * np.pi * turns)
    waves[0] /= 2.0
    return waves.astype(np.float32)


def _fast(size: int) -> int:
    """The next size that the Fourier transform is quick with: 1, 3 or 9 times a power of 2."""
    return min(odd << shift for odd in (1, 3, 9) for shift in range(16) if odd << shift >= size)


def _decimated(samples: Samples, factor: int, first: int, last: int) -> Singles:
    """Every `factor`-th sample of the low band, from number `first` to `last`; there is silence around the sound."""
    taps = np.arange(-4 * factor, 4 * factor + 1)
    weights = np.sinc(taps / (1.5 * factor)) * np.hanning(len(taps) + 2)[1:-1]
    weights /= weights.sum()
    start, end = (first - 4) * factor, (last + 4) * factor
    inside = samples[max(start, 0) : max(end, 0)]
    sound = np.zeros(end - start, dtype=np.float32)
    sound[max(-start, 0) : max(-start, 0) + len(inside)] = inside
    low = np.zeros(last - first, dtype=np.float32)
    for tap, weight in enumerate(weights.astype(np.float32)):
        low += weight * sound[tap : tap + factor * len(low) : factor]
    return low


def _peaks(height: Singles, lags: Numbers, rate: float) -> tuple[Floats, Floats]:
    """The best peaks of each row, each the top of the parabola through its three points: F0 in Hz and strength."""
    before, at, after = height[:, :-2], height[:, 1:-1], height[:, 2:]
    lost = (OCTAVE * np.log2(HIGHEST * lags[1:-1] / rate)).astype(np.float32)
    score = np.where((at > before) & (at >= after) & (at > 0.0), at - lost, np.float32(-1.0))
    best = _highest(score)
    a, b, c = (np.take_along_axis(part, best, axis=1).astype(np.float64) for part in (before, at, after))
    shift = np.clip(0.5 * (a - c) / np.minimum(a - 2.0 * b + c, -1e-9), -0.5, 0.5)
    lag = lags[1:-1][best] + shift
    top = np.minimum(b - 0.25 * (a - c) * shift, 1.0) - OCTAVE * np.log2(HIGHEST * lag / rate)
    real = (np.take_along_axis(score, best, axis=1) > -1.0) & (rate / lag >= LOWEST) & (rate / lag <= HIGHEST)
    return np.where(real, rate / lag, 0.0), np.where(real, top, -1.0)


def _highest(score: Singles) -> Numbers:
    """The places of the `CANDIDATES` highest values of each row, the lowest first: array[row, candidate]."""
    left, rows = score.copy(), np.arange(len(score))
    found = np.empty((len(score), CANDIDATES), dtype=np.intp)
    for place in reversed(range(CANDIDATES)):
        found[:, place] = left.argmax(axis=1)
        left[rows, found[:, place]] = -np.inf
    return found


def _or_unvoiced(f0: Floats, strength: Floats, power: Floats) -> tuple[Floats, Floats]:
    """The candidates with the unvoiced one, F0 0, before them."""
    level = 10.0 * np.log10(np.maximum(power, 1e-9) / max(power.max(), 1e-9))
    unvoiced = THRESHOLD + (1.0 - THRESHOLD) * np.clip((WEAK - level) / (WEAK - FAINT), 0.0, 1.0)
    return np.column_stack([np.zeros(len(f0)), f0]), np.column_stack([unvoiced, strength])


def path(frames: Numbers, f0: Floats, strength: Floats) -> Floats:
    """The F0 of each frame on the path that is best as a whole: its strengths less the costs of its steps (Viterbi).

    `f0` and `strength` are array[frame, candidate]. Frames that do not follow one another are met from silence.
    """
    ways = strength[1:, :, None] - _steps(frames, f0)
    totals = np.empty_like(strength)
    totals[0] = strength[0] - TURN * (f0[0] > 0.0)
    for way, before, total in zip(ways, totals[:-1], totals[1:], strict=True):
        way += before
        np.maximum.reduce(way, axis=1, out=total)
    best: Floats = f0[np.arange(len(f0)), _traced(totals[-1], ways.argmax(axis=2))]
    return best


def _traced(last: Floats, came: Numbers) -> list[int]:
    """The candidate of each frame on the way back from the best of the last; `came` is array[frame - 1, to]: from
    which each is best come to."""
    chosen = [int(last.argmax())]
    for row in reversed(came.tolist()):
        chosen.append(row[chosen[-1]])
    return chosen[::-1]


def _steps(frames: Numbers, f0: Floats) -> Floats:
    """What it costs to come to each candidate of a frame from each of the frame before: array[frame - 1, to, from]."""
    octaves, voiced = np.log2(np.where(f0 > 0.0, f0, 1.0)), f0 > 0.0
    to, come = (slice(1, None), slice(None), None), (slice(None, -1), None, slice(None))
    cost = np.where(voiced[to] & voiced[come], JUMP * np.abs(octaves[to] - octaves[come]), 0.0)
    cost += np.where(voiced[to] ^ voiced[come], TURN, 0.0)
    apart = np.diff(frames) > 1
    cost[apart] = TURN * (1.0 * voiced[1:, :, None] + voiced[:-1, None, :])[apart]
    return cost
