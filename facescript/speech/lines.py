"""A line to the pieces that are spoken at once and the silences between them, and the words in its plain text."""

from __future__ import annotations

import unicodedata
from dataclasses import dataclass

from facescript.ir.acts import Say, Stretch
from facescript.speech.model import VoiceFailure

BREATH = 0.3
"""Seconds of silence that `|` makes."""

LONGEST = 20_000
"""Characters of a line."""

LONGEST_PAUSE = 600.0
"""Seconds of one pause inside a line."""

CLAUSE_ENDS = ".,;:!?…。，、；：！？।؟،"
JOINERS = "'’.,:·"
"""Signs that join the letters or figures on both sides to one word: don't, 2.4, 10:30."""


@dataclass(frozen=True, slots=True)
class Piece:
    """A stretch of the plain text spoken at once: characters `first` to `last`, with its stresses and readings."""

    text: str
    first: int
    last: int
    marks: tuple[Stretch, ...]

    def readings(self) -> dict[int, Stretch]:
        """The reading that covers a character, by the character's place in the line."""
        return {at: mark for mark in self.marks if mark.kind == "reading" for at in range(mark.start, mark.end)}


@dataclass(frozen=True, slots=True)
class Word:
    """A word of a text: characters `first` to `last`."""

    first: int
    last: int


def pieces(line: Say) -> tuple[Piece | float, ...]:
    """The pieces of a line in order; a number is that many seconds of silence. Raises `VoiceFailure`: FS503 where
    nothing in the line can be spoken."""
    if not _has_sound(line.text):
        raise VoiceFailure("it has no letter and no number", "FS503")
    if len(line.text) > LONGEST:
        raise VoiceFailure(f"it has {len(line.text)} characters, and a voice takes at most {LONGEST} at a time")
    found: list[Piece | float] = []
    at = 0
    for pause in sorted((mark for mark in line.stretches if mark.kind in ("breath", "pause")), key=lambda m: m.start):
        found += [_piece(line, at, pause.start), _silence(pause)]
        at = pause.start
    found.append(_piece(line, at, len(line.text)))
    return tuple(part for part in found if isinstance(part, float) or _has_sound(part.text))


def _has_sound(text: str) -> bool:
    """Whether a voice has something to say: a mark that stands on no letter is none."""
    return any(unicodedata.category(sign)[0] in "LN" for sign in text)


def _silence(pause: Stretch) -> float:
    seconds = BREATH if pause.kind == "breath" else float(pause.value)
    if seconds > LONGEST_PAUSE:
        raise VoiceFailure(f"a pause of {seconds:g} s inside it is longer than {LONGEST_PAUSE:g} s")
    return seconds


def _piece(line: Say, first: int, last: int) -> Piece:
    marks = tuple(
        _whole_words(
            line.text, Stretch(mark.kind, max(mark.start, first), min(mark.end, last), mark.value), first, last
        )
        for mark in sorted(line.stretches, key=lambda mark: mark.start)
        if mark.kind in ("stress", "reading") and mark.start < last and mark.end > first
    )
    return Piece(line.text[first:last], first, last, marks)


def _whole_words(text: str, mark: Stretch, first: int, last: int) -> Stretch:
    """A stress on a part of a word is on the word: a tag inside it would tear it apart."""
    start, end = mark.start, mark.end
    if mark.kind != "stress":
        return mark
    while start > first and _in_word(text, start):
        start -= 1
    while end < last and _in_word(text, end):
        end += 1
    return Stretch("stress", start, end)


def _in_word(text: str, at: int) -> bool:
    """Whether the characters on both sides of a place belong to one word."""
    return all(is_letter(sign) and not is_unspaced(sign) for sign in text[at - 1 : at + 1])


def is_letter(sign: str) -> bool:
    """Whether a character is part of a word: a letter, a mark on one, or a figure."""
    return unicodedata.category(sign)[0] in "LMN"


def is_unspaced(sign: str) -> bool:
    """Whether a character belongs to a script written without spaces, where every character counts as a word."""
    code = ord(sign)
    return (
        0x0E00 <= code <= 0x0EFF  # Thai, Lao
        or 0x1000 <= code <= 0x109F  # Myanmar
        or 0x1780 <= code <= 0x17FF  # Khmer
        or 0x3040 <= code <= 0x30FF  # kana
        or is_han(sign)
    )


def is_han(sign: str) -> bool:
    """Whether a character is Chinese."""
    code = ord(sign)
    return (
        0x3400 <= code <= 0x4DBF or 0x4E00 <= code <= 0x9FFF or 0xF900 <= code <= 0xFAFF or 0x20000 <= code <= 0x3FFFF
    )


def words(text: str) -> tuple[Word, ...]:
    """The words of a text in order; a character of an unspaced script, with the marks on it, is a word."""
    found: list[Word] = []
    at = 0
    while at < len(text):
        last = _word_end(text, at)
        if last > at:
            found.append(Word(at, last))
        at = max(last, at + 1)
    return tuple(found)


def _word_end(text: str, at: int) -> int:
    if not is_letter(text[at]):
        return at
    alone = is_unspaced(text[at])
    end = at + 1
    while end < len(text) and _goes_on(text, end, alone):
        end += 1
    return end


def _goes_on(text: str, at: int, alone: bool) -> bool:
    """Whether the character at `at` belongs to the word before it."""
    if alone or unicodedata.category(text[at])[0] == "M":
        return unicodedata.category(text[at])[0] == "M"
    if is_letter(text[at]):
        return not is_unspaced(text[at])
    inner = at + 1 < len(text) and is_letter(text[at + 1]) and not is_unspaced(text[at + 1])
    return inner and text[at] in JOINERS and is_letter(text[at - 1])
