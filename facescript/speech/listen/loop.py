"""English sound to its phones by pocketsphinx's phoneme loop: no words, but all that it has learnt of English speech.

pocketsphinx is the extra `english`; its model of English comes with it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from importlib.util import find_spec
from types import MappingProxyType
from typing import Any

import numpy as np

from facescript.speech.model import PhoneTime
from facescript.speech.sound.recording import Recording, Samples
from facescript.speech.sound.resample import resampled, resampled_length
from facescript.speech.timing.alphabets import to_ipa

STOPS = "pbtdkɡcɟʈɖ"

CLOSURE = 2.0 / 3.0
"""The part of a stop that is its closure: a `PhoneTime` begins at the burst behind it."""

RATE, FRAMES_A_SECOND = 16_000, 100
"""Samples and frames a second of pocketsphinx's model."""

LONGEST, SHORTEST = 20.0, 10.0
"""Seconds of sound that are decoded at once: it is cut where it is quietest between the two."""

SPAN = 800
"""Samples around a cut that are to be quiet: a twentieth of a second."""

SETTINGS: MappingProxyType[str, Any] = MappingProxyType({"lw": 2.0, "beam": 1e-20, "pbeam": 1e-20, "loglevel": "FATAL"})


def installed() -> bool:
    """Whether the extra `english` is there."""
    return find_spec("pocketsphinx") is not None


def looped(recording: Recording) -> tuple[PhoneTime, ...]:
    """The phones of a recording in English, one after another; "" is silence. The extra must be installed."""
    count = resampled_length(len(recording.samples), recording.rate, RATE)
    found: list[PhoneTime] = []
    first = 0
    while first < count:
        rough = resampled(recording.samples, recording.rate, RATE, first, min(first + round(LONGEST * RATE), count))
        sound = np.clip(np.rint(rough), -32_768, 32_767).astype("<i2")
        if first + len(sound) < count:
            sound = sound[: _quietest(sound)]
        found += _decoded(sound, first / RATE)
        first += len(sound)
    return tuple(bursting(found))


def _quietest(sound: Samples) -> int:
    """The sample behind `SHORTEST` around which there is least sound."""
    energy = np.cumsum(np.square(sound[round(SHORTEST * RATE) :].astype(np.float64)))
    return round(SHORTEST * RATE) + SPAN // 2 + int(np.argmin(energy[SPAN:] - energy[:-SPAN]))


def _decoded(sound: Samples, start: float) -> list[PhoneTime]:
    """The phones of a stretch that begins at second `start`; a decoder of its own, which remembers nothing."""
    from pocketsphinx import Decoder, get_model_path

    model = f"{get_model_path()}/en-us/en-us"
    decoder = Decoder(hmm=model, allphone=f"{model}-phone.lm.bin", **SETTINGS)
    decoder.start_utt()
    decoder.process_raw(sound.tobytes(), full_utt=True)
    decoder.end_utt()
    ends = [(segment.word, (segment.end_frame + 1) / FRAMES_A_SECOND) for segment in decoder.seg() or ()]
    return labelled(ends, len(sound) / RATE, start)


def labelled(segments: Sequence[tuple[str, float]], duration: float, start: float = 0.0) -> list[PhoneTime]:
    """Names of CMU's phones with the seconds at which they end, from `start` to the end of the sound."""
    found: list[PhoneTime] = []
    at = 0.0
    symbols = to_ipa([name for name, _ in segments])
    for (_, end), (symbol, _) in zip(segments, symbols, strict=True):
        last = min(end, duration)
        if last > at:
            found.append(PhoneTime(symbol, start + at, start + last))
            at = last
    return [*found, PhoneTime("", start + at, start + duration)] if at < duration else found


def bursting(phones: Sequence[PhoneTime]) -> Iterator[PhoneTime]:
    """Phones whose stops begin with their closure to phones whose stops begin at their burst: the closure becomes a
    part of what is before."""
    moved = 0.0
    for phone, after in zip(phones, [*phones[1:], None], strict=True):
        start, moved = phone.start + moved, 0.0
        if after and after.symbol and after.symbol in STOPS:
            moved = CLOSURE * (after.end - after.start)
        yield replace(phone, start=start, end=phone.end + moved)
