"""Spoken pieces and silences to one line of sound with its words and phones."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest

from facescript.speech.espeak.client import Heard, Sound
from facescript.speech.model import PhoneTime, Spoken, WordTime
from facescript.speech.mouth.visemes import visemes

RATE = 22_050
"""Samples a second of what espeak-ng speaks."""

LEAD, TAIL = 0.06, 0.04
"""Seconds of quiet kept before the first sound and after the last: a plosive's closure, and the voice's fading."""

PARTING = 0.3
"""The share of an m before its end at which the vowel after it is heard already: espeak-ng tells of a vowel when it is
full, 17 to 31 ms after the lips have parted (bar L2, a vowel inside an utterance)."""

BYTES = 2


@dataclass(frozen=True, slots=True)
class Part:
    """A piece as sound of `rate` Hz; words and phones in seconds from its start, words by characters of the line."""

    pcm: bytes
    words: tuple[WordTime, ...]
    phones: tuple[PhoneTime, ...]
    rate: int = RATE

    @property
    def duration(self) -> float:
        return len(self.pcm) / BYTES / self.rate


def phones(sound: Sound) -> tuple[PhoneTime, ...]:
    """The phones of an utterance one after another, silences whole; a switch of language is silence."""
    starts = [event for event in sound.events if event.kind == "phone"]
    total = len(sound.pcm) / BYTES / RATE
    ends = [event.sample / RATE for event in starts[1:]] + [total]
    found: list[PhoneTime] = []
    for event, end in zip(starts, ends, strict=True):
        phone = _phone(event, min(end, total))
        if phone.end <= phone.start:
            continue
        if found and not found[-1].symbol and not phone.symbol:
            found[-1] = replace(found[-1], end=phone.end)
        else:
            found.append(phone)
    return tuple(_parting(found))


def _parting(found: Sequence[PhoneTime]) -> Iterator[PhoneTime]:
    """The phones, a vowel after an m from where it is heard."""
    moved = 0.0
    for phone, after in zip_longest(found, found[1:]):
        start, moved = phone.start - moved, 0.0
        if phone.symbol == "m" and after and any(each.kind == "vowel" for each in visemes(after.symbol)[:1]):
            moved = PARTING * (phone.end - phone.start)
        yield replace(phone, start=start, end=phone.end - moved)


def _phone(event: Heard, end: float) -> PhoneTime:
    plain = "" if event.symbol.startswith("(") else event.symbol.replace("ˈ", "").replace("ˌ", "")
    return PhoneTime(plain, event.sample / RATE, end, "ˈ" in event.symbol)


def trimmed(part: Part, sounding: tuple[float, float]) -> Part:
    """The part without the quiet beyond `LEAD` and `TAIL` around `sounding`, the stretch in which there is sound."""
    first = round(max(sounding[0] - LEAD, 0) * part.rate)
    last = min(round((sounding[1] + TAIL) * part.rate), len(part.pcm) // BYTES)
    moved = shifted(part, -first / part.rate)
    total = (last - first) / part.rate
    kept = (replace(phone, start=max(phone.start, 0.0), end=min(phone.end, total)) for phone in moved.phones)
    words = (replace(word, start=_inside(word.start, total), end=_inside(word.end, total)) for word in moved.words)
    return Part(
        part.pcm[BYTES * first : BYTES * last], tuple(words), tuple(p for p in kept if p.end > p.start), part.rate
    )


def _inside(time: float, total: float) -> float:
    """A word that the voice leaves out at the end may stand in the quiet that is cut off."""
    return min(max(time, 0.0), total)


def shifted(part: Part, by: float) -> Part:
    """The part's words and phones `by` seconds later."""
    words = (replace(word, start=word.start + by, end=word.end + by) for word in part.words)
    sounds = (replace(phone, start=phone.start + by, end=phone.end + by) for phone in part.phones)
    return replace(part, words=tuple(words), phones=tuple(sounds))


def joined(parts: Sequence[Part | float], rate: int = RATE) -> Part:
    """Parts of one rate one after another; a number is that many seconds of silence."""
    sound = bytearray()
    words: list[WordTime] = []
    sounds: list[PhoneTime] = []
    for part in parts:
        at = len(sound) / BYTES / rate
        if isinstance(part, float):
            sound += bytes(BYTES * round(part * rate))
            sounds.append(PhoneTime("", at, len(sound) / BYTES / rate))
            continue
        moved = shifted(part, at)
        sound += moved.pcm
        words += moved.words
        sounds += moved.phones
    return Part(bytes(sound), tuple(words), tuple(sounds), rate)


def spoken(part: Part) -> Spoken:
    return Spoken(part.pcm, part.rate, part.duration, part.words, part.phones)
