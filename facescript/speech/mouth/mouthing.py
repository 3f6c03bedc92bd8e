"""Phones of a line to shapes of the mouth in time: when each is reached, how long it stays, how far it goes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from statistics import median

from facescript.speech.mandarin.syllables import PREFIX
from facescript.speech.model import PhoneTime
from facescript.speech.mouth.effort import EVEN, Effort
from facescript.speech.mouth.room import GAP, arranged
from facescript.speech.mouth.shape import CLOSED, MouthShape
from facescript.speech.mouth.visemes import PLAIN, Table, Viseme, visemes

CLOSING, LEAST_CLOSING = 0.06, 0.02
"""Seconds before its burst at which a p or b is shut (45 to 70 ms), and beside another closure at least."""

SLACK = 0.015
"""Seconds by which that may come later in fast speech, so that a vowel between two closures is seen."""

QUICK = 0.04
"""Seconds of the median phone below which closures get shorter with all the rest, down to a half."""

PAUSE = 0.2
"""Seconds of silence in which the mouth goes to rest."""

LEAD, ROUNDED_LEAD, PARTING_LEAD = 0.12, 0.17, 0.18
"""Seconds from the first movement of the mouth to the first sound after a pause (bar L2). Rounding is seen earlier, and
so are lips that part for a breath before they close on a p, b or m."""

PARTED = 0.25
"""The degree of shape h to which they part."""

DECAY = 0.13
"""Seconds from the last sound to the mouth at rest (JALI: about 150 ms after)."""

UNSTRESSED = 0.8
"""Degree of a vowel without stress beside a stressed one."""

WHOLE, LEAST_REACH = 0.08, 0.5
"""Seconds of a vowel from which on it is reached as a whole, and the least that is left of a shorter one: in fast
speech only closures are reached."""


@dataclass(frozen=True, slots=True)
class Manner:
    """How a line is spoken: what its sound says of stress and loudness, what an author says of single sounds, and how
    long before its burst a stop is shut, s."""

    effort: Effort
    table: Table
    closing: float


def mouth_shapes(phones: Sequence[PhoneTime], effort: Effort = EVEN, table: Table = PLAIN) -> tuple[MouthShape, ...]:
    """The shapes of a line in order of time, with room to move between any two."""
    found: list[MouthShape] = []
    manner = Manner(effort, table, _closing(phones))
    for phone, after in pairwise([*_whole_silences(phones), None]):
        assert phone is not None
        if not phone.symbol:
            found += _rest(phone, after, table)
        elif phone.symbol.startswith(PREFIX):
            found.append(_given(phone, after, effort))
        else:
            found += _sounding(phone, after, manner)
    return arranged(found)


def _closing(phones: Sequence[PhoneTime]) -> float:
    lengths = [phone.end - phone.start for phone in phones if phone.symbol]
    return CLOSING * min(max(median(lengths) / QUICK, 0.5), 1.0) if lengths else CLOSING


def _whole_silences(phones: Sequence[PhoneTime]) -> list[PhoneTime]:
    """The phones with silences that follow each other made one."""
    found: list[PhoneTime] = []
    for phone in phones:
        if found and not phone.symbol and not found[-1].symbol:
            found[-1] = replace(found[-1], end=phone.end)
        else:
            found.append(phone)
    return found


def _rest(phone: PhoneTime, after: PhoneTime | None, table: Table) -> list[MouthShape]:
    """The mouth at rest in a silence long enough."""
    if phone.end - phone.start < PAUSE:
        return []
    on = min(phone.start + DECAY, (phone.start + phone.end) / 2)
    off = max(on, phone.end - lead(after, table))
    return [MouthShape("rest", on, off), *breath(off, phone.end - CLOSING, after, table)]


def lead(first: PhoneTime | None, table: Table = PLAIN) -> float:
    """How long before its first sound the mouth begins to move."""
    shape = _first_shape(first, table)
    return ROUNDED_LEAD if shape in ("u", "o") else PARTING_LEAD if shape == "m" else LEAD


def breath(begins: float, shut: float, first: PhoneTime | None, table: Table = PLAIN) -> list[MouthShape]:
    """Lips at rest that are to be `shut` for the first sound part a little after `begins`: else they would not be seen
    to close."""
    if _first_shape(first, table) != "m" or shut - begins < 2 * GAP:
        return []
    middle = (begins + shut) / 2
    return [MouthShape("h", middle, middle, PARTED, exact=True)]


def _first_shape(phone: PhoneTime | None, table: Table) -> str:
    found = table.visemes(phone.symbol) if phone and phone.symbol else ()
    return found[0].shape if found else ""


def _given(phone: PhoneTime, after: PhoneTime | None, effort: Effort) -> MouthShape:
    """A Mandarin shape: there when it is given, then on its way, unless a gap or a silence lets it stay to its end;
    closures always stay. It is the thesis's as it is: only a line that is louder or softer as a whole moves the jaw."""
    name = visemes(phone.symbol)[0].shape
    stays = name in CLOSED or after is None or not after.symbol or after.start - phone.end > GAP / 3
    on = min(phone.start, phone.end - CLOSING) if name == "m" else phone.start
    off = phone.end if stays else max(on, phone.start)
    trim = (phone.end - phone.start) / 4 if name == "f" else 0.0
    return MouthShape(name, on, off, slack=trim, yields=trim, trim=trim, effort=effort.line, exact=True)


