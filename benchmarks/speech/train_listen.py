"""Trains the recogniser of mouth shapes and writes its weights: `python benchmarks/speech/train_listen.py`.

An hour on one core; the same machine and libraries give the same weights. It needs what `listen_people.py` and
`listen_voices.py` name. Nothing that is measured (`measure_listen.py`: its voices, people and sentences) is trained on.
Its figures were looked at between trials, and so had a part in six choices: that people's voices are trained on too,
and which; bands between the paper's; how far to either side is looked; that throats of five lengths are tried; how many
weights there are, and how long they learn; and that all classes are alike in the end.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
from listen_takes import Lesson, lessons
from numpy.random import Generator, default_rng
from numpy.typing import NDArray

from facescript.speech.listen import network
from facescript.speech.listen.bands import ENERGY, FAINTEST
from facescript.speech.listen.classes import CLASS, CLASSES, SOUNDS
from facescript.speech.listen.network import BANDS, FLOOR, LOUD, PLACES, SPEAKING, Network, around, heights, packed

Singles = NDArray[np.float32]
Numbers = NDArray[np.intp]

SEED = 5
HIDDEN = (256, 128)
EPOCHS, SHARE, BATCH = 40, 0.5, 512
"""How often a share of the takes, by chance, is learnt from."""

RATE, DECAY = 2e-3, 1e-4
"""Adam's step at the start (it falls by half a cosine), and how fast weights shrink."""

FIELD, OWN, BLUR = 0.2, 0.25, 0.1
"""Powers of ten by which bands differ by chance: from moment to moment, and for all of a sound in a take; and what is
added to every input."""

MOMENT, NEAR = 6, 3.0
"""Frames and bands over which such chance is alike."""

EVEN, SILENT, PERSON = 0.8, 0.5, 1.0
"""How far rare classes count for more while it learns (1: all classes alike), what silence counts, and what takes of
people do."""

SHUT = 0.5
"""What is added for closed lips, in natural logarithms: a mouth that stays open in a b is seen most."""


def usual(taken: Sequence[Lesson]) -> Singles:
    """The mean of all speech against its take's loudness: array[band]."""
    sums, count = np.zeros(len(BANDS)), 0
    for lesson in taken:
        energy = lesson.features[:, ENERGY]
        loud = np.percentile(energy[energy > np.log10(FAINTEST) + 0.5], LOUD)
        speech = lesson.features[energy > loud - SPEAKING, : len(BANDS)] - loud
        sums += np.maximum(speech, -FLOOR - 1.0).sum(axis=0)
        count += len(speech)
    return (sums / count).astype(np.float32)


