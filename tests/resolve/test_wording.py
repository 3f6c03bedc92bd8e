"""Where words stand in a text, in spaced and unspaced scripts and where both meet."""

from __future__ import annotations

import pytest

from facescript.ir.wording import find


@pytest.mark.parametrize(
    ("text", "word", "nth", "found"),
    [
        ("Take my *cup*, my Cup.", "cup", 1, "cup"),
        ("the robots, the robots", "robots", 2, "robots"),
        ("小明在长城脚下长大。", "长城", 1, "长城"),
        ("小明说OK，去3个。", "ok", 1, "OK"),
        ("小明说OK，去3个。", "3", 1, "3"),
        ("小明说OK，去3个。", "小明", 1, "小明"),
    ],
)
def test_found(text: str, word: str, nth: int, found: str) -> None:
    place = find(text, word, nth)
    assert place is not None
    assert text[slice(*place)] == found


@pytest.mark.parametrize(("text", "word"), [("小明说OK", "O"), ("cups", "cup"), ("one two", "two one")])
def test_not_found(text: str, word: str) -> None:
    assert find(text, word) is None
