"""Spoken pieces and silences to one line of sound with its words and phones."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
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

Take = Callable[[bytes], None]
"""Gets the sound of a line in order, in stretches, while the line is being spoken."""


def unheard(pcm: bytes) -> None:
    """What takes the sound of a line that nobody waits for."""


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


class Trim:
    """Hands on the sound of an utterance while it is made, cut as `trimmed` cuts it: the same bytes."""

    def __init__(self, take: Take) -> None:
        self._take = take
        self._sound = bytearray()
        self._first: int | None = None
        self._sure = self._given = 0
        self._before: Heard | None = None

    def __call__(self, stretch: Sound) -> None:
        """Take in the next stretch, and hand on what lies before the last phone that is heard: that is sure to stay."""
        self._sound += stretch.pcm
        for event in stretch.events:
            if event.kind == "phone":
                self._begin(event)
        if self._first is not None:
            self._hand_on(self._sound[self._first + self._given : self._sure])

    def finish(self, part: Part) -> None:
        """Hand on the rest of what has become `part`."""
        self._hand_on(part.pcm[self._given :])

    def _begin(self, event: Heard) -> None:
        before, self._before = self._before, event
        if self._first is None and before and _symbol(before) and event.sample > before.sample:
            self._first = BYTES * _first_sample(before.sample / RATE, RATE)
        if _symbol(event):
            self._sure = BYTES * event.sample

    def _hand_on(self, pcm: bytes | bytearray) -> None:
        if pcm:
            self._given += len(pcm)
            self._take(bytes(pcm))


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
    return PhoneTime(_symbol(event), event.sample / RATE, end, "ˈ" in event.symbol)


def _symbol(event: Heard) -> str:
    return "" if event.symbol.startswith("(") else event.symbol.replace("ˈ", "").replace("ˌ", "")


def trimmed(part: Part, sounding: tuple[float, float]) -> Part:
    """The part without the quiet beyond `LEAD` and `TAIL` around `sounding`, the stretch in which there is sound."""
    first = _first_sample(sounding[0], part.rate)
    last = min(round((sounding[1] + TAIL) * part.rate), len(part.pcm) // BYTES)
    moved = shifted(part, -first / part.rate)
    total = (last - first) / part.rate
    kept = (replace(phone, start=max(phone.start, 0.0), end=min(phone.end, total)) for phone in moved.phones)
    words = (replace(word, start=_inside(word.start, total), end=_inside(word.end, total)) for word in moved.words)
    return Part(
        part.pcm[BYTES * first : BYTES * last], tuple(words), tuple(p for p in kept if p.end > p.start), part.rate
    )


def _first_sample(sounding: float, rate: int) -> int:
    """The sample at which a part begins whose first sound is at `sounding` seconds."""
    return round(max(sounding - LEAD, 0) * rate)


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
