"""Lines to pieces and silences, and the words in a text."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from saying import line, over

from facescript.ir.acts import Stretch
from facescript.speech.lines import BREATH, Piece, is_letter, pieces, words
from facescript.speech.model import VoiceFailure


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("I don't know, it's 10:30.", "I|don't|know|it's|10:30"),
        ("thirty-one: 2.4 or 1,000", "thirty|one|2.4|or|1,000"),
        ("L’eau d'été", "L’eau|d'été"),
        ("मैं तुमसे", "मैं|तुमसे"),
        ("长城！a b", "长|城|a|b"),
        ("かんじです", "か|ん|じ|で|す"),
        ("안녕하세요 저는", "안녕하세요|저는"),
        ("e\u0301te\u0301", "e\u0301te\u0301"),
        ("... — !", ""),
    ],
)
def test_words(text: str, expected: str) -> None:
    assert "|".join(text[word.first : word.last] for word in words(text)) == expected


@given(st.text(max_size=60))
def test_words_hold_every_letter_once_and_in_order(text: str) -> None:
    found = words(text)
    inside = [at for word in found for at in range(word.first, word.last)]
    assert inside == sorted(set(inside))
    assert {at for at, sign in enumerate(text) if is_letter(sign)} <= set(inside)
    assert all(is_letter(text[word.first]) and is_letter(text[word.last - 1]) for word in found)


def test_pauses_cut_a_line() -> None:
    text = "One two. Three four."
    found = pieces(line(text, "en-us", Stretch("breath", 8, 8), Stretch("pause", 14, 14, "1.5")))
    assert [part if isinstance(part, float) else part.text for part in found] == [
        "One two.",
        BREATH,
        " Three",
        1.5,
        " four.",
    ]


def test_marks_stay_with_their_piece() -> None:
    text = "One two three"
    marks = (over(text, "One two", "stress"), Stretch("breath", 3, 3), over(text, "three", "reading", "tree"))
    found = [part for part in pieces(line(text, "en-us", *marks)) if isinstance(part, Piece)]
    assert [[(mark.kind, mark.start, mark.end) for mark in part.marks] for part in found] == [
        [("stress", 0, 3)],
        [("stress", 3, 7), ("reading", 8, 13)],
    ]


def test_stress_on_a_part_of_a_word_is_on_the_word() -> None:
    text = "quite unbelievable"
    (piece,) = pieces(line(text, "en-us", over(text, "believ", "stress")))
    assert isinstance(piece, Piece)
    assert [(mark.start, mark.end) for mark in piece.marks] == [(6, 18)]


@pytest.mark.parametrize(
    ("text", "marks", "code", "reason"),
    [
        ("...", (), "FS503", "no letter"),
        ("a" * 20_001, (), "FS501", "at most 20000"),
        ("a b", (Stretch("pause", 1, 1, "601"),), "FS501", "longer than 600 s"),
    ],
)
def test_what_cannot_be_said(text: str, marks: tuple[Stretch, ...], code: str, reason: str) -> None:
    with pytest.raises(VoiceFailure, match=reason) as failure:
        pieces(line(text, "en-us", *marks))
    assert failure.value.code == code
