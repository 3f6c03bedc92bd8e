"""Phones to what can be told of a mouth by its sound: one of the mouth's shapes a frame, and one of four classes.

The rule is the mouth's own: a phone has the shapes of `mouth/visemes.py`, and a shape's values for `open` and `round`
decide its class. It serves for a voice's phones as for those that were heard.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from facescript.speech.listen.bands import FRAMES_A_SECOND
from facescript.speech.model import PhoneTime
from facescript.speech.mouth.mouthing import CLOSING
from facescript.speech.mouth.visemes import SHAPES, Viseme, visemes

Numbers = NDArray[np.intp]

SILENCE = "rest"

SOUNDS = (SILENCE, "m", "f", "h'", "h", "r", "z", "th", "a", "a-", "e", "i", "o", "u")
"""What is told apart: the mouth's shapes. `a-` is an a of a degree below 1 (æ, ɐ, ʌ), h is also a sound that is hardly
rounded (β), h' also `n`, a Mandarin final."""

SYMBOLS = ("", "m", "f", "n", "ə", "ʃ", "s", "θ", "a", "ɐ", "ɛ", "i", "o", "u")
"""The phone that stands for each. Lips shut for a p or b are an m: they are as shut."""

CLASSES = ("silence", "closed", "narrow", "open", "round")

ROUND, OPEN = 0.65, 0.7
"""From which rounding a shape is round, and from which opening it is open, each times its degree."""

PARTED = Viseme("h", "sound")
"""The mouth of a p or b after its burst where no sound follows."""


def class_of(viseme: Viseme) -> str:
    """The class of a shape: closed where nothing is open (m, and f: lip on teeth); round before open."""
    if viseme.shape == SILENCE:
        return "silence"
    opening, _, rounding, *_ = SHAPES[viseme.shape]
    if opening <= 0.0:
        return "closed"
    if rounding * viseme.degree >= ROUND:
        return "round"
    return "open" if opening * viseme.degree >= OPEN else "narrow"


def sound_of(viseme: Viseme) -> str:
    """The row of `SOUNDS` that a shape belongs to."""
    if viseme.shape == "a" and viseme.degree < 1.0:
        return "a-"
    if viseme.shape in ("o", "u") and class_of(viseme) == "narrow":
        return "h"
    return "h'" if viseme.shape == "n" else viseme.shape


def frames(phones: Sequence[PhoneTime], count: int) -> tuple[Numbers, Numbers]:
    """The places in `SOUNDS` and in `CLASSES` of what the mouth does in the middle of each of `count` frames."""
    sounds, classes = np.zeros(count, dtype=np.intp), np.zeros(count, dtype=np.intp)
    for start, end, viseme in spans(phones):
        first, last = (max(int(np.ceil(time * FRAMES_A_SECOND - 0.5)), 0) for time in (start, end))
        sounds[first:last] = SOUNDS.index(sound_of(viseme))
        classes[first:last] = CLASSES.index(class_of(viseme))
    return sounds, classes


def spans(phones: Sequence[PhoneTime]) -> Iterator[tuple[float, float, Viseme]]:
    """The shapes of phones from second to second, silences left out, each over those before it. A stop's closure lies
    before its burst, in at most half of a sound before it; behind the burst, lips have parted for the next sound."""
    for before, phone, after in zip([None, *phones], phones, [*phones[1:], None], strict=False):
        found = visemes(phone.symbol, phone.stress) if phone.symbol else ()
        if found and found[0].kind == "stop" and before and before.symbol:
            closing = min(CLOSING, (before.end - before.start) / 2.0)
            yield phone.start - closing, phone.start, found[0]
        if found and found[0].shape == "m" and found[0].kind == "stop":
            found = (*found[1:], *(visemes(after.symbol) if after else ())[: len(found) == 1]) or (PARTED,)
        share = (phone.end - phone.start) / max(len(found), 1)
        for index, viseme in enumerate(found):
            yield phone.start + index * share, phone.start + (index + 1) * share, viseme


CLASS = np.array([CLASSES.index(class_of(visemes(symbol)[0])) if symbol else 0 for symbol in SYMBOLS])
"""The class of each sound: array[sound]."""
