"""The ranges around a place, from the inside out."""

from __future__ import annotations

from analysing import analysis
from lsprotocol import types

from facescript.lsp.features.selection import selection
from facescript.lsp.places import offset

SCRIPT = """\
scene opening:
    together:
        ada: show smile.left 20% + (AU7 30%), posed
        ada: say "I have lost my cup."
"""


def around(text: str, line: int, column: int) -> list[str]:
    made = analysis(text)
    found: types.SelectionRange | None = selection(made, [types.Position(line, column)])[0]
    texts = []
    while found is not None:
        texts.append(text[offset(made.source, found.range.start) : offset(made.source, found.range.end)])
        found = found.parent
    return texts


def test_from_a_word_to_the_file() -> None:
    assert around(SCRIPT, 2, 37) == [
        "AU7",
        "AU7 30%",
        "(AU7 30%)",
        "show smile.left 20% + (AU7 30%)",
        "show smile.left 20% + (AU7 30%), posed",
        "ada: show smile.left 20% + (AU7 30%), posed",
        SCRIPT[18:].strip(),
        SCRIPT.strip(),
        SCRIPT,
    ]


def test_from_a_word_of_a_text_to_the_text_in_its_quotes() -> None:
    assert around(SCRIPT, 3, 27)[:4] == [
        "lost",
        "I have lost my cup.",
        '"I have lost my cup."',
        'say "I have lost my cup."',
    ]


def test_in_a_line_that_cannot_be_read_there_is_its_word() -> None:
    text = 'nod\nlook at "\n'
    assert around(text, 1, 2) == ["look", text]
    assert around(text, 99, 0) == [text]