def _sounding(phone: PhoneTime, after: PhoneTime | None, manner: Manner) -> list[MouthShape]:
    """The shapes of a phone given in IPA."""
    found = manner.table.visemes(phone.symbol, phone.stress)
    share = (phone.end - phone.start) / max(len(found), 1)
    shapes = []
    for index, viseme in enumerate(found):
        start = phone.start + index * share
        if index == len(found) - 1 and _falls_away(viseme, after, manner.table):
            continue
        if viseme.kind == "vowel":
            shapes.append(_vowel(viseme, start, share, phone, manner.effort))
        else:
            shapes.append(_consonant(viseme, start, share, manner.closing, manner.effort.line))
    return shapes


def _vowel(viseme: Viseme, start: float, length: float, phone: PhoneTime, effort: Effort) -> MouthShape:
    """Stress, of the word or in the sound, and time make a vowel whole."""
    stress = max(float(phone.stress), effort.stress(phone))
    reach = min(max((phone.end - phone.start) / WHOLE, LEAST_REACH), 1.0)
    degree = viseme.degree * (UNSTRESSED + (1.0 - UNSTRESSED) * stress) * reach
    on, off = start + 0.25 * length, start + 0.7 * length
    return MouthShape(viseme.shape, on, off, degree, effort=effort.jaw(phone), vowel=True, own=viseme.values)


def _consonant(viseme: Viseme, start: float, length: float, closing: float, effort: float) -> MouthShape:
    """A stop's event is its burst: its shape stands before it; other consonants last as long as their sound."""
    end = start + length
    name, degree, own = viseme.shape, viseme.degree, viseme.values
    if name == "m" and viseme.kind == "stop":
        return MouthShape("m", start - closing, start, slack=SLACK, yields=closing - LEAST_CLOSING)
    if name == "m":
        return MouthShape("m", start, end)
    if name == "f":
        late = 0.3 * length
        return MouthShape("f", start + 0.1 * length, end - late, slack=late, yields=late, trim=0.1 * length)
    if viseme.kind == "stop":
        return MouthShape(name, start - GAP, start, degree, effort=effort, own=own)
    return MouthShape(name, start + 0.1 * length, end - 0.3 * length, degree, effort=effort, own=own)


def _falls_away(viseme: Viseme, after: PhoneTime | None, table: Table) -> bool:
    """The thesis's rule for h' and h (section 5.2.2): they leave no shape before i, u, e and o. Where the tongue is
    seen, as for l and n, it stays."""
    quick = viseme.kind == "stop" if viseme.shape == "h'" else viseme.kind != "vowel" and viseme.shape == "h"
    if not quick or not after or not after.symbol:
        return False
    found = table.visemes(after.symbol)
    return bool(found) and found[0].shape in ("i", "u", "e", "o")
