"""Chinese characters to their syllables in context, by the dictionary of pypinyin and words of our own."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import TYPE_CHECKING

from facescript.speech.lines import is_han
from facescript.speech.mandarin.phrases import AROUND, SINGLES, WORDS
from facescript.speech.mandarin.syllables import TONES, numbered

if TYPE_CHECKING:
    from opencc import OpenCC

LONGEST_WORD = 10
"""Characters of the longest word of the dictionary, about; longer ones are sayings."""

TWO = {"著": "着"}
"""What is 着 in most texts in traditional characters; `WORDS` has those in which it is 著."""


@dataclass(frozen=True, slots=True)
class Read:
    """A character's syllable, "" where none is known, and the number of the word that it stands in."""

    syllable: str
    word: int


@lru_cache(maxsize=64)
def read(text: str) -> tuple[Read, ...]:
    """The reading of each character of a text, before tones act on each other; what is not Chinese has none."""
    plain = "".join(map(_simplified, text))
    found: list[Read] = []
    word = 0
    while len(found) < len(text):
        at = len(found)
        syllables = _word_at(text, plain, at) or (_single(text, plain, at),)
        found += [Read(syllable, word) for syllable in syllables]
        word += 1
    return tuple(found)


def _word_at(text: str, plain: str, at: int) -> tuple[str, ...]:
    """The syllables of the longest word that begins at a place; none where a character stands alone."""
    if not is_han(plain[at]):
        return ()
    phrases, _ = _dictionary()
    for end in range(min(at + LONGEST_WORD, len(plain)), at + 1, -1):
        word = plain[at:end]
        ours = WORDS.get(text[at:end]) or WORDS.get(word)
        if ours:
            return tuple(ours.split())
        if word in phrases:
            return tuple(map(_own, word, (readings[0] for readings in phrases[word])))
    return ()


def _single(text: str, plain: str, at: int) -> str:
    """The syllable of a character that stands in no word."""
    for sign, pattern, syllable in AROUND:
        if sign == plain[at] and re.compile(pattern).match(plain, at):
            return syllable
    if text[at] in SINGLES:
        return SINGLES[text[at]]
    found = _dictionary()[1].get(ord(text[at]), "").split(",")[0] if is_han(text[at]) else ""
    return _own(text[at], found) if found else ""


def _own(sign: str, sound: str) -> str:
    """The dictionary's syllable as this package writes it: without a mark it has no tone; 一 and 不 have their own."""
    if sign in "一不" and sound[:1] in "yb":
        return {"一": "yi1", "不": "bu4"}[sign]
    numbers = numbered(sound if any(mark in TONES for mark in unicodedata.normalize("NFD", sound)) else sound + "5")
    return "er" + numbers[-1] if numbers[:-1] == "r" else numbers


@cache
def _dictionary() -> tuple[dict[str, list[list[str]]], dict[int, str]]:
    """pypinyin's words and characters with the marks of their tones."""
    from pypinyin.constants import PHRASES_DICT, PINYIN_DICT  # 0.2 s to import: only Mandarin lines pay it

    return PHRASES_DICT, PINYIN_DICT


@cache
def _converter() -> OpenCC:
    from opencc import OpenCC  # as slow to import as pypinyin

    return OpenCC("t2s")


@lru_cache(maxsize=1 << 14)
def _simplified(sign: str) -> str:
    """A traditional character as the simplified one, for the look-up of words; any other as it is."""
    return TWO.get(sign) or (_converter().convert(sign) if is_han(sign) else sign)
