"""Features to how likely each sound is in each frame: a small network that looks a fifth of a second to either side.

Its weights are what `benchmarks/speech/train_listen.py` found; they are whole numbers in a file of this package.
"""

from __future__ import annotations

import json
from base64 import b64decode, b64encode
from collections.abc import Sequence
from functools import cache
from importlib.resources import files

import numpy as np
from numpy.typing import NDArray

from facescript.speech.listen.bands import BETWEEN, CENTRES, ENERGY, F0, FAINTEST, product

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]

BANDS = tuple(sorted(CENTRES + BETWEEN))
"""Hz in the middle of the bands that the network knows."""

THROATS = (0.82, 0.91, 1.0, 1.1, 1.2)
"""How many times as high a speaker's formants may be as those of the usual one."""

HEARD = tuple(throat * band for throat in THROATS for band in BANDS)
"""Hz in the middle of the bands that are listened to: those of each throat."""

STARTS = range(0, len(HEARD), len(BANDS))
"""The column at which the bands of each throat begin."""

LEAST = np.float32(1e-12)

CERTAIN = 0.1
"""How much a frame's certainty counts for a throat, for frames that follow each other are alike."""

PLACES = np.array((-12, -9, -7, -5, -4, -3, -2, -1, 0, 1, 2, 3, 4, 5, 7, 9, 12))
"""The frames that are looked at, from the one that is told of."""

LOUD = 95.0
"""The percentile of the energies of sounding frames that is the recording's own loudness."""

SPEAKING, FLOOR = 3.0, 4.5
"""How far below that, in powers of ten, a frame still counts as speech, and where everything is as silent as can be."""

USUAL = 90.0
"""Frames of the usual speaker that are put before every recording, for a short one is not like itself."""

HERTZ = 150.0
"""F0 that is 0 in the octaves that are told."""

WHOLE = 127
"""What the largest weight of a layer's column is written as."""

BLOCK = 4_096
"""Frames that go through the network at once."""


def heights(found: Singles, usual: Singles) -> Singles:
    """Features to what is alike in all recordings: array[frame, bands, energy, voiced, octaves of the voice].

    Bands are powers of ten above the mean of the recording's speech, which `usual` (the same of all speakers, against
    the loudness) steadies; the energy is above the loudness; the voice's height is one number for the whole recording.
    """
    energy = found[:, ENERGY]
    sounding = energy[energy > np.log10(FAINTEST) + 0.5]
    loud = np.float32(np.percentile(sounding, LOUD) if len(sounding) else 0.0)
    level = np.maximum(found[:, :F0] - loud, -FLOOR - np.float32(1.0))
    speech = level[energy > loud - SPEAKING, :-1]
    mean = (speech.sum(axis=0) + USUAL * usual) / (len(speech) + USUAL)
    level[:, :-1] = np.maximum(level[:, :-1] - mean, -FLOOR)
    voiced = found[:, F0] > 0.0
    octaves = np.log2(np.median(found[voiced, F0]) / HERTZ) if voiced.any() else 0.0
    columns: Singles = np.column_stack([level, voiced, np.full(len(found), octaves)]).astype(np.float32)
    return columns


def around(columns: Singles, first: int, last: int) -> Singles:
    """The inputs of the frames `first` to `last`: what is at `PLACES` from each, and the voice's height once; the first
    and the last frame stand for what is beyond."""
    places = np.arange(first, last)[:, None] + PLACES
    near = columns[np.clip(places, 0, len(columns) - 1), :-1].reshape(last - first, -1)
    return np.column_stack([near, columns[first:last, -1]])


class Network:
    """Layers of weights: array[in + 1, out] each, the last row added; tanh between them."""

    def __init__(self, layers: Sequence[Singles], usual: Singles) -> None:
        self.layers, self.usual = tuple(layers), usual

    def scores(self, found: Singles) -> Singles:
        """The natural logarithm of how likely each sound is in each frame: array[frame, sound].

        `found` are the features with the bands of `HEARD`. What each throat's bands say counts the more, the more
        certain the network is with them as a whole: the speaker's own are those that it has learnt from most.
        """
        said = [self._said(found[:, place : place + len(BANDS)], found[:, ENERGY:]) for place in STARTS]
        certain = CERTAIN * np.array([each.max(axis=1).sum() for each in said], dtype=np.float64)
        shares = np.exp(certain - certain.max())
        shares /= shares.sum()
        likely = sum(np.float32(share) * np.exp(each) for share, each in zip(shares, said, strict=True))
        scores: Singles = np.log(likely + LEAST)
        return scores

    def _said(self, bands: Singles, rest: Singles) -> Singles:
        """The scores by the bands of one throat, and energy and F0."""
        columns = heights(np.column_stack([bands, rest]), self.usual)
        blocks = [
            self._through(around(columns, first, min(first + BLOCK, len(columns))))
            for first in range(0, len(columns), BLOCK)
        ]
        return np.concatenate(blocks) if blocks else np.zeros((0, self.layers[-1].shape[1]), dtype=np.float32)

    def _through(self, values: Singles) -> Singles:
        for layer in self.layers[:-1]:
            values = np.tanh(product(values, layer[:-1]) + layer[-1])
        scores = product(values, self.layers[-1][:-1]) + self.layers[-1][-1]
        scores -= scores.max(axis=1, keepdims=True)
        likely: Singles = scores - np.log(np.exp(scores).sum(axis=1, keepdims=True))
        return likely


@cache
def network() -> Network:
    """The network of this package."""
    kept = json.loads((files(__package__) / "weights.json").read_text("ascii"))
    layers = [_unpacked(layer["values"], layer["scales"]) for layer in kept["layers"]]
    return Network(layers, np.array(kept["usual"], dtype=np.float32))


def packed(network: Network) -> str:
    """A network as the text that `network` reads: weights in 8-bit whole numbers times their column's scale, in base
    64."""
    layers = []
    for layer in network.layers:
        scales = np.round(np.abs(layer).max(axis=0) / WHOLE, 7)
        whole = np.rint(layer / scales).clip(-WHOLE, WHOLE).astype(np.int8)
        values = b64encode(whole.tobytes()).decode("ascii")
        layers.append({"scales": " ".join(f"{scale:.7f}" for scale in scales), "values": values})
    return json.dumps({"usual": [round(float(value), 4) for value in network.usual], "layers": layers}, indent=1) + "\n"


def _unpacked(values: str, scales: str) -> Singles:
    columns = np.array(scales.split(), dtype=np.float32)
    return np.frombuffer(b64decode(values), dtype=np.int8).reshape(-1, len(columns)) * columns
