"""A piece of a Mandarin line to its characters, figures and foreign words, each with its syllables."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass, replace

from facescript.ir.acts import Stretch
from facescript.speech.lines import Piece, is_han, is_letter
from facescript.speech.mandarin.figures import figures
from facescript.speech.mandarin.phonetic import PARTICLES, is_zhuyin, pinyin, syllables_of, zhuyin
from facescript.speech.mandarin.readings import Read, read
from facescript.speech.mandarin.sandhi import Said, said
from facescript.speech.model import VoiceFailure

MARKS = {
    **dict.fromkeys("，、,—–", ", "),
    **dict.fromkeys("。.．", ". "),
    **dict.fromkeys("？?", "? "),
    **dict.fromkeys("！!", "! "),
    **dict.fromkeys("；;", "; "),
    **dict.fromkeys("：:", ": "),
    **dict.fromkeys("…", ", "),
}
"""What punctuation is to the voice; quotation marks, emoji and what else is not here are not heard."""

ADDRESS = re.compile(r"(?:https?://|www\.)[\w\-./?=&%#~+:@]*[\w/]|[\w.+-]{1,64}@[\w-]+(?:\.[\w-]+)+", re.ASCII)
LATIN = re.compile("(?:[A-Za-z\u00c0-\u024f][\u0300-\u036f]*['’]?[0-5]?){1,60}")
JOINERS = ".-&'’"
"""Signs that join foreign letters to one word: Node.js, T-shirt, R&B."""

LANGUAGES = {"CYRILLIC": "ru", "GREEK": "el", "HANGUL": "ko", "ARABIC": "ar", "HEBREW": "he", "THAI": "th"}
LANGUAGES |= {"DEVANAGARI": "hi", **dict.fromkeys(("HIRAGANA", "KATAKANA", "KATAKANA-HIRAGANA"), "ja")}
LATIN_LANGUAGE = "en-us"
"""The languages that foreign letters are spoken in, by the first word of a letter's name."""

APART = 100_000
"""More than the words of any line: what is read for figures counts its words from a multiple of it."""


@dataclass(frozen=True, slots=True)
class Unit:
    """Characters `first` to `last` of the piece: their syllables, or none and a mark of punctuation, or foreign words
    and their language."""

    first: int
    last: int
    syllables: tuple[str, ...] = ()
    mark: str = ""
    foreign: str = ""
    language: str = ""
    stressed: bool = False


Draft = tuple[Unit, tuple[Said, ...]]
"""A unit and what is said for it, before tones act on each other."""


def units(piece: Piece, line: str) -> tuple[Unit, ...]:
    """The piece cut into units; `line` is the whole text, the context in which characters are read.

    A character is a unit, as is a syllable of zhuyin or pinyin, a number with its unit, and a stretch of foreign
    words. Raises `VoiceFailure` (FS502) at a character or a reading without a syllable.
    """
    drafts = list(_drafts(piece, line))
    sounds = iter(said([each for unit, sounds in drafts for each in sounds or _break(unit)]))
    found: list[Unit] = []
    for unit, before in drafts:
        syllables = tuple(next(sounds).syllable for _ in before or _break(unit))
        found.append(replace(unit, syllables=syllables, stressed=_stressed(piece, unit)) if before else unit)
    return tuple(found)


def _break(unit: Unit) -> tuple[Said, ...]:
    """What keeps the tones on both sides of it apart: a pause, or foreign words."""
    return (Said("", "", -1),) if unit.foreign or unit.mark.strip() else ()


def _stressed(piece: Piece, unit: Unit) -> bool:
    place = piece.first + unit.first
    return any(mark.kind == "stress" and mark.start <= place < mark.end for mark in piece.marks)


def _drafts(piece: Piece, line: str) -> Iterator[Draft]:
    context = read(line)[piece.first : piece.last]
    written = piece.readings()
    text, at, latin = piece.text, 0, False
    while at < len(text):
        found = _written(piece, at, written.get(piece.first + at)) or _address(text, at) or _figures(text, at)
        if not found:
            found = _phonetic(text, at, latin)
            latin = bool(found) or (latin and text[at] == " ")
        found = found or _foreign(text, at) or [_character(text, at, context[at])]
        yield from found
        at = found[-1][0].last


