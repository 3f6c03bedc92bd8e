"""Rhubarb Lip Sync's mouth cues, JSON or TSV, to times and back: shapes of the mouth, without words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from types import MappingProxyType
from typing import Any

from facescript.speech.mandarin.syllables import PREFIX
from facescript.speech.model import PhoneTime
from facescript.speech.mouth.visemes import visemes
from facescript.speech.timing.times import Times, moment, times_of, unusable

SHAPES = MappingProxyType({"A": "m", "B": "i", "C": "e", "D": "a", "E": "o", "F": "u", "G": "f", "H": "h'", "X": ""})
"""Our shape for each of Rhubarb's: A closed, B teeth together, C open, D wide open, E rounded a little, F puckered,
G teeth on the lip, H tongue up, X at rest."""

LETTERS = MappingProxyType({shape: letter for letter, shape in SHAPES.items()} | {"n": "H", "th": "H", "rest": "X"})
"""Rhubarb's letter for each of our shapes; B for those that have none."""


def shape(letter: object, line: int | None = None) -> str:
    """The symbol of a phone for Rhubarb's letter. Raises `VoiceFailure`."""
    if not isinstance(letter, str) or letter.strip().upper() not in SHAPES:
        raise unusable(f"`{str(letter)[:40]}` is no mouth shape of Rhubarb's, which are A to H and X", line)
    name = SHAPES[letter.strip().upper()]
    return PREFIX + name if name else ""


def from_cues(cues: Iterable[Any], duration: float) -> Times:
    """The cues of a JSON file. Raises `VoiceFailure`."""
    found = []
    for number, cue in enumerate(cues, 1):
        if not isinstance(cue, dict) or not {"start", "end", "value"} <= cue.keys():
            raise unusable(f"mouth cue {number} has no `start`, `end` and `value`")
        found.append(PhoneTime(shape(cue["value"]), moment(cue["start"]), moment(cue["end"])))
    return times_of((), found, duration=duration)


def is_tsv(text: str) -> bool:
    first = next((line for line in text.split("\n") if line.strip()), "").split("\t")
    return len(first) == 2 and first[1].strip().upper() in SHAPES


def read_tsv(text: str) -> Times:
    """Lines of a time and a letter; the last one is the end. Raises `VoiceFailure`."""
    found: list[tuple[float, str]] = []
    for number, line in enumerate(text.split("\n"), 1):
        if line.strip():
            time, tab, letter = line.partition("\t")
            if not tab:
                raise unusable("a line is a time, a tab and a letter", number)
            found.append((moment(time, number), shape(letter, number)))
    found.sort(key=lambda cue: cue[0])
    ends = [time for time, _ in found[1:]] + [found[-1][0]]
    return times_of((), [PhoneTime(symbol, time, end) for (time, symbol), end in zip(found, ends, strict=True)])


def write_tsv(times: Times) -> str:
    """The shapes of the phones as Rhubarb's letters, and the end."""
    cues = [*_cues(times), (times.duration, "X")]
    kept = [cue for before, cue in zip([(0.0, ""), *cues], cues, strict=False) if cue[1] != before[1]]
    if kept[-1] != cues[-1]:
        kept.append(cues[-1])
    return "".join(f"{time:.2f}\t{letter}\n" for time, letter in kept)


def _cues(times: Times) -> Iterator[tuple[float, str]]:
    for phone in times.phones:
        found = visemes(phone.symbol) if phone.symbol else ()
        share = (phone.end - phone.start) / max(len(found), 1)
        if not found:
            yield phone.start, "X"
        for index, viseme in enumerate(found):
            yield phone.start + index * share, LETTERS.get(viseme.shape, "B")
