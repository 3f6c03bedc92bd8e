"""piper's phonemes, a letter or a mark each, with their lengths in samples, to phones with their times."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Sequence

from facescript.speech.model import PhoneTime
from facescript.speech.mouth.visemes import visemes

STRESS, WEAK = "ˈ", "ˌ"


def phones(sounds: Iterable[tuple[str, int]], rate: int) -> tuple[PhoneTime, ...]:
    """The phones of a sentence one after another; a stress is on the vowel that comes next.

    A mark belongs to the letter that it stands at, a space to what is before it; all else, and what stands before the
    first sound and behind the last, is silence.
    """
    found: list[PhoneTime] = []
    start, at, stress = 0, 0, False
    for sign, samples in sounds:
        at += samples
        if sign in (STRESS, WEAK):
            stress = sign == STRESS
            continue
        if found and _is_mark(sign):
            last = found[-1]
            symbol = last.symbol + _written(sign) if last.symbol else ""
            found[-1] = PhoneTime(symbol, last.start, at / rate, last.stress)
        else:
            symbol = sign if _is_letter(sign) else ""
            vowel = any(shape.kind == "vowel" for shape in visemes(symbol)[:1])
            found.append(PhoneTime(symbol, start / rate, at / rate, stress and vowel))
            stress = stress and not vowel
        start = at
    return tuple(phone for phone in found if phone.end > phone.start)


def symbols(spelt: Sequence[str]) -> tuple[str, ...]:
    """The symbols of the phones of a word."""
    return tuple(phone.symbol for phone in phones(((sign, 1) for sign in spelt), 1) if phone.symbol)


def _is_letter(sign: str) -> bool:
    return unicodedata.category(sign[0])[0] == "L"


def _is_mark(sign: str) -> bool:
    """Whether a sign belongs to the one before: a length, a sign over or behind a letter, a tone, a space."""
    return sign == " " or unicodedata.category(sign[0]) in ("Lm", "Mn", "Nd")


def _written(mark: str) -> str:
    """What a mark adds to the symbol: a tone or a space nothing."""
    return "" if mark == " " or mark.isdecimal() else mark