def _written(piece: Piece, at: int, mark: Stretch | None) -> list[Draft]:
    """The next character of a stretch with the written reading `mark`, or all of it where it has no characters."""
    if mark is None:
        return []
    text = piece.text[mark.start - piece.first : mark.end - piece.first]
    syllables = syllables_of(mark.value)
    places = [index for index, sign in enumerate(text, mark.start - piece.first) if is_letter(sign)]
    if len(syllables) == len(places):
        if at not in places:
            return []
        return [(Unit(at, at + 1), (Said(piece.text[at], syllables[places.index(at)], -1, True),))]
    if any(map(is_han, text)) or not syllables:
        reason = f"`{mark.value}` has {len(syllables)} syllables and `{text}` has {len(places)} characters"
        raise VoiceFailure(reason, "FS502")
    last = mark.end - piece.first
    return [(Unit(at, last), tuple(Said("", syllable, -1, True) for syllable in syllables))]


def _address(text: str, at: int) -> list[Draft]:
    """An address of a page or of a person, spoken as one."""
    match = ADDRESS.match(text, at)
    return [(Unit(at, match.end(), foreign=match[0], language=LATIN_LANGUAGE), ())] if match else []


def _figures(text: str, at: int) -> list[Draft]:
    found = figures(text, at)
    if found is None:
        return []
    last, characters = found
    sounds = (
        Said(sign, each.syllable, APART * (at + 1) + each.word)
        for sign, each in zip(characters, read(characters), strict=True)
    )
    return [(Unit(at, last), tuple(sounds))]


def _phonetic(text: str, at: int, after: bool) -> list[Draft]:
    """Syllables written in zhuyin, or a word in pinyin; `after` one, a particle needs no tone."""
    if is_zhuyin(text[at]):
        end = at
        while end < len(text) and (is_zhuyin(text[end]) or text[end] in "ˉˊˇˋ"):
            end += 1
        cuts = tuple(zhuyin(text[at:end]))
    else:
        match = LATIN.match(text, at) if not at or not text[at - 1].isalnum() else None
        word = match[0].rstrip("'’") if match else ""
        cuts = pinyin(word) or (((0, len(word), word.lower() + "5"),) if after and word.lower() in PARTICLES else ())
    return [
        (Unit(at + first, at + last), (Said(text[at + first], syllable, APART * (at + 1)),))
        for first, last, syllable in cuts
    ]


def _foreign(text: str, at: int) -> list[Draft]:
    """A stretch of letters of one foreign script, with the spaces inside it, up to a word in pinyin."""
    language = _language(text[at])
    end = at
    while language and end < len(text):
        begin = end
        while begin < len(text) and text[begin] == " ":
            begin += 1
        last = _word_end(text, begin, language)
        if last == begin or (begin > at and _phonetic(text, begin, False)):
            break
        end = last
    return [(Unit(at, end, foreign=text[at:end], language=language), ())] if end > at else []


def _word_end(text: str, at: int, language: str) -> int:
    while at < len(text):
        joined = text[at] in JOINERS and at + 1 < len(text) and _language(text[at + 1]) == language
        if _language(text[at]) != language and not joined and unicodedata.category(text[at])[0] != "M":
            break
        at += 1
    return at


def _language(sign: str) -> str:
    """The language that a letter is spoken in; "" for Chinese and for what is no letter."""
    if not sign.isalpha() or is_han(sign) or is_zhuyin(sign):
        return ""
    return LANGUAGES.get(unicodedata.name(sign, "").split(" ")[0], LATIN_LANGUAGE)


def _character(text: str, at: int, found: Read) -> Draft:
    if found.syllable:
        return Unit(at, at + 1), (Said(text[at], found.syllable, found.word),)
    if is_han(text[at]):
        raise VoiceFailure(f"no reading of `{text[at]}` is known; write one, as in `[read zhang3]长[/]`", "FS502")
    return Unit(at, at + 1, mark=MARKS.get(text[at], " ")), ()
