"""What aligning finds: words with how sure they are, phones, and both as a file of times has them."""

from __future__ import annotations

from dataclasses import dataclass, replace

from facescript.speech.mandarin.syllables import PREFIX
from facescript.speech.model import Doubt, PhoneTime, WordTime
from facescript.speech.timing.times import TimedWord, Times


@dataclass(frozen=True, slots=True)
class Alignment:
    """Words by characters of the line, with a confidence (0..1) each; phones as a `Spoken` has them, and when each
    begins as people label it (a plosive with its closure). Seconds of the recording, which has `duration`."""

    words: tuple[WordTime, ...]
    confidences: tuple[float, ...]
    phones: tuple[PhoneTime, ...]
    labelled: tuple[float, ...]
    duration: float
    doubts: tuple[Doubt, ...] = ()

    def times(self) -> Times:
        """The words, and the phones as people label them."""
        words = (
            TimedWord(word.text, word.start, word.end, round(sure, 3))
            for word, sure in zip(self.words, self.confidences, strict=True)
        )
        ends = [*self.labelled[1:], max([0.0, *(phone.end for phone in self.phones[-1:])])]
        phones = (
            replace(phone, start=start, end=max(start, _end(phone, end)))
            for phone, start, end in zip(self.phones, self.labelled, ends, strict=True)
        )
        return Times(tuple(words), tuple(phones), self.duration)


def _end(phone: PhoneTime, following: float) -> float:
    """Phones end where the next begins; between two Mandarin mouth shapes there may be time to move."""
    return min(phone.end, following) if phone.symbol.startswith(PREFIX) else following
