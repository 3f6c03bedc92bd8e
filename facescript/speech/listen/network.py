"""Features to how likely each sound is in each frame: a small network that looks a tenth of a second to either side.

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
"""Hz in the middle of the bands that are listened to."""

REACH = 6
"""Frames to either side that are looked at."""

LOUD = 95.0
"""The percentile of the energies of sounding frames that is the recording's own loudness."""

SPEAKING, FLOOR = 3.0, 4.5
"""How far below that, in powers of ten, a frame still counts as speech, and where everything is as silent as can be."""

USUAL = 90.0
"""Frames of the usual speaker that are put before every recording, for a short one is not like itself."""

HERTZ = 150.0
"""F0 that is 0 in the octaves that are told."""

WHOLE = 32_767
"""What the largest weight of a layer is written as."""

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
    """The inputs of the frames `first` to `last`: what is `REACH` frames to either side, and the voice's height once;
    the first and the last frame stand for what is beyond."""
    places = np.arange(first, last)[:, None] + np.arange(-REACH, REACH + 1)
    near = columns[np.clip(places, 0, len(columns) - 1), :-1].reshape(last - first, -1)
    return np.column_stack([near, columns[first:last, -1]])


class Network:
    """Layers of weights: array[in + 1, out] each, the last row added; tanh between them."""

    def __init__(self, layers: Sequence[Singles], usual: Singles) -> None:
        self.layers, self.usual = tuple(layers), usual

    def scores(self, found: Singles) -> Singles:
        """The natural logarithm of how likely each sound is in each frame: array[frame, sound]."""
        columns = heights(found, self.usual)
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
    layers = [_unpacked(layer["values"], layer["columns"]) * np.float32(layer["scale"]) for layer in kept["layers"]]
    return Network(layers, np.array(kept["usual"], dtype=np.float32))


def packed(network: Network) -> str:
    """A network as the text that `network` reads: weights in 16-bit whole numbers times a scale, in base 64."""
    layers = []
    for layer in network.layers:
        scale = float(np.abs(layer).max()) / WHOLE
        whole = np.rint(layer / scale).astype("<i2")
        values = b64encode(whole.tobytes()).decode("ascii")
        layers.append({"columns": layer.shape[1], "scale": scale, "values": values})
    return json.dumps({"usual": [round(float(value), 4) for value in network.usual], "layers": layers}, indent=1) + "\n"


def _unpacked(values: str, columns: int) -> Singles:
    whole = np.frombuffer(b64decode(values), dtype="<i2").reshape(-1, columns)
    return whole.astype(np.float32)
