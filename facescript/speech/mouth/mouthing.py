"""Phones of a line to shapes of the mouth in time: when each is reached, how long it stays, which fall away."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from facescript.speech.mandarin.syllables import PREFIX
from facescript.speech.model import PhoneTime
from facescript.speech.mouth.visemes import Viseme, visemes

CLOSING = 0.06
"""Seconds before its burst at which a p or b is shut (45 to 70 ms)."""

SLACK = 0.015
"""Seconds by which that may come later in fast speech."""

PAUSE = 0.2
"""Seconds of silence in which the mouth goes to rest."""

LEAD, ROUNDED_LEAD, PARTING_LEAD = 0.12, 0.17, 0.18
"""Seconds from the first movement of the mouth to the first sound after a pause (bar L2). Rounding is seen earlier, and
so are lips that part for a breath before they close on a p, b or m."""

PARTED = 0.25
"""The degree of shape h to which they part."""

DECAY = 0.13
"""Seconds from the last sound to the mouth at rest (JALI: about 150 ms after)."""

GAP = 0.03
"""The shortest way from one shape to the next, in seconds."""

UNSTRESSED = 0.8
"""Degree of a vowel without stress beside a stressed one."""

FOLLOWED = 0.7
"""How far the corners of a consonant go with those of the rounded vowel after it."""

RANK = {"m": 3, "f": 2, "u": 2, "o": 2, "th": 1, "z": 1, "r": 1, "h'": 0, "h": 0}
"""Which of two shapes without room for both stays; vowels and the others have 1."""


@dataclass(frozen=True, slots=True)
class MouthShape:
    """A shape of `visemes.SHAPES` at a degree, fully there from `on` to `off` (seconds).

    Before `on` the mouth comes from the shape before, after `off` it goes to the next. `follows` names the rounded
    vowel whose corners a consonant takes in advance; `slack` is how much later `on` may come.
    """

    name: str
    on: float
    off: float
    degree: float = 1.0
    follows: str = ""
    slack: float = 0.0

    def later(self, seconds: float, limit: float) -> MouthShape:
        """The shape moved by `seconds`, no longer there at `limit`."""
        off = min(self.off + seconds, limit)
        return MouthShape(self.name, self.on + seconds, off, self.degree, self.follows, self.slack)

    @property
    def shut(self) -> bool:
        return self.name == "m"


def mouth_shapes(phones: Sequence[PhoneTime]) -> tuple[MouthShape, ...]:
    """The shapes of a line in order of time, with room to move between any two."""
    found: list[MouthShape] = []
    for phone, after in pairwise([*_whole_silences(phones), None]):
        assert phone is not None
        if not phone.symbol:
            found += _rest(phone, after)
        elif phone.symbol.startswith(PREFIX):
            found.append(_given(phone, after))
        else:
            found += _sounding(phone, after)
    return arranged(found)


def _whole_silences(phones: Sequence[PhoneTime]) -> list[PhoneTime]:
    """The phones with silences that follow each other made one."""
    found: list[PhoneTime] = []
    for phone in phones:
        if found and not phone.symbol and not found[-1].symbol:
            found[-1] = replace(found[-1], end=phone.end)
        else:
            found.append(phone)
    return found


def arranged(shapes: Sequence[MouthShape]) -> tuple[MouthShape, ...]:
    """The shapes with at least `GAP` between them: closed lips stay, others give way, the weaker fall away."""
    kept: list[MouthShape] = []
    for shape in shapes:
        _append(kept, shape)
    return tuple(kept)


def _append(kept: list[MouthShape], shape: MouthShape) -> None:
    """Put a shape behind the others, making room."""
    while kept:
        last = kept[-1]
        if last.name == shape.name and (last.shut or shape.on - last.off < GAP):
            if last.shut and shape.on - last.off >= 2 * GAP:
                break
            kept[-1] = replace(last, off=max(last.off, shape.off), degree=max(last.degree, shape.degree))
            return
        made = _made_room(last, shape, kept[-2].off if len(kept) > 1 else float("-inf"))
        if made:
            kept[-1], shape = made
            break
        if _rank(last) >= _rank(shape) or last.shut:
            return
        kept.pop()
    kept.append(shape)


def _made_room(last: MouthShape, shape: MouthShape, earlier: float) -> tuple[MouthShape, MouthShape] | None:
    """The two shapes `GAP` apart, or None; `earlier` is when the one before them ends."""
    if last.off + GAP <= shape.on:
        return last, shape
    if not last.shut and last.on + GAP <= shape.on:
        return replace(last, off=shape.on - GAP), shape
    latest = shape.on + shape.slack if shape.shut else shape.off + GAP
    if last.off + GAP <= latest:
        return last, replace(shape, on=last.off + GAP, off=max(shape.off, last.off + GAP))
    if not last.shut and last.on + GAP <= latest:
        return replace(last, off=last.on), replace(shape, on=last.on + GAP, off=max(shape.off, last.on + GAP))
    moved = latest - GAP
    if not last.shut and earlier + GAP <= moved:
        return replace(last, on=moved, off=moved), replace(shape, on=latest, off=max(shape.off, latest))
    return None


def _rank(shape: MouthShape) -> int:
    return RANK.get(shape.name, 1)


def _rest(phone: PhoneTime, after: PhoneTime | None) -> list[MouthShape]:
    """The mouth at rest in a silence long enough."""
    if phone.end - phone.start < PAUSE:
        return []
    on = min(phone.start + DECAY, (phone.start + phone.end) / 2)
    off = max(on, phone.end - lead(after))
    return [MouthShape("rest", on, off), *breath(off, phone.end - CLOSING, after)]


def lead(first: PhoneTime | None) -> float:
    """How long before its first sound the mouth begins to move."""
    shape = _first_shape(first)
    return ROUNDED_LEAD if shape in ("u", "o") else PARTING_LEAD if shape == "m" else LEAD


def breath(begins: float, shut: float, first: PhoneTime | None) -> list[MouthShape]:
    """Lips at rest that are to be `shut` for the first sound part a little after `begins`: else they would not be seen
    to close."""
    if _first_shape(first) != "m" or shut - begins < 2 * GAP:
        return []
    middle = (begins + shut) / 2
    return [MouthShape("h", middle, middle, PARTED)]


def _first_shape(phone: PhoneTime | None) -> str:
    found = visemes(phone.symbol) if phone and phone.symbol else ()
    return found[0].shape if found else ""


def _given(phone: PhoneTime, after: PhoneTime | None) -> MouthShape:
    """A Mandarin shape: there when it is given, then on its way, unless a gap or a silence lets it stay to its end;
    closed lips always stay."""
    name = visemes(phone.symbol)[0].shape
    stays = name in ("m", "f") or after is None or not after.symbol or after.start - phone.end > GAP / 3
    on = min(phone.start, phone.end - CLOSING) if name == "m" else phone.start
    return MouthShape(name, on, phone.end if stays else max(on, phone.start))


def _sounding(phone: PhoneTime, after: PhoneTime | None) -> list[MouthShape]:
    """The shapes of a phone given in IPA."""
    found = visemes(phone.symbol, phone.stress)
    rounded = _rounded_vowel(after)
    share = (phone.end - phone.start) / max(len(found), 1)
    shapes = []
    for index, viseme in enumerate(found):
        start = phone.start + index * share
        vowel = rounded if index == len(found) - 1 else ""
        if index == len(found) - 1 and _falls_away(viseme, after):
            continue
        if viseme.kind == "vowel":
            degree = viseme.degree * (1.0 if phone.stress else UNSTRESSED)
            shapes.append(MouthShape(viseme.shape, start + 0.25 * share, start + 0.7 * share, degree))
        else:
            shapes.append(_consonant(viseme, start, share, vowel))
    return shapes


def _consonant(viseme: Viseme, start: float, length: float, vowel: str) -> MouthShape:
    """A stop's event is its burst: its shape stands before it; other consonants last as long as their sound."""
    end = start + length
    if viseme.shape == "m":
        if viseme.kind == "stop":
            return MouthShape("m", start - CLOSING, start, slack=SLACK)
        return MouthShape("m", start, end)
    follows = vowel if viseme.shape not in ("f", "u", "i") else ""
    if viseme.kind == "stop":
        return MouthShape(viseme.shape, start - GAP, start, viseme.degree, follows)
    return MouthShape(viseme.shape, start + 0.1 * length, end - 0.3 * length, viseme.degree, follows)


def _rounded_vowel(after: PhoneTime | None) -> str:
    """The rounded shape that the next phone begins with, or ""."""
    shape = _first_shape(after)
    return shape if shape in ("u", "o") else ""


def _falls_away(viseme: Viseme, after: PhoneTime | None) -> bool:
    """The thesis's rule for h' and h (section 5.2.2): they leave no shape before i, u, e and o."""
    if viseme.kind == "vowel" or viseme.shape not in ("h'", "h") or not after or not after.symbol:
        return False
    found = visemes(after.symbol)
    return bool(found) and found[0].shape in ("i", "u", "e", "o")
