"""A document brought into the one layout by an editor: whole, in part, and not at all where it has errors."""

from __future__ import annotations

import pytest
from analysing import analysis
from lsprotocol import types

from facescript.lsp.desk import Analysis
from facescript.lsp.features.formatting import edits, edits_within
from facescript.lsp.places import offset
from facescript.syntax.formatter import format_source

UNTIDY = "face  ada = woman\n\n\n\nada:\n  nod\n  show smile 40% posed # \U0001f600\nwait 2s\nada: shake"


def applied(found: Analysis, changes: list[types.TextEdit]) -> str:
    text = found.source.text
    for edit in reversed(changes):
        start, end = offset(found.source, edit.range.start), offset(found.source, edit.range.end)
        text = text[:start] + edit.new_text + text[end:]
    return text


@pytest.mark.parametrize(
    "text",
    [UNTIDY, UNTIDY + "\n", UNTIDY + "\n\n\n", "nod ", "\n\nnod\n", "nod\n", "\n\n# \U0001f600", "nod\n\n\n\nnod\n"],
)
def test_the_edits_lead_to_the_layout(text: str) -> None:
    found = analysis(text)
    changes = edits(found)
    assert applied(found, changes) == format_source(found.source)
    places = [(edit.range.start.line, edit.range.start.character) for edit in changes]
    assert places == sorted(places)


def test_lines_that_are_tidy_are_not_touched() -> None:
    found = analysis("nod\n" * 31 + "shake  40%\n" + "nod\n" * 30)
    (edit,) = edits(found)
    assert edit == types.TextEdit(types.Range(types.Position(31, 0), types.Position(32, 0)), "shake 40%\n")
    assert edits(analysis("nod\n")) == []


def test_a_range_keeps_to_itself() -> None:
    found = analysis("nod  40%\nshake  40%\nwink  left\n")
    for end in (types.Position(1, 3), types.Position(2, 0)):
        (edit,) = edits_within(found, types.Range(types.Position(1, 0), end))
        assert edit.new_text == "shake 40%\n"
    assert edits_within(found, types.Range(types.Position(9, 0), types.Position(99, 9))) == []


@pytest.mark.parametrize("text", ["nod  40%\nshow (\n", "", "a\tb\x00"])
def test_what_has_errors_is_left_alone(text: str) -> None:
    assert edits(analysis(text)) == []
