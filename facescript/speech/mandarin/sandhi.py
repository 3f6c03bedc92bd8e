"""Syllables as a dictionary has them to syllables as they are said: the tones of 一, 不 and of two thirds in a row."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

FIGURES = "零〇一二三四五六七八九十"
LARGE = "百千万亿"
ORDINAL = "第初"
DATES = "月号日楼班级等中"
"""What makes a 一 before it a number in a row: 一月, 一楼, 一等."""


@dataclass(frozen=True, slots=True)
class Said:
    """A character of a text and its syllable; `word` counts the words of the text. What is `set` stays as it is."""

    sign: str
    syllable: str
    word: int
    set: bool = False

    @property
    def tone(self) -> str:
        return self.syllable[-1:]


def said(found: Sequence[Said]) -> tuple[Said, ...]:
    """A text's characters with the tones that they have beside each other; without a syllable it is a break."""
    turned = list(found)
    for place, each in enumerate(found):
        if each.set or not each.syllable:
            continue
        after = found[place + 1] if place + 1 < len(found) else None
        tone = None
        if each.sign == "一" and each.syllable[:-1] == "yi":
            tone = _tone_of_one(found, place, after)
        elif each.sign == "不" and each.syllable == "bu4" and after and after.tone == "4":
            tone = "2"
        if tone:
            turned[place] = replace(each, syllable=each.syllable[:-1] + tone)
    return tuple(_thirds(turned))


def _tone_of_one(found: Sequence[Said], place: int, after: Said | None) -> str:
    """yi2 before a fourth tone (and 个), yi4 before others, yi1 as a number in a row and at a word's end."""
    before = found[place - 1] if place else None
    if after is None or not after.syllable or after.sign in FIGURES or after.sign in DATES:
        return "1"
    if before and before.syllable:
        if before.sign == after.sign and found[place - 2].sign != "一":
            return "5"  # 看一看, but not 一天一天
        if before.sign in ORDINAL or (before.sign in FIGURES and after.sign not in LARGE):
            return "1"
        if before.word == found[place].word != after.word:
            return "1"  # 唯一, 统一
    return "2" if after.tone == "4" or after.sign in "个個" else "4"


def _thirds(found: list[Said]) -> list[Said]:
    """In a row of third tones every second from the end keeps it, and in a word only the last."""
    turned = list(found)
    rows: list[list[int]] = [[]]
    for place, each in enumerate(found):
        if each.tone == "3":
            rows[-1].append(place)
        elif rows[-1]:
            rows.append([])
    for row in rows:
        for place in _raised(found, row):
            if not found[place].set:
                turned[place] = replace(found[place], syllable=found[place].syllable[:-1] + "2")
    return turned


def _raised(found: Sequence[Said], row: Sequence[int]) -> set[int]:
    """The places of a row of third tones that are said in the second."""
    raised = {first for first, second in pairwise(row) if found[first].word == found[second].word}
    for first, second in reversed(list(pairwise(row))):
        if second not in raised:
            raised.add(first)
    return raised
