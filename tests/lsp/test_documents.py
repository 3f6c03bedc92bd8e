"""An editor's changes land where the editor made them, whatever signs and line ends the text has."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lsprotocol import types

from facescript.lsp.documents import Document, offset

SIGNS = st.text(st.sampled_from("ab \n\r\f\u2028é你😀\ud83d\udc00"), max_size=30)


def edited(text: str, start: tuple[int, int], end: tuple[int, int], put: str) -> str:
    document = Document("file:///a.face", text, 1)
    place = types.Range(types.Position(*start), types.Position(*end))
    document.apply_change(types.TextDocumentContentChangePartial(range=place, text=put))
    return document.source


@pytest.mark.parametrize(
    ("text", "start", "end", "found"),
    [
        ("a\fb\nc", (1, 0), (1, 1), "a\fb\nX"),
        ("a\u2028b\nc", (1, 0), (1, 0), "a\u2028b\nXc"),
        ("a\r\nb\rc", (2, 0), (2, 0), "a\r\nb\rXc"),
        ("a😀b", (0, 3), (0, 3), "a😀Xb"),
        ("a😀b", (0, 2), (0, 4), "aX"),
        ("\ud83dx", (0, 1), (0, 2), "\ud83dX"),
        ("a\nb\n", (1, 0), (2, 0), "a\nX"),
        ("a", (9, 9), (9, 9), "aX"),
        ("ab\ncd", (1, 1), (0, 1), "ab\ncXd"),
    ],
)
def test_a_change_of_a_range(text: str, start: tuple[int, int], end: tuple[int, int], found: str) -> None:
    assert edited(text, start, end, "X") == found


@given(SIGNS, st.data())
def test_every_place_is_found_again(text: str, data: st.DataObject) -> None:
    """Every offset between two signs, but in the middle of a line's end, has a line and a column."""
    at = data.draw(st.integers(0, len(text)))
    before = text[:at].replace("\r\n", "\n").replace("\r", "\n")
    if text[at - 1 : at + 1] != "\r\n" and not (at and "\ud800" <= text[at - 1] < "\udc00" and text[at : at + 1] > ""):
        line = before.rpartition("\n")[2]
        column = len(line.encode("utf-16-le", "surrogatepass")) // 2
        assert offset(text, types.Position(before.count("\n"), column)) == at