def changed(lesson: Lesson, rng: Generator) -> Singles:
    """The features of a take as another speaker's would differ: each sound a little, and each moment."""
    found = lesson.features.copy()
    count, bands = len(found), len(BANDS)
    alike = np.exp(-0.5 * np.square((np.arange(bands)[:, None] - np.arange(bands)) / NEAR))
    alike /= np.sqrt(np.square(alike).sum(axis=0))
    own = OWN * rng.standard_normal((len(SOUNDS), bands)) @ alike
    moments = FIELD * rng.standard_normal((count // MOMENT + 3, bands)) @ alike
    places = np.arange(count) / MOMENT + rng.random()
    whole = places.astype(np.intp)
    part = (places - whole)[:, None]
    found[:, :bands] += own[lesson.sounds] + moments[whole] * (1.0 - part) + moments[whole + 1] * part
    found[:, ENERGY] += 0.5 * OWN * rng.standard_normal(len(SOUNDS))[lesson.sounds]
    found[:, :-1] = np.maximum(found[:, :-1], np.log10(FAINTEST))
    return found


def inputs(taken: Sequence[Lesson], mean: Singles, rng: Generator) -> Singles:
    parts = []
    for lesson in taken:
        columns = heights(changed(lesson, rng), mean)
        parts.append(around(columns, 0, len(columns)))
    return np.concatenate(parts)


def counted(taken: Sequence[Lesson]) -> Singles:
    """What each frame counts: array[frame], 1 in the mean."""
    classes = np.concatenate([lesson.classes for lesson in taken])
    shares = np.bincount(classes, minlength=len(CLASSES)) / len(classes)
    counts = shares**-EVEN
    counts[0] *= SILENT
    people = np.concatenate([np.full(len(lesson.classes), PERSON if lesson.person else 1.0) for lesson in taken])
    weights = counts[classes] * people
    return (weights / weights.mean()).astype(np.float32)


class Adam:
    """Layers of weights, and what their gradients were."""

    def __init__(self, sizes: Sequence[int], rng: Generator) -> None:
        shapes = list(pairwise(sizes))
        self.layers = [np.vstack([rng.normal(0.0, a**-0.5, (a, b)), np.zeros((1, b))]) for a, b in shapes]
        self.layers = [layer.astype(np.float32) for layer in self.layers]
        self.means = [np.zeros_like(layer) for layer in self.layers]
        self.squares = [np.zeros_like(layer) for layer in self.layers]
        self.steps = 0

    def step(self, gradients: Sequence[Singles], rate: float) -> None:
        self.steps += 1
        for layer, mean, square, gradient in zip(self.layers, self.means, self.squares, gradients, strict=True):
            mean += 0.1 * (gradient - mean)
            square += 0.001 * (gradient * gradient - square)
            size = np.sqrt(square / (1.0 - 0.999**self.steps)) + 1e-8
            layer -= rate * (mean / (1.0 - 0.9**self.steps) / size + DECAY * layer)


def gradients(layers: Sequence[Singles], values: Singles, truth: Numbers, counts: Singles) -> list[Singles]:
    """How the cross entropy changes with the weights of each layer."""
    reached = [values]
    for layer in layers[:-1]:
        reached.append(np.tanh(reached[-1] @ layer[:-1] + layer[-1]))
    scores = reached[-1] @ layers[-1][:-1] + layers[-1][-1]
    fault = np.exp(scores - scores.max(axis=1, keepdims=True))
    fault /= fault.sum(axis=1, keepdims=True)
    fault[np.arange(len(truth)), truth] -= 1.0
    fault *= counts[:, None] / len(truth)
    found: list[Singles] = []
    for layer, before in zip(reversed(layers), reversed(reached), strict=True):
        found.append(np.vstack([before.T @ fault, fault.sum(axis=0)]))
        fault = (fault @ layer[:-1].T) * (1.0 - before * before)
    return found[::-1]


def trained(taken: Sequence[Lesson]) -> Network:
    rng = default_rng(SEED)
    mean, counts = usual(taken), counted(taken)
    total = EPOCHS * int(SHARE * len(counts) / BATCH)
    adam = Adam((len(PLACES) * (len(BANDS) + 2) + 1, *HIDDEN, len(SOUNDS)), rng)
    edges = np.cumsum([0, *(len(lesson.sounds) for lesson in taken)])
    for epoch in range(EPOCHS):
        chosen = rng.permutation(len(taken))[: int(SHARE * len(taken))]
        parts = [taken[place] for place in chosen]
        part_counts = np.concatenate([counts[edges[place] : edges[place + 1]] for place in chosen])
        learn(adam, parts, part_counts, mean, total, rng)
        print(f"epoch {epoch + 1} of {EPOCHS}", flush=True)
    adam.layers[-1][-1] += evened(taken)
    return Network(adam.layers, mean)


def learn(adam: Adam, taken: Sequence[Lesson], counts: Singles, mean: Singles, total: int, rng: Generator) -> None:
    """Goes through takes once; `total` is the steps of all times."""
    values, truth = inputs(taken, mean, rng), np.concatenate([lesson.sounds for lesson in taken])
    order = rng.permutation(len(truth))
    for first in range(0, len(truth) - BATCH + 1, BATCH):
        part = order[first : first + BATCH]
        blurred = values[part] + BLUR * rng.standard_normal((BATCH, values.shape[1]), dtype=np.float32)
        rate = RATE * 0.5 * (1.0 + np.cos(np.pi * min(adam.steps / total, 1.0))) + 1e-6
        adam.step(gradients(adam.layers, blurred, truth[part], counts[part]), rate)


def evened(taken: Sequence[Lesson]) -> Singles:
    """What is added to the score of each sound, so that in the end all classes but silence are alike, and closed lips
    a little more."""
    classes = np.concatenate([lesson.classes for lesson in taken])
    added = (EVEN - 1.0) * np.log(np.bincount(classes, minlength=len(CLASSES)) / len(classes))
    added[0] = 0.0
    added[CLASSES.index("closed")] += SHUT
    return added[CLASS].astype(np.float32)


def main() -> None:
    taken = list(lessons(SEED))
    print(f"{sum(len(lesson.sounds) for lesson in taken)} frames of {len(taken)} takes", flush=True)
    path = Path(network.__file__).with_name("weights.json")
    path.write_text(packed(trained(taken)), "ascii")


if __name__ == "__main__":
    main()
