"""Every syllable of Mandarin, by way of its zhuyin: the thesis's shapes, their composition and their times."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import pytest
from pypinyin import Style
from pypinyin.contrib.tone_convert import to_normal
from pypinyin.pinyin_dict import pinyin_dict
from pypinyin.style import convert

from facescript.speech.mandarin.syllables import PREFIX, numbered, shapes, timed
from facescript.speech.model import VoiceFailure
from facescript.speech.mouth.mouthing import mouth_shapes
from facescript.speech.mouth.visemes import SHAPES

CLASSES = """
m ㄅㄆㄇ   f ㄈ   h' ㄉㄊㄋㄌㄐㄑㄒ   h ㄍㄎㄏㄜㄥㄦ   r ㄓㄔㄕㄖ   z ㄗㄘㄙ   a ㄚ   e ㄝ   i ㄧ   o ㄛ   u ㄨㄩ   n ㄣ
au ㄠ   ou ㄡ   an ㄢ   ah ㄤ   ei ㄟ   ai ㄞ
"""
"""Tables 5.5 and 5.6, rebuilt: shapes and the signs of zhuyin that take them."""

STARTS = {1: (0,), 2: (0, 80.95), 3: (0, 43.37, 83.12), 4: (0, 24.5, 45.65, 71.53)}
"""Percent of a syllable at which each of its shapes is given (section 5.3)."""

NOT_THE_THESIS_S = {"m", "n", "ng", "hm", "hng", "ê"}
"""Sounds without a vowel, and one that zhuyin writes as the class itself; Mandarin has them as exclamations."""


def of_sign(sign: str) -> list[str]:
    names = CLASSES.split()
    name = next(names[at] for at in range(0, len(names), 2) if sign in names[at + 1])
    return [name] if name in SHAPES else list(name)


def by_zhuyin(zhuyin: str) -> list[str]:
    """A syllable's shapes by the rules of section 5.2.2, sign by sign."""
    found = [shape for sign in zhuyin for shape in of_sign(sign)]
    if "ㄢ" in zhuyin[1:] and zhuyin[zhuyin.index("ㄢ") - 1] in "ㄧㄩ":
        found[found.index("a")] = "e"
    if zhuyin[0] in "ㄅㄆㄇ" and zhuyin[1:] == "ㄛ":
        found.insert(1, "u")
    if len(found) > 1 and found[0] in ("h'", "h") and zhuyin[0] not in "ㄜㄥㄦ" and found[1] in ("i", "u", "e", "o"):
        del found[0]
    return found


@cache
def syllables() -> dict[str, str]:
    """All syllables of pypinyin's dictionary in pinyin, with their zhuyin."""
    written = {each for row in set(pinyin_dict.values()) for each in row.split(",")}
    found = {}
    for plain in sorted({to_normal(each, v_to_u=False) for each in written} - NOT_THE_THESIS_S):
        try:
            name = numbered(f"{plain}1")
        except VoiceFailure:
            continue
        found[name] = "".join(sign for sign in convert(name, Style.BOPOMOFO, strict=True) if "ㄅ" <= sign <= "ㄩ")
    return found


def test_every_syllable_is_composed_as_the_thesis_says() -> None:
    assert len(syllables()) > 400
    for name, zhuyin in syllables().items():
        assert list(shapes(name)) == by_zhuyin(zhuyin), (name, zhuyin)


@pytest.mark.parametrize("length", [0.12, 0.25, 0.6])
def test_every_syllable_is_timed_as_the_thesis_says(length: float) -> None:
    for name in syllables():
        found = timed(name, 1.0, 1.0 + length, 1.0 + 0.1 * length)
        told = [round(100 * (phone.start - 1.0) / length, 2) for phone in found]
        assert told == list(STARTS[len(found)]), name
        assert all(one.end <= two.start + 1e-9 for one, two in pairwise(found)), name
        assert [phone.symbol.removeprefix(PREFIX) for phone in found] == list(shapes(name))


def test_every_shape_is_there_when_it_is_given() -> None:
    """In a syllable of usual length no shape of it falls away, and each is whole at its start."""
    for name in syllables():
        found = timed(name, 1.0, 1.3, 1.03)
        kept = mouth_shapes(found)
        assert [shape.name for shape in kept] == list(shapes(name)), name
        for phone, shape in zip(found, kept, strict=True):
            assert shape.on <= phone.start + 1e-9 <= shape.off + 2e-9, name
            assert shape.values == SHAPES[shape.name], name
