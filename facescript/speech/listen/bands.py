"""Sound to the audio features of the paper (section III-A): twelve critical bands, energy and F0, 60 frames a second.

Frames of 1/60 s stand side by side; each is weighted with a Hamming window and pre-emphasised, H(z) = 1 - 0.97 / z at
16 kHz, and the filter bank is applied to its Fourier spectrum. Pre-emphasis is applied there too, so that sound of any
rate gives the same features without being resampled.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from facescript.speech.sound.prosody import FEW, HOP, prosody

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Samples = NDArray[np.int16]

FRAMES_A_SECOND = 60

CENTRES = (112.0, 255.0, 426.0, 627.0, 860.0, 1147.0, 1483.0, 1937.0, 2452.0, 3299.0, 4128.0, 6811.0)
"""Hz in the middle of each band."""

BETWEEN = (183.0, 339.0, 524.0, 739.0, 996.0, 1305.0, 1693.0, 2176.0, 2837.0, 3689.0, 5316.0)
"""Hz halfway between two bands on the Bark scale: with them, no formant falls through the gaps."""

ENERGY, F0 = -2, -1
"""The last two columns, behind those of the bands."""

PRE_EMPHASIS, PRE_EMPHASIS_RATE = 0.97, 16_000

FULL = 32_768.0

FAINTEST = 1e-9
"""The energy that is told of what has none; a frame of the last of 16 bits has a hundred times as much."""

BLOCK = 3_600
"""Frames whose spectra are held at once: a minute."""


def bark(hertz: float | Floats) -> Floats:
    """The place of a frequency on the scale of critical bands (equation 1)."""
    places: Floats = 13.0 * np.arctan(0.76 * np.asarray(hertz) / 1000.0) + 3.5 * np.arctan(
        np.square(np.asarray(hertz) / 7500.0)
    )
    return places


def bandwidth(hertz: float) -> float:
    """Hz of the critical band around a frequency (equation 2)."""
    return float(25.0 + 75.0 * (1.0 + 1.4 * (hertz / 1000.0) ** 2) ** 0.69)


def features(samples: Samples, rate: int, centres: tuple[float, ...] = CENTRES) -> Singles:
    """The features of mono sound at `rate` Hz: array[frame, bands, energy, F0]; 14 with the paper's bands.

    Frame i lies from i / 60 to (i + 1) / 60 s; the last is filled up with silence. Bands and energy are the decimal
    logarithm of the energy in a frame (equation 3; full scale is 1), F0 is in Hz, 0 where there is no voice. What a
    sound below 16 kHz cannot have is as faint as silence. A pure function; of the sound, a minute is held at a time.
    """
    count = -(-len(samples) * FRAMES_A_SECOND // rate)
    found = np.empty((count, len(centres) + 2), dtype=np.float32)
    for first in range(0, count, BLOCK):
        last = min(first + BLOCK, count)
        found[first:last, :F0] = _energies(samples, rate, first, last, centres)
    found[:, F0] = _f0(samples, rate, count)
    return found


def _energies(samples: Samples, rate: int, first: int, last: int, centres: tuple[float, ...]) -> Singles:
    """The bands and the energy of the frames `first` to `last`."""
    size = -(-rate // FRAMES_A_SECOND)
    starts = np.arange(first, last) * rate // FRAMES_A_SECOND
    begin, end = int(starts[0]), int(starts[-1]) + size
    sound = np.zeros(end - begin, dtype=np.float32)
    part = samples[begin:end]
    sound[: len(part)] = part
    frames = sound[(starts - begin)[:, None] + np.arange(size)] * (np.hamming(size) / FULL).astype(np.float32)
    spectrum = np.fft.rfft(frames, _transform(size))
    power = spectrum.real**2 + spectrum.imag**2
    energies = product(power.astype(np.float32), filters(rate, centres))
    logarithms: Singles = np.log10(np.maximum(energies, FAINTEST))
    return logarithms


def product(rows: Singles, weights: Singles) -> Singles:
    """The product of two matrices, always the same: a few rows at a time are not shared out among threads."""
    padded = np.concatenate([rows, np.zeros((-len(rows) % FEW, rows.shape[1]), dtype=np.float32)])
    found: Singles = (padded.reshape(-1, FEW, rows.shape[1]) @ weights).reshape(len(padded), -1)[: len(rows)]
    return found


def _transform(size: int) -> int:
    return 1 << (size - 1).bit_length()


@lru_cache(maxsize=8)
def filters(rate: int, centres: tuple[float, ...] = CENTRES) -> Singles:
    """Power spectrum to energies at a rate: array[frequency, band and the whole]. A band is a normal curve over
    frequency with the area of its critical band; by Parseval, the sum over the spectrum is that over the samples."""
    size = _transform(-(-rate // FRAMES_A_SECOND))
    hertz = np.arange(size // 2 + 1) * (rate / size)
    turns = 2.0 * np.pi * np.minimum(hertz, PRE_EMPHASIS_RATE / 2) / PRE_EMPHASIS_RATE
    emphasis = np.abs(1.0 - PRE_EMPHASIS * np.exp(-1j * turns)) ** 2
    columns = [emphasis * np.exp(-np.pi * np.square((hertz - centre) / bandwidth(centre))) for centre in centres]
    columns.append((hertz <= PRE_EMPHASIS_RATE / 2).astype(np.float64))
    scale = 2.0 / size * (PRE_EMPHASIS_RATE / rate)
    return (np.column_stack(columns) * scale).astype(np.float32)


def _f0(samples: Samples, rate: int, count: int) -> Singles:
    """F0 in the middle of each frame."""
    tracked = prosody(np.ascontiguousarray(samples, dtype="<i2").data, rate).f0
    middles = (np.arange(count) + 0.5) / FRAMES_A_SECOND
    places = np.minimum(np.rint(middles / HOP).astype(np.intp), len(tracked) - 1)
    found: Singles = tracked[places].astype(np.float32) if len(tracked) else np.zeros(count, dtype=np.float32)
    return found
