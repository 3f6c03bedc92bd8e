"""A recording alone to phones: what is heard in each frame, smoothed to sounds that last, in IPA."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from facescript.speech.listen.bands import ENERGY, F0, FRAMES_A_SECOND, features
from facescript.speech.listen.classes import CLASS, CLASSES, SOUNDS, SYMBOLS
from facescript.speech.listen.network import HEARD, network
from facescript.speech.listen.path import best_path
from facescript.speech.model import PhoneTime
from facescript.speech.sound.recording import Recording

Singles = NDArray[np.float32]
Numbers = NDArray[np.intp]

SHORTEST = dict(zip(CLASSES, (6, 3, 2, 2, 2), strict=True))
"""Frames that the mouth stays in a class: a silence of a tenth of a second is one, a shorter one is a stop."""

SHORTEST_SOUND = 2

CHANGE = 1.0
"""What a change costs, in natural logarithms."""

QUIETEST = -5.0
"""The energy of a frame (about 70 dB below full scale) that a recording with speech in it has somewhere."""

FAINTEST = np.float32(1e-6)

STEADY, VOICED = 1.0, 0.05
"""Powers of ten that the energy of noise stays within, and the part of its frames that may seem to have a voice."""

LOUD = 0.65
"""The share of a recording's vowels, by their energy, that are no louder than its stressed ones."""

VOWELS = "aɐɛiouə"


def listened(recording: Recording) -> tuple[PhoneTime, ...]:
    """The phones of a recording, one after another from its start to its end; "" is silence.

    Nothing is known of its words or language. Each phone stands for all with its shape of the mouth, a vowel with
    `stress` is among the recording's louder ones. A pure function.
    """
    found = features(recording.samples, recording.rate, HEARD)
    if not _may_be_speech(found):
        return (PhoneTime("", 0.0, recording.duration),) if len(found) else ()
    scores = network().scores(found)
    return tuple(_phones(_sounds(scores), found[:, ENERGY], recording.duration))


def _may_be_speech(found: Singles) -> bool:
    """Whether there is more than silence, or noise that is always as loud."""
    energy = found[:, ENERGY]
    if energy.max(initial=QUIETEST) <= QUIETEST:
        return False
    low, high = np.percentile(energy, (10.0, 95.0))
    return bool(high - low > STEADY or (found[:, F0] > 0.0).mean() > VOICED)


def _sounds(scores: Singles) -> Numbers:
    """The place in `SOUNDS` of each frame: the best path of classes, and inside of it the best of sounds."""
    likely = np.exp(scores)
    classes = np.stack([likely[:, place == CLASS].sum(axis=1) for place in range(len(CLASSES))], axis=1)
    shortest = np.array([SHORTEST[name] for name in CLASSES])
    kept = best_path(np.log(classes + FAINTEST), shortest, CHANGE)
    inside = np.where(kept[:, None] == CLASS, scores, scores + 10.0 * np.log(FAINTEST))
    return best_path(inside, np.full(len(SOUNDS), SHORTEST_SOUND), CHANGE)


def _phones(sounds: Numbers, energy: Singles, duration: float) -> Iterator[PhoneTime]:
    """Runs of the same sound as phones; a vowel's stress is told by the loudest frame in it."""
    edges = np.flatnonzero(np.diff(sounds)) + 1
    runs = list(zip([0, *edges], [*edges, len(sounds)], strict=True)) if len(sounds) else []
    symbols = [SYMBOLS[sounds[first]] for first, _ in runs]
    peaks = [float(energy[first:last].max()) for first, last in runs]
    loud = np.quantile([peak for peak, symbol in zip(peaks, symbols, strict=True) if symbol in VOWELS] or [0.0], LOUD)
    for (first, last), symbol, peak in zip(runs, symbols, peaks, strict=True):
        end = min(last / FRAMES_A_SECOND, duration)
        yield PhoneTime(symbol, first / FRAMES_A_SECOND, end, symbol in VOWELS and bool(peak >= loud))
