"""Several channels of sound to the weights with which they are mixed to one, so that what is heard stays heard."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

UNHEARD = 0.01
"""A channel with less than this part of the loudest one's power (20 dB below) is left out: one may be empty."""

AGAINST = 0.25
"""Where a mix has less than this part of the loudest channel's power, channels work against each other."""


class Channels:
    """What is known of sound in `count` channels after each block of it: the powers, and how alike they are."""

    def __init__(self, count: int) -> None:
        self._products: Floats = np.zeros((count, count))

    def add(self, block: NDArray[np.int16]) -> None:
        """A block of the sound, array[sample, channel]."""
        values = block.astype(np.float64)
        self._products += np.einsum("si,sj->ij", values, values)

    def weights(self) -> Floats:
        """A weight a channel, which sum to 1: the mean of those that are heard, or the loudest alone where the mean
        would all but vanish."""
        powers = np.diagonal(self._products)
        heard = powers > UNHEARD * powers.max()
        if not heard.any():
            return np.full(len(powers), 1.0 / len(powers))
        mean = heard / heard.sum()
        if mean @ self._products @ mean >= AGAINST * powers.max() / heard.sum():
            return np.asarray(mean)
        return np.asarray(np.arange(len(powers)) == int(powers.argmax()), dtype=np.float64)
