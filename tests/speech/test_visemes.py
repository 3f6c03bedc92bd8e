"""Phones of any language to shapes of the mouth, and the shapes' values."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.performance.channels import MOUTH
from facescript.speech.model import PhoneTime
from facescript.speech.mouth.mouthing import mouth_shapes
from facescript.speech.mouth.room import GAP, TOUCH, arranged
from facescript.speech.mouth.shape import MouthShape
from facescript.speech.mouth.visemes import PLAIN, SHAPES, visemes

THESIS = {
    # up, dn in MNS0; corners outwards in MW0 (sections 5.2.1 and 5.2.2)
    "m": (0, 0, 0),
    "h'": (0.25, 0.3, 0),
    "h": (0.25, 0.5, -1 / 12),
    "r": (0.25, 0.25, -0.15),
    "z": (0.15, 0.15, 0),
    "a": (0.3, 0.8, -1 / 8),
    "i": (0, 1 / 6, 1 / 12),
    "u": (0.3, 0.3, -0.2),
    "e": (0, 0.5, 1 / 12),
    "o": (0.25, 0.65, -0.2),
    "n": (0.3, 0.4, 0),
}


@pytest.mark.parametrize("name", THESIS)
def test_shapes_are_the_thesis_s(name: str) -> None:
    values = dict(zip(MOUTH, SHAPES[name], strict=True))
    assert (values["upper"], values["lower"], values["wide"]) == THESIS[name]
    assert values["open"] == pytest.approx(values["upper"] + values["lower"])


def test_f_hides_half_the_lower_lip() -> None:
    values = dict(zip(MOUTH, SHAPES["f"], strict=True))
    assert values["open"] == 0
    assert values["lower"] < 0
    assert values["upper"] == 0


def test_shares_are_shares() -> None:
    for values in SHAPES.values():
        told = dict(zip(MOUTH, values, strict=True))
        assert all(0 <= told[name] <= 1 for name in ("round", "jaw", "teeth", "tongue"))


PHONES = """
p b m       | m | m | m
f v pf      | f | f | m f
t d k ɡ     | h' | h' | h | h
s z ts dz   | z | z | z | z
ʃ ʒ tʃ dʒ   | r | r | r | r
θ ð l ɹ     | th | th | h' | r
w j ŋ χ     | u | i | h | h
aɪ eɪ ɔɪ    | a i | e i | o i
aʊ oʊ əʊ    | a u | o u | h u
iː uː ɑː ɜː | i | u | a | h
ɔːɹ ɚ ɑ̃ y   | o r | h | a | u
ʃh k͡p       | r h | h m
zh:a zh:h'  | a | h'
ꙮ ꙮː        | h' | h
"""


@pytest.mark.parametrize("row", PHONES.strip().splitlines())
def test_phones_to_shapes(row: str) -> None:
    symbols, *expected = (cell.strip() for cell in row.split("|"))
    assert [" ".join(v.shape for v in visemes(symbol)) for symbol in symbols.split()] == expected


CHART = """
p b t d ʈ ɖ c ɟ k ɡ q ɢ ʔ ʡ m ɱ n ɳ ɲ ŋ ɴ ʙ r ʀ ⱱ ɾ ɽ ɸ β f v θ ð s z ʃ ʒ ʂ ʐ ç ʝ x ɣ χ ʁ ħ ʕ h ɦ ʜ ʢ ɬ ɮ ɺ ʋ ɹ ɻ j ɰ l
ɭ ʎ ʟ ʘ ǀ ǃ ǂ ǁ ɓ ɗ ʄ ɠ ʛ ʍ w ɥ ɕ ʑ ɧ i y ɨ ʉ ɯ u ɪ ʏ ʊ e ø ɘ ɵ ɤ o ə ɛ œ ɜ ɞ ʌ ɔ æ ɐ a ɶ ɑ ɒ ɝ ɚ ɫ
ʦ ʣ ʧ ʤ ʨ ʥ ᵻ ᵿ g A S Z X
"""
"""The letters of the IPA, and what some voices of espeak-ng write besides."""


def test_the_table_has_every_letter_of_the_chart() -> None:
    assert [sign for sign in CHART.split() if PLAIN.unknown(sign)] == []
    assert PLAIN.unknown("aꙮː") == "ꙮ"


@settings(deadline=None, max_examples=50)
@given(st.text(max_size=8), st.booleans())
def test_no_symbol_is_too_strange(symbol: str, stressed: bool) -> None:
    assert all(viseme.shape in SHAPES for viseme in visemes(symbol, stressed))


def told(shapes: tuple[MouthShape, ...]) -> str:
    return " ".join(f"{s.name}@{s.on * 1000:.0f}-{s.off * 1000:.0f}" for s in shapes)


def row_of(symbols: str, length: float = 0.1) -> list[PhoneTime]:
    """Phones of the same length one after another; `_` is silence, `'` stress."""
    return [
        PhoneTime(symbol.strip("'_"), at * length, (at + 1) * length, "'" in symbol)
        for at, symbol in enumerate(symbols.split())
    ]


@pytest.mark.parametrize(
    ("symbols", "expected"),
    [
        ("p 'a", "m@-60-0 a@125-170"),
        ("'a m 'a", "a@25-70 m@100-200 a@230-270"),
        ("'a p 'a", "a@25-25 m@55-100 a@225-270"),
        ("m b 'u", "m@0-100 u@225-270"),
        ("f 'i", "f@10-70 i@125-170"),
        ("t 'i", "i@125-170"),
        ("t 'a", "h'@-30-0 a@125-170"),
        ("k 'u", "u@125-170"),
        ("s 'u", "z@10-70 u@125-170"),
        ("ʃ 'o t", "r@10-70 o@125-140 h'@170-200"),
        ("'aɪ", "a@12-32 i@62-85"),
        ("'a _ _ _ 'a", "a@25-70 rest@230-280 a@425-470"),
        ("tʃ 'a", "r@10-70 a@125-170"),
    ],
)
def test_phones_to_shapes_in_time(symbols: str, expected: str) -> None:
    assert told(mouth_shapes(row_of(symbols))) == expected


def test_a_long_silence_is_a_rest() -> None:
    phones = [PhoneTime("a", 0, 0.2), PhoneTime("", 0.2, 1.0), PhoneTime("a", 1.0, 1.2)]
    assert told(mouth_shapes(phones)) == "a@50-140 rest@330-880 a@1050-1140"


def test_mandarin_shapes_are_there_when_they_are_given() -> None:
    phones = [PhoneTime("zh:m", 0.1, 0.14), PhoneTime("zh:a", 0.3, 0.35), PhoneTime("zh:i", 0.35, 0.55)]
    assert told(mouth_shapes(phones)) == "m@80-140 a@300-300 i@350-550"


SYMBOLS = st.sampled_from("_ p b m f t s ʃ a i uː oʊ ə zh:m zh:a zh:i ɹ w".split())


@settings(deadline=None)
@given(st.lists(st.tuples(SYMBOLS, st.floats(0.005, 0.4), st.booleans()), max_size=30))
def test_any_row_of_phones_leaves_room_to_move(row: list[tuple[str, float, bool]]) -> None:
    phones, at = [], 0.0
    for symbol, length, stress in row:
        phones.append(PhoneTime(symbol.strip("_"), at, at + length, stress))
        at += length
    shapes = mouth_shapes(phones)
    assert all(shape.on <= shape.off for shape in shapes)
    for one, two in pairwise(shapes):
        assert two.on - one.off >= (TOUCH if one.closed and two.closed else GAP) - 1e-9
    again = arranged(shapes)
    assert [shape.name for shape in again] == [shape.name for shape in shapes]
    assert [shape.on for shape in again] == pytest.approx([shape.on for shape in shapes])
    shut = [shape for shape in shapes if shape.name == "m"]
    for phone in phones:
        if phone.symbol in ("p", "b"):
            assert any(shape.on - 1e-9 <= phone.start <= shape.off + 1e-9 for shape in shut)
        if phone.symbol == "zh:m":
            assert any(shape.on <= phone.end - 0.059 and shape.off >= phone.end - 1e-9 for shape in shut)
        if phone.symbol == "m":
            assert any(shape.on <= phone.start + 0.016 and shape.off >= phone.end - 1e-9 for shape in shut)
